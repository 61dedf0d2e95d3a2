// What is read and what is refused, in numbers.
#pragma once

#include <cstddef>
#include <cstdint>

namespace vallecula::pipeline {

// What an import needs.
constexpr int kFewestSlices = 16;
constexpr double kCoarsestSliceMm = 5.0;    ///< between slices; also the widest hole that is bridged by interpolation
constexpr double kCoarsestInPlaneMm = 2.0;  ///< voxel in the plane of the slices

// Exactness.
constexpr double kExactMm = 1e-3;  ///< positions that differ by less are the same
/// Slices within this of an even ladder (positions written with one decimal) are resampled onto its spacing; sideways
/// shifts up to it are left.
constexpr double kNearlyEvenMm = 0.1;

// Bounds of what a header may ask for, checked before anything is allocated.
constexpr std::int64_t kMostVoxels = std::int64_t{1} << 29;  ///< 1 GiB of int16
constexpr std::int64_t kLargestSide = 8192;
constexpr std::int64_t kMostFrames = 16384;
constexpr std::size_t kMostInflatedBytes = std::size_t{1} << 30;

// A folder with whatever else is in it.
constexpr int kFolderDepth = 4;  ///< subfolders of subfolders
constexpr int kMostFiles = 50'000;

// The helper program.
constexpr std::size_t kHelperMemoryBytes = std::size_t{4} << 30;  ///< addresses, for each of its processes
constexpr int kHelperCpuSeconds = 600;                            ///< for each of its processes
constexpr int kHelperStallSeconds = 60;                           ///< without a file or a slice getting done

}  // namespace vallecula::pipeline
