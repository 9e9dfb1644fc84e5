/* Entries of the schema that several of its tables use. */
#include "scene/rules/schema_parts.h"

const cyaml_schema_value_t scene_schema_parts_real = {CYAML_VALUE_FLOAT(NEEDED, double)};
const cyaml_strval_t scene_schema_parts_axes[3] = {{"x", 0}, {"y", 1}, {"z", 2}};
