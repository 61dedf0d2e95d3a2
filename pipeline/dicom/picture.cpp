#include "pipeline/dicom/picture.h"

#include <gdcmAttribute.h>
#include <gdcmReader.h>
#include <gdcmSequenceOfItems.h>
#include <gdcmTrace.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <regex>
#include <set>

#include "pipeline/dicom/limits.h"
#include "pipeline/dicom/mapped_file.h"
#include "pipeline/dicom/whole_file.h"

namespace vallecula::pipeline {
namespace {

using gdcm::DataSet;
using gdcm::Tag;

/// What is wrong with one picture; becomes Picture::fault.
struct Fault {
  std::string text;
};

std::string text_of(const DataSet& data, const Tag& tag) {
  if (!data.FindDataElement(tag)) return {};
  const auto* bytes = data.GetDataElement(tag).GetByteValue();
  if (bytes == nullptr || bytes->GetPointer() == nullptr) return {};
  std::string text(bytes->GetPointer(), bytes->GetLength());
  while (!text.empty() && (text.back() == ' ' || text.back() == '\0')) text.pop_back();
  return text;
}

/// The decimal strings of an attribute; empty when it is missing.
std::vector<double> decimals_of(const DataSet& data, const Tag& tag, const char* name) {
  std::vector<double> values;
  const auto text = text_of(data, tag);
  for (std::size_t at = 0; at < text.size();) {
    const auto end = std::min(text.find('\\', at), text.size());
    const auto word = text.substr(at, end - at);
    char* rest = nullptr;
    const double value = std::strtod(word.c_str(), &rest);
    while (*rest == ' ') ++rest;
    if (word.empty() || *rest != '\0' || !std::isfinite(value))
      throw Fault{std::string(name) + " is not a number; export the series again"};
    values.push_back(value);
    at = end + 1;
  }
  return values;
}

template <std::uint16_t group, std::uint16_t element>
std::optional<unsigned> whole_number_of(const DataSet& data) {
  const Tag tag(group, element);
  if (!data.FindDataElement(tag)) return {};
  const auto* bytes = data.GetDataElement(tag).GetByteValue();
  if (bytes == nullptr || bytes->GetLength() < sizeof(typename gdcm::Attribute<group, element>::ArrayType)) return {};
  gdcm::Attribute<group, element> attribute;
  attribute.SetFromDataElement(data.GetDataElement(tag));
  return attribute.GetValue();
}

/// Where a frame's attributes stand: its own functional groups, those shared by all, the data set itself.
class FrameAttributes {
 public:
  FrameAttributes(const DataSet& root, const DataSet* shared, const DataSet* own)
      : root_(root), shared_(shared), own_(own) {}

  /// The data set that holds `tag`: inside `sequence` of the groups, else at the root.
  const DataSet& holder(const Tag& sequence, const Tag& tag) const {
    for (const DataSet* group : {own_, shared_}) {
      if (group == nullptr || !group->FindDataElement(sequence)) continue;
      const auto items = group->GetDataElement(sequence).GetValueAsSQ();
      if (!items || items->GetNumberOfItems() == 0) continue;
      const DataSet& inside = items->GetItem(1).GetNestedDataSet();
      if (!inside.FindDataElement(tag)) continue;
      keep_.push_back(items);
      return inside;
    }
    return root_;
  }
  std::string text(const Tag& sequence, const Tag& tag) const { return text_of(holder(sequence, tag), tag); }
  std::vector<double> decimals(const Tag& sequence, const Tag& tag, const char* name, std::size_t count) const {
    auto values = decimals_of(holder(sequence, tag), tag, name);
    if (values.empty()) throw Fault{std::string(name) + " is missing; export the series again with its geometry"};
    if (values.size() != count)
      throw Fault{std::string(name) + " has the wrong number of values; export the series again"};
    return values;
  }

