// NRRD (teem.sourceforge.net/nrrd/format.html): lines of text up to an empty one.
#include <map>

#include "pipeline/dicom/series_error.h"
#include "pipeline/dicom/text_header.h"
#include "pipeline/dicom/volume_header.h"

namespace vallecula::pipeline {
namespace {

VoxelType nrrd_type(const std::string& name) {
  static const std::map<std::string, VoxelType> kTypes = {{"signed char", VoxelType::int8},
                                                          {"int8", VoxelType::int8},
                                                          {"int8_t", VoxelType::int8},
                                                          {"uchar", VoxelType::uint8},
                                                          {"unsigned char", VoxelType::uint8},
                                                          {"uint8", VoxelType::uint8},
                                                          {"uint8_t", VoxelType::uint8},
                                                          {"short", VoxelType::int16},
                                                          {"short int", VoxelType::int16},
                                                          {"signed short", VoxelType::int16},
                                                          {"signed short int", VoxelType::int16},
                                                          {"int16", VoxelType::int16},
                                                          {"int16_t", VoxelType::int16},
                                                          {"ushort", VoxelType::uint16},
                                                          {"unsigned short", VoxelType::uint16},
                                                          {"unsigned short int", VoxelType::uint16},
                                                          {"uint16", VoxelType::uint16},
                                                          {"uint16_t", VoxelType::uint16},
                                                          {"int", VoxelType::int32},
                                                          {"signed int", VoxelType::int32},
                                                          {"int32", VoxelType::int32},
                                                          {"int32_t", VoxelType::int32},
                                                          {"uint", VoxelType::uint32},
                                                          {"unsigned int", VoxelType::uint32},
                                                          {"uint32", VoxelType::uint32},
                                                          {"uint32_t", VoxelType::uint32},
                                                          {"float", VoxelType::float32},
                                                          {"double", VoxelType::float64}};
  const auto found = kTypes.find(name);
  if (found == kTypes.end()) throw SeriesError("its voxels are of a kind no CT has; export the CT itself");
  return found->second;
}

/// Which of x and y must change sign to become LPS.
std::array<double, 3> signs_of(const std::string& space) {
  if (space == "left-posterior-superior" || space == "lps") return {1, 1, 1};
  if (space == "right-anterior-superior" || space == "ras") return {-1, -1, 1};
  if (space == "left-anterior-superior" || space == "las") return {1, -1, 1};
  throw SeriesError("does not say which side is left (its field `space`); export it with its orientation");
}

}  // namespace

bool is_nrrd(std::string_view bytes) { return bytes.substr(0, 7) == "NRRD000"; }

VolumeHeader nrrd_header(std::string_view bytes) {
  std::map<std::string, std::string> fields;
  std::size_t at = 0;
  bool ended = false;
  for (int line_number = 0; at < bytes.size() && line_number < 4096; ++line_number) {
    const auto end = bytes.find('\n', at);
    if (end == std::string_view::npos || end - at > 65536) break;
    const auto line = stripped(bytes.substr(at, end - at));
    at = end + 1;
    if (line.empty()) {
      ended = true;
      break;
    }
    if (line_number == 0 || line[0] == '#') continue;
    if (line.rfind("Segment0_", 0) == 0) throw SeriesError("is a segmentation, not a CT; name the CT's file");
    const auto colon = line.find(": ");
    if (colon != std::string::npos && line.find(":=") > colon)
      fields[lower_case(line.substr(0, colon))] = stripped(line.substr(colon + 2));
  }
  VolumeHeader header;
  header.data_file = fields.count("data file") != 0 ? fields["data file"] : fields["datafile"];
  if (!header.data_file.empty()) header.data_file = file_beside(header.data_file);
  if (!ended && header.data_file.empty()) throw SeriesError("its header is cut short; copy the file again");
  if (fields["dimension"] != "3") throw SeriesError("is no volume of three dimensions; export the CT as one volume");
  int sizes[3];
  sizes_in(fields["sizes"], sizes);
  header.type = nrrd_type(lower_case(fields["type"]));
  header.big_endian = fields["endian"] == "big";
  const auto encoding = lower_case(fields["encoding"]);
  header.packed = encoding == "gzip" || encoding == "gz";
  if (!header.packed && encoding != "raw")
    throw SeriesError("its encoding is neither raw nor gzip; save it as one of them");
  header.data_at = header.data_file.empty() ? at : 0;
  if (fields.count("line skip") != 0 && fields["line skip"] != "0")
    throw SeriesError("its data file has lines to skip; save it as one .nrrd file");
  if (const auto skip = numbers_in(fields["byte skip"]); skip.size() == 1 && skip[0] != 0.0) {
    if (skip[0] == -1.0 && !header.packed)
      header.data_at_end = true;
    else if (skip[0] > 0.0 && skip[0] < 1e9 && !header.packed)
      header.data_at += static_cast<std::size_t>(skip[0]);
    else
      throw SeriesError("its data file has bytes to skip; save it as one .nrrd file");
  }
  const auto signs = signs_of(lower_case(fields["space"]));
  const auto directions = numbers_in(fields["space directions"]);
  const auto origin = numbers_in(fields["space origin"]);
  if (directions.size() != 9 || origin.size() != 3)
    throw SeriesError("does not say where it lies (space directions, space origin); export it with its orientation");
  for (int k = 0; k < 3; ++k) {
    header.geometry.size[k] = sizes[k];
    header.geometry.origin[k] = signs[k] * origin[k];
    for (int a = 0; a < 3; ++a) header.geometry.step[k][a] = signs[a] * directions[3 * k + a];
  }
  check_volume_header(header);
  return header;
}

}  // namespace vallecula::pipeline
