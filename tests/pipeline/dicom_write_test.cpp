// The series as others read it: VTK's own DICOM parser for geometry and HU, and a small parser here for the attributes
// the CT Image IOD asks for. Neither shares code with the writer (GDCM).
#include <gtest/gtest.h>
#include <unistd.h>
#include <vtkDICOMImageReader.h>
#include <vtkImageData.h>
#include <vtkNew.h>

#include <cstring>
#include <fstream>
#include <map>
#include <set>
#include <string>

#include "pipeline/dicom/write_series.h"
#include "pipeline/manikin/manikin.h"

namespace vallecula::pipeline {
namespace {

namespace fs = std::filesystem;

class DicomWrite : public testing::Test {
 protected:
  void SetUp() override {
    const auto* info = testing::UnitTest::GetInstance()->current_test_info();
    dir_ = fs::path(testing::TempDir()) /
           (std::string("vallecula-dicom-") + info->name() + "-" + std::to_string(::getpid()));
    fs::remove_all(dir_);
    fs::create_directories(dir_);
  }
  void TearDown() override { fs::remove_all(dir_); }
  fs::path dir_;
};

/// Top-level elements of an explicit little endian file: tag -> value with padding removed.
std::map<std::uint32_t, std::string> elements(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::string bytes((std::istreambuf_iterator<char>(in)), {});
  std::map<std::uint32_t, std::string> result;
  EXPECT_EQ(bytes.substr(128, 4), "DICM");
  const auto u16 = [&](std::size_t i) {
    return static_cast<unsigned char>(bytes[i]) | static_cast<unsigned char>(bytes[i + 1]) << 8;
  };
  const auto u32 = [&](std::size_t i) {
    return static_cast<std::uint32_t>(u16(i)) | static_cast<std::uint32_t>(u16(i + 2)) << 16;
  };
  for (std::size_t i = 132; i + 8 <= bytes.size();) {
    const std::uint32_t tag = static_cast<std::uint32_t>(u16(i)) << 16 | static_cast<std::uint32_t>(u16(i + 2));
    const std::string vr = bytes.substr(i + 4, 2);
    const bool is_long = std::set<std::string>{"OB", "OW", "OF", "SQ", "UT", "UN"}.count(vr) > 0;
    const std::uint32_t length = is_long ? u32(i + 8) : static_cast<std::uint32_t>(u16(i + 6));
    i += is_long ? 12 : 8;
    std::string value = bytes.substr(i, length);
    i += length;
    if (vr == "US") {
      value = std::to_string(u16(i - length));
    } else if (!is_long) {
      while (!value.empty() && (value.back() == ' ' || value.back() == '\0')) value.pop_back();
    }
    result[tag] = value;
  }
  return result;
}

Hounsfield small_volume() {
  Grid grid;
  grid.size = {18, 14, 5};
  grid.spacing = {0.5, 0.5, 0.8};
  grid.origin = {-3.25, 10.5, -40.0};
  Hounsfield volume(grid);
  for (std::size_t i = 0; i < grid.count(); ++i) {
    const auto c = grid.cell(i);
    volume.voxels[i] = static_cast<std::int16_t>(-1000 + 40 * c[0] + 7 * c[1] + 300 * c[2]);
  }
  return volume;
}

SeriesDescription about() {
  SeriesDescription description;
  description.patient_id = "MANIKIN-7";
  description.patient_name = "Manikin^7";
  description.patient_weight_kg = 3.2;
  description.study_description = "Study";
  description.series_description = "Series";
  description.unique_key = "test";
  return description;
}

TEST_F(DicomWrite, VtkReadsTheGeometryAndEveryValue) {
  const auto volume = small_volume();
  write_ct_series(volume, about(), dir_);
  vtkNew<vtkDICOMImageReader> reader;
  reader->SetDirectoryName(dir_.c_str());
  reader->Update();
  vtkImageData* image = reader->GetOutput();
  int size[3];
  image->GetDimensions(size);
  for (int a = 0; a < 3; ++a) ASSERT_EQ(size[a], volume.grid.size[a]);
  EXPECT_NEAR(reader->GetPixelSpacing()[0], 0.5, 1e-6);
  EXPECT_NEAR(reader->GetPixelSpacing()[1], 0.5, 1e-6);
  EXPECT_NEAR(reader->GetPixelSpacing()[2], 0.8, 1e-4);
  const float* cosines = reader->GetImageOrientationPatient();
  const float expected[6] = {1, 0, 0, 0, 1, 0};
  for (int i = 0; i < 6; ++i) EXPECT_FLOAT_EQ(cosines[i], expected[i]);
  for (int z = 0; z < size[2]; ++z)
    for (int y = 0; y < size[1]; ++y)
      for (int x = 0; x < size[0]; ++x)  // VTK's rows run upwards and its slices from the head down
        ASSERT_EQ(image->GetScalarComponentAsDouble(x, size[1] - 1 - y, size[2] - 1 - z, 0), volume.at(x, y, z))
            << x << ' ' << y << ' ' << z;
}

TEST_F(DicomWrite, TheCtImageIodIsComplete) {
  const auto volume = small_volume();
  write_ct_series(volume, about(), dir_);
  const auto first = elements(dir_ / "ct-0001.dcm");
  const auto last = elements(dir_ / "ct-0005.dcm");
  // PS3.3 A.3: attributes of type 1 must be there with a value, those of type 2 may be empty.
  for (const std::uint32_t tag :
       {0x00020002u, 0x00020003u, 0x00020010u, 0x00080008u, 0x00080016u, 0x00080018u, 0x00080060u,
        0x00180050u, 0x00180060u, 0x00185100u, 0x0020000du, 0x0020000eu, 0x00200032u, 0x00200037u,
        0x00200052u, 0x00280002u, 0x00280004u, 0x00280010u, 0x00280011u, 0x00280030u, 0x00280100u,
        0x00280101u, 0x00280102u, 0x00280103u, 0x00281052u, 0x00281053u, 0x7fe00010u}) {
    ASSERT_TRUE(first.count(tag)) << std::hex << tag;
    EXPECT_FALSE(first.at(tag).empty()) << std::hex << tag;
  }
  for (const std::uint32_t tag :
       {0x00080020u, 0x00080030u, 0x00080050u, 0x00080070u, 0x00080090u, 0x00100010u, 0x00100020u, 0x00100030u,
        0x00100040u, 0x00200010u, 0x00200011u, 0x00200012u, 0x00200013u, 0x00201040u})
    EXPECT_TRUE(first.count(tag)) << std::hex << tag;
  EXPECT_EQ(first.at(0x00080016), "1.2.840.10008.5.1.4.1.1.2");
  EXPECT_EQ(first.at(0x00020002), "1.2.840.10008.5.1.4.1.1.2");
  EXPECT_EQ(first.at(0x00020003), first.at(0x00080018));
  EXPECT_EQ(first.at(0x00080060), "CT");
  EXPECT_EQ(first.at(0x00080008), "ORIGINAL\\PRIMARY\\AXIAL");
  EXPECT_EQ(first.at(0x00185100), "HFS");
  EXPECT_EQ(first.at(0x00280004), "MONOCHROME2");
  EXPECT_EQ(first.at(0x00280010), "14");  // rows
  EXPECT_EQ(first.at(0x00280011), "18");
  EXPECT_EQ(first.at(0x00280100), "16");
  EXPECT_EQ(std::stod(first.at(0x00281052)), -1024.0);
  EXPECT_EQ(std::stod(first.at(0x00281053)), 1.0);
  EXPECT_EQ(first.at(0x00100020), "MANIKIN-7");
  EXPECT_EQ(first.at(0x00200037), "1\\0\\0\\0\\1\\0");
  EXPECT_EQ(first.at(0x7fe00010).size(), 18u * 14u * 2u);
  double x = 0;
  double y = 0;
  double z = 0;
  ASSERT_EQ(std::sscanf(last.at(0x00200032).c_str(), "%lf\\%lf\\%lf", &x, &y, &z), 3);
  EXPECT_NEAR(x, -3.25, 1e-9);
  EXPECT_NEAR(y, 10.5, 1e-9);
  EXPECT_NEAR(z, -40.0 + 4 * 0.8, 1e-9);
  // One study, series and frame; each image its own UID, of legal form.
  for (const std::uint32_t tag : {0x0020000du, 0x0020000eu, 0x00200052u}) EXPECT_EQ(first.at(tag), last.at(tag));
  std::set<std::string> uids = {first.at(0x0020000d), first.at(0x0020000e), first.at(0x00200052), first.at(0x00080018),
                                last.at(0x00080018)};
  EXPECT_EQ(uids.size(), 5u);
  for (const auto& uid : uids) {
    EXPECT_LE(uid.size(), 64u);
    EXPECT_EQ(uid.find_first_not_of("0123456789."), std::string::npos) << uid;
    EXPECT_EQ(uid.substr(0, 5), "2.25.");
    EXPECT_NE(uid[5], '0');
  }
}

TEST_F(DicomWrite, AFileThatCannotBeWrittenIsNamed) {
  try {
    write_ct_series(small_volume(), about(), dir_ / "missing");
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("ct-0001.dcm"), std::string::npos);
  }
}

ManikinOptions quick() {
  ManikinOptions options;
  options.weight_kg = 0.6;
  options.seed = 5;
  options.in_plane_mm = 0.6;
  options.slice_mm = 1.0;
  return options;
}

std::set<std::string> names(const fs::path& dir) {
  std::set<std::string> result;
  for (const auto& entry : fs::directory_iterator(dir)) result.insert(entry.path().filename().string());
  return result;
}

TEST_F(DicomWrite, AManikinIsASeriesWithItsTruth) {
  const auto out = dir_ / "infant";
  double last = 0.0;
  write_manikin(quick(), out, [&](const std::string&, double fraction) {
    EXPECT_GE(fraction, last);
    last = fraction;
  });
  EXPECT_EQ(last, 1.0);
  EXPECT_EQ(names(dir_), std::set<std::string>{"infant"});
  const auto scan = scan_manikin(quick());
  const auto truth = read_label_map(out / "truth.nrrd");
  EXPECT_EQ(truth.voxels, scan.labels.voxels);
  EXPECT_EQ(truth.grid.size, scan.labels.grid.size);
  EXPECT_EQ(names(out).size(), static_cast<std::size_t>(truth.grid.size[2]) + 1);
  vtkNew<vtkDICOMImageReader> reader;
  reader->SetFileName((out / "ct-0040.dcm").c_str());
  reader->Update();
  const int rows = truth.grid.size[1];
  for (int y = 0; y < rows; y += 7)
    for (int x = 0; x < truth.grid.size[0]; x += 7)
      ASSERT_EQ(reader->GetOutput()->GetScalarComponentAsDouble(x, rows - 1 - y, 0, 0), scan.ct.at(x, y, 39));
  const auto position = scan.ct.grid.position(0, 0, 39);
  for (int a = 0; a < 3; ++a) EXPECT_NEAR(reader->GetImagePositionPatient()[a], position[a], 1e-3);
}

TEST_F(DicomWrite, NothingIsOverwrittenOrLeftHalfWritten) {
  const auto refused = [&](const ManikinOptions& options, const fs::path& dir) -> std::string {
    try {
      write_manikin(options, dir);
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return {};
  };
  std::ofstream(dir_ / "note.txt") << "mine";
  EXPECT_NE(refused(quick(), dir_).find("already exists"), std::string::npos);
  EXPECT_NE(refused(quick(), dir_ / "note.txt").find("already exists"), std::string::npos);
  EXPECT_NE(refused(quick(), dir_ / "note.txt" / "infant").find("choose a folder"), std::string::npos);
  auto heavy = quick();
  heavy.weight_kg = 80.0;
  EXPECT_NE(refused(heavy, dir_ / "infant").find("0.6 to 4.5 kg"), std::string::npos);
  EXPECT_NE(refused(quick(), "").find("no folder"), std::string::npos);
  EXPECT_EQ(names(dir_), std::set<std::string>{"note.txt"});
  // A failure on the way (here: a listener that throws) leaves nothing either.
  EXPECT_THROW(write_manikin(quick(), dir_ / "infant",
                             [](const std::string&, double fraction) {
                               if (fraction > 0.85) throw std::runtime_error("stop");
                             }),
               std::runtime_error);
  EXPECT_EQ(names(dir_), std::set<std::string>{"note.txt"});
}

}  // namespace
}  // namespace vallecula::pipeline
