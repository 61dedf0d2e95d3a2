// From shapes to voxels: blocks that hold one matter are filled at once, voxels on a boundary are sampled finely; then
// the scanner's blur and noise.
#include <algorithm>
#include <atomic>
#include <mutex>
#include <stdexcept>
#include <thread>

#include "pipeline/manikin/manikin_data.h"

namespace vallecula::pipeline {
namespace {

using manikin::Body;
using manikin::Matter;
using manikin::Vec;

// In-plane and axial sigma of the scanner's point spread, mm: about 0.8 mm full width at half maximum.
constexpr double kBlurInPlane = 0.32;
constexpr double kBlurAxial = 0.36;

std::string number(double value) {
  std::string text = std::to_string(value);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text;
}

void check_range(const char* what, double value, double low, double high, const char* unit) {
  if (!(value >= low && value <= high))
    throw std::runtime_error("manikin: " + std::string(what) + " of " + number(value) + " " + unit + " is outside " +
                             number(low) + " to " + number(high) + " " + unit + "; give a value in that range");
}

Grid grid_for(const ManikinOptions& options, const Manikin& man) {
  const double s = man.scale();
  const bool small = options.weight_kg < 2.0;
  const double pixel = options.in_plane_mm > 0.0 ? options.in_plane_mm : small ? 0.4 : 0.5;
  const double slice = options.slice_mm > 0.0 ? options.slice_mm : small ? 0.6 : 0.8;
  // Square field about the head; from below the carina, where the bronchi end, to above the vertex.
  const int side = 16 * static_cast<int>(std::ceil(158.0 * s / pixel / 16.0));
  // Whole tenths of a millimetre, so that positions are short decimal strings.
  const double bottom = std::floor(10.0 * (man.landmarks().at("carina")[2] - 12.0 * s)) / 10.0;
  const double top = 86.0 * s;
  Grid grid;
  grid.size = {side, side, static_cast<int>(std::ceil((top - bottom) / slice))};
  grid.spacing = {pixel, pixel, slice};
  grid.origin = {-0.5 * (side - 1) * pixel, std::round(52.0 * s) - 0.5 * (side - 1) * pixel, bottom};
  return grid;
}

/// Runs work(i) for i in [0, count) on all cores; the first exception is thrown again here.
template <class Work>
void in_parallel(int count, Work&& work) {
  std::atomic<int> next{0};
  std::exception_ptr failure;
  std::mutex guard;
  const auto loop = [&] {
    try {
      for (int i = next++; i < count; i = next++) work(i);
    } catch (...) {
      const std::lock_guard<std::mutex> lock(guard);
      failure = std::current_exception();
      next = count;
    }
  };
  std::vector<std::thread> threads;
  const unsigned cores = std::max(1u, std::thread::hardware_concurrency());
  for (unsigned t = 1; t < cores; ++t) threads.emplace_back(loop);
  loop();
  for (auto& t : threads) t.join();
  if (failure) std::rethrow_exception(failure);
}

class Voxeliser {
 public:
  Voxeliser(const Body& body, double scale, const Grid& grid, std::vector<float>& hu, std::vector<std::uint8_t>& labels)
      : body_(body), scale_(scale), grid_(grid), hu_(hu), labels_(labels) {}

  void block(const std::array<int, 3>& low, const std::array<int, 3>& size, const Body::Open& known) const {
    std::array<int, 3> n{};
    for (int a = 0; a < 3; ++a) n[a] = std::min(size[a], grid_.size[a] - low[a]);
    Body::Open open = known;
    Matter matter{};
    const Vec centre = at(low[0] + 0.5 * (n[0] - 1), low[1] + 0.5 * (n[1] - 1), low[2] + 0.5 * (n[2] - 1));
    const double radius =
        0.5 * manikin::norm({n[0] * grid_.spacing[0], n[1] * grid_.spacing[1], n[2] * grid_.spacing[2]});
    if (body_.settle(centre, radius / scale_, open, matter)) {
      fill(low, n, matter);
    } else if (n[0] == 1 && n[1] == 1 && n[2] == 1) {
      sample(low, open);
    } else {
      const std::array<int, 3> part{std::max(1, size[0] / 4), std::max(1, size[1] / 4), std::max(1, size[2] / 3)};
      for (int z = 0; z < n[2]; z += part[2])
        for (int y = 0; y < n[1]; y += part[1])
          for (int x = 0; x < n[0]; x += part[0])
            block({low[0] + x, low[1] + y, low[2] + z},
                  {std::min(part[0], n[0] - x), std::min(part[1], n[1] - y), std::min(part[2], n[2] - z)}, open);
    }
  }

