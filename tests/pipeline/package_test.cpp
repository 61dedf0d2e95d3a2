// A package that was written is read back as it was, and one that was touched since is refused by the touched file's
// name.
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkStringArray.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <fstream>
#include <random>

#include "pipeline/package/aside.h"
#include "pipeline/package/label_map.h"
#include "pipeline/package/patient_package.h"

namespace vallecula::pipeline {
namespace {

namespace fs = std::filesystem;

Surface tetrahedron_surface(double scale, bool with_tissue) {
  Surface s;
  s.points = {{0, 0, 0}, {scale, 0, 0}, {0, scale, 0}, {0, 0, scale / 3.0}};
  s.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  if (with_tissue) s.tissue = {0, 1, 4, 5};
  return s;
}

PatientPackage example() {
  PatientPackage p;
  p.name = "example";
  p.provenance = {{"modality", "CT"}, {"note", "quotes \" and : colons"}};
  double v = 0.1;
  for (const auto* name : kLandmarks) {
    p.landmarks[name] = {v, -v / 3.0, v * v};
    v += 1.7;
  }
  p.materials["tongue"] = {6000.0, 0.45, 1040.0};
  p.materials["epiglottis"] = {90e3, 0.45, 1040.0};
  for (const auto* name : kSurfaces) p.surfaces[name] = tetrahedron_surface(7.0 + name[0], std::string(name) == "face");
  p.tongue.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}};
  p.tongue.tets = {{0, 1, 2, 3}, {1, 2, 3, 4}};
  p.tongue.tissue = {0, 1};
  p.tongue.anchor = {1, 2, 3, 0, 0};
  p.tongue.contact = {2, 2, 0, 1, 1};
  p.quality = {{"tongue volume", 7.25, "ml", true, ""},
               {"watertight", 0.0, "", false, "open: at the back"},
               {"head size", 1.02, "of term", true, "a figure without a limit", false},
               {"carina", std::nullopt, "", false, "inferred: below the scan"}};
  return p;
}

Labels example_labels() {
  Grid g;
  g.size = {7, 9, 11};
  g.spacing = {0.5, 0.6, 0.7};
  g.origin = {-1.0, 2.0, -3.25};
  Labels labels(g);
  std::mt19937 random(3);
  for (auto& v : labels.voxels) v = static_cast<std::uint8_t>(random() % 11);
  return labels;
}

class Package : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::temp_directory_path() / ("vallecula-package-test-" + std::to_string(::getpid()));
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  fs::path written() {
    const auto dir = folder_ / "example.patient";
    write_package(example(), example_labels(), dir);
    return dir;
  }
  fs::path folder_;
};

TEST_F(Package, ReadsBackWhatWasWritten) {
  const auto dir = written();
  const auto in = example();
  const auto out = read_package(dir);
  EXPECT_EQ(out.schema, 1);
  EXPECT_EQ(out.name, in.name);
  EXPECT_EQ(out.provenance, in.provenance);
  EXPECT_EQ(out.landmarks, in.landmarks);
  ASSERT_EQ(out.surfaces.size(), in.surfaces.size());
  for (const auto& [name, surface] : in.surfaces) {
    EXPECT_EQ(out.surfaces.at(name).points, surface.points) << name;
    EXPECT_EQ(out.surfaces.at(name).triangles, surface.triangles) << name;
    EXPECT_EQ(out.surfaces.at(name).tissue, surface.tissue) << name;
  }
  EXPECT_EQ(out.tongue.points, in.tongue.points);
  EXPECT_EQ(out.tongue.tets, in.tongue.tets);
  EXPECT_EQ(out.tongue.tissue, in.tongue.tissue);
  EXPECT_EQ(out.tongue.anchor, in.tongue.anchor);
  EXPECT_EQ(out.tongue.contact, in.tongue.contact);
  EXPECT_EQ(out.materials.at("epiglottis").young_pa, 90e3);
  ASSERT_EQ(out.quality.size(), 4u);
  EXPECT_EQ(out.quality[1].note, in.quality[1].note);
  EXPECT_FALSE(out.quality[1].ok);
  EXPECT_TRUE(out.quality[1].judged);
  EXPECT_FALSE(out.quality[2].judged);
  EXPECT_EQ(out.quality[1].value, in.quality[1].value);
  EXPECT_EQ(out.quality[3].value, std::nullopt) << "a remark has no figure";
  EXPECT_EQ(read_label_map(dir / "labels.nrrd").voxels, example_labels().voxels);
}

TEST_F(Package, LeavesNothingElseBehind) {
  const auto dir = written();
  written();  // replaces the first
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()), 1);
  EXPECT_NO_THROW(read_package(dir));
}

/// The labels lie on the scan's grid, the landmarks in the package's frame.
TEST_F(Package, TheThumbnailCutsTheScanThroughItsOwnMiddle) {
  const auto thumbnail = [&](double gum_x, double shift_x) {
    auto package = example();
    package.landmarks["upper_gum_midline"][0] = gum_x;
    package.pose.scan_to_package[3] = shift_x;
    const auto dir = folder_ / "cut.patient";
    write_package(package, example_labels(), dir);
    std::ifstream in(dir / "thumbnail.png", std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(in), {});
  };
  const auto middle = thumbnail(0.5, 0.0);
  EXPECT_NE(middle, thumbnail(-1.0, 0.0)) << "another cut is another picture";
  EXPECT_EQ(middle, thumbnail(40.5, 40.0));
}

