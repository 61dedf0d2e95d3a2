// DICOM SEG, read with GDCM as a data set: its picture reader does not know pixels of one bit that run on from frame
// to frame. Binary, fractional (from one half on) and label map segmentations, uncompressed.
#include <gdcmReader.h>
#include <gdcmSequenceOfItems.h>
#include <gdcmTrace.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <optional>

#include "pipeline/dicom/mapped_file.h"
#include "pipeline/dicom/whole_file.h"
#include "pipeline/exchange/label_readers.h"

namespace vallecula::pipeline {
namespace {

using Sequence = gdcm::SmartPointer<gdcm::SequenceOfItems>;

const gdcm::Tag kRows(0x0028, 0x0010);
const gdcm::Tag kColumns(0x0028, 0x0011);
const gdcm::Tag kBitsAllocated(0x0028, 0x0100);
const gdcm::Tag kNumberOfFrames(0x0028, 0x0008);
const gdcm::Tag kSegmentationType(0x0062, 0x0001);
const gdcm::Tag kSegments(0x0062, 0x0002);
const gdcm::Tag kSegmentNumber(0x0062, 0x0004);
const gdcm::Tag kSegmentLabel(0x0062, 0x0005);
const gdcm::Tag kSegmentIdentification(0x0062, 0x000a);
const gdcm::Tag kReferencedSegment(0x0062, 0x000b);
const gdcm::Tag kMaximumFraction(0x0062, 0x000e);
const gdcm::Tag kPropertyType(0x0062, 0x000f);
const gdcm::Tag kCodeValue(0x0008, 0x0100);
const gdcm::Tag kSharedGroups(0x5200, 0x9229);
const gdcm::Tag kFrameGroups(0x5200, 0x9230);
const gdcm::Tag kPlanePosition(0x0020, 0x9113);
const gdcm::Tag kImagePosition(0x0020, 0x0032);
const gdcm::Tag kPlaneOrientation(0x0020, 0x9116);
const gdcm::Tag kImageOrientation(0x0020, 0x0037);
const gdcm::Tag kPixelMeasures(0x0028, 0x9110);
const gdcm::Tag kPixelSpacing(0x0028, 0x0030);
const gdcm::Tag kSliceSpacing(0x0018, 0x0088);
const gdcm::Tag kSliceThickness(0x0018, 0x0050);
const gdcm::Tag kPixelData(0x7fe0, 0x0010);

std::string text_of(const gdcm::DataSet& data, const gdcm::Tag& tag) {
  if (!data.FindDataElement(tag)) return {};
  const auto* bytes = data.GetDataElement(tag).GetByteValue();
  if (bytes == nullptr) return {};
  std::string text(bytes->GetPointer(), bytes->GetLength());
  while (!text.empty() && (text.back() == ' ' || text.back() == '\0')) text.pop_back();
  return text;
}

/// US; -1 when it is not there.
int short_of(const gdcm::DataSet& data, const gdcm::Tag& tag) {
  if (!data.FindDataElement(tag)) return -1;
  const auto* bytes = data.GetDataElement(tag).GetByteValue();
  if (bytes == nullptr || bytes->GetLength() < 2) return -1;
  std::uint16_t value = 0;
  std::memcpy(&value, bytes->GetPointer(), sizeof(value));
  return value;
}

/// DS or IS: numbers between backslashes; empty when one is none.
std::vector<double> decimals_of(const gdcm::DataSet& data, const gdcm::Tag& tag) {
  std::vector<double> values;
  const auto text = text_of(data, tag);
  for (std::size_t at = 0; at < text.size();) {
    const auto end = std::min(text.find('\\', at), text.size());
    const auto part = text.substr(at, end - at);
    char* stop = nullptr;
    const double value = std::strtod(part.c_str(), &stop);
    if (stop == part.c_str() || !std::isfinite(value)) return {};
    values.push_back(value);
    at = end + 1;
  }
  return values;
}

Sequence items_of(const gdcm::DataSet& data, const gdcm::Tag& tag) {
  if (!data.FindDataElement(tag)) return nullptr;
  return data.GetDataElement(tag).GetValueAsSQ();
}

/// The first item of a sequence, or null. The item lives as long as `data`.
const gdcm::DataSet* first_item(const gdcm::DataSet& data, const gdcm::Tag& tag, Sequence& keep) {
  keep = items_of(data, tag);
  if (keep == nullptr || keep->GetNumberOfItems() < 1) return nullptr;
  return &keep->GetItem(1).GetNestedDataSet();
}

struct ImageFrame {
  Vector3 position{};
  int segment = 0;  ///< 0: all segments by value (label map)
};

class Segmentation {
 public:
  Segmentation(const gdcm::DataSet& data, const std::filesystem::path& file) : data_(data), file_(file) {}

