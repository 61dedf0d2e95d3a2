// The built-in patient: head and airway of a newborn infant, from a weight and a seed, and its CT series.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/package/label_map.h"
#include "pipeline/package/patient_package.h"

namespace vallecula::pipeline {

/// What a scenario asks of one infant instead of what its seed draws. Nothing given: the seed's.
struct ManikinShape {
  std::optional<double> mouth_opening;      ///< factor on the design's (22 mm at term), 0.8 .. 1.15
  std::optional<double> tongue_size;        ///< factor on the design's width and height, 0.9 .. 1.1
  std::optional<double> larynx_height_mm;   ///< to the head from the design's, in a term infant: -3 .. 1.5
  std::optional<double> epiglottis_length;  ///< factor on the design's, 0.8 .. 1.2
  std::optional<double> gestation_weeks;    ///< 22 .. 44: sets the way from the cords to the carina
};

struct ManikinOptions {
  double weight_kg = 3.2;    ///< 0.6 .. 4.5
  std::uint64_t seed = 1;    ///< 0 is the unvaried design; any other seed is one infant of that weight
  double noise_hu = 12.0;    ///< standard deviation in a uniform region, 0 .. 200
  double in_plane_mm = 0.0;  ///< 0.4 .. 0.6; 0 chooses 0.5, and 0.4 below 2 kg
  double slice_mm = 0.0;     ///< 0.6 .. 1.0; 0 chooses 0.8, and 0.6 below 2 kg
  ManikinShape shape{};
};

/// Smallest and largest weight the manikin is made for, kg.
constexpr double kLightest = 0.6;
constexpr double kHeaviest = 4.5;

/// The true anatomy, free of voxels. Points are LPS mm with the origin at the upper gum's midline.
class Manikin {
 public:
  /// Throws std::runtime_error for a weight outside kLightest .. kHeaviest and for a shape out of its range.
  explicit Manikin(double weight_kg = 3.2, std::uint64_t seed = 1, const ManikinShape& shape = {});
  ~Manikin();
  Manikin(Manikin&&) noexcept;
  Manikin& operator=(Manikin&&) noexcept;

  /// Lengths relative to the term infant of 3.2 kg.
  double scale() const;
  Label label_at(const Point& p) const;
  /// Hounsfield units of what lies at the point; no blur, no noise.
  double hounsfield_at(const Point& p) const;
  /// Every name of kLandmarks.
  std::map<std::string, Point> landmarks() const;
  /// Outline of the glottic opening in its plane, ordered.
  std::vector<Point> glottis_outline() const;

  /// Fraction of the glottic opening (by area) that the operator's eye sees when the tongue base is lifted by
  /// `lift_mm` along the handle: rays past lips, gums, palate, larynx, and the tongue and epiglottis as they then are.
  double glottis_seen(double lift_mm) const;
  /// The same along the opening's midline alone: POGO as a length, 0 .. 1.
  double glottis_seen_midline(double lift_mm) const;

  /// Distance of the line of sight (operator's eye to glottis centre) from a part, mm; negative when it is in the way.
  /// Parts: upper_lip, upper_gum, hard_palate, lower_gum, arytenoids, nose, posterior_wall, soft_palate, tongue,
  /// epiglottis. `lift_mm` moves the last two.
  double sight_clearance(const std::string& part, double lift_mm = 0.0) const;

  struct Data;
  const Data& data() const { return *data_; }

 private:
  std::unique_ptr<Data> data_;
};

/// A CT volume of a manikin and its true labels, on one grid.
struct ManikinScan {
  Hounsfield ct;
  Labels labels;
};

/// Called with what is being done and the share done, 0 .. 1, never falling. Calls come one at a time, but while voxels
/// are made from worker threads. What it throws ends the work and reaches the caller.
using ManikinProgress = std::function<void(const std::string& stage, double fraction)>;

/// Voxelises with partial volume, scanner blur and noise. The same options give the same voxels.
/// Throws std::runtime_error for options out of range.
ManikinScan scan_manikin(const ManikinOptions& options, const ManikinProgress& progress = {});

/// Writes DIR/*.dcm (CT Image Storage) and DIR/truth.nrrd. DIR must not exist or be empty; it is written aside and
/// renamed when whole. Throws std::runtime_error with one message for a person, and then leaves nothing behind.
void write_manikin(const ManikinOptions& options, const std::filesystem::path& dir,
                   const ManikinProgress& progress = {});

}  // namespace vallecula::pipeline
