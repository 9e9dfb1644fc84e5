/* The type of a register of doubles (vec): eight with AVX-512, four with AVX2, two elsewhere. Its functions are in
 * base/vec.h. A header that only names the type or its lanes includes this file: the compiler needs a third of a second
 * for the intrinsics that base/vec.h includes. */
#pragma once
#include <stdint.h>
#if defined __AVX512F__ && defined __AVX512VL__ && !defined FRANA_SCALAR
#    define VEC_AVX512 1
#else
#    define VEC_AVX512 0
#endif
#if defined __AVX2__ && !VEC_AVX512 && !defined FRANA_SCALAR
#    define VEC_AVX2 1
#else
#    define VEC_AVX2 0
#endif

/* NAME: for messages; EACH: a number in all lanes; BEFORE: the lanes of two vecs that vec_before takes. */
#if VEC_AVX512
enum { VEC_LANES = 8 };
#    define VEC_NAME "8 doubles (AVX-512)"
#    define VEC_EACH(x) x, x, x, x, x, x, x, x
#    define VEC_BITS 1, 2, 4, 8, 16, 32, 64, 128
#    define VEC_BEFORE 7, 8, 9, 10, 11, 12, 13, 14
#elif VEC_AVX2
enum { VEC_LANES = 4 };
#    define VEC_NAME "4 doubles (AVX2)"
#    define VEC_EACH(x) x, x, x, x
#    define VEC_BITS 1, 2, 4, 8
#    define VEC_BEFORE 3, 4, 5, 6
#else
enum { VEC_LANES = 2 };
#    define VEC_NAME "2 doubles"
#    define VEC_EACH(x) x, x
#    define VEC_BITS 1, 2
#    define VEC_BEFORE 1, 2
#endif
enum { VEC_ALL = (1 << VEC_LANES) - 1 }; /* a bit for each lane */
typedef double vec __attribute__((vector_size(8 * VEC_LANES)));
typedef int64_t vec_mask __attribute__((vector_size(8 * VEC_LANES)));
