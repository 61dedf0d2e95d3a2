// Label maps of other programs, written byte by byte with values known by construction;
// tests/truth/exchange_formats.py holds the same against SimpleITK, nibabel and pydicom.
#include "pipeline/exchange/label_image.h"

#include <gtest/gtest.h>
#include <zlib.h>

#include <cstdlib>
#include <cstring>
#include <random>

#include "pipeline/exchange/edit_files.h"
#include "pipeline/exchange/label_names.h"
#include "tests/pipeline/exchange/exchange_folder.h"
#include "tests/pipeline/exchange/segmentation_file.h"

namespace vallecula::pipeline {
namespace {

namespace fs = std::filesystem;
using test::expect_message;

class LabelImageFile : public test::ExchangeFolder {
 protected:
  /// Of a damaged file: read whole, or refused with one message; the name may be a person's.
  bool is_refused(const std::string& bytes, std::string* message = nullptr) const {
    const auto file = write("DOE^JANE", bytes);
    try {
      const auto image = read_label_image(file);
      EXPECT_EQ(image.sets.size(), image.place.count());
      return false;
    } catch (const LabelMapError& e) {
      EXPECT_EQ(std::string(e.what()).rfind("label map (name withheld): ", 0), 0U) << e.what();
      if (message != nullptr) *message = e.what();
      return true;
    }
  }
};

/// A grid of 4 x 3 x 2 voxels; value of (i, j, k) is i + 4 j + 12 k, of which those up to 10 are labels.
std::string counting_voxels() {
  std::string v;
  for (int i = 0; i < 24; ++i) v += static_cast<char>(i <= 10 ? i : 0);
  return v;
}

std::string nrrd_header(const std::string& type, const std::string& space, const std::string& directions,
                        const std::string& origin, const std::string& more = "") {
  return "NRRD0004\ntype: " + type + "\ndimension: 3\nspace: " + space +
         "\nsizes: 4 3 2\nspace directions: " + directions +
         "\nkinds: domain domain domain\nencoding: raw\nspace origin: " + origin + "\n" + more + "\n";
}

/// Value of the image at a point, by its nearest voxel, by hand.
std::uint16_t set_at(const LabelImage& image, int i, int j, int k) {
  return image.sets[static_cast<std::size_t>((k * image.place.size[1] + j) * image.place.size[0] + i)];
}

TEST_F(LabelImageFile, NamesAreKnownInTheWordsOfOthers) {
  EXPECT_EQ(label_of_name("Tongue"), kTongue);
  EXPECT_EQ(label_of_name("bone mandible"), kMandible);
  EXPECT_EQ(label_of_name("Mandible"), kMandible);
  EXPECT_EQ(label_of_name("SOFT-PALATE"), kSoftPalate);
  EXPECT_EQ(label_of_name("esophagus"), kOesophagus);
  EXPECT_EQ(label_of_name("vertebrae_C1"), kSpine);
  EXPECT_EQ(label_of_name("vertebrae_T12"), kSpine);
  for (const auto* other : {"", "tongue tumour", "larynx_air", "vertebrae_X1", "trachea", "vertebrae_C1b"})
    EXPECT_EQ(label_of_name(other), std::nullopt) << other;
  for (const auto& label : kLabelNames) {
    EXPECT_EQ(label_of_name(label.name), label.value);
    EXPECT_EQ(label_of_code(label.snomed), label.value);
  }
}

TEST_F(LabelImageFile, NrrdInLpsAndRasLieAtTheSamePlace) {
  // Axes permuted and turned: i to the head, j to the right, k to the front (LPS: -x, -y).
  const auto lps = read_label_image(write(
      "lps.nrrd",
      nrrd_header("uchar", "left-posterior-superior", "(0,0,2) (-3,0,0) (0,-4,0)", "(10,20,30)") + counting_voxels()));
  const auto ras = read_label_image(write(
      "ras.nrrd",
      nrrd_header("uchar", "right-anterior-superior", "(0,0,2) (3,0,0) (0,4,0)", "(-10,-20,30)") + counting_voxels()));
  EXPECT_TRUE(same_place(lps.place, ras.place));
  EXPECT_EQ(lps.place.position(1, 2, 1), (Vector3{10 - 6, 20 - 4, 32}));
  EXPECT_EQ(lps.sets, ras.sets);
  EXPECT_EQ(set_at(lps, 3, 1, 0), bit_of(7));
  // On a grid along the patient's axes that holds each voxel's centre.
  Grid grid;
  grid.size = {3, 2, 4};
  grid.spacing = {3, 4, 2};
  grid.origin = {4, 16, 30};
  const auto labels = on_grid(lps, grid, "lps.nrrd");
  for (int k = 0; k < 2; ++k) {
    for (int j = 0; j < 3; ++j) {
      for (int i = 0; i < 4; ++i) {
        const int value = i + 4 * j + 12 * k;
        EXPECT_EQ(labels.at(2 - j, 1 - k, i), value <= 10 ? value : 0) << i << j << k;
      }
    }
  }
}

TEST_F(LabelImageFile, NamesDecideOverValuesAndUnknownOnesAreLeftOut) {
  const std::string keys =
      "Segment0_ID:=a\nSegment0_Name:=Tongue\nSegment0_LabelValue:=1\nSegment0_Layer:=0\n"
      "Segment1_ID:=b\nSegment1_Name:=Doe, Jane\nSegment1_LabelValue:=2\nSegment1_Layer:=0\n"
      "Segment2_ID:=c\nSegment2_Name:=Zunge 2\nSegment2_LabelValue:=3\nSegment2_Layer:=0\n"
      "Segment2_Tags:=Segmentation.Status:x|TerminologyEntry:C~SCT^123037004^Anatomical "
      "Structure~SCT^4596009^Larynx~^^~A~^^~^^|\n";
  const auto file = write("named.seg.nrrd",
                          nrrd_header("uchar", "LPS", "(1,0,0) (0,1,0) (0,0,1)", "(0,0,0)", keys) + counting_voxels());
  const auto image = read_label_image(file);
  EXPECT_EQ(image.labels, (std::set<std::uint8_t>{kTongue, kLarynx}));
  EXPECT_EQ(image.left_out, 1);
  EXPECT_EQ(set_at(image, 1, 0, 0), bit_of(kTongue));
  EXPECT_EQ(set_at(image, 2, 0, 0), 0);
  EXPECT_EQ(set_at(image, 3, 0, 0), bit_of(kLarynx)) << "by its code";
  Edits edits;
  Grid grid;
  grid.size = {4, 3, 2};
  EditFiles files;
  files.labels = file;
  for (const auto& remark : add_edit_files(files, grid, edits))
    EXPECT_EQ(remark.find("Doe"), std::string::npos) << "a name in the file goes nowhere";
  EXPECT_EQ(edits.replaced, image.labels);

  const auto none = write("none.nrrd", nrrd_header("uchar", "LPS", "(1,0,0) (0,1,0) (0,0,1)", "(0,0,0)",
                                                   "Segment0_ID:=a\nSegment0_Name:=liver\nSegment0_LabelValue:=1\n") +
                                           counting_voxels());
  expect_message([&] { read_label_image(none); }, "tongue, epiglottis");
}

TEST_F(LabelImageFile, LayersOverlapAndTheFinerStructureHasTheVoxel) {
  std::string voxels;
  for (int i = 0; i < 24; ++i) {
    voxels += static_cast<char>(i < 12 ? 1 : 0);            // layer 0: skin
    voxels += static_cast<char>(i >= 6 && i < 18 ? 3 : 0);  // layer 1: tongue
  }
  const std::string header =
      "NRRD0005\ntype: uchar\ndimension: 4\nspace: LPS\nsizes: 2 4 3 2\nspace directions: none (1,0,0) (0,1,0) "
      "(0,0,1)\n"
      "kinds: list domain domain domain\nencoding: raw\nspace origin: (0,0,0)\n";
  const auto file = write("layers.seg.nrrd",
                          header +
                              "Segment0_ID:=a\nSegment0_Name:=skin\nSegment0_LabelValue:=1\nSegment0_Layer:=0\n"
                              "Segment1_ID:=b\nSegment1_Name:=tongue\nSegment1_LabelValue:=3\nSegment1_Layer:=1\n\n" +
                              voxels);
  const auto image = read_label_image(file);
  Grid grid;
  grid.size = {4, 3, 2};
  const auto labels = on_grid(image, grid, file);
  for (std::size_t i = 0; i < 24; ++i) {
    EXPECT_EQ(image.sets[i], (i < 12 ? bit_of(kSkin) : 0) | (i >= 6 && i < 18 ? bit_of(kTongue) : 0)) << i;
    EXPECT_EQ(labels.voxels[i], i >= 6 && i < 18 ? kTongue : i < 6 ? kSkin : kBackground) << i;
  }
  const auto lost =
      write("lost.seg.nrrd", header + "Segment0_ID:=a\nSegment0_Name:=skin\nSegment0_Layer:=2\n\n" + voxels);
  expect_message([&] { read_label_image(lost); }, "layer");
}

/// NIfTI-1 with an sform in RAS: axes i, j, k along -x, y, z.
std::string nifti(std::int16_t datatype, std::int16_t bits, const std::string& voxels, float slope = 1.0F) {
  std::string h(352, '\0');
  const auto put = [&](std::size_t at, auto value) { std::memcpy(h.data() + at, &value, sizeof(value)); };
  put(0, std::int32_t{348});
  const std::int16_t dim[8] = {3, 4, 3, 2, 1, 1, 1, 1};
  for (int i = 0; i < 8; ++i) put(40 + 2 * i, dim[i]);
  put(70, datatype);
  put(72, bits);
  put(108, 352.0F);
  put(112, slope);
  put(123, std::uint8_t{2});
  put(254, std::int16_t{1});
  const float rows[12] = {-2, 0, 0, -10, 0, 3, 0, -20, 0, 0, 4, 30};
  for (int i = 0; i < 12; ++i) put(280 + 4 * i, rows[i]);
  std::memcpy(h.data() + 344, "n+1\0", 4);
  return h + voxels;
}

TEST_F(LabelImageFile, NiftiIsTurnedFromRasToLps) {
  const auto file = write("a.nii", nifti(2, 8, counting_voxels()));
  const auto image = read_label_image(file);
  EXPECT_EQ(image.place.position(0, 0, 0), (Vector3{10, 20, 30}));
  EXPECT_EQ(image.place.position(1, 1, 1), (Vector3{12, 17, 34}));
  EXPECT_EQ(set_at(image, 2, 1, 0), bit_of(6));

  std::string wide;
  for (const char c : counting_voxels()) {
    const float v = static_cast<float>(c);
    wide.append(reinterpret_cast<const char*>(&v), sizeof(v));
  }
  EXPECT_EQ(read_label_image(write("f.nii", nifti(16, 32, wide))).sets, image.sets);
  gzFile packed = ::gzopen((folder_ / "a.nii.gz").c_str(), "wb");
  const auto bytes = text_of(file);
  ::gzwrite(packed, bytes.data(), static_cast<unsigned>(bytes.size()));
  ::gzclose(packed);
  EXPECT_EQ(read_label_image(folder_ / "a.nii.gz").sets, image.sets);

  expect_message([&] { read_label_image(write("s.nii", nifti(2, 8, counting_voxels(), 0.5F))); }, "scaled");
  std::string other = counting_voxels();
  other[23] = 77;
  expect_message([&] { read_label_image(write("o.nii", nifti(2, 8, other))); }, "77");
  const auto mapped = read_label_image(folder_ / "o.nii", {{77, kTongue}});
  EXPECT_EQ(mapped.labels, (std::set<std::uint8_t>{kTongue}));
  EXPECT_EQ(set_at(mapped, 3, 2, 1), bit_of(kTongue));
}

/// 3 columns, 2 rows, slices at z 5, 7 and 11 (that at 9 is empty and left out).
test::SegmentationFile segmentation() {
  test::SegmentationFile s;
  s.segments = {{"tongue", "21974007"}, {"Unterkiefer", "91609006"}, {"Doe^Jane", "1"}};
  s.columns = 3;
  s.rows = 2;
  s.spacing = "3\\4";  // rows 3 mm apart, columns 4 mm
  s.thickness = "2";
  s.frames = {{1, "1\\2\\11", {1, 0, 0, 0, 0, 1}},
              {1, "1\\2\\5", {0, 1, 1, 0, 0, 0}},
              {2, "1\\2\\7", {0, 0, 0, 1, 0, 0}},
              {2, "1\\2\\5", {0, 0, 1, 1, 0, 0}},
              {3, "1\\2\\5", {1, 1, 1, 1, 1, 1}}};
  return s;
}

TEST_F(LabelImageFile, DicomSegmentationByItsFramesPlaces) {
  const auto file = folder_ / "seg.dcm";
  test::write_segmentation(segmentation(), file);
  const auto image = read_label_image(file);
  EXPECT_EQ(image.place.size, (std::array<int, 3>{3, 2, 4}));
  EXPECT_EQ(image.place.position(2, 1, 3), (Vector3{1 + 8, 2 + 3, 11}));
  EXPECT_EQ(image.labels, (std::set<std::uint8_t>{kTongue, kMandible}));
  EXPECT_EQ(image.left_out, 1);
  EXPECT_EQ(set_at(image, 1, 0, 0), bit_of(kTongue));
  EXPECT_EQ(set_at(image, 2, 0, 0), bit_of(kTongue) | bit_of(kMandible)) << "segments may overlap";
  EXPECT_EQ(set_at(image, 0, 1, 1), bit_of(kMandible));
  EXPECT_EQ(set_at(image, 0, 0, 3), bit_of(kTongue));
  EXPECT_EQ(set_at(image, 2, 1, 3), bit_of(kTongue));
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 2; ++j) EXPECT_EQ(set_at(image, i, j, 2), 0);
  }
  const auto refused = [&](const auto& change, const std::string& naming) {
    auto s = segmentation();
    change(s);
    test::write_segmentation(s, file);
    expect_message([&] { read_label_image(file); }, naming);
  };
  refused([](auto& s) { s.modality = "CT"; }, "SEG");
  refused([](auto& s) { s.type = "SURFACE"; }, "SURFACE");
  refused([](auto& s) { s.frames[1].position = "1\\2\\5.9"; }, "evenly");
  refused([](auto& s) { s.frames[1].position = "3\\2\\5"; }, "evenly");
  refused([](auto& s) { s.frames[1].position = "1\\2"; }, "where it lies");
  refused([](auto& s) { s.frames.pop_back(), s.frames.back().ones.clear(), s.frames[0].ones.clear(); }, "cut short");
  refused([](auto& s) { s.orientation = "1\\0\\0\\1\\0\\0"; }, "right angles");
  refused([](auto& s) { s.frames[0].position = "1\\2\\900000"; }, "apart");
  refused([](auto& s) { s.segments.clear(); }, "segments");
}

