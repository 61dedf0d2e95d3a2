#include "pipeline/dicom/read_place.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "pipeline/dicom/decode.h"
#include "pipeline/dicom/limits.h"
#include "pipeline/dicom/mapped_file.h"
#include "pipeline/dicom/series_error.h"
#include "pipeline/dicom/volume_file.h"

namespace vallecula::pipeline {
namespace {

constexpr int kThumbnailSide = 128;

std::vector<Picture> scan(const FileList& files, ReadHost& host) {
  std::vector<Picture> pictures;
  for (int f = 0; f < files.count(); ++f) {
    host.at_file(files.name(f));
    try {
      const MappedFile map(files.path(f));
      auto found = read_pictures(map.bytes(), f);
      if (found.empty() && (!files.is_folder() || files.path(f).extension() == ".dcm")) {
        Picture p;
        p.file = f;
        p.modality = "CT";
        p.fault = "is no DICOM file; copy it again or take it out of the folder";
        found.push_back(p);
      }
      pictures.insert(pictures.end(), found.begin(), found.end());
    } catch (const std::bad_alloc&) {
      throw SeriesError(files.name(f) + ": asks for more memory than a CT needs; is it damaged?");
    } catch (const std::exception& e) {
      Picture p;
      p.file = f;
      p.modality = "CT";
      p.fault = e.what();
      if (files.path(f).extension() == ".dcm" || !files.is_folder()) pictures.push_back(p);
    }
    host.alive(0.2 * (f + 1) / files.count());
  }
  if (pictures.empty())
    throw SeriesError(
        "series: no DICOM images in this folder; name the folder that holds the series' files, or a "
        "NIfTI, NRRD or MetaImage file itself");
  return pictures;
}

/// The middle slice of a CT that is seen from the feet. Other directions would show a profile of the face: none.
Thumbnail thumbnail_of(const FileList& files, const SeriesGroup& group, ReadHost& host) {
  const auto& g = group.plan.geometry;
  if (!group.readable || group.entry.orientation.rfind("axial", 0) != 0) return {};
  const SharedMemory memory(sizeof(std::int16_t) * static_cast<std::size_t>(g.size[0]) * g.size[1]);
  const auto* hu = static_cast<std::int16_t*>(memory.data());
  try {
    host.at_file(
        files.name(group.pictures[group.plan.places[static_cast<std::size_t>(group.slices() / 2)].front()].file));
    decode(files, group, {group.slices() / 2}, Padding::to_air, static_cast<std::int16_t*>(memory.data()),
           [&](double) { host.alive(0.5); });
  } catch (const SeriesError&) {
    return {};  // the reading itself will say why
  }
  const double wide = g.size[0] * norm(g.step[0]);
  const double high = g.size[1] * norm(g.step[1]);
  const double scale = kThumbnailSide / std::max(wide, high);
  Thumbnail t;
  t.width = std::clamp(static_cast<int>(std::lround(wide * scale)), 1, kThumbnailSide);
  t.height = std::clamp(static_cast<int>(std::lround(high * scale)), 1, kThumbnailSide);
  // A row runs to the patient's left and a column to the back in the usual axial slice; others are turned over.
  const bool flip_x = g.step[0][0] < 0.0;
  const bool flip_y = g.step[1][1] < 0.0;
  for (int y = 0; y < t.height; ++y) {
    for (int x = 0; x < t.width; ++x) {
      const int from_x = flip_x ? t.width - 1 - x : x;
      const int from_y = flip_y ? t.height - 1 - y : y;
      const int i0 = from_x * g.size[0] / t.width;
      const int i1 = std::max(i0 + 1, (from_x + 1) * g.size[0] / t.width);
      const int j0 = from_y * g.size[1] / t.height;
      const int j1 = std::max(j0 + 1, (from_y + 1) * g.size[1] / t.height);
      double sum = 0.0;
      for (int j = j0; j < j1; ++j) {
        for (int i = i0; i < i1; ++i)
          sum += std::clamp<int>(hu[static_cast<std::size_t>(j) * g.size[0] + i], -160, 240);
      }
      const double mean = sum / ((i1 - i0) * (j1 - j0));
      t.grey.push_back(static_cast<std::uint8_t>(std::lround((mean + 160.0) * 255.0 / 400.0)));
    }
  }
  return t;
}

void note_clamped(std::size_t clamped, std::vector<std::string>& notes) {
  if (clamped > 0)
    notes.push_back(std::to_string(clamped) +
                    " voxels lay outside -32768 to 32767 HU and were set to the nearer of these");
}

void read_group(const FileList& files, const SeriesGroup& group, Padding padding, ReadHost& host, ReadAnswer& answer) {
  const auto& plan = group.plan;
  const auto& g = plan.geometry;
  const std::size_t slice = static_cast<std::size_t>(g.size[0]) * g.size[1];
  std::vector<int> places(plan.places.size());
  for (std::size_t i = 0; i < places.size(); ++i) places[i] = static_cast<int>(i);
  std::int16_t* out = host.voxels(g.count());
  const auto alive = [&](double f) { host.alive(0.2 + 0.8 * f); };
  Decoded decoded;
  if (!plan.interpolated()) {
    decoded = decode(files, group, places, padding, out, alive);
  } else {
    const SharedMemory memory(sizeof(std::int16_t) * slice * places.size());
    const auto* source = static_cast<const std::int16_t*>(memory.data());
    decoded = decode(files, group, places, padding, static_cast<std::int16_t*>(memory.data()), alive);
    for (std::size_t k = 0; k < plan.sources.size(); ++k) {
      const auto [place, share] = plan.sources[k];
      const auto* below = source + slice * static_cast<std::size_t>(place);
      if (share == 0.0) {
        std::memcpy(out + slice * k, below, slice * sizeof(std::int16_t));
        continue;
      }
      for (std::size_t i = 0; i < slice; ++i)
        out[slice * k + i] =
            static_cast<std::int16_t>(std::lround((1.0 - share) * below[i] + share * below[slice + i]));
    }
  }
  answer.geometry = g;
  answer.slices = group.slices();
  answer.notes = plan.notes;
  if (decoded.doubles > 0)
    answer.notes.push_back(std::to_string(decoded.doubles) +
                           " pictures were there twice, the same at the same position; one of each was kept");
  note_clamped(decoded.clamped, answer.notes);
}

SeriesEntry entry_of(const VolumeHeader& header) {
  const auto& g = header.geometry;
  SeriesEntry entry;
  entry.number = 1;
  entry.modality = "volume";
  entry.size = g.size;
  entry.spacing = {norm(g.step[0]), norm(g.step[1]), norm(g.step[2])};
  entry.orientation = orientation_words(g);
  if (g.size[2] < kFewestSlices)
    entry.reason = "only " + std::to_string(g.size[2]) + " slices";
  else if (*std::max_element(entry.spacing.begin(), entry.spacing.end()) > kCoarsestSliceMm + kExactMm)
    entry.reason =
        "too coarse: voxels of " + millimetres_text(*std::max_element(entry.spacing.begin(), entry.spacing.end()));
  entry.usable = entry.reason.empty();
  return entry;
}

/// A single file that is a volume; false when it is none.
bool read_volume_file(const FileList& files, const ReadRequest& request, ReadHost& host, ReadAnswer& answer) {
  if (files.is_folder()) return false;
  host.at_file(files.name(0));
  try {
    const MappedFile map(files.path(0));
    const auto header = volume_header(map.bytes());
    if (!header) return false;
    const auto entry = entry_of(*header);
    answer.entries = {entry};
    if (request.list) return true;
    if (!request.choice.empty() && request.choice != "1") throw SeriesError("holds one volume; leave --series out");
    if (request.purpose == Purpose::import && !entry.usable)
      throw SeriesError(entry.reason + "; export the CT with at least " + std::to_string(kFewestSlices) +
                        " slices, at most " + millimetres_text(kCoarsestSliceMm) + " apart");
    auto* out = host.voxels(header->geometry.count());
    const auto beat = [&](double f) { host.alive(f); };
    std::size_t clamped = 0;
    if (header->data_file.empty()) {
      clamped = read_voxels(*header, map.bytes(), out, beat);
    } else {
      const MappedFile data(files.path(0).parent_path() / header->data_file);
      clamped = read_voxels(*header, data.bytes(), out, beat);
    }
    answer.geometry = header->geometry;
    answer.slices = header->geometry.size[2];
    note_clamped(clamped, answer.notes);
    return true;
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& e) {
    throw SeriesError(files.name(0) + ": " + e.what());
  }
}

}  // namespace

ReadAnswer read_place(const ReadRequest& request, ReadHost& host) {
  ReadAnswer answer;
  const FileList files(request.place);
  if (read_volume_file(files, request, host, answer)) return answer;
  auto groups = group_pictures(scan(files, host), files);
  if (request.list) {
    for (auto& group : groups) {
      if (request.thumbnails) group.entry.thumbnail = thumbnail_of(files, group, host);
      answer.entries.push_back(group.entry);
    }
    return answer;
  }
  read_group(files, choose(groups, request.choice, request.purpose), request.padding, host, answer);
  return answer;
}

}  // namespace vallecula::pipeline
