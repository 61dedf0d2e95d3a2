// vallecula_import_bench [NxNxM ...]: how long an import takes and how much memory, by the number of voxels.
// The same infant in the same field of 160 mm on finer and finer grids, each imported by a process of its own.
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <random>

#include "pipeline/dicom/write_series.h"
#include "pipeline/import.h"
#include "pipeline/manikin/manikin.h"
#include "pipeline/segment/volume_ops.h"

namespace {

namespace fs = std::filesystem;
using namespace vallecula::pipeline;

/// The scan on another grid over the same field; the noise is put on afterwards, for interpolation would smooth it
/// away.
Hounsfield on_grid(const Hounsfield& scan, const std::array<int, 3>& size) {
  Grid g;
  g.size = size;
  for (int a = 0; a < 3; ++a) {
    const double length = scan.grid.size[a] * scan.grid.spacing[a];
    g.spacing[a] = length / size[a];
    g.origin[a] = scan.grid.origin[a] - 0.5 * scan.grid.spacing[a] + 0.5 * g.spacing[a];
  }
  const auto field = to_float(scan);
  std::mt19937 random(1);
  std::normal_distribution<float> noise(0.0F, 12.0F);
  Hounsfield out(g);
  for (std::size_t i = 0; i < g.count(); ++i) {
    const double v = value_at(field, g.position(i)) + noise(random);
    out.voxels[i] = static_cast<std::int16_t>(std::clamp(v, -1024.0, 3071.0));
  }
  return out;
}

/// In a process of its own, so that its peak of memory is the import's alone.
int import_and_print(const char* series, const char* out) {
  ImportOptions options;
  options.series = series;
  options.out = out;
  try {
    for (const auto& stage : import_series(options).stages) std::printf("  %s %.2f", stage.name.c_str(), stage.seconds);
    return 0;
  } catch (const std::exception& e) {
    std::printf("  %s\n", e.what());
    return 1;
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc == 4 && std::string(argv[1]) == "--import") return import_and_print(argv[2], argv[3]);
  std::vector<std::array<int, 3>> sizes;
  for (int i = 1; i < argc; ++i) {
    std::array<int, 3> n{};
    if (std::sscanf(argv[i], "%dx%dx%d", &n[0], &n[1], &n[2]) != 3 || *std::min_element(n.begin(), n.end()) < 32) {
      std::fprintf(stderr, "usage: vallecula_import_bench [COLUMNSxROWSxSLICES ...], each at least 32\n");
      return 2;
    }
    sizes.push_back(n);
  }
  if (sizes.empty()) sizes = {{256, 256, 150}, {384, 384, 225}, {512, 512, 300}};
  ManikinOptions manikin;
  manikin.noise_hu = 0.0;
  manikin.in_plane_mm = 0.4;
  manikin.slice_mm = 0.6;
  const auto scan = scan_manikin(manikin).ct;
  const auto work = fs::temp_directory_path() / ("vallecula-bench-" + std::to_string(::getpid()));
  int failures = 0;
  for (const auto& size : sizes) {
    fs::remove_all(work);
    fs::create_directories(work / "series");
    const auto hu = on_grid(scan, size);
    write_ct_series(hu, {"BENCH", "Bench", 0.0, "", "", "bench"}, work / "series");
    std::printf("%d x %d x %d:", size[0], size[1], size[2]);
    std::fflush(stdout);
    const auto start = std::chrono::steady_clock::now();
    const pid_t child = ::fork();
    if (child == 0) {
      const auto series = work / "series";
      const auto out = work / "bench.patient";
      ::execl("/proc/self/exe", argv[0], "--import", series.c_str(), out.c_str(), nullptr);
      ::_exit(127);
    }
    int status = 0;
    rusage used{};
    ::wait4(child, &status, 0, &used);
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    std::printf("\n  wall %.1f s, %.0f ns a voxel, processor %.1f s, peak %.0f MB\n", seconds,
                1e9 * seconds / static_cast<double>(hu.grid.count()),
                static_cast<double>(used.ru_utime.tv_sec + used.ru_stime.tv_sec), used.ru_maxrss / 1024.0);
    std::fflush(stdout);
    failures += status == 0 ? 0 : 1;
  }
  fs::remove_all(work);
  return failures == 0 ? 0 : 1;
}
