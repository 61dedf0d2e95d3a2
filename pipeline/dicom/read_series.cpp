#include "pipeline/dicom/read_series.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "pipeline/dicom/slice.h"
#include "pipeline/dicom/to_patient_axes.h"

namespace vallecula::pipeline {
namespace {

namespace fs = std::filesystem;

constexpr int kFewestSlices = 16;

std::string name_of(const fs::path& file) { return file.filename().string(); }

std::vector<fs::path> files_in(const fs::path& folder) {
  if (!fs::exists(folder)) throw SeriesError("series " + folder.string() + ": there is no such folder; check the name");
  if (!fs::is_directory(folder)) {
    throw SeriesError("series " + folder.string() + ": is a file; name the folder that holds the whole series");
  }
  std::vector<fs::path> files;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    if (entry.is_regular_file() && name_of(entry.path()) != "DICOMDIR") files.push_back(entry.path());
  }
  if (error)
    throw SeriesError("series " + folder.string() + ": cannot be listed (" + error.message() +
                      "); check the permissions");
  std::sort(files.begin(), files.end());
  if (files.empty())
    throw SeriesError("series " + folder.string() + ": the folder is empty; name a folder with a CT series");
  return files;
}

/// The files of the one CT series meant.
std::vector<fs::path> choose_series(const fs::path& folder, std::vector<std::string>& notes) {
  std::map<std::string, std::vector<fs::path>> series;
  std::map<std::string, int> other_modalities;
  for (const auto& file : files_in(folder)) {
    const auto header = read_slice_header(file);
    if (!header || !header->has_pixels) continue;
    if (header->modality != "CT") {
      ++other_modalities[header->modality];
      continue;
    }
    if (header->frames > 1) {
      throw SeriesError("file " + name_of(file) +
                        ": is a multi-frame image; export the series as one file a slice (CT Image Storage)");
    }
    series[header->series].push_back(file);
  }
  if (series.empty() && !other_modalities.empty()) {
    throw SeriesError("series " + folder.string() + ": its modality is " + other_modalities.begin()->first +
                      ", not CT; name the folder of a CT series, for only its values are Hounsfield units");
  }
  if (series.empty()) {
    throw SeriesError("series " + folder.string() +
                      ": no DICOM images in this folder; name the folder that holds the series' files");
  }
  auto largest = series.begin();
  for (auto it = series.begin(); it != series.end(); ++it) {
    if (it->second.size() > largest->second.size()) largest = it;
  }
  for (auto it = series.begin(); it != series.end(); ++it) {
    if (it == largest) continue;
    // A scout or a dose page beside the series is common; two stacks are a question only a person can answer.
    if (it->second.size() * 4 > largest->second.size()) {
      throw SeriesError("series " + folder.string() + ": the folder holds " + std::to_string(series.size()) +
                        " CT series; put the one meant into a folder of its own");
    }
    notes.push_back(std::to_string(it->second.size()) + " files of another CT series in the folder were left out");
  }
  if (static_cast<int>(largest->second.size()) < kFewestSlices) {
    throw SeriesError("series " + folder.string() + ": only " + std::to_string(largest->second.size()) +
                      " slices; at least " + std::to_string(kFewestSlices) +
                      " are needed, from the nose to the carina; export the whole series");
  }
  return largest->second;
}

void check_same_geometry(const Slice& first, const Slice& other) {
  if (other.columns != first.columns || other.rows != first.rows) {
    throw SeriesError("file " + name_of(other.file) + ": its matrix differs from that of " + name_of(first.file) +
                      "; take it out of the folder, or export the series with one size");
  }
  for (int a = 0; a < 3; ++a) {
    if (std::abs(other.row[a] - first.row[a]) > 1e-3 || std::abs(other.column[a] - first.column[a]) > 1e-3) {
      throw SeriesError("file " + name_of(other.file) + ": its orientation differs from that of " +
                        name_of(first.file) + "; take it out of the folder (is it a scout?)");
    }
  }
  for (int a = 0; a < 2; ++a) {
    if (std::abs(other.spacing[a] - first.spacing[a]) > 1e-3 * first.spacing[a]) {
      throw SeriesError("file " + name_of(other.file) + ": its PixelSpacing differs from that of " +
                        name_of(first.file) + "; take it out of the folder, or export the series with one spacing");
    }
  }
}

std::array<double, 3> normal_of(const Slice& s) {
  return {s.row[1] * s.column[2] - s.row[2] * s.column[1], s.row[2] * s.column[0] - s.row[0] * s.column[2],
          s.row[0] * s.column[1] - s.row[1] * s.column[0]};
}

double along(const std::array<double, 3>& normal, const Slice& s) {
  return std::inner_product(normal.begin(), normal.end(), s.position.begin(), 0.0);
}

/// Distance between neighbours, checked to be the same throughout.
double even_spacing(const std::vector<Slice>& slices, const std::array<double, 3>& normal) {
  std::vector<double> gaps;
  for (std::size_t k = 1; k < slices.size(); ++k)
    gaps.push_back(along(normal, slices[k]) - along(normal, slices[k - 1]));
  auto sorted = gaps;
  std::nth_element(sorted.begin(), sorted.begin() + sorted.size() / 2, sorted.end());
  const double usual = sorted[sorted.size() / 2];
  for (std::size_t k = 0; k < gaps.size(); ++k) {
    const auto pair = name_of(slices[k].file) + " and " + name_of(slices[k + 1].file);
    if (gaps[k] < 1e-3) throw SeriesError("files " + pair + ": lie at the same position; keep one of them");
    if (std::abs(gaps[k] - usual) > std::max(0.02 * usual, 0.02)) {
      throw SeriesError("files " + pair + ": lie " + std::to_string(gaps[k]) + " mm apart where the others lie " +
                        std::to_string(usual) +
                        " mm apart; a slice is missing or the series was merged from two: export it again");
    }
  }
  return (along(normal, slices.back()) - along(normal, slices.front())) / static_cast<double>(slices.size() - 1);
}

void check_hounsfield(const Hounsfield& hu, const fs::path& folder) {
  std::size_t air = 0;
  std::size_t soft = 0;
  for (const auto v : hu.voxels) {
    air += v < -700 ? 1 : 0;
    soft += v > -150 && v < 200 ? 1 : 0;
  }
  if (air * 200 < hu.voxels.size() || soft * 200 < hu.voxels.size()) {
    throw SeriesError(
        "series " + folder.string() +
        ": its values do not look like Hounsfield units (air near -1000, tissue near 0); export the original series");
  }
}

}  // namespace

CtSeries read_ct_series(const fs::path& folder, const std::function<void(double)>& progress) {
  CtSeries series;
  const auto files = choose_series(folder, series.notes);
  std::vector<Slice> slices;
  slices.reserve(files.size());
  for (const auto& file : files) {
    slices.push_back(read_slice(file));
    check_same_geometry(slices.front(), slices.back());
    if (progress) progress(0.9 * static_cast<double>(slices.size()) / static_cast<double>(files.size()));
  }
  const auto normal = normal_of(slices.front());
  std::stable_sort(slices.begin(), slices.end(),
                   [&](const Slice& a, const Slice& b) { return along(normal, a) < along(normal, b); });
  series.slices = static_cast<int>(slices.size());
  series.matrix = {slices.front().columns, slices.front().rows};
  series.source_spacing = {slices.front().spacing[0], slices.front().spacing[1], even_spacing(slices, normal)};
  series.hu = to_patient_axes(slices, series.resampled);
  if (series.resampled)
    series.notes.push_back("the series was oblique or tilted and was resampled onto the patient's axes");
  check_hounsfield(series.hu, folder);
  if (progress) progress(1.0);
  return series;
}

}  // namespace vallecula::pipeline