 private:
  Vec at(double x, double y, double z) const {
    const auto p = grid_.position(x, y, z);
    return {p[0] / scale_, p[1] / scale_, p[2] / scale_};
  }
  void fill(const std::array<int, 3>& low, const std::array<int, 3>& n, Matter matter) const {
    const auto value = static_cast<float>(manikin::hounsfield_of(matter));
    const std::uint8_t label = manikin::label_of(matter);
    for (int z = 0; z < n[2]; ++z)
      for (int y = 0; y < n[1]; ++y) {
        const std::size_t i = grid_.index(low[0], low[1] + y, low[2] + z);
        std::fill_n(hu_.begin() + static_cast<std::ptrdiff_t>(i), n[0], value);
        std::fill_n(labels_.begin() + static_cast<std::ptrdiff_t>(i), n[0], label);
      }
  }
  /// A voxel on a boundary: the mean over 2 x 2 x 3 points (partial volume); its label is what lies at its centre.
  void sample(const std::array<int, 3>& v, const Body::Open& open) const {
    double sum = 0.0;
    for (const double z : {-1.0 / 3.0, 0.0, 1.0 / 3.0})
      for (const double y : {-0.25, 0.25})
        for (const double x : {-0.25, 0.25})
          sum += manikin::hounsfield_of(body_.at(at(v[0] + x, v[1] + y, v[2] + z), open));
    const std::size_t i = grid_.index(v[0], v[1], v[2]);
    hu_[i] = static_cast<float>(sum / 12.0);
    labels_[i] = manikin::label_of(body_.at(at(v[0], v[1], v[2]), open));
  }

