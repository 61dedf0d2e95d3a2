#include "pipeline/dicom/read_series.h"

#include "pipeline/dicom/ct_helper.h"
#include "pipeline/dicom/stack.h"
#include "pipeline/dicom/to_patient_axes.h"

namespace vallecula::pipeline {
namespace {

constexpr double kWorthSayingDegrees = 0.05;

CtVolume read(const std::filesystem::path& place, const std::string& choice, Purpose purpose, Padding padding,
              const std::function<void(double)>& progress) {
  ReadRequest request;
  request.place = place.string();
  request.choice = choice;
  request.purpose = purpose;
  request.padding = padding;
  auto result = run_ct_helper(request, progress);
  CtVolume volume;
  volume.geometry = result.answer.geometry;
  volume.voxels = std::move(result.voxels);
  volume.slices = result.answer.slices;
  volume.notes = std::move(result.answer.notes);
  return volume;
}

void check_hounsfield(const CtVolume& volume) {
  std::size_t air = 0;
  std::size_t soft = 0;
  const std::size_t count = volume.geometry.count();
  for (std::size_t i = 0; i < count; ++i) {
    const auto v = volume.voxels.get()[i];
    air += v < -700 ? 1 : 0;
    soft += v > -150 && v < 200 ? 1 : 0;
  }
  if (air * 200 < count || soft * 200 < count) {
    throw SeriesError(
        "series: its values do not look like Hounsfield units (air near -1000, tissue near 0); export the original "
        "series");
  }
}

}  // namespace

std::vector<SeriesEntry> list_series(const std::filesystem::path& place, bool thumbnails,
                                     const std::function<void(double)>& progress) {
  ReadRequest request;
  request.place = place.string();
  request.list = true;
  request.thumbnails = thumbnails;
  return run_ct_helper(request, progress).answer.entries;
}

CtVolume read_ct_volume(const std::filesystem::path& place, const std::string& choice,
                        const std::function<void(double)>& progress) {
  return read(place, choice, Purpose::volume, Padding::keep, progress);
}

CtSeries read_ct_series(const std::filesystem::path& place, const std::function<void(double)>& progress,
                        const std::string& choice) {
  auto volume = read(place, choice, Purpose::import, Padding::to_air, [&](double f) {
    if (progress) progress(0.9 * f);
  });
  check_hounsfield(volume);
  const auto& g = volume.geometry;
  CtSeries series;
  series.slices = volume.slices;
  series.matrix = {g.size[0], g.size[1]};
  const auto normal = cross(g.step[0], g.step[1]);
  series.source_spacing = {norm(g.step[0]), norm(g.step[1]), std::abs(dot(normal, g.step[2])) / norm(normal)};
  series.notes = std::move(volume.notes);
  series.hu = to_patient_axes(volume, series.resampled);
  if (const double tilt = tilt_degrees(g); series.resampled && tilt > kWorthSayingDegrees)
    series.notes.push_back("the gantry was tilted by " + degrees_text(tilt) + "; the shear was corrected");
  if (series.resampled)
    series.notes.push_back("the series was oblique or tilted and was resampled onto the patient's axes");
  if (progress) progress(1.0);
  return series;
}

}  // namespace vallecula::pipeline
