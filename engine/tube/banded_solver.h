// A symmetric positive definite system of 3x3 blocks in which block i meets i + 1 and i + 2 only: a chain's.
#pragma once

#include <array>

#include "engine/types.h"

namespace vallecula::engine {

/// Filled by the caller (lower triangle), then solved in place by a block LDL^T without pivots, in a fixed order.
template <int kBlocks>
struct BandedSystem {
  std::array<Mat3, kBlocks> diagonal, next, second;  ///< blocks (i, i), (i + 1, i), (i + 2, i)
  std::array<Vec3, kBlocks> right;                   ///< the solution, once solved

  void clear() noexcept {
    for (int i = 0; i < kBlocks; ++i) {
      diagonal[i].setZero();
      next[i].setZero();
      second[i].setZero();
      right[i].setZero();
    }
  }

  void solve() noexcept {
    for (int i = 0; i < kBlocks; ++i) {
      const Mat3 inverse = diagonal[i].inverse();
      if (i + 1 < kBlocks) {
        const Mat3 lower = next[i] * inverse;
        diagonal[i + 1].noalias() -= lower * next[i].transpose();
        right[i + 1].noalias() -= lower * right[i];
        if (i + 2 < kBlocks) {
          const Mat3 lowest = second[i] * inverse;
          next[i + 1].noalias() -= lowest * next[i].transpose();
          diagonal[i + 2].noalias() -= lowest * second[i].transpose();
          right[i + 2].noalias() -= lowest * right[i];
          second[i] = lowest;
        }
        next[i] = lower;
      }
      right[i] = inverse * right[i];
    }
    for (int i = kBlocks - 2; i >= 0; --i) {
      right[i].noalias() -= next[i].transpose() * right[i + 1];
      if (i + 2 < kBlocks) right[i].noalias() -= second[i].transpose() * right[i + 2];
    }
  }
};

}  // namespace vallecula::engine