  LabelImage read() {
    read_kind();
    read_segments();
    read_geometry();
    read_frames();
    lay_slices();
    fill();
    return std::move(image_);
  }

 private:
  [[noreturn]] void fail(const std::string& what) const { fail_label_file(file_, what); }

  void read_kind() {
    const auto type = text_of(data_, kSegmentationType);
    rows_ = short_of(data_, kRows);
    columns_ = short_of(data_, kColumns);
    bits_ = short_of(data_, kBitsAllocated);
    const auto frames = decimals_of(data_, kNumberOfFrames);
    if (rows_ < 1 || columns_ < 1 || frames.size() != 1 || !(frames[0] >= 1.0 && frames[0] <= 1e6))
      fail("this DICOM segmentation does not say how large it is");
    frames_ = static_cast<int>(frames[0]);
    fractional_ = type == "FRACTIONAL";
    by_value_ = type == "LABELMAP";
    const bool known =
        (type == "BINARY" && bits_ == 1) || (fractional_ && bits_ == 8) || (by_value_ && (bits_ == 8 || bits_ == 16));
    if (!known) {
      // Its own words only when they are the standard's: nothing else of a header is repeated.
      const bool word = fractional_ || by_value_ || type == "BINARY" || type == "SURFACE";
      fail("segmentation type " + (word ? type : std::string("of its own")) + " with " + std::to_string(bits_) +
           " bits is not read; save it as a binary segmentation");
    }
    if (fractional_) fraction_ = std::max(1, short_of(data_, kMaximumFraction));
  }

  void read_segments() {
    const auto segments = items_of(data_, kSegments);
    if (segments == nullptr || segments->GetNumberOfItems() < 1) fail("this DICOM segmentation names no segments");
    for (std::size_t i = 1; i <= segments->GetNumberOfItems(); ++i) {
      const auto& segment = segments->GetItem(i).GetNestedDataSet();
      const int number = short_of(segment, kSegmentNumber);
      if (number < 0) fail("a segment has no number");
      Sequence keep;
      const auto* type = first_item(segment, kPropertyType, keep);
      const auto label =
          segment_label(text_of(segment, kSegmentLabel), type ? text_of(*type, kCodeValue) : "", image_.left_out);
      if (label) table_.add(0, number, *label);
    }
  }

  void read_geometry() {
    Sequence groups;
    shared_ = first_item(data_, kSharedGroups, groups);
    frame_groups_ = items_of(data_, kFrameGroups);
    if (frame_groups_ == nullptr || static_cast<int>(frame_groups_->GetNumberOfItems()) != frames_)
      fail("it does not say of every frame where it lies");
    const auto& first = frame_groups_->GetItem(1).GetNestedDataSet();
    const auto orientation = grouped(first, kPlaneOrientation, kImageOrientation);
    const auto spacing = grouped(first, kPixelMeasures, kPixelSpacing);
    if (orientation.size() != 6 || spacing.size() != 2) fail("its frames have no orientation or no pixel spacing");
    const Vector3 along_row = unit({orientation[0], orientation[1], orientation[2]});
    const Vector3 along_column = unit({orientation[3], orientation[4], orientation[5]});
    normal_ = unit(cross(along_row, along_column));
    if (std::abs(dot(along_row, along_column)) > 1e-3) fail("rows and columns of its frames are not at right angles");
    image_.place.step[0] = spacing[1] * along_row;  // Pixel Spacing: between rows first
    image_.place.step[1] = spacing[0] * along_column;
    orientation_ = orientation;
    for (const auto& tag : {kSliceSpacing, kSliceThickness}) {
      const auto mm = grouped(first, kPixelMeasures, tag);
      if (mm.size() == 1 && mm[0] > 1e-3 && slice_mm_ == 0.0) slice_mm_ = mm[0];
    }
    groups_alive_ = groups;
  }

