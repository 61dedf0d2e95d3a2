// NIfTI-1 (nifti1.h of the NIfTI Data Format Working Group): a header of 348 bytes; axes are RAS.
#include <algorithm>
#include <cmath>
#include <cstring>

#include "pipeline/dicom/series_error.h"
#include "pipeline/dicom/volume_header.h"

namespace vallecula::pipeline {
namespace {

constexpr std::size_t kHeaderBytes = 348;

class Fields {
 public:
  explicit Fields(std::string_view bytes) : bytes_(bytes) {
    swapped_ = get<std::int32_t>(0) != static_cast<std::int32_t>(kHeaderBytes);
  }
  bool swapped() const { return swapped_; }
  template <class T>
  T get(std::size_t at) const {
    char raw[sizeof(T)];
    std::memcpy(raw, bytes_.data() + at, sizeof(T));
    if (swapped_) std::reverse(raw, raw + sizeof(T));
    T value;
    std::memcpy(&value, raw, sizeof(T));
    return value;
  }
  double real(std::size_t at) const { return static_cast<double>(get<float>(at)); }

 private:
  std::string_view bytes_;
  bool swapped_ = false;
};

VoxelType type_of(int code) {
  switch (code) {
    case 2:
      return VoxelType::uint8;
    case 4:
      return VoxelType::int16;
    case 8:
      return VoxelType::int32;
    case 16:
      return VoxelType::float32;
    case 64:
      return VoxelType::float64;
    case 256:
      return VoxelType::int8;
    case 512:
      return VoxelType::uint16;
    case 768:
      return VoxelType::uint32;
    default:
      throw SeriesError("its voxels are of a kind no CT has (colour or complex); export the CT itself");
  }
}

/// Columns of the rotation times the voxel sizes (method 2 of nifti1.h), RAS.
void from_quaternion(const Fields& f, CtGeometry& g) {
  const double b = f.real(256);
  const double c = f.real(260);
  const double d = f.real(264);
  const double rest = 1.0 - (b * b + c * c + d * d);
  double a = std::sqrt(std::max(rest, 0.0));
  double n = std::sqrt(a * a + b * b + c * c + d * d);
  if (!(n > 0.0)) n = 1.0;
  const double q[4] = {a / n, b / n, c / n, d / n};
  const double qfac = f.real(76) < 0.0 ? -1.0 : 1.0;
  const double r[3][3] = {{q[0] * q[0] + q[1] * q[1] - q[2] * q[2] - q[3] * q[3], 2 * (q[1] * q[2] - q[0] * q[3]),
                           2 * (q[1] * q[3] + q[0] * q[2])},
                          {2 * (q[1] * q[2] + q[0] * q[3]), q[0] * q[0] + q[2] * q[2] - q[1] * q[1] - q[3] * q[3],
                           2 * (q[2] * q[3] - q[0] * q[1])},
                          {2 * (q[1] * q[3] - q[0] * q[2]), 2 * (q[2] * q[3] + q[0] * q[1]),
                           q[0] * q[0] + q[3] * q[3] - q[1] * q[1] - q[2] * q[2]}};
  for (int row = 0; row < 3; ++row) {
    for (int k = 0; k < 3; ++k)
      g.step[k][row] = r[row][k] * f.real(80 + 4 * static_cast<std::size_t>(k)) * (k == 2 ? qfac : 1.0);
    g.origin[row] = f.real(268 + 4 * static_cast<std::size_t>(row));
  }
}

void from_matrix(const Fields& f, CtGeometry& g) {
  for (int row = 0; row < 3; ++row) {
    const std::size_t at = 280 + 16 * static_cast<std::size_t>(row);
    for (int k = 0; k < 3; ++k) g.step[k][row] = f.real(at + 4 * static_cast<std::size_t>(k));
    g.origin[row] = f.real(at + 12);
  }
}

}  // namespace

bool is_nifti(std::string_view bytes) {
  if (bytes.size() < kHeaderBytes) return false;
  const auto magic = bytes.substr(344, 3);
  return magic == "n+1" || magic == "ni1";
}

VolumeHeader nifti_header(std::string_view bytes) {
  const Fields f(bytes);
  if (f.get<std::int32_t>(0) != static_cast<std::int32_t>(kHeaderBytes))
    throw SeriesError("its NIfTI header is damaged; copy the file again");
  if (bytes.substr(344, 3) == "ni1")
    throw SeriesError("is half of a pair of NIfTI files; save it as one .nii or .nii.gz");
  VolumeHeader header;
  const int dimensions = f.get<std::int16_t>(40);
  for (int k = 1; k < 8; ++k) {
    const int n = k <= dimensions ? f.get<std::int16_t>(40 + 2 * static_cast<std::size_t>(k)) : 1;
    if (k <= 3)
      header.geometry.size[k - 1] = n;
    else if (n > 1)
      throw SeriesError("holds several volumes (a fourth dimension); save the one meant by itself");
  }
  header.type = type_of(f.get<std::int16_t>(70));
  header.big_endian = f.swapped();
  const double at = f.real(108);
  if (!(at >= 348.0 && at < 1e9)) throw SeriesError("its NIfTI header is damaged; copy the file again");
  header.data_at = static_cast<std::size_t>(at);
  const double slope = f.real(112);
  if (slope != 0.0) {
    header.slope = slope;
    header.intercept = f.real(116);
  }
  if (f.get<std::int16_t>(254) > 0)
    from_matrix(f, header.geometry);
  else if (f.get<std::int16_t>(252) > 0)
    from_quaternion(f, header.geometry);
  else
    throw SeriesError(
        "does not say which side is left (neither sform nor qform); convert it from the DICOM series again");
  const int units = f.get<std::uint8_t>(123) & 7;
  const double to_mm = units == 1 ? 1000.0 : units == 3 ? 1e-3 : 1.0;
  for (int k = 0; k < 3; ++k) {
    for (int row = 0; row < 3; ++row) header.geometry.step[k][row] *= row < 2 ? -to_mm : to_mm;
    header.geometry.origin[k] *= k < 2 ? -to_mm : to_mm;
  }
  check_volume_header(header);
  return header;
}

}  // namespace vallecula::pipeline
