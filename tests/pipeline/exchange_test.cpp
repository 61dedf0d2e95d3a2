// Label maps, landmarks and surfaces from and for other programs. Files are written here byte by byte, with values known
// by construction; tests/truth/exchange_formats.py holds the same against SimpleITK, nibabel and pydicom.
#include <gtest/gtest.h>
#include <unistd.h>
#include <zlib.h>

#include <cmath>
#include <cstring>
#include <fstream>
#include <random>
#include <sstream>

#include "pipeline/exchange/compare.h"
#include "pipeline/exchange/edit_files.h"
#include "pipeline/exchange/label_image.h"
#include "pipeline/exchange/label_names.h"
#include "pipeline/exchange/landmark_file.h"
#include "pipeline/exchange/stl_files.h"
#include "pipeline/mesh/surface_check.h"
#include "tests/pipeline/segmentation_file.h"

namespace vallecula::pipeline {
namespace {

namespace fs = std::filesystem;

class Exchange : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::temp_directory_path() / ("vallecula-exchange-test-" + std::to_string(::getpid()));
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  fs::path write(const std::string& name, const std::string& bytes) const {
    std::ofstream(folder_ / name, std::ios::binary) << bytes;
    return folder_ / name;
  }
  static std::string text_of(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    std::ostringstream all;
    all << in.rdbuf();
    return all.str();
  }
  fs::path folder_;
};

template <class Work>
void expect_message(const Work& work, const std::string& naming) {
  try {
    work();
    FAIL() << "accepted; expected a message that names " << naming;
  } catch (const std::runtime_error& e) {
    EXPECT_NE(std::string(e.what()).find(naming), std::string::npos) << e.what();
  }
}

/// A grid of 4 x 3 x 2 voxels; value of (i, j, k) is i + 4 j + 12 k, of which those up to 10 are labels.
std::string counting_voxels() {
  std::string v;
  for (int i = 0; i < 24; ++i) v += static_cast<char>(i <= 10 ? i : 0);
  return v;
}

std::string nrrd_header(const std::string& type, const std::string& space, const std::string& directions,
                        const std::string& origin, const std::string& more = "") {
  return "NRRD0004\ntype: " + type + "\ndimension: 3\nspace: " + space + "\nsizes: 4 3 2\nspace directions: " + directions +
         "\nkinds: domain domain domain\nencoding: raw\nspace origin: " + origin + "\n" + more + "\n";
}

/// Value of the image at a point, by its nearest voxel, by hand.
std::uint16_t set_at(const LabelImage& image, int i, int j, int k) {
  return image.sets[static_cast<std::size_t>((k * image.place.size[1] + j) * image.place.size[0] + i)];
}

TEST_F(Exchange, NamesAreKnownInTheWordsOfOthers) {
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

TEST_F(Exchange, NrrdInLpsAndRasLieAtTheSamePlace) {
  // Axes permuted and turned: i to the head, j to the right, k to the front (LPS: -x, -y).
  const auto lps = read_label_image(
      write("lps.nrrd", nrrd_header("uchar", "left-posterior-superior", "(0,0,2) (-3,0,0) (0,-4,0)", "(10,20,30)") +
                            counting_voxels()));
  const auto ras = read_label_image(
      write("ras.nrrd", nrrd_header("uchar", "right-anterior-superior", "(0,0,2) (3,0,0) (0,4,0)", "(-10,-20,30)") +
                            counting_voxels()));
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

TEST_F(Exchange, NamesDecideOverValuesAndUnknownOnesAreLeftOut) {
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

TEST_F(Exchange, LayersOverlapAndTheFinerStructureHasTheVoxel) {
  std::string voxels;
  for (int i = 0; i < 24; ++i) {
    voxels += static_cast<char>(i < 12 ? 1 : 0);           // layer 0: skin
    voxels += static_cast<char>(i >= 6 && i < 18 ? 3 : 0);  // layer 1: tongue
  }
  const std::string header =
      "NRRD0005\ntype: uchar\ndimension: 4\nspace: LPS\nsizes: 2 4 3 2\nspace directions: none (1,0,0) (0,1,0) (0,0,1)\n"
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
  const auto lost = write("lost.seg.nrrd", header + "Segment0_ID:=a\nSegment0_Name:=skin\nSegment0_Layer:=2\n\n" + voxels);
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

TEST_F(Exchange, NiftiIsTurnedFromRasToLps) {
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

TEST_F(Exchange, DicomSegmentationByItsFramesPlaces) {
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

TEST_F(Exchange, AnotherScansLabelsAreRefused) {
  const auto file = write("far.nrrd", nrrd_header("uchar", "LPS", "(1,0,0) (0,1,0) (0,0,1)", "(500,0,0)") + counting_voxels());
  Grid grid;
  grid.size = {40, 40, 40};
  expect_message([&] { on_grid(read_label_image(file), grid, file); }, "another scan");
}

/// Truth for damaged files is only this: read, or refused with one message, and quickly.
TEST_F(Exchange, DamagedFilesAreReadOrRefused) {
  test::write_segmentation(segmentation(), folder_ / "seg.dcm");
  const std::vector<std::string> whole = {
      nrrd_header("ushort", "LPS", "(1,0,0) (0,1,0) (0,0,1)", "(0,0,0)",
                  "endian: little\nSegment0_ID:=a\nSegment0_Name:=tongue\nSegment0_LabelValue:=1\n") +
          std::string(48, '\1'),
      nifti(2, 8, counting_voxels()), text_of(folder_ / "seg.dcm")};
  std::mt19937 random(5);
  int refused = 0;
  for (const auto& bytes : whole) {
    for (int trial = 0; trial < 400; ++trial) {
      auto damaged = bytes;
      if (trial % 4 == 0) {
        damaged.resize(random() % damaged.size());
      } else {
        for (int n = 0; n < 1 + trial % 3; ++n) damaged[random() % damaged.size()] = static_cast<char>(random());
      }
      const auto file = write("damaged", damaged);
      try {
        const auto image = read_label_image(file);
        EXPECT_EQ(image.sets.size(), image.place.count());
      } catch (const LabelMapError& e) {
        EXPECT_NE(std::string(e.what()).find("damaged"), std::string::npos);
        ++refused;
      }
    }
  }
  EXPECT_GT(refused, 200);
  expect_message([&] { read_label_image(write("huge.nrrd", "NRRD0004\ntype: uchar\ndimension: 3\nspace: LPS\nsizes: 4096 "
                                                          "4096 4096\nspace directions: (1,0,0) (0,1,0) (0,0,1)\n"
                                                          "encoding: gzip\nspace origin: (0,0,0)\n\n")); },
                 "million");
  expect_message([&] { read_label_image(folder_ / "nowhere.nrrd"); }, "nowhere.nrrd");
  expect_message([&] { read_label_image(folder_); }, "cannot be opened");
}

PatientPackage package_with_landmarks() {
  PatientPackage p;
  double v = 1.0;
  for (const auto* name : kLandmarks) {
    p.landmarks[name] = {v, -2.0 * v, 30.0 + v};
    v += 1.5;
  }
  p.landmarks["glottis_normal"] = {0.0, -0.6, 0.8};
  p.findings["carina"] = {Origin::inferred, "a rule with \"quotes\""};
  return p;
}

TEST_F(Exchange, LandmarksGoOutAndOnlyMovedOnesComeBack) {
  const auto package = package_with_landmarks();
  const auto file = folder_ / "l.mrk.json";
  write_landmark_file(package, file);
  auto given = read_landmark_file(file);
  EXPECT_TRUE(given.moved.empty());
  EXPECT_EQ(given.unmoved, 10);

  auto text = text_of(file);
  const std::string carina = "\"position\": [8.5000, -17.0000, 38.5000]";
  ASSERT_NE(text.find(carina), std::string::npos) << text;
  text.replace(text.find(carina), carina.size(), "\"position\": [8.5, -16.25, 38.5]");
  given = read_landmark_file(write("moved.mrk.json", text));
  ASSERT_EQ(given.moved.size(), 1u);
  EXPECT_EQ(given.moved.at("carina"), (Point{8.5, -16.25, 38.5}));

  // What another program wrote, in RAS with tabs: all its points count, and the direction is a point beside the glottis.
  const auto ras = read_landmark_file(write(
      "ras.mrk.json",
      "{\"markups\": [{\"type\": \"Fiducial\", \"coordinateSystem\": \"RAS\",\n\t\"controlPoints\": [\n"
      "\t\t{\"label\": \"glottis_centre\", \"position\": [-1.0, -2.0, 3.0]},\n"
      "\t\t{\"label\": \"glottis_normal\", \"position\": [-1.0, -2.0, 13.0], \"positionStatus\": \"defined\"},\n"
      "\t\t{\"label\": \"Jane Doe\", \"position\": [0, 0, 0]},\n"
      "\t\t{\"label\": \"carina\", \"position\": [0, 0, 0], \"positionStatus\": \"undefined\"}]}]}"));
  EXPECT_EQ(ras.moved.at("glottis_centre"), (Point{1, 2, 3}));
  EXPECT_EQ(ras.moved.at("glottis_normal"), (Point{0, 0, 1}));
  EXPECT_EQ(ras.left_out, 2);

  expect_message([&] { read_landmark_file(write("x.mrk.json", "{\"markups\": [")); }, "x.mrk.json");
  expect_message([&] { read_landmark_file(write("y.mrk.json", "[1, 2]")); }, "y.mrk.json");
  expect_message([&] { read_landmark_file(write("z.mrk.json", "{\"markups\": [{\"controlPoints\": [{\"label\": "
                                                              "\"F-1\", \"position\": [0,0,0]}]}]}")); },
                 "upper_gum_midline");
  expect_message([&] { read_landmark_file(write("n.mrk.json", "{\"markups\": [{\"controlPoints\": [{\"label\": "
                                                              "\"carina\", \"position\": [0,\"a\",0]}]}]}")); },
                 "n.mrk.json");
  expect_message([&] { read_landmark_file(folder_ / "nowhere.mrk.json"); }, "nowhere.mrk.json");
}

TEST_F(Exchange, LandmarksLieOnTheScanWhereverThePackageWasMoved) {
  auto package = package_with_landmarks();
  // A quarter turn about x, a shift, all lengths halved: scan (1, 2, 3) is package (0.5 * (1, -3, 2) + (5, 6, 7)).
  package.pose.scan_to_package = {0.5, 0, 0, 5, 0, 0, -0.5, 6, 0, 0.5, 0, 7, 0, 0, 0, 1};
  package.pose.scale = 0.5;
  package.pose.mouth_opened_deg = 12.0;
  package.landmarks["carina"] = {5.5, 4.5, 8.0};
  const auto file = folder_ / "l.mrk.json";
  write_landmark_file(package, file);
  EXPECT_NE(text_of(file).find("[1.0000, 2.0000, 3.0000]"), std::string::npos);
  EXPECT_NE(text_of(file).find("mouth"), std::string::npos) << "what a rigid way back cannot undo is said";
}

TEST_F(Exchange, BorderOfTetrahedraIsClosedAndLooksOutwards) {
  // A cube of five tetrahedra.
  TetMesh mesh;
  for (int i = 0; i < 8; ++i) mesh.points.push_back({double(i & 1), double(i >> 1 & 1), double(i >> 2 & 1)});
  mesh.points.push_back({9, 9, 9});  // used by none
  mesh.tets = {{0, 1, 2, 4}, {3, 2, 1, 7}, {5, 1, 4, 7}, {6, 4, 2, 7}, {1, 2, 4, 7}};
  for (auto& t : mesh.tets) {
    const auto& p = mesh.points;
    if (dot(cross(p[t[1]] - p[t[0]], p[t[2]] - p[t[0]]), p[t[3]] - p[t[0]]) < 0) std::swap(t[0], t[1]);
  }
  const auto border = border_of(mesh);
  EXPECT_EQ(border.points.size(), 8u);
  EXPECT_EQ(border.triangles.size(), 12u);
  const auto f = facts_of(border);
  EXPECT_TRUE(f.closed && f.manifold) << f.fault;
  EXPECT_NEAR(f.volume_mm3, 1.0, 1e-12);

  PatientPackage package;
  package.surfaces["face"] = border;
  package.tongue = mesh;
  EXPECT_EQ(write_stl_files(package, folder_ / "stl"), (std::vector<std::string>{"face.stl", "tongue.stl"}));
  const auto bytes = text_of(folder_ / "stl" / "tongue.stl");
  EXPECT_EQ(bytes.size(), 84u + 50u * 12u) << "binary STL";
  EXPECT_NE(bytes.substr(0, 80).find("LPS"), std::string::npos);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_ / "stl"), fs::directory_iterator()), 2);
  write("file", "in the way");
  EXPECT_THROW(write_stl_files(package, folder_ / "file"), PackageError);
}

LabelImage boxes(std::array<int, 3> low, std::array<int, 3> high, std::uint8_t label) {
  LabelImage image;
  image.place.size = {40, 30, 20};
  image.place.step = {{{0.5, 0, 0}, {0, 1.0, 0}, {0, 0, 2.0}}};
  image.sets.assign(image.place.count(), 0);
  for (int k = low[2]; k <= high[2]; ++k) {
    for (int j = low[1]; j <= high[1]; ++j) {
      for (int i = low[0]; i <= high[0]; ++i) image.sets[static_cast<std::size_t>((k * 30 + j) * 40 + i)] = bit_of(label);
    }
  }
  return image;
}

TEST_F(Exchange, ComparisonOfShiftedBoxesIsExact) {
  // 20 x 10 x 5 voxels moved by 4 along i (2 mm): overlap 16 of 20.
  const auto a = boxes({5, 5, 5}, {24, 14, 9}, kTongue);
  const auto b = boxes({9, 5, 5}, {28, 14, 9}, kTongue);
  auto c = compare_labels(a, b);
  ASSERT_EQ(c.structures.size(), 1u);
  EXPECT_FALSE(c.resampled);
  EXPECT_EQ(c.structures[0].voxels, (std::array<std::size_t, 2>{1000, 1000}));
  EXPECT_NEAR(c.structures[0].millilitres[0], 1.0, 1e-12);
  EXPECT_NEAR(c.structures[0].dice, 0.8, 1e-12);
  EXPECT_NEAR(c.structures[0].hausdorff_mm, 2.0, 1e-6);
  EXPECT_NEAR(c.structures[0].hausdorff_95_mm, 2.0, 1e-6) << "a face of 50 is more than a twentieth of 704";
  // Boxes one in the other, 1 mm (i: 2 voxels) larger on the i side alone: that face of 50 voxels is 1 mm away.
  const auto grown = boxes({5, 5, 5}, {26, 14, 9}, kTongue);
  c = compare_labels(a, grown);
  EXPECT_NEAR(c.structures[0].hausdorff_mm, 1.0, 1e-6);
  EXPECT_NEAR(c.structures[0].dice, 2.0 * 1000 / 2100, 1e-12);
  const auto same = compare_labels(a, a);
  EXPECT_EQ(same.structures[0].dice, 1.0);
  EXPECT_EQ(same.structures[0].mean_surface_mm, 0.0);

  // The same box said from the other end of the axis: another grid, the same place.
  auto mirrored = a;
  mirrored.place.origin = a.place.position(39, 0, 0);
  mirrored.place.step[0] = -1.0 * a.place.step[0];
  for (std::size_t i = 0; i < a.sets.size(); ++i) mirrored.sets[i - i % 40 + 39 - i % 40] = a.sets[i];
  c = compare_labels(a, mirrored);
  EXPECT_TRUE(c.resampled);
  EXPECT_EQ(c.structures[0].dice, 1.0);

  const auto other = boxes({5, 5, 5}, {6, 6, 6}, kAirway);
  c = compare_labels(a, other);
  ASSERT_EQ(c.structures.size(), 2u);
  EXPECT_EQ(c.structures[0].voxels[1], 0u);
  EXPECT_EQ(c.structures[0].dice, 0.0);
  EXPECT_TRUE(std::isnan(c.structures[0].hausdorff_mm));
  auto far = a;
  far.place.origin = {900, 0, 0};
  expect_message([&] { compare_labels(a, far); }, "same scan");
}

TEST_F(Exchange, ComparisonOfConcentricBallsIsTheirRadiiApart) {
  const auto ball = [](double radius) {
    LabelImage image;
    image.place.size = {61, 61, 61};
    image.place.step = {{{0.5, 0, 0}, {0, 0.5, 0}, {0, 0, 0.5}}};
    image.sets.assign(image.place.count(), 0);
    std::size_t at = 0;
    for (int k = 0; k < 61; ++k) {
      for (int j = 0; j < 61; ++j) {
        for (int i = 0; i < 61; ++i, ++at)
          image.sets[at] = std::hypot(0.5 * (i - 30), 0.5 * (j - 30), 0.5 * (k - 30)) <= radius ? bit_of(kTongue) : 0;
      }
    }
    return image;
  };
  const auto c = compare_labels(ball(9.0), ball(12.0));
  const double ratio = std::pow(9.0 / 12.0, 3);
  EXPECT_NEAR(c.structures[0].dice, 2.0 * ratio / (1.0 + ratio), 0.01);
  EXPECT_NEAR(c.structures[0].hausdorff_mm, 3.0, 0.5) << "within a voxel";
  EXPECT_NEAR(c.structures[0].mean_surface_mm, 3.0, 0.15);
  EXPECT_LE(c.structures[0].hausdorff_95_mm, c.structures[0].hausdorff_mm);
}

}  // namespace
}  // namespace vallecula::pipeline