  /// A value of a functional group: the frame's own, else the one shared by all.
  std::vector<double> grouped(const gdcm::DataSet& frame, const gdcm::Tag& group, const gdcm::Tag& tag) const {
    for (const auto* data : {&frame, shared_}) {
      if (data == nullptr) continue;
      Sequence keep;
      const auto* item = first_item(*data, group, keep);
      if (item != nullptr) return decimals_of(*item, tag);
    }
    return {};
  }

  void read_frames() {
    for (int i = 1; i <= frames_; ++i) {
      const auto& data = frame_groups_->GetItem(static_cast<std::size_t>(i)).GetNestedDataSet();
      ImageFrame frame;
      const auto position = grouped(data, kPlanePosition, kImagePosition);
      if (position.size() != 3) fail("it does not say of every frame where it lies");
      frame.position = {position[0], position[1], position[2]};
      const auto orientation = grouped(data, kPlaneOrientation, kImageOrientation);
      for (std::size_t a = 0; a < 6; ++a) {
        if (orientation.size() != 6 || std::abs(orientation[a] - orientation_[a]) > 1e-4)
          fail("its frames lie in different directions");
      }
      if (!by_value_) {
        Sequence keep;
        for (const auto* from : {&data, shared_}) {
          const auto* item = from == nullptr ? nullptr : first_item(*from, kSegmentIdentification, keep);
          if (item != nullptr && frame.segment == 0) frame.segment = std::max(0, short_of(*item, kReferencedSegment));
        }
        if (frame.segment == 0) fail("it does not say of every frame which segment it shows");
      }
      list_.push_back(frame);
    }
  }

  /// Empty slices are left out of these files: their places are found by the distance between the others.
  void lay_slices() {
    std::vector<double> heights;
    for (const auto& frame : list_) heights.push_back(dot(frame.position, normal_));
    std::sort(heights.begin(), heights.end());
    double least = 0.0;
    for (std::size_t i = 1; i < heights.size(); ++i) {
      const double gap = heights[i] - heights[i - 1];
      if (gap > 1e-2 && (least == 0.0 || gap < least)) least = gap;
    }
    // What the file says of the distance holds only when the frames stand so: some write the thickness alone.
    const double in_it = slice_mm_ > 0.0 ? least / slice_mm_ : 0.0;
    const bool said = slice_mm_ > 0.0 && (least == 0.0 || (in_it > 0.5 && std::abs(in_it - std::round(in_it)) < 0.02));
    const double step = said ? slice_mm_ : least;
    if (step == 0.0) fail("it has one slice and does not say how thick it is");
    const double slices = std::round((heights.back() - heights.front()) / step) + 1.0;
    if (slices > 4096.0) fail("its slices lie further apart than a head");
    const auto lowest = std::min_element(list_.begin(), list_.end(), [&](const ImageFrame& a, const ImageFrame& b) {
      return dot(a.position, normal_) < dot(b.position, normal_);
    });
    image_.place.origin = lowest->position;
    image_.place.size = {columns_, rows_, static_cast<int>(slices)};
    image_.place.step[2] = step * normal_;
    check_placement(image_.place, 1, file_);
    for (const auto& frame : list_) {
      const auto off = frame.position - image_.place.origin;
      const double at = dot(off, normal_) / step;
      const double beside = norm(off - dot(off, normal_) * normal_);
      if (std::abs(at - std::round(at)) > 0.05 || beside > 0.05 * step)
        fail("its slices are not evenly spaced on one line; resample it onto the scan");
      slice_of_.push_back(static_cast<int>(std::lround(at)));
    }
  }