TEST_F(LabelImageFile, AnotherScansLabelsAreRefused) {
  const auto file =
      write("far.nrrd", nrrd_header("uchar", "LPS", "(1,0,0) (0,1,0) (0,0,1)", "(500,0,0)") + counting_voxels());
  Grid grid;
  grid.size = {40, 40, 40};
  expect_message([&] { on_grid(read_label_image(file), grid, file); }, "another scan");
}

/// GDCM ends the process on some of these: that process is the helper's, and its death is one message.
TEST_F(LabelImageFile, DamageThatEndsTheDicomLibraryIsOneMessage) {
  auto file = segmentation();
  file.open_lengths = true;
  test::write_segmentation(file, folder_ / "seg.dcm");
  EXPECT_EQ(read_label_image(folder_ / "seg.dcm").labels, (std::set<std::uint8_t>{kTongue, kMandible}));
  const auto whole = text_of(folder_ / "seg.dcm");
  // GDCM 3.0 of Debian 12 asserts that an open length is a sequence's or unknown: SV is neither.
  int died = 0;
  const auto mark = std::string("SQ\0\0", 4) + std::string(4, '\xff');
  for (auto at = whole.find(mark); at != std::string::npos; at = whole.find(mark, at + 1)) {
    auto damaged = whole;
    damaged[at + 1] = 'V';
    std::string message;
    EXPECT_TRUE(is_refused(damaged, &message));
    died += message ==
            "label map (name withheld): the DICOM library does not survive this file; it is damaged: copy it again or "
            "leave it out";
  }
  EXPECT_GT(died, 10);
  std::mt19937 random(7);
  int refused = 0;
  for (int trial = 0; trial < 300; ++trial) {
    auto damaged = whole;
    for (int n = 0; n < 1 + trial % 4; ++n)
      damaged[132 + random() % (damaged.size() - 132)] = static_cast<char>(random());
    refused += is_refused(damaged) ? 1 : 0;
  }
  EXPECT_GT(refused, 150);
}