  const Body& body_;
  double scale_;
  const Grid& grid_;
  std::vector<float>& hu_;
  std::vector<std::uint8_t>& labels_;
};

std::vector<float> gaussian(double sigma_voxels) {
  const int reach = std::max(1, static_cast<int>(std::ceil(3.0 * sigma_voxels)));
  std::vector<float> kernel;
  double sum = 0.0;
  for (int i = -reach; i <= reach; ++i) {
    const double w = std::exp(-0.5 * i * i / (sigma_voxels * sigma_voxels));
    kernel.push_back(static_cast<float>(w));
    sum += w;
  }
  for (auto& w : kernel) w = static_cast<float>(w / sum);
  return kernel;
}

/// Convolves one line of `n` values `stride` apart, clamping at the ends.
void blur_line(float* line, int n, std::size_t stride, const std::vector<float>& kernel, std::vector<float>& copy) {
  const int reach = static_cast<int>(kernel.size() / 2);
  copy.resize(static_cast<std::size_t>(n) + 2 * reach);
  for (int i = -reach; i < n + reach; ++i) copy[i + reach] = line[std::clamp(i, 0, n - 1) * stride];
  for (int i = 0; i < n; ++i) {
    float sum = 0.0f;
    for (std::size_t k = 0; k < kernel.size(); ++k) sum += kernel[k] * copy[i + k];
    line[i * stride] = sum;
  }
}

void blur(std::vector<float>& hu, const Grid& grid) {
  const auto plane = gaussian(kBlurInPlane / grid.spacing[0]);
  const auto axial = gaussian(kBlurAxial / grid.spacing[2]);
  const auto row = static_cast<std::size_t>(grid.size[0]);
  in_parallel(grid.size[2], [&](int z) {
    std::vector<float> copy;
    for (int y = 0; y < grid.size[1]; ++y) blur_line(&hu[grid.index(0, y, z)], grid.size[0], 1, plane, copy);
    for (int x = 0; x < grid.size[0]; ++x) blur_line(&hu[grid.index(x, 0, z)], grid.size[1], row, plane, copy);
  });
  in_parallel(grid.size[1], [&](int y) {
    std::vector<float> copy;
    for (int x = 0; x < grid.size[0]; ++x)
      blur_line(&hu[grid.index(x, y, 0)], grid.size[2], row * grid.size[1], axial, copy);
  });
}

std::uint64_t mix(std::uint64_t z) {
  z += 0x9E3779B97F4A7C15ull;
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ull;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EBull;
  return z ^ (z >> 31);
}

/// Normal noise of one slice, slightly grainy as reconstructed CT is: white noise through a 3 x 3 kernel whose gain is
/// divided out. It depends on seed and slice only, not on threads.
std::vector<float> noise_of_slice(std::uint64_t seed, int slice, int width, int height, double sigma) {
  const int w = width + 2;
  const int h = height + 2;
  std::vector<float> white(static_cast<std::size_t>(w) * h + 1);
  std::uint64_t state = mix(mix(seed) ^ (static_cast<std::uint64_t>(slice) + 1));
  for (std::size_t i = 0; i + 1 < white.size(); i += 2) {
    state = mix(state);
    const double u = (static_cast<double>(state >> 40) + 0.5) * 0x1.0p-24;
    const double a = static_cast<double>(state & 0xFFFFFF) * 0x1.0p-24 * 6.283185307179586;
    const double r = std::sqrt(-2.0 * std::log(u));
    white[i] = static_cast<float>(r * std::cos(a));
    white[i + 1] = static_cast<float>(r * std::sin(a));
  }
  constexpr double kSide = 0.2;  // kernel (0.2, 0.6, 0.2) both ways; its gain is the sum of squares
  constexpr double kMiddle = 1.0 - 2.0 * kSide;
  constexpr double kGain = kMiddle * kMiddle + 2.0 * kSide * kSide;
  std::vector<float> result(static_cast<std::size_t>(width) * height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      double sum = 0.0;
      for (int j = 0; j < 3; ++j) {
        const float* line = &white[static_cast<std::size_t>(y + j) * w + x];
        const double across = kSide * (line[0] + line[2]) + kMiddle * line[1];
        sum += (j == 1 ? kMiddle : kSide) * across;
      }
      result[static_cast<std::size_t>(y) * width + x] = static_cast<float>(sigma / kGain * sum);
    }
  return result;
}

}  // namespace

ManikinScan scan_manikin(const ManikinOptions& options, const ManikinProgress& progress) {
  check_range("a weight", options.weight_kg, kLightest, kHeaviest, "kg");
  check_range("noise", options.noise_hu, 0.0, 200.0, "HU");
  if (options.in_plane_mm != 0.0) check_range("a pixel spacing", options.in_plane_mm, 0.4, 0.6, "mm");
  if (options.slice_mm != 0.0) check_range("a slice spacing", options.slice_mm, 0.6, 1.0, "mm");
  const auto report = [&](const char* stage, double fraction) {
    if (progress) progress(stage, fraction);
  };
  report("shaping the anatomy", 0.0);
  const Manikin man(options.weight_kg, options.seed, options.shape);
  ManikinScan scan;
  scan.labels = Labels(grid_for(options, man));
  const Grid& grid = scan.labels.grid;
  std::vector<float> hu(grid.count());

  constexpr std::array<int, 3> kBlock{16, 16, 9};
  const int columns = (grid.size[0] + kBlock[0] - 1) / kBlock[0];
  const int rows = (grid.size[1] + kBlock[1] - 1) / kBlock[1];
  const int layers = (grid.size[2] + kBlock[2] - 1) / kBlock[2];
  const Voxeliser voxeliser(man.data().body, man.scale(), grid, hu, scan.labels.voxels);
  std::mutex guard;
  int done = 0;
  in_parallel(rows * layers, [&](int i) {
    for (int c = 0; c < columns; ++c)
      voxeliser.block({c * kBlock[0], (i % rows) * kBlock[1], (i / rows) * kBlock[2]}, kBlock, Body::Open().set());
    const std::lock_guard<std::mutex> lock(guard);
    report("scanning", 0.9 * ++done / (rows * layers));
  });
  report("scanner blur and noise", 0.9);
  blur(hu, grid);
  scan.ct = Hounsfield(grid);
  in_parallel(grid.size[2], [&](int z) {
    const auto noise = noise_of_slice(options.seed, z, grid.size[0], grid.size[1], options.noise_hu);
    const std::size_t first = grid.index(0, 0, z);
    for (std::size_t i = 0; i < noise.size(); ++i)
      scan.ct.voxels[first + i] =
          static_cast<std::int16_t>(std::lround(std::clamp(hu[first + i] + noise[i], -1024.0f, 3071.0f)));
  });
  report("scanner blur and noise", 1.0);
  return scan;
}

}  // namespace vallecula::pipeline
