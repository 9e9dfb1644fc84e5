/* The scene's arrangements and volumes of points in the words of meshless/arrange. Not collective. */
#pragma once
#include "meshless/arrange/arrange.h"
#include "scene/scene.h"

enum meshless_arrangement meshless_points_arrangement(enum scene_arrangement kind);
enum meshless_volume meshless_points_volume(enum scene_point_volume kind);
