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

}  // namespace vallecula::engine
