// Eight floats at a time with GCC's vector extension, beside float4.h's four. The kernels that use them are compiled twice,
// for plain x86-64 and for AVX2, and the processor chooses as the program starts. Both give the same bits: each lane does
// the same operations in the same order, and products and sums are never fused.
#pragma once

#include "engine/tissue/float4.h"

namespace vallecula::engine {

// Sanitizers cannot be entered before they are set up, which is when the choice is made.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define VALLECULA_KERNEL
#else
#define VALLECULA_KERNEL __attribute__((target_clones("avx2", "default")))
#endif
// Helpers become part of whichever kernel they are called from.
#define VALLECULA_INLINE inline __attribute__((always_inline))

// Without AVX the compiler would align these to 16 bytes only, and the AVX2 kernels rely on 32.
using F8 = float __attribute__((vector_size(32), aligned(32)));
using I8 = int __attribute__((vector_size(32), aligned(32)));

constexpr int kLanes = 8;

VALLECULA_INLINE F8 splat8(float s) { return F8{s, s, s, s, s, s, s, s}; }
VALLECULA_INLINE F8 join(F4 low, F4 high) { return __builtin_shufflevector(low, high, 0, 1, 2, 3, 4, 5, 6, 7); }
VALLECULA_INLINE F4 low_half(F8 a) { return __builtin_shufflevector(a, a, 0, 1, 2, 3); }
VALLECULA_INLINE F4 high_half(F8 a) { return __builtin_shufflevector(a, a, 4, 5, 6, 7); }
VALLECULA_INLINE F8 abs8(F8 a) { return (F8)((I8)a & (I8{} + 0x7fffffff)); }
VALLECULA_INLINE F8 min8(F8 a, F8 b) { return a < b ? a : b; }
VALLECULA_INLINE F8 sqrt8(F8 a) {
  F8 r;
  for (int i = 0; i < kLanes; ++i) r[i] = std::sqrt(a[i]);
  return r;
}

/// Within each half: rows a, b, c, d become lanes (as transpose() in float4.h does with four).
VALLECULA_INLINE void transpose8(F8& a, F8& b, F8& c, F8& d) {
  const F8 ab_low = __builtin_shuffle(a, b, I8{0, 8, 1, 9, 4, 12, 5, 13});
  const F8 ab_high = __builtin_shuffle(a, b, I8{2, 10, 3, 11, 6, 14, 7, 15});
  const F8 cd_low = __builtin_shuffle(c, d, I8{0, 8, 1, 9, 4, 12, 5, 13});
  const F8 cd_high = __builtin_shuffle(c, d, I8{2, 10, 3, 11, 6, 14, 7, 15});
  a = __builtin_shuffle(ab_low, cd_low, I8{0, 1, 8, 9, 4, 5, 12, 13});
  b = __builtin_shuffle(ab_low, cd_low, I8{2, 3, 10, 11, 6, 7, 14, 15});
  c = __builtin_shuffle(ab_high, cd_high, I8{0, 1, 8, 9, 4, 5, 12, 13});
  d = __builtin_shuffle(ab_high, cd_high, I8{2, 3, 10, 11, 6, 7, 14, 15});
}

/// x, y, z of eight nodes, lane by lane.
VALLECULA_INLINE void gather(const Float4* from, const std::int32_t node[kLanes], F8& x, F8& y, F8& z) {
  x = join(from[node[0]].v, from[node[4]].v);
  y = join(from[node[1]].v, from[node[5]].v);
  z = join(from[node[2]].v, from[node[6]].v);
  F8 w = join(from[node[3]].v, from[node[7]].v);
  transpose8(x, y, z, w);
}

/// Adds x, y, z of eight lanes to their nodes.
VALLECULA_INLINE void scatter_add(Float4* to, const std::int32_t node[kLanes], F8 x, F8 y, F8 z) {
  F8 w = splat8(0.0f);
  transpose8(x, y, z, w);
  to[node[0]].v += low_half(x);
  to[node[1]].v += low_half(y);
  to[node[2]].v += low_half(z);
  to[node[3]].v += low_half(w);
  to[node[4]].v += high_half(x);
  to[node[5]].v += high_half(y);
  to[node[6]].v += high_half(z);
  to[node[7]].v += high_half(w);
}

}  // namespace vallecula::engine
