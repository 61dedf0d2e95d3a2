// Four floats at a time with GCC's vector extension: SSE on every x86-64, the same bits on each of them.
#pragma once

#include <cmath>

#include "engine/types.h"

namespace vallecula::engine {

using F4 = float __attribute__((vector_size(16)));
using I4 = int __attribute__((vector_size(16)));

/// A value with room for x, y, z and one unused lane; what node vectors are made of.
struct Float4 {
  F4 v = {0, 0, 0, 0};
};

inline F4 splat(float s) { return F4{s, s, s, s}; }
inline F4 from_vec3(const Vec3& p) {
  return F4{static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z()), 0.0f};
}
inline Vec3 to_vec3(F4 v) { return Vec3(v[0], v[1], v[2]); }
inline float dot3(F4 a, F4 b) {
  const F4 p = a * b;
  return p[0] + p[1] + p[2];
}
inline F4 sqrt4(F4 a) {
  F4 r;
  for (int i = 0; i < 4; ++i) r[i] = std::sqrt(a[i]);
  return r;
}
inline F4 abs4(F4 a) { return (F4)((I4)a & I4{0x7fffffff, 0x7fffffff, 0x7fffffff, 0x7fffffff}); }

/// Rows a, b, c, d become lanes: afterwards a holds the first components, b the second, c the third.
inline void transpose(F4& a, F4& b, F4& c, F4& d) {
  const F4 ab_low = __builtin_shuffle(a, b, I4{0, 4, 1, 5}), ab_high = __builtin_shuffle(a, b, I4{2, 6, 3, 7});
  const F4 cd_low = __builtin_shuffle(c, d, I4{0, 4, 1, 5}), cd_high = __builtin_shuffle(c, d, I4{2, 6, 3, 7});
  a = __builtin_shuffle(ab_low, cd_low, I4{0, 1, 4, 5});
  b = __builtin_shuffle(ab_low, cd_low, I4{2, 3, 6, 7});
  c = __builtin_shuffle(ab_high, cd_high, I4{0, 1, 4, 5});
  d = __builtin_shuffle(ab_high, cd_high, I4{2, 3, 6, 7});
}

}  // namespace vallecula::engine
