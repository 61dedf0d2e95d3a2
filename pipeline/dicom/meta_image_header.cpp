// MetaImage (itk.org/Wiki/ITK/MetaIO): lines "Key = value", the last of them ElementDataFile; axes are LPS.
#include <map>

#include "pipeline/dicom/series_error.h"
#include "pipeline/dicom/text_header.h"
#include "pipeline/dicom/volume_header.h"

namespace vallecula::pipeline {
namespace {

VoxelType type_of(const std::string& name) {
  static const std::map<std::string, VoxelType> kTypes = {
      {"MET_CHAR", VoxelType::int8},     {"MET_UCHAR", VoxelType::uint8},   {"MET_SHORT", VoxelType::int16},
      {"MET_USHORT", VoxelType::uint16}, {"MET_INT", VoxelType::int32},     {"MET_UINT", VoxelType::uint32},
      {"MET_FLOAT", VoxelType::float32}, {"MET_DOUBLE", VoxelType::float64}};
  const auto found = kTypes.find(name);
  if (found == kTypes.end()) throw SeriesError("its voxels are of a kind no CT has; export the CT itself");
  return found->second;
}

}  // namespace

bool is_meta_image(std::string_view bytes) {
  const auto head = bytes.substr(0, 1024);
  return head.find("ElementType") != std::string_view::npos || head.find("NDims") != std::string_view::npos;
}

VolumeHeader meta_image_header(std::string_view bytes) {
  std::map<std::string, std::string> fields;
  std::size_t at = 0;
  for (int line_number = 0; fields.count("ElementDataFile") == 0; ++line_number) {
    const auto end = std::min(bytes.find('\n', at), bytes.size());
    if (at >= bytes.size() || end - at > 65536 || line_number > 4096)
      throw SeriesError("its header is cut short; copy the file again");
    const auto line = bytes.substr(at, end - at);
    at = std::min(end + 1, bytes.size());
    const auto equals = line.find('=');
    if (equals != std::string_view::npos) fields[stripped(line.substr(0, equals))] = stripped(line.substr(equals + 1));
  }
  const auto is_true = [&](const char* key) { return lower_case(fields[key]) == "true"; };
  const auto numbers = [&](std::initializer_list<const char*> keys, std::vector<double> otherwise) {
    for (const char* key : keys) {
      if (fields.count(key) == 0) continue;
      auto values = numbers_in(fields[key]);
      if (values.size() != otherwise.size()) throw SeriesError("its header is damaged; export it again");
      return values;
    }
    return otherwise;
  };
  VolumeHeader header;
  if (fields["NDims"] != "3") throw SeriesError("is no volume of three dimensions; export the CT as one volume");
  if (fields.count("ElementNumberOfChannels") != 0 && fields["ElementNumberOfChannels"] != "1")
    throw SeriesError("its voxels are of a kind no CT has; export the CT itself");
  if (fields.count("BinaryData") != 0 && !is_true("BinaryData"))
    throw SeriesError("its voxels are written as text; save it in binary form");
  int sizes[3];
  sizes_in(fields["DimSize"], sizes);
  header.type = type_of(fields["ElementType"]);
  header.big_endian = is_true("BinaryDataByteOrderMSB") || is_true("ElementByteOrderMSB");
  header.packed = is_true("CompressedData");
  if (fields["ElementDataFile"] == "LOCAL") {
    header.data_at = at;
  } else {
    header.data_file = file_beside(fields["ElementDataFile"]);
    if (header.data_file == "LIST" || header.data_file.find('%') != std::string::npos)
      throw SeriesError("is spread over several files; save it as one .mha file");
    const double skip = numbers({"HeaderSize"}, {0.0})[0];
    header.data_at_end = skip == -1.0;
    if (skip > 0.0 && skip < 1e9) header.data_at = static_cast<std::size_t>(skip);
  }
  const auto spacing = numbers({"ElementSpacing", "ElementSize"}, {1, 1, 1});
  const auto origin = numbers({"Offset", "Position", "Origin"}, {0, 0, 0});
  const auto matrix = numbers({"TransformMatrix", "Rotation", "Orientation"}, {1, 0, 0, 0, 1, 0, 0, 0, 1});
  for (int k = 0; k < 3; ++k) {
    header.geometry.size[k] = sizes[k];
    header.geometry.origin[k] = origin[k];
    for (int a = 0; a < 3; ++a) header.geometry.step[k][a] = matrix[3 * k + a] * spacing[k];
  }
  check_volume_header(header);
  return header;
}

}  // namespace vallecula::pipeline
