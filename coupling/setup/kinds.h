/* The scene's kinds in the words of fluid and solid. A kind that has no translation does not compile. Not collective.
 */
#pragma once
#include "fluid/fluid.h"
#include "scene/scene.h"
#include "solid/state.h"

struct solid_turn setup_kinds_turn(const struct scene_turn *turn);
enum fluid_side_type setup_kinds_side(enum scene_side_type kind);
enum fluid_profile setup_kinds_profile(enum scene_profile kind);
enum fluid_condition setup_kinds_condition(enum scene_condition kind);
enum fluid_projection setup_kinds_projection(enum scene_projection kind);
enum fluid_integrator setup_kinds_fluid_integrator(enum scene_fluid_integrator kind);
enum fluid_driving_type setup_kinds_driving(enum scene_driving kind);
enum solid_model setup_kinds_model(enum scene_model kind);
/* tensile_strength of a material whose bonds soften, else 0. */
double setup_kinds_strength(const struct scene_material *material);
enum solid_micromodulus_kind setup_kinds_micromodulus(enum scene_micromodulus kind);
enum solid_partial setup_kinds_partial(enum scene_partial kind);
enum solid_correction setup_kinds_correction(enum scene_correction kind);
enum solid_precision setup_kinds_precision(enum scene_precision kind);
enum solid_horizons setup_kinds_horizons(enum scene_horizons kind);
enum solid_depth setup_kinds_depth(enum scene_surface kind);
enum solid_shape setup_kinds_shape(enum scene_shape kind);
enum solid_load_kind setup_kinds_load(enum scene_load_kind kind);
enum solid_initial_shape setup_kinds_initial(enum scene_initial_shape kind);
enum solid_integrator setup_kinds_integrator(enum scene_integrator kind);
