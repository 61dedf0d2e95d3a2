#include "pipeline/dicom/slice.h"

#include <gdcmAttribute.h>
#include <gdcmImageReader.h>
#include <gdcmReader.h>
#include <gdcmTrace.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstring>
#include <fstream>
#include <set>

#include "pipeline/dicom/read_series.h"
#include "pipeline/dicom/whole_file.h"

namespace vallecula::pipeline {
namespace {

constexpr std::int16_t kAirHu = -1024;

[[noreturn]] void fail(const std::filesystem::path& file, const std::string& what) {
  throw SeriesError("file " + file.filename().string() + ": " + what);
}

bool has_dicom_marker(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::array<char, 132> head{};
  return in.read(head.data(), head.size()) && std::memcmp(head.data() + 128, "DICM", 4) == 0;
}

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

std::string text_of(const gdcm::DataSet& data, const gdcm::Tag& tag) {
  if (!data.FindDataElement(tag)) return {};
  const auto* bytes = data.GetDataElement(tag).GetByteValue();
  if (bytes == nullptr) return {};
  std::string text(bytes->GetPointer(), bytes->GetLength());
  while (!text.empty() && (text.back() == ' ' || text.back() == '\0')) text.pop_back();
  return text;
}

template <std::uint16_t group, std::uint16_t element>
auto numbers_of(const gdcm::DataSet& data, const std::filesystem::path& file, const char* name, std::size_t count) {
  const gdcm::Tag tag(group, element);
  if (!data.FindDataElement(tag) || data.GetDataElement(tag).IsEmpty()) {
    fail(file, std::string(name) + " is missing; export the series again with its geometry");
  }
  gdcm::Attribute<group, element> attribute;
  attribute.SetFromDataElement(data.GetDataElement(tag));
  std::vector<double> values;
  for (unsigned i = 0; i < attribute.GetNumberOfValues(); ++i) values.push_back(attribute.GetValue(i));
  if (values.size() != count)
    fail(file, std::string(name) + " has the wrong number of values; export the series again");
  for (const double v : values) {
    if (!std::isfinite(v)) fail(file, std::string(name) + " is not a number; export the series again");
  }
  return values;
}

template <class T>
void rescale(const std::vector<char>& buffer, double slope, double intercept, const std::optional<double>& padding,
             std::vector<std::int16_t>& hu) {
  for (std::size_t i = 0; i < hu.size(); ++i) {
    T stored;
    std::memcpy(&stored, buffer.data() + i * sizeof(T), sizeof(T));
    if (padding && static_cast<double>(stored) == *padding) {
      hu[i] = kAirHu;
      continue;
    }
    hu[i] = static_cast<std::int16_t>(
        std::clamp(std::lround(slope * static_cast<double>(stored) + intercept), -32768L, 32767L));
  }
}

std::optional<double> padding_of(const gdcm::DataSet& data, bool is_signed) {
  const gdcm::Tag tag(0x0028, 0x0120);
  if (!data.FindDataElement(tag)) return {};
  const auto* bytes = data.GetDataElement(tag).GetByteValue();
  if (bytes == nullptr || bytes->GetLength() < 2) return {};
  std::uint16_t raw = 0;
  std::memcpy(&raw, bytes->GetPointer(), 2);
  return is_signed ? static_cast<double>(static_cast<std::int16_t>(raw)) : static_cast<double>(raw);
}

void fill_hu(const gdcm::Image& image, const gdcm::DataSet& data, Slice& slice) {
  const auto& format = image.GetPixelFormat();
  if (format.GetSamplesPerPixel() != 1)
    fail(slice.file, "is a colour picture, not a CT slice; take it out of the folder");
  std::vector<char> buffer(image.GetBufferLength());
  // A cut-short compressed file passes Read() and fails only here.
  if (buffer.empty() || !image.GetBuffer(buffer.data()))
    fail(slice.file, "its picture is cut short or damaged; copy the file again");
  slice.hu.resize(static_cast<std::size_t>(slice.columns) * slice.rows);
  if (buffer.size() < slice.hu.size() * format.GetPixelSize())
    fail(slice.file, "its picture is cut short; copy the file again");

  const double slope = image.GetSlope();
  const double intercept = image.GetIntercept();
  const bool is_signed = format.GetPixelRepresentation() == 1;
  const auto padding = padding_of(data, is_signed);
  switch (format.GetBitsAllocated()) {
    case 8:
      is_signed ? rescale<std::int8_t>(buffer, slope, intercept, padding, slice.hu)
                : rescale<std::uint8_t>(buffer, slope, intercept, padding, slice.hu);
      return;
    case 16:
      is_signed ? rescale<std::int16_t>(buffer, slope, intercept, padding, slice.hu)
                : rescale<std::uint16_t>(buffer, slope, intercept, padding, slice.hu);
      return;
    case 32:
      is_signed ? rescale<std::int32_t>(buffer, slope, intercept, padding, slice.hu)
                : rescale<std::uint32_t>(buffer, slope, intercept, padding, slice.hu);
      return;
    default:
      fail(slice.file, "has " + std::to_string(format.GetBitsAllocated()) +
                           " bits a voxel; expected 8, 16 or 32: export the series again");
  }
}

}  // namespace

std::optional<SliceHeader> read_slice_header(const std::filesystem::path& file) {
  gdcm::Trace::WarningOff();
  gdcm::Trace::ErrorOff();
  gdcm::Trace::DebugOff();
  const bool marked = has_dicom_marker(file);
  const bool named = lower(file.extension().string()) == ".dcm";
  if (!marked && !named) return {};
  if (const auto fault = fault_of_dicom_file(file); !fault.empty()) {
    fail(file, "is no whole DICOM file (" + fault + "); copy it again or take it out of the folder");
  }
  gdcm::Reader reader;
  reader.SetFileName(file.c_str());
  // Reading up to the pixels without descending into private data is enough to sort files into series.
  if (!reader.ReadUpToTag(gdcm::Tag(0x7fe0, 0x0010), std::set<gdcm::Tag>())) {
    fail(file, "is no whole DICOM file (cut short or damaged); copy it again or take it out of the folder");
  }
  const auto& data = reader.GetFile().GetDataSet();
  SliceHeader header;
  header.file = file;
  header.modality = text_of(data, gdcm::Tag(0x0008, 0x0060));
  header.series = text_of(data, gdcm::Tag(0x0020, 0x000e));
  header.has_pixels =
      data.FindDataElement(gdcm::Tag(0x0028, 0x0010)) && data.FindDataElement(gdcm::Tag(0x0028, 0x0011));
  const auto frames = text_of(data, gdcm::Tag(0x0028, 0x0008));
  if (!frames.empty()) header.frames = std::atoi(frames.c_str());
  if (header.modality.empty() && header.series.empty()) {
    if (!named) return {};
    fail(file, "is no whole DICOM file (cut short or damaged); copy it again or take it out of the folder");
  }
  return header;
}

Slice read_slice(const std::filesystem::path& file) {
  gdcm::ImageReader reader;
  reader.SetFileName(file.c_str());
  if (!reader.Read()) fail(file, "cannot be read as a DICOM image (cut short or damaged); copy the file again");
  const auto& image = reader.GetImage();
  const auto& data = reader.GetFile().GetDataSet();
  Slice slice;
  slice.file = file;
  slice.columns = static_cast<int>(image.GetDimension(0));
  slice.rows = static_cast<int>(image.GetDimension(1));
  if (slice.columns < 2 || slice.rows < 2) fail(file, "has no picture; take it out of the folder");
  const auto spacing = numbers_of<0x0028, 0x0030>(data, file, "PixelSpacing", 2);
  slice.spacing = {spacing[1], spacing[0]};  // DICOM: between rows first
  if (!(spacing[0] > 0.0 && spacing[1] > 0.0)) fail(file, "PixelSpacing is not positive; export the series again");
  const auto position = numbers_of<0x0020, 0x0032>(data, file, "ImagePositionPatient", 3);
  const auto direction = numbers_of<0x0020, 0x0037>(data, file, "ImageOrientationPatient", 6);
  double row_length = 0.0;
  double column_length = 0.0;
  double dot = 0.0;
  for (int a = 0; a < 3; ++a) {
    slice.position[a] = position[a];
    slice.row[a] = direction[a];
    slice.column[a] = direction[3 + a];
    row_length += direction[a] * direction[a];
    column_length += direction[3 + a] * direction[3 + a];
    dot += direction[a] * direction[3 + a];
  }
  if (std::abs(row_length - 1.0) > 1e-2 || std::abs(column_length - 1.0) > 1e-2 || std::abs(dot) > 1e-2) {
    fail(file, "ImageOrientationPatient is not a pair of perpendicular unit vectors; export the series again");
  }
  for (const auto& [tag, name] : {std::pair{gdcm::Tag(0x0028, 0x1052), "RescaleIntercept"},
                                  std::pair{gdcm::Tag(0x0028, 0x1053), "RescaleSlope"}}) {
    if (text_of(data, tag).empty())
      fail(file, std::string(name) +
                     " is missing, so its grey values cannot be turned into HU; export the original series");
  }
  fill_hu(image, data, slice);
  return slice;
}

}  // namespace vallecula::pipeline