/// Truth for damaged files is only this: read, or refused with one message, and quickly.
TEST_F(LabelImageFile, DamagedFilesAreReadOrRefused) {
  test::write_segmentation(segmentation(), folder_ / "seg.dcm");
  const std::vector<std::string> whole = {
      nrrd_header("ushort", "LPS", "(1,0,0) (0,1,0) (0,0,1)", "(0,0,0)",
                  "endian: little\nSegment0_ID:=a\nSegment0_Name:=tongue\nSegment0_LabelValue:=1\n") +
          std::string(48, '\1'),
      nifti(2, 8, counting_voxels()), text_of(folder_ / "seg.dcm")};
  int refused = 0;
  const bool slow = std::getenv("VALLECULA_SLOW") != nullptr;
  for (const auto& bytes : whole) {
    // Each DICOM file starts the helper.
    const bool dicom = &bytes == &whole.back();
    const int trials = dicom ? (slow ? 4000 : 150) : (slow ? 40000 : 400);
    std::mt19937 random(5);
    for (int trial = 0; trial < trials; ++trial) {
      auto damaged = bytes;
      if (trial % 4 == 0) {
        damaged.resize(random() % damaged.size());
      } else {
        for (int n = 0; n < 1 + trial % 3; ++n) damaged[random() % damaged.size()] = static_cast<char>(random());
      }
      refused += is_refused(damaged) ? 1 : 0;
    }
  }
  EXPECT_GT(refused, 200);
  expect_message(
      [&] {
        read_label_image(write("huge.nrrd",
                               "NRRD0004\ntype: uchar\ndimension: 3\nspace: LPS\nsizes: 4096 "
                               "4096 4096\nspace directions: (1,0,0) (0,1,0) (0,0,1)\n"
                               "encoding: gzip\nspace origin: (0,0,0)\n\n"));
      },
      "million");
  expect_message([&] { read_label_image(folder_ / "label7.nrrd"); }, "label7.nrrd");
  expect_message([&] { read_label_image(folder_); }, "cannot be opened");
}

}  // namespace
}  // namespace vallecula::pipeline
