/* Keys of the other ends of bonds. For solid/ only. */
#pragma once
#include "solid/body/cloud.h"

/* A key of the other end of a bond: global id and periodic image. */
static inline long solid_key_of(long id, int image) { return SOLID_IMAGES * id + image; }
static inline long solid_key_id(long key) { return key / SOLID_IMAGES; }
static inline int solid_key_image(long key) { return (int)(key % SOLID_IMAGES); }
