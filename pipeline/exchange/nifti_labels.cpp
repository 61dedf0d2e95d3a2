// NIfTI-1 and -2 in one file. RAS millimetres in the file, LPS here; the names are not in it.
#include <cmath>
#include <cstring>

#include "pipeline/exchange/label_readers.h"

namespace vallecula::pipeline {
namespace {

/// Numbers at fixed bytes of the header, in the file's byte order.
class Header {
 public:
  Header(std::string bytes, bool swapped) : bytes_(std::move(bytes)), swapped_(swapped) {}
  template <class T>
  T at(std::size_t offset) const {
    std::array<char, sizeof(T)> raw{};
    for (std::size_t i = 0; i < sizeof(T); ++i) raw[swapped_ ? sizeof(T) - 1 - i : i] = bytes_[offset + i];
    T value;
    std::memcpy(&value, raw.data(), sizeof(T));
    return value;
  }
  template <class T>
  Vector3 three(std::size_t offset) const {
    return {static_cast<double>(at<T>(offset)), static_cast<double>(at<T>(offset + sizeof(T))),
            static_cast<double>(at<T>(offset + 2 * sizeof(T)))};
  }

 private:
  std::string bytes_;
  bool swapped_;
};

/// What both versions say, in one form.
struct Nifti {
  std::array<std::int64_t, 8> dim{};
  int datatype = 0;
  double voxels_at = 0.0;
  double slope = 0.0;
  double intercept = 0.0;
  int qform = 0;
  int sform = 0;
  int units = 0;
  double handedness = 1.0;
  Vector3 pixdim{};
  Vector3 quaternion{};
  Vector3 offset{};
  std::array<Vector3, 3> rows{};
  Vector3 row_ends{};
};

template <class Real>
void read_frame(const Header& h, std::size_t quaternion, std::size_t rows, Nifti& n) {
  n.quaternion = h.three<Real>(quaternion);
  n.offset = h.three<Real>(quaternion + 3 * sizeof(Real));
  for (int r = 0; r < 3; ++r) {
    n.rows[r] = h.three<Real>(rows + r * 4 * sizeof(Real));
    n.row_ends[r] = h.at<Real>(rows + (r * 4 + 3) * sizeof(Real));
  }
}

Nifti parsed(const Header& h, bool second) {
  Nifti n;
  for (int a = 0; a < 8; ++a) n.dim[a] = second ? h.at<std::int64_t>(16 + 8 * a) : h.at<std::int16_t>(40 + 2 * a);
  if (second) {
    n.datatype = h.at<std::int16_t>(12);
    n.pixdim = h.three<double>(112);
    n.handedness = h.at<double>(104);
    n.voxels_at = static_cast<double>(h.at<std::int64_t>(168));
    n.slope = h.at<double>(176);
    n.intercept = h.at<double>(184);
    n.qform = h.at<std::int32_t>(344);
    n.sform = h.at<std::int32_t>(348);
    read_frame<double>(h, 352, 400, n);
    n.units = h.at<std::int32_t>(500) & 7;
  } else {
    n.datatype = h.at<std::int16_t>(70);
    n.pixdim = h.three<float>(80);
    n.handedness = h.at<float>(76);
    n.voxels_at = h.at<float>(108);
    n.slope = h.at<float>(112);
    n.intercept = h.at<float>(116);
    n.qform = h.at<std::int16_t>(252);
    n.sform = h.at<std::int16_t>(254);
    read_frame<float>(h, 256, 280, n);
    n.units = h.at<std::uint8_t>(123) & 7;
  }
  return n;
}

Element element_of(int datatype, const std::filesystem::path& file) {
  switch (datatype) {
    case 2:
      return Element::u8;
    case 4:
      return Element::i16;
    case 8:
      return Element::i32;
    case 16:
      return Element::f32;
    case 64:
      return Element::f64;
    case 256:
      return Element::i8;
    case 512:
      return Element::u16;
    case 768:
      return Element::u32;
    case 1024:
      return Element::i64;
    case 1280:
      return Element::u64;
    default:
      fail_label_file(file, "voxels of NIfTI type " + std::to_string(datatype) + "; expected whole numbers");
  }
}

/// Where the voxels lie: the sform if there is one, else the qform (the standard's own order for aligned images).
Placement placed(const Nifti& n, const std::filesystem::path& file) {
  Placement place;
  std::array<Vector3, 3> step{};  // RAS
  Vector3 origin{};
  if (n.sform > 0) {
    for (int a = 0; a < 3; ++a) step[a] = {n.rows[0][a], n.rows[1][a], n.rows[2][a]};
    origin = n.row_ends;
  } else if (n.qform > 0) {
    const auto [b, c, d] = n.quaternion;
    const double a = std::sqrt(std::max(0.0, 1.0 - b * b - c * c - d * d));
    const std::array<Vector3, 3> r = {{{a * a + b * b - c * c - d * d, 2 * (b * c - a * d), 2 * (b * d + a * c)},
                                       {2 * (b * c + a * d), a * a + c * c - b * b - d * d, 2 * (c * d - a * b)},
                                       {2 * (b * d - a * c), 2 * (c * d + a * b), a * a + d * d - b * b - c * c}}};
    for (int axis = 0; axis < 3; ++axis) {
      const double mm = n.pixdim[axis] * (axis == 2 && n.handedness < 0.0 ? -1.0 : 1.0);
      step[axis] = {mm * r[0][axis], mm * r[1][axis], mm * r[2][axis]};
    }
    origin = n.offset;
  } else {
    fail_label_file(file, "it does not say where its voxels lie in the patient (neither sform nor qform)");
  }
  const double mm = n.units == 1 ? 1000.0 : n.units == 3 ? 0.001 : 1.0;
  const auto to_lps = [mm](const Vector3& v) { return Vector3{-mm * v[0], -mm * v[1], mm * v[2]}; };
  for (int a = 0; a < 3; ++a) {
    if (n.dim[a + 1] < 1 || n.dim[a + 1] > 4096) fail_label_file(file, "a size that is not 1 to 4096 voxels");
    place.size[a] = static_cast<int>(n.dim[a + 1]);
    place.step[a] = to_lps(step[a]);
  }
  place.origin = to_lps(origin);
  return place;
}

}  // namespace

LabelImage read_nifti_labels(const std::filesystem::path& file, const std::map<int, std::uint8_t>& values) {
  auto bytes = first_bytes(file, 540);
  std::int32_t size = 0;
  std::memcpy(&size, bytes.data(), sizeof(size));
  const auto reversed = static_cast<std::int32_t>(__builtin_bswap32(static_cast<std::uint32_t>(size)));
  const bool swapped = size != 348 && size != 540;
  const int header_size = swapped ? reversed : size;
  if ((header_size != 348 && header_size != 540) || bytes.size() < static_cast<std::size_t>(header_size))
    fail_label_file(file, "the NIfTI header is damaged");
  const auto n = parsed(Header(std::move(bytes), swapped), header_size == 540);

  if (n.dim[0] < 3 || n.dim[0] > 7) fail_label_file(file, "it is not a volume of three dimensions");
  for (int a = 4; a <= static_cast<int>(n.dim[0]); ++a) {
    if (n.dim[a] > 1) fail_label_file(file, "it has more than three dimensions; save one volume of labels");
  }
  const bool scaled = std::isfinite(n.slope) && n.slope != 0.0 && (n.slope != 1.0 || n.intercept != 0.0);
  if (scaled) fail_label_file(file, "its values are scaled; labels must be stored as they are");
  if (!(n.voxels_at >= header_size && n.voxels_at < 1e9)) fail_label_file(file, "the NIfTI header is damaged");

  LabelImage image;
  image.place = placed(n, file);
  check_placement(image.place, 1, file);
  VoxelLayout layout;
  layout.element = element_of(n.datatype, file);
  layout.big_endian = swapped;  // of this machine's order the standard says nothing else
  layout.gzip = is_gzip(file);
  (layout.gzip ? layout.skip : layout.at) = static_cast<std::uint64_t>(n.voxels_at);
  fill_sets(image, file, layout, unnamed_table(values), values.empty());
  return image;
}

}  // namespace vallecula::pipeline