TEST_F(Package, TheTongueSaysItsMaterialsToOtherPrograms) {
  vtkNew<vtkXMLUnstructuredGridReader> reader;
  reader->SetFileName((written() / "tongue.vtu").c_str());
  reader->Update();
  auto* fields = reader->GetOutput()->GetFieldData();
  ASSERT_NE(fields->GetArray("young_pa"), nullptr);
  EXPECT_EQ(fields->GetArray("young_pa")->GetComponent(0, 0), 6000.0);
  EXPECT_EQ(fields->GetArray("young_pa")->GetComponent(1, 0), 90e3);
  EXPECT_EQ(fields->GetArray("poisson")->GetComponent(1, 0), 0.45);
  auto* names = vtkStringArray::SafeDownCast(fields->GetAbstractArray("tissue_names"));
  ASSERT_NE(names, nullptr);
  EXPECT_EQ(names->GetValue(1), "epiglottis");
}

TEST_F(Package, KilledWhileWritingThereIsAWholePackageOrNone) {
  const auto dir = folder_ / "example.patient";
  const auto labels = example_labels();
  std::mt19937 random(5);
  int none = 0;
  for (int kill = 0; kill < 60; ++kill) {
    if (kill < 20) fs::remove_all(dir);  // at first there is nothing to replace
    const bool was_there = fs::exists(dir);
    const pid_t child = ::fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
      for (;;) write_package(example(), labels, dir);
    }
    ::usleep(random() % 30000);
    ::kill(child, SIGKILL);
    int status = 0;
    ::waitpid(child, &status, 0);
    if (!fs::exists(dir)) {
      ASSERT_FALSE(was_there) << "a package that was there is not lost";
      ++none;
      continue;
    }
    ASSERT_NO_THROW(read_package(dir)) << kill;
  }
  EXPECT_GT(none, 0) << "some were killed before there was anything";
  write_package(example(), labels, dir);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()), 1) << "what they left is gone";
}

TEST_F(Package, AnOldPackageWhoseSuccessorNeverCameIsPutBack) {
  const auto dir = written();
  const pid_t dead = ::fork();
  if (dead == 0) ::_exit(0);
  ::waitpid(dead, nullptr, 0);
  const auto old = folder_ / (".example.patient." + std::to_string(dead) + ".old");
  fs::rename(dir, old);
  clean_asides(dir);
  EXPECT_NO_THROW(read_package(dir));
  EXPECT_FALSE(fs::exists(old));
  // What a living process is making is not touched.
  const auto living = folder_ / (".example.patient." + std::to_string(::getppid()) + ".part");
  fs::create_directory(living);
  clean_asides(dir);
  EXPECT_TRUE(fs::exists(living));
}

TEST_F(Package, AnyChangedByteIsRefusedByName) {
  const auto dir = written();
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(dir)) files.push_back(entry.path());
  ASSERT_EQ(files.size(),
            kSurfaces.size() + 5);  // patient.yaml, labels.nrrd, landmarks.mrk.json, tongue.vtu, thumbnail
  std::mt19937 random(11);
  for (const auto& file : files) {
    for (int trial = 0; trial < 5; ++trial) {
      const auto at = static_cast<std::streamoff>(random() % fs::file_size(file));
      std::fstream bytes(file, std::ios::binary | std::ios::in | std::ios::out);
      bytes.seekg(at);
      const char before = static_cast<char>(bytes.get());
      const auto poke = [&](char c) {
        bytes.seekp(at);
        bytes.put(c);
        bytes.flush();
      };
      poke(static_cast<char>(before ^ (1 << (random() % 7))));
      try {
        read_package(dir);
        FAIL() << file << " changed at byte " << at << " and was accepted";
      } catch (const PackageError& e) {
        EXPECT_NE(std::string(e.what()).find(file.filename().string()), std::string::npos) << e.what();
      }
      poke(before);
    }
  }
  EXPECT_NO_THROW(read_package(dir));
}

TEST_F(Package, MissingThingsAreNamed) {
  const auto dir = written();
  fs::remove(dir / "airway.vtp");
  try {
    read_package(dir);
    FAIL();
  } catch (const PackageError& e) {
    EXPECT_NE(std::string(e.what()).find("airway.vtp"), std::string::npos);
  }
  EXPECT_THROW(read_package(folder_ / "nowhere.patient"), PackageError);
  EXPECT_THROW(read_package(folder_), PackageError);

  auto incomplete = example();
  incomplete.landmarks.erase("carina");
  EXPECT_THROW(write_package(incomplete, example_labels(), folder_ / "b.patient"), PackageError);
  EXPECT_FALSE(fs::exists(folder_ / "b.patient"));
}

TEST_F(Package, AnotherFolderIsNotOverwritten) {
  fs::create_directories(folder_ / "photos");
  std::ofstream(folder_ / "photos" / "a.txt") << "keep";
  EXPECT_THROW(write_package(example(), example_labels(), folder_ / "photos"), PackageError);
  EXPECT_TRUE(fs::exists(folder_ / "photos" / "a.txt"));
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()), 1)
      << "nothing half-written is left";
}

TEST_F(Package, AnInvertedTetrahedronIsRefused) {
  auto p = example();
  std::swap(p.tongue.tets[0][1], p.tongue.tets[0][2]);
  write_package(p, example_labels(), folder_ / "c.patient");
  try {
    read_package(folder_ / "c.patient");
    FAIL();
  } catch (const PackageError& e) {
    EXPECT_NE(std::string(e.what()).find("tongue.vtu"), std::string::npos);
  }
}

}  // namespace
}  // namespace vallecula::pipeline