 private:
  const DataSet& root_;
  const DataSet* shared_;
  const DataSet* own_;
  mutable std::vector<gdcm::SmartPointer<gdcm::SequenceOfItems>> keep_;  // a sequence parsed on demand lives here
};

const Tag kNone(0, 0);
const Tag kPlanePosition(0x0020, 0x9113);
const Tag kPlaneOrientation(0x0020, 0x9116);
const Tag kPixelMeasures(0x0028, 0x9110);
const Tag kPixelTransformation(0x0028, 0x9145);
const Tag kFrameContent(0x0020, 0x9111);
const Tag kFrameType(0x0018, 0x9329);
const Tag kReconstruction(0x0018, 0x9314);
const Tag kExposure(0x0018, 0x9325);

/// Words of the standard only: anything else in these fields is free text that may name a person.
std::string known_modality(const std::string& modality) {
  static const std::set<std::string> kTerms = {
      "CT", "MR", "PT", "NM",  "US",       "CR",     "DX",     "MG",      "XA",  "RF",  "SC",  "OT", "SR", "PR",
      "KO", "IO", "ES", "SEG", "RTSTRUCT", "RTDOSE", "RTPLAN", "RTIMAGE", "REG", "FID", "DOC", "PX", "OP", "ECG"};
  return kTerms.count(modality) != 0 ? modality : "other";
}

std::string known_kernel(std::string kernel) {
  kernel = kernel.substr(0, kernel.find('\\'));
  static const std::regex kUsual(
      "[A-Z]{1,2}[a-z]?[0-9]{2}[a-z]{0,2}|[A-D]|U[A-C]|Y[A-D]|STANDARD|SOFT|DETAIL|BONE|BONEPLUS|LUNG|EDGE|CHST|"
      "Standard|Soft|Detail|Bone|Lung|Sharp|Smooth");
  return std::regex_match(kernel, kUsual) ? kernel : "";
}

void read_geometry(const FrameAttributes& from, Picture& p) {
  const auto spacing = from.decimals(kPixelMeasures, Tag(0x0028, 0x0030), "PixelSpacing", 2);
  p.spacing = {spacing[1], spacing[0]};  // DICOM: between rows first
  if (!(spacing[0] > 1e-3 && spacing[1] > 1e-3 && spacing[0] < 100.0 && spacing[1] < 100.0))
    throw Fault{"PixelSpacing is no length a voxel can have; export the series again"};
  const auto position = from.decimals(kPlanePosition, Tag(0x0020, 0x0032), "ImagePositionPatient", 3);
  const auto direction = from.decimals(kPlaneOrientation, Tag(0x0020, 0x0037), "ImageOrientationPatient", 6);
  for (int a = 0; a < 3; ++a) {
    if (std::abs(position[a]) > 1e5)
      throw Fault{"ImagePositionPatient lies outside any scanner; export the series again"};
    p.position[a] = position[a];
    p.row[a] = direction[a];
    p.column[a] = direction[3 + a];
  }
  if (std::abs(norm(p.row) - 1.0) > 1e-2 || std::abs(norm(p.column) - 1.0) > 1e-2 ||
      std::abs(dot(p.row, p.column)) > 1e-2) {
    throw Fault{"ImageOrientationPatient is not a pair of perpendicular unit vectors; export the series again"};
  }
}

void read_rescale(const FrameAttributes& from, Picture& p) {
  const auto value = [&](const Tag& tag, const char* name) {
    const auto values = decimals_of(from.holder(kPixelTransformation, tag), tag, name);
    if (values.size() == 1) return values[0];
    throw Fault{std::string(name) +
                " is missing, so its grey values cannot be turned into HU; export the original series"};
  };
  p.intercept = value(Tag(0x0028, 0x1052), "RescaleIntercept");
  p.slope = value(Tag(0x0028, 0x1053), "RescaleSlope");
  if (p.slope == 0.0 || std::abs(p.slope) > 1e6 || std::abs(p.intercept) > 1e9)
    throw Fault{"its rescale gives no HU; export the original series"};
  const auto type = from.text(kPixelTransformation, Tag(0x0028, 0x1054));
  if (!type.empty() && type != "HU" && type != "US")
    throw Fault{"its values are not HU (RescaleType); export the original CT series, not a derived map"};
}

void read_padding(const DataSet& root, Picture& p) {
  const bool is_signed = whole_number_of<0x0028, 0x0103>(root).value_or(0) == 1;
  // The two attributes are US or SS as the pixels are, in the file's byte order; their bytes are read as they stand.
  const auto stored = [&](const Tag& tag) -> std::optional<double> {
    if (!root.FindDataElement(tag)) return {};
    const auto* bytes = root.GetDataElement(tag).GetByteValue();
    if (bytes == nullptr || bytes->GetLength() < 2) return {};
    std::uint16_t raw = 0;
    std::copy_n(bytes->GetPointer(), 2, reinterpret_cast<char*>(&raw));
    return is_signed ? static_cast<double>(static_cast<std::int16_t>(raw)) : static_cast<double>(raw);
  };
  const auto value = stored(Tag(0x0028, 0x0120));
  if (!value) return;
  const double limit = stored(Tag(0x0028, 0x0121)).value_or(*value);
  p.padding = {std::min(*value, limit), std::max(*value, limit)};
}

/// Size and format, against what the file can hold: a header may ask for any amount of memory.
void read_format(const DataSet& root, std::size_t pixel_bytes, bool packed, Picture& p) {
  const auto columns = static_cast<std::int64_t>(whole_number_of<0x0028, 0x0011>(root).value_or(0));
  const auto rows = static_cast<std::int64_t>(whole_number_of<0x0028, 0x0010>(root).value_or(0));
  const auto bits = whole_number_of<0x0028, 0x0100>(root).value_or(0);
  const auto samples = whole_number_of<0x0028, 0x0002>(root).value_or(1);
  const auto photometric = text_of(root, Tag(0x0028, 0x0004));
  p.colour = samples != 1 || (photometric != "MONOCHROME2" && photometric != "MONOCHROME1" && !photometric.empty());
  if (columns < 2 || rows < 2) throw Fault{"has no picture; take it out of the folder"};
  if (columns > kLargestSide || rows > kLargestSide || columns * rows * p.frames > kMostVoxels) {
    throw Fault{"its header asks for " + std::to_string(columns) + " x " + std::to_string(rows) + " x " +
                std::to_string(p.frames) + " voxels, more than any CT this program reads; it is damaged or no head CT"};
  }
  if (bits != 8 && bits != 16 && bits != 32) {
    throw Fault{"has " + std::to_string(bits) + " bits a voxel; expected 8, 16 or 32: export the series again"};
  }
  const auto stored = whole_number_of<0x0028, 0x0101>(root).value_or(bits);
  const auto high = whole_number_of<0x0028, 0x0102>(root).value_or(stored - 1);
  if (stored < 1 || stored > bits || high + 1 < stored || high >= bits)
    throw Fault{"its header contradicts itself about the bits of a voxel; export the series again"};
  const auto needed = static_cast<std::uint64_t>(columns * rows * p.frames) * bits / 8 * samples;
  if (!packed && needed > pixel_bytes) throw Fault{"its picture is cut short; copy the file again"};
  p.columns = static_cast<int>(columns);
  p.rows = static_cast<int>(rows);
}

void read_phases(const FrameAttributes& from, const DataSet& root, Picture& p) {
  const auto index = whole_number_of<0x0020, 0x9128>(from.holder(kFrameContent, Tag(0x0020, 0x9128)));
  const auto acquisition = whole_number_of<0x0020, 0x9156>(from.holder(kFrameContent, Tag(0x0020, 0x9156)));
  const auto type = from.text(kFrameType, Tag(0x0008, 0x9007));
  p.phases = {text_of(root, Tag(0x0020, 0x0100)) + (index ? std::to_string(*index) : ""),
              text_of(root, Tag(0x0020, 0x0012)) + (acquisition ? std::to_string(*acquisition) : ""),
              text_of(root, Tag(0x0018, 0x1060)),
              from.text(kFrameContent, Tag(0x0020, 0x9056)),
              text_of(root, Tag(0x0008, 0x0008)) + type,
              from.text(kReconstruction, Tag(0x0018, 0x1210)),
              text_of(root, Tag(0x0018, 0x0060))};
  p.kernel = known_kernel(p.phases[5]);
  p.localizer = p.phases[4].find("LOCALIZER") != std::string::npos;
}

gdcm::SmartPointer<gdcm::SequenceOfItems> items_of(const DataSet& root, const Tag& tag) {
  if (!root.FindDataElement(tag)) return nullptr;
  return root.GetDataElement(tag).GetValueAsSQ();
}

/// By its class: CT, Enhanced CT, Legacy Converted Enhanced CT Image Storage.
bool says_it_is_ct(const gdcm::File& file) {
  const std::string ct = "1.2.840.10008.5.1.4.1.1.2";
  for (const auto& uid :
       {text_of(file.GetDataSet(), Tag(0x0008, 0x0016)), text_of(file.GetHeader(), Tag(0x0002, 0x0002))}) {
    if (uid == ct || uid == ct + ".1" || uid == ct + ".2") return true;
  }
  return false;
}

std::vector<Picture> pictures_of(const gdcm::File& file, const DicomCheck& check, int number) {
  const auto& root = file.GetDataSet();
  Picture common;
  common.file = number;
  common.series = text_of(root, Tag(0x0020, 0x000e));
  common.instance = text_of(root, Tag(0x0008, 0x0018));
  const auto modality = text_of(root, Tag(0x0008, 0x0060));
  common.modality = known_modality(modality);
  common.has_pixels = root.FindDataElement(Tag(0x0028, 0x0010)) && root.FindDataElement(Tag(0x0028, 0x0011));
  if (says_it_is_ct(file) && (modality.empty() || !common.has_pixels)) {
    common.modality = "CT";
    common.fault = "is a CT slice without a picture, cut short; copy it again or take it out of the folder";
    return {common};
  }
  if (modality.empty() && common.series.empty() && !common.has_pixels) return {};
  if (!common.has_pixels || common.modality != "CT") return {common};

  const auto fail = [&common](const std::string& text) {
    common.fault = text;
    return std::vector<Picture>{common};
  };
  std::int64_t frames = 1;
  if (const auto text = text_of(root, Tag(0x0028, 0x0008)); !text.empty())
    frames = std::strtoll(text.c_str(), nullptr, 10);
  if (frames < 1) return fail("has no picture; take it out of the folder");
  if (frames > kMostFrames)
    return fail("its header asks for " + std::to_string(frames) +
                " frames, more than any CT this program reads; it is damaged or no head CT");
  common.frames = static_cast<int>(frames);
  const auto shared = items_of(root, Tag(0x5200, 0x9229));
  const auto own = items_of(root, Tag(0x5200, 0x9230));
  const std::size_t described = own ? own->GetNumberOfItems() : 0;
  if (frames > 1 && described == 0)
    return fail(
        "is a multi-frame file without a position for each frame; export it as Enhanced CT or one file a slice");
  if (described != 0 && static_cast<std::int64_t>(described) != frames)
    return fail("its header describes " + std::to_string(described) + " frames and claims " + std::to_string(frames) +
                "; it is damaged: export the series again");

  const auto& syntax = file.GetHeader().GetDataSetTransferSyntax();
  const DataSet* for_all = shared && shared->GetNumberOfItems() > 0 ? &shared->GetItem(1).GetNestedDataSet() : nullptr;
  std::vector<Picture> pictures;
  for (std::int64_t f = 0; f < frames; ++f) {
    Picture p = common;
    p.frame = static_cast<int>(f);
    try {
      const DataSet* of_frame =
          described != 0 ? &own->GetItem(static_cast<gdcm::SequenceOfItems::SizeType>(f + 1)).GetNestedDataSet()
                         : nullptr;
      const FrameAttributes attributes(root, for_all, of_frame);
      read_phases(attributes, root, p);
      read_format(root, check.pixel_bytes, syntax.IsEncapsulated(), p);
      if (p.colour) {  // left out as a whole, whatever else it lacks
        pictures.push_back(std::move(p));
        continue;
      }
      read_padding(root, p);
      if (!p.localizer) read_rescale(attributes, p);
      read_geometry(attributes, p);
    } catch (const Fault& fault) {
      if (!p.localizer) p.fault = fault.text;
    }
    pictures.push_back(std::move(p));
  }
  return pictures;
}

}  // namespace

std::vector<Picture> read_pictures(std::string_view bytes, int file) {
  const auto check = check_dicom(bytes);
  if (!check.dicom) return {};
  Picture damaged;
  damaged.file = file;
  damaged.series = check.series;
  // A damaged file that says it is something else is left alone; one that does not say may be a slice of the CT.
  damaged.modality = check.modality.empty() ? "CT" : known_modality(check.modality);
  damaged.fault = "is no whole DICOM file (" + (check.fault.empty() ? "it cannot be parsed" : check.fault) +
                  "); copy it again or take it out of the folder";
  if (!check.fault.empty()) return {damaged};
  gdcm::Trace::WarningOff();
  gdcm::Trace::ErrorOff();
  gdcm::Trace::DebugOff();
  try {
    ByteStream stream(bytes);
    gdcm::Reader reader;
    reader.SetStream(stream);
    // Reading up to the pixels is enough to sort pictures into series.
    if (!reader.ReadUpToTag(Tag(0x7fe0, 0x0010), std::set<Tag>())) return {damaged};
    return pictures_of(reader.GetFile(), check, file);
  } catch (const std::exception&) {
    return {damaged};
  }
}

}  // namespace vallecula::pipeline