  void fill() {
    if (!data_.FindDataElement(kPixelData)) fail("it has no pixel data");
    const auto* pixels = data_.GetDataElement(kPixelData).GetByteValue();
    if (pixels == nullptr) fail("its pixel data is compressed; save it uncompressed");
    const auto each = static_cast<std::size_t>(rows_) * columns_;
    const auto wanted = (each * static_cast<std::size_t>(frames_) * static_cast<std::size_t>(bits_) + 7) / 8;
    if (pixels->GetLength() < wanted) fail("its pixel data is cut short; copy the file again");
    const auto* bytes = reinterpret_cast<const std::uint8_t*>(pixels->GetPointer());
    image_.sets.assign(image_.place.count(), 0);
    for (int f = 0; f < frames_; ++f) {
      const auto set = table_.sets(0, list_[f].segment);
      const auto to = each * static_cast<std::size_t>(slice_of_[f]);
      const auto from = each * static_cast<std::size_t>(f);
      for (std::size_t i = 0; i < each; ++i) image_.sets[to + i] |= set_of(bytes, from + i, set);
    }
  }

  std::uint16_t set_of(const std::uint8_t* bytes, std::size_t pixel, std::uint16_t frame_set) const {
    if (bits_ == 1) return (bytes[pixel / 8] >> (pixel % 8) & 1) != 0 ? frame_set : 0;  // the lowest bit is the first
    if (fractional_) return 2 * bytes[pixel] >= fraction_ ? frame_set : 0;
    const int value = bits_ == 8 ? bytes[pixel] : bytes[2 * pixel] | bytes[2 * pixel + 1] << 8;
    return value == 0 ? 0 : table_.sets(0, value);
  }

  const gdcm::DataSet& data_;
  const std::filesystem::path& file_;
  LabelImage image_;
  ValueTable table_{1};
  int rows_ = 0;
  int columns_ = 0;
  int bits_ = 0;
  int frames_ = 0;
  int fraction_ = 1;
  bool fractional_ = false;
  bool by_value_ = false;
  Sequence frame_groups_;
  Sequence groups_alive_;
  const gdcm::DataSet* shared_ = nullptr;
  std::vector<double> orientation_;
  Vector3 normal_{};
  double slice_mm_ = 0.0;
  std::vector<ImageFrame> list_;
  std::vector<int> slice_of_;
};

}  // namespace

LabelImage parsed_dicom_segmentation(const std::filesystem::path& file) {
  std::optional<MappedFile> mapped;
  try {
    mapped.emplace(file);
  } catch (const std::runtime_error&) {
    fail_label_file(file, "cannot be opened");
  }
  // GDCM ends the process on some cut files.
  if (const auto check = check_dicom(mapped->bytes()); !check.fault.empty()) fail_label_file(file, check.fault);
  gdcm::Trace::WarningOff();
  gdcm::Trace::ErrorOff();
  ByteStream stream(mapped->bytes());
  gdcm::Reader reader;
  reader.SetStream(stream);
  bool read = false;
  try {
    read = reader.Read();
  } catch (const std::exception&) {
    read = false;
  }
  if (!read) fail_label_file(file, "cannot be read as DICOM; copy the file again");
  const auto& data = reader.GetFile().GetDataSet();
  if (text_of(data, gdcm::Tag(0x0008, 0x0060)) != "SEG")
    fail_label_file(file, "this DICOM file is no segmentation (modality SEG)");
  return Segmentation(data, file).read();
}

}  // namespace vallecula::pipeline
