#include "pipeline/dicom/write_series.h"

#include <gdcmImageWriter.h>
#include <gdcmMediaStorage.h>
#include <sodium.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <fstream>
#include <stdexcept>
#include <system_error>

namespace vallecula::pipeline {
namespace {

/// A UID under the UUID root 2.25 (PS3.5 B.2): 128 bits of a hash, written as a decimal number.
std::string uid_for(const std::string& key) {
  std::array<unsigned char, 16> hash{};
  crypto_generichash(hash.data(), hash.size(), reinterpret_cast<const unsigned char*>(key.data()), key.size(), nullptr,
                     0);
  hash[6] = static_cast<unsigned char>((hash[6] & 0x0F) | 0x80);  // a version 8 UUID: bits of the maker's own choice
  hash[8] = static_cast<unsigned char>((hash[8] & 0x3F) | 0x80);
  std::string digits;
  std::vector<unsigned> value(hash.begin(), hash.end());
  while (!value.empty()) {
    unsigned rest = 0;
    std::vector<unsigned> quotient;
    for (const unsigned byte : value) {
      const unsigned part = rest * 256 + byte;
      if (!quotient.empty() || part / 10 != 0) quotient.push_back(part / 10);
      rest = part % 10;
    }
    digits.push_back(static_cast<char>('0' + rest));
    value = std::move(quotient);
  }
  std::reverse(digits.begin(), digits.end());
  return "2.25." + digits;
}

/// Sets an attribute from its text (DICOM's numbers of value representation DS and IS are text too). An empty one is
/// what the standard wants of a type 2 attribute whose value is not known.
void set(gdcm::DataSet& data, std::uint16_t group, std::uint16_t element, const gdcm::VR& vr, std::string value) {
  if (value.size() % 2 != 0) value.push_back(vr == gdcm::VR::UI ? '\0' : ' ');
  gdcm::DataElement attribute(gdcm::Tag(group, element));
  attribute.SetVR(vr);
  attribute.SetByteValue(value.data(), static_cast<std::uint32_t>(value.size()));
  data.Replace(attribute);
}

std::string decimal_string(double value) {
  char text[17];  // a decimal string holds at most 16 characters
  std::snprintf(text, sizeof text, "%.8g", value);
  return text;
}

void set_image(gdcm::Image& image, const Hounsfield& volume, int slice) {
  const Grid& grid = volume.grid;
  image.SetNumberOfDimensions(2);
  image.SetDimension(0, static_cast<unsigned>(grid.size[0]));
  image.SetDimension(1, static_cast<unsigned>(grid.size[1]));
  image.SetSpacing(0, grid.spacing[0]);
  image.SetSpacing(1, grid.spacing[1]);
  image.SetSpacing(2, grid.spacing[2]);
  const auto corner = grid.position(0, 0, slice);
  for (unsigned a = 0; a < 3; ++a) image.SetOrigin(a, corner[a]);  // the array form drops z of a 2D image
  // The whole array at once: the form with indices becomes identity without a word when used out of order.
  const double cosines[6] = {1, 0, 0, 0, 1, 0};
  image.SetDirectionCosines(cosines);
  image.SetPixelFormat(gdcm::PixelFormat(1, 16, 12, 11, 0));
  image.SetPhotometricInterpretation(gdcm::PhotometricInterpretation::MONOCHROME2);
  image.SetTransferSyntax(gdcm::TransferSyntax::ExplicitVRLittleEndian);
  image.SetIntercept(-1024.0);
  image.SetSlope(1.0);
  const std::size_t count = static_cast<std::size_t>(grid.size[0]) * grid.size[1];
  std::vector<std::uint16_t> stored(count);
  const std::size_t first = grid.index(0, 0, slice);
  for (std::size_t i = 0; i < count; ++i)
    stored[i] = static_cast<std::uint16_t>(std::clamp<int>(volume.voxels[first + i], -1024, 3071) + 1024);
  gdcm::DataElement pixels(gdcm::Tag(0x7fe0, 0x0010));
  pixels.SetByteValue(reinterpret_cast<const char*>(stored.data()), static_cast<std::uint32_t>(2 * count));
  image.SetDataElement(pixels);
}

void set_attributes(gdcm::DataSet& data, const Hounsfield& volume, int slice, const SeriesDescription& about) {
  const std::string number = std::to_string(slice + 1);
  set(data, 0x0028, 0x0004, gdcm::VR::CS, "MONOCHROME2");  // also in the image; without it here GDCM warns
  // SOP common, patient
  set(data, 0x0008, 0x0005, gdcm::VR::CS, "ISO_IR 192");
  set(data, 0x0008, 0x0016, gdcm::VR::UI, gdcm::MediaStorage::GetMSString(gdcm::MediaStorage::CTImageStorage));
  set(data, 0x0008, 0x0018, gdcm::VR::UI, uid_for(about.unique_key + "/instance/" + number));
  set(data, 0x0010, 0x0010, gdcm::VR::PN, about.patient_name);
  set(data, 0x0010, 0x0020, gdcm::VR::LO, about.patient_id);
  set(data, 0x0010, 0x0030, gdcm::VR::DA, "");
  set(data, 0x0010, 0x0040, gdcm::VR::CS, "");
  if (about.patient_weight_kg > 0.0) set(data, 0x0010, 0x1030, gdcm::VR::DS, decimal_string(about.patient_weight_kg));
  // Study, series, frame of reference, equipment
  set(data, 0x0020, 0x000d, gdcm::VR::UI, uid_for(about.unique_key + "/study"));
  set(data, 0x0020, 0x000e, gdcm::VR::UI, uid_for(about.unique_key + "/series"));
  set(data, 0x0020, 0x0052, gdcm::VR::UI, uid_for(about.unique_key + "/frame"));
  set(data, 0x0020, 0x1040, gdcm::VR::LO, "");
  set(data, 0x0008, 0x0020, gdcm::VR::DA, "");
  set(data, 0x0008, 0x0030, gdcm::VR::TM, "");
  set(data, 0x0008, 0x0023, gdcm::VR::DA, "");
  set(data, 0x0008, 0x0033, gdcm::VR::TM, "");
  set(data, 0x0008, 0x0050, gdcm::VR::SH, "");
  set(data, 0x0008, 0x0090, gdcm::VR::PN, "");
  set(data, 0x0020, 0x0010, gdcm::VR::SH, "1");
  set(data, 0x0008, 0x1030, gdcm::VR::LO, about.study_description);
  set(data, 0x0008, 0x103e, gdcm::VR::LO, about.series_description);
  set(data, 0x0008, 0x0060, gdcm::VR::CS, "CT");
  set(data, 0x0008, 0x0070, gdcm::VR::LO, "Vallecula");
  set(data, 0x0018, 0x0015, gdcm::VR::CS, "HEAD");
  set(data, 0x0018, 0x5100, gdcm::VR::CS, "HFS");
  set(data, 0x0020, 0x0011, gdcm::VR::IS, "1");
  // Image
  set(data, 0x0008, 0x0008, gdcm::VR::CS, "ORIGINAL\\PRIMARY\\AXIAL");
  set(data, 0x0020, 0x0013, gdcm::VR::IS, number);
  set(data, 0x0020, 0x0012, gdcm::VR::IS, "1");
  set(data, 0x0018, 0x0060, gdcm::VR::DS, decimal_string(120.0));
  set(data, 0x0018, 0x0050, gdcm::VR::DS, decimal_string(volume.grid.spacing[2]));
  set(data, 0x0018, 0x0088, gdcm::VR::DS, decimal_string(volume.grid.spacing[2]));
  set(data, 0x0020, 0x1041, gdcm::VR::DS, decimal_string(volume.grid.position(0, 0, slice)[2]));
  set(data, 0x0028, 0x1054, gdcm::VR::LO, "HU");
  set(data, 0x0028, 0x1050, gdcm::VR::DS, decimal_string(40.0));
  set(data, 0x0028, 0x1051, gdcm::VR::DS, decimal_string(400.0));
}

}  // namespace

void write_ct_series(const Hounsfield& volume, const SeriesDescription& description, const std::filesystem::path& dir,
                     const std::function<void(double fraction)>& progress) {
  if (sodium_init() < 0) throw std::runtime_error("DICOM series: the hash library did not start");
  for (int z = 0; z < volume.grid.size[2]; ++z) {
    char name[32];
    std::snprintf(name, sizeof name, "ct-%04d.dcm", z + 1);
    const auto file = dir / name;
    if (!std::ofstream(file).good())  // GDCM ends the process when it cannot open the file
      throw std::runtime_error("DICOM series: " + file.string() +
                               " cannot be written; check the space and permissions");
    gdcm::ImageWriter writer;
    set_image(writer.GetImage(), volume, z);
    set_attributes(writer.GetFile().GetDataSet(), volume, z, description);
    writer.SetFileName(file.c_str());
    const bool written = writer.Write();
    std::error_code error;
    const auto pixels = 2u * static_cast<std::uintmax_t>(volume.grid.size[0]) * volume.grid.size[1];
    if (!written || std::filesystem::file_size(file, error) <= pixels || error)
      throw std::runtime_error("DICOM series: " + file.string() +
                               " cannot be written; check the space and permissions");
    if (progress) progress(static_cast<double>(z + 1) / volume.grid.size[2]);
  }
}

}  // namespace vallecula::pipeline
