// All functions from here to avx2_end.inl are compiled for AVX2 and FMA; what has been included before, for
// any processor, so that no inline function of a header asks for more than the processor may have.

#include <immintrin.h>

#if defined(__clang__)
#pragma clang attribute push(__attribute__((target("avx2,fma"))), apply_to = function)
#else
#pragma GCC push_options
#pragma GCC target("avx2,fma")
#endif
#define RIGOR_LANES_HAVE_FMA 1
