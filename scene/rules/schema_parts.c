/* Entries of the schema that several of its tables use. */
#include "scene/rules/schema_parts.h"

const cyaml_schema_value_t scene_schema_parts_real = {CYAML_VALUE_FLOAT(NEEDED, double)};
const cyaml_strval_t scene_schema_parts_axes[3] = {{"x", 0}, {"y", 1}, {"z", 2}};
const cyaml_strval_t scene_schema_parts_arrangements[5] = {{"lattice", SCENE_ARRANGED_LATTICE},
                                                           {"hexagonal", SCENE_ARRANGED_HEXAGONAL},
                                                           {"perturbed", SCENE_ARRANGED_PERTURBED},
                                                           {"centroidal", SCENE_ARRANGED_CENTROIDAL},
                                                           {"random", SCENE_ARRANGED_RANDOM}};
const cyaml_strval_t scene_schema_parts_volumes[2] = {{"equal", SCENE_VOLUME_EQUAL}, {"cell", SCENE_VOLUME_CELL}};
