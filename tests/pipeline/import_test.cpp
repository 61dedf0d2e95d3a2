// The whole import: from files of a series to a package that can be played, and what a person is told when it cannot be
// done.
#include "pipeline/import.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <set>
#include <sstream>

#include "pipeline/manikin/manikin.h"
#include "pipeline/mesh/self_intersection.h"
#include "pipeline/mesh/surface_check.h"
#include "pipeline/mesh/tet_quality.h"
#include "pipeline/package/label_map.h"
#include "tests/pipeline/dicom_file.h"

namespace vallecula::pipeline {
namespace {

namespace fs = std::filesystem;

fs::path scratch() { return fs::temp_directory_path() / ("vallecula-import-test-" + std::to_string(::getpid())); }

std::string text_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream all;
  all << in.rdbuf();
  return all.str();
}

/// One import of the term manikin serves all questions about a good package (ctest starts a process for every test, so
/// it is one test).
struct Imported {
  fs::path series = scratch() / "series";
  ImportReport report;
  PatientPackage package;
  std::vector<std::string> stages;
  std::vector<double> done;
  const Surface& face() const { return package.surfaces.at("face"); }
};

void check_progress_rises_through_the_stages(const Imported& in) {
  ASSERT_FALSE(in.done.empty());
  EXPECT_TRUE(std::is_sorted(in.done.begin(), in.done.end()));
  EXPECT_NEAR(in.done.back(), 1.0, 1e-9);
  EXPECT_EQ(std::set<std::string>(in.stages.begin(), in.stages.end()),
            (std::set<std::string>{"read", "segment", "segment: head", "segment: airway", "segment: bones",
                                   "segment: epiglottis", "segment: tongue", "segment: soft palate and larynx",
                                   "segment: landmarks", "position", "surfaces", "surfaces: face", "surfaces: airway",
                                   "surfaces: jaw and palate", "tetrahedra", "write"}));
  ASSERT_EQ(in.report.stages.size(), 6u);
}

/// A verdict that can only be good is none.
void check_quality_judges_only_by_limits(const Imported& in) {
  std::map<std::string, const QualityItem*> items;
  for (const QualityItem& item : in.package.quality) items[item.name] = &item;
  for (const char* name : {"head size", "gap between the gums", "glottis area", "tetrahedra", "shortest edge"}) {
    ASSERT_EQ(items.count(name), 1u) << name;
    EXPECT_FALSE(items[name]->judged) << name;
  }
  for (const char* name :
       {"tongue volume", "mouth open", "face surface", "face surface crosses itself", "palate surface crosses itself",
        "volume kept by the airway surface", "volume kept by the mandible surface", "volume kept by the tetrahedra",
        "tetrahedra below 10 degrees", "smallest dihedral angle", "tongue inside the jaw's bone",
        "tongue inside the tissue around it", "gap where the tongue is held"}) {
    ASSERT_EQ(items.count(name), 1u) << name;
    EXPECT_TRUE(items[name]->judged && items[name]->ok) << name;
  }
}

void check_leaves_nothing_but_the_package(const Imported&) {
  std::set<std::string> names;
  for (const auto& entry : fs::directory_iterator(scratch())) names.insert(entry.path().filename().string());
  EXPECT_EQ(names, (std::set<std::string>{"series", "term.patient"}));
}

void check_surfaces_are_closed_and_look_outwards(const Imported& in) {
  for (const auto& [name, surface] : in.package.surfaces) {
    if (name == "glottis") continue;
    const auto f = facts_of(surface);
    EXPECT_TRUE(f.closed && f.manifold && f.finite) << name << ": " << f.fault;
    EXPECT_EQ(f.parts, 1) << name;
    EXPECT_GT(f.volume_mm3, 0.0) << name;
    EXPECT_TRUE(self_intersections(surface).empty()) << name;
  }
  EXPECT_TRUE(self_intersections(in.package.surfaces.at("glottis")).empty());
  EXPECT_LT(in.face().triangles.size(), 120000u);
}

void check_surfaces_hold_the_volume_of_the_truth(const Imported& in) {
  const auto truth = read_label_map(in.series / "truth.nrrd");
  const auto volume = [&](std::set<int> labels) {
    double n = 0.0;
    for (const auto v : truth.voxels) n += labels.count(v) != 0 ? 1.0 : 0.0;
    return n * truth.grid.voxel_mm3();
  };
  const auto ratio = [&](const char* name, double expected) {
    return facts_of(in.package.surfaces.at(name)).volume_mm3 / expected;
  };
  EXPECT_NEAR(ratio("mandible", volume({kMandible})), 1.0, 0.03) << "smoothing must not shrink";
  EXPECT_NEAR(ratio("airway", volume({kAirway})), 1.0, 0.05);
  EXPECT_NEAR(ratio("face", volume({kSkin, kSkull, kMandible, kLarynx, kOesophagus, kSoftPalate, kSpine})), 1.0, 0.02);
  EXPECT_NEAR(quality_of(in.package.tongue).volume_mm3 / volume({kTongue, kEpiglottis}), 1.0, 0.02);
}

void check_every_tissue_is_on_the_face_where_it_belongs(const Imported& in) {
  std::map<int, double> area;
  const Point gum = in.package.landmarks.at("upper_gum_midline");
  for (std::size_t t = 0; t < in.face().triangles.size(); ++t) {
    const auto& c = in.face().triangles[t];
    Point p{};
    for (const int v : c) {
      for (int a = 0; a < 3; ++a) p[a] += in.face().points[v][a] / 3.0;
    }
    ++area[in.face().tissue[t]];
    const double away = std::hypot(p[0] - gum[0], p[1] - gum[1], p[2] - gum[2]);
    if (in.face().tissue[t] != static_cast<int>(Tissue::skin)) {
      EXPECT_LT(away, 130.0) << "no mucosa on the scalp";
    }
    if (in.face().tissue[t] == static_cast<int>(Tissue::lip)) {
      EXPECT_LT(away, 40.0);
    }
  }
  for (int tissue = 0; tissue < 6; ++tissue) EXPECT_GT(area[tissue], 100.0) << "tissue " << tissue;
}

void check_tetrahedra_are_well_shaped_and_held(const Imported& in) {
  const auto& m = in.package.tongue;
  const auto q = quality_of(m);
  EXPECT_GT(q.smallest_dihedral_deg, 10.0);
  EXPECT_LT(q.largest_dihedral_deg, 165.0);
  EXPECT_GE(m.tets.size(), 4500u);
  EXPECT_LE(m.tets.size(), 5500u);
  // The leaf hangs on the tongue: they share nodes, and every node is used.
  std::vector<int> of(m.points.size(), 0);
  std::size_t leaf = 0;
  for (std::size_t t = 0; t < m.tets.size(); ++t) {
    leaf += m.tissue[t];
    for (const int v : m.tets[t]) of[v] |= 1 << m.tissue[t];
  }
  EXPECT_GT(leaf, 150u);
  EXPECT_GT(std::count(of.begin(), of.end(), 3), 10);
  EXPECT_EQ(std::count(of.begin(), of.end(), 0), 0);
  std::map<int, int> held;
  const Point hyoid = in.package.landmarks.at("hyoid");
  const Point tip = in.package.landmarks.at("epiglottis_tip");
  for (std::size_t v = 0; v < m.points.size(); ++v) {
    ++held[m.anchor[v]];
    const auto away = [&](const Point& p) {
      return std::hypot(m.points[v][0] - p[0], m.points[v][1] - p[1], m.points[v][2] - p[2]);
    };
    if (m.anchor[v] == static_cast<int>(Anchor::hyoid)) {
      EXPECT_LT(away(hyoid), 10.0);
    }
    if (away(tip) < 4.0) {
      EXPECT_EQ(m.anchor[v], static_cast<int>(Anchor::free)) << "the leaf's tip is free";
    }
  }
  for (int anchor = 1; anchor < 4; ++anchor) EXPECT_GT(held[anchor], 8) << anchor;
  EXPECT_GT(held[0], static_cast<int>(m.points.size() / 2));
}

void check_glottis_outline_is_the_true_opening(const Imported& in) {
  const auto truth = Manikin().glottis_outline();
  const auto& found = in.package.surfaces.at("glottis").points;
  ASSERT_GE(found.size(), 12u);
  double worst = 0.0;
  for (const auto& p : found) {
    double best = 1e9;
    for (std::size_t i = 0; i < truth.size(); ++i) {
      const auto& a = truth[i];
      const auto& b = truth[(i + 1) % truth.size()];
      for (int s = 0; s <= 20; ++s) {
        const double f = s / 20.0;
        best = std::min(best, std::hypot(a[0] + f * (b[0] - a[0]) - p[0], a[1] + f * (b[1] - a[1]) - p[1],
                                         a[2] + f * (b[2] - a[2]) - p[2]));
      }
    }
    worst = std::max(worst, best);
  }
  EXPECT_LT(worst, 1.6);
}

void check_nothing_identifies_the_source(const Imported&) {
  for (const auto& entry : fs::directory_iterator(scratch() / "term.patient")) {
    const auto text = text_of(entry.path());
    for (const char* word : {"Manikin^", "MANIKIN-", "2.25.", "1.2.826", "/tmp", "series"}) {
      EXPECT_EQ(text.find(word), std::string::npos) << word << " in " << entry.path().filename();
    }
  }
}

/// Nothing that is there goes unasked; and before any work is done.
void check_a_package_is_replaced_only_when_asked(const Imported& in) {
  ImportOptions again;
  again.series = in.series;
  again.out = scratch() / "term.patient";
  bool worked = false;
  try {
    import_series(again, [&](const std::string&, double) { worked = true; });
    ADD_FAILURE() << "it was replaced unasked";
  } catch (const ImportError& e) {
    EXPECT_NE(std::string(e.what()).find("already there"), std::string::npos) << e.what();
  }
  EXPECT_FALSE(worked);
  std::string endless = "DoeJane";
  for (int doubled = 0; doubled < 6; ++doubled) endless += endless;  // no file system takes it
  again.out = scratch() / (endless + ".patient");
  try {
    import_series(again);
    ADD_FAILURE() << "it was taken";
  } catch (const ImportError& e) {
    EXPECT_EQ(std::string(e.what()).rfind("files: ", 0), 0U) << e.what();
    for (const auto* secret : {"Doe", "/"})
      EXPECT_EQ(std::string(e.what()).find(secret), std::string::npos) << e.what();
  }
  again.out = scratch() / "many.patient";
  again.tetrahedra = 100001;
  EXPECT_THROW(import_series(again), ImportError);
}

void check_the_same_series_gives_the_same_package(const Imported& in) {
  ImportOptions again;
  again.series = in.series;
  again.out = scratch() / "again" / "term.patient";
  import_series(again);
  for (const auto& entry : fs::directory_iterator(scratch() / "term.patient")) {
    EXPECT_EQ(text_of(entry.path()), text_of(again.out / entry.path().filename())) << entry.path().filename();
  }
  fs::remove_all(scratch() / "again");
}

TEST(ImportManikin, GivesAPackageThatCanBePlayed) {
  fs::remove_all(scratch());
  fs::create_directories(scratch());
  Imported in;
  write_manikin(ManikinOptions{}, in.series);
  ImportOptions options;
  options.series = in.series;
  options.out = scratch() / "term.patient";
  in.report = import_series(options, [&](const std::string& stage, double done) {
    in.stages.push_back(stage);
    in.done.push_back(done);
  });
  in.package = read_package(options.out);
  check_progress_rises_through_the_stages(in);
  check_quality_judges_only_by_limits(in);
  check_leaves_nothing_but_the_package(in);
  check_surfaces_are_closed_and_look_outwards(in);
  check_surfaces_hold_the_volume_of_the_truth(in);
  check_every_tissue_is_on_the_face_where_it_belongs(in);
  check_tetrahedra_are_well_shaped_and_held(in);
  check_glottis_outline_is_the_true_opening(in);
  check_nothing_identifies_the_source(in);
  check_a_package_is_replaced_only_when_asked(in);
  check_the_same_series_gives_the_same_package(in);
  fs::remove_all(scratch());
}

class ImportErrors : public ::testing::Test {
 protected:
  void SetUp() override {
    dir_ = fs::temp_directory_path() / ("vallecula-import-errors-" + std::to_string(::getpid()));
    fs::remove_all(dir_);
    fs::create_directories(dir_ / kSeries);
  }
  void TearDown() override { fs::remove_all(dir_); }
  static constexpr const char* kSeries = "Doe_Jane";  ///< a folder is often called so: no message may say it
  std::string message(const fs::path& out) const {
    ImportOptions options;
    options.series = dir_ / kSeries;
    options.out = out;
    try {
      import_series(options);
    } catch (const ImportError& e) {
      return e.what();
    }
    return "no error";
  }
  fs::path dir_;
};

TEST_F(ImportErrors, SayWhatWhereAndHowAndLeaveNothing) {
  EXPECT_NE(message(dir_ / "a.patient").find("empty"), std::string::npos);
  EXPECT_NE(message(dir_ / "a").find(".patient"), std::string::npos);
  std::ofstream(dir_ / "taken.patient") << "a file";
  EXPECT_NE(message(dir_ / "taken.patient").find("not a patient package"), std::string::npos);
  EXPECT_NE(message(dir_ / "taken.patient" / "a.patient").find("is a file, not a folder"), std::string::npos)
      << message(dir_ / "taken.patient" / "a.patient");
  fs::remove(dir_ / "taken.patient");
  if (::geteuid() != 0) {
    fs::permissions(dir_ / kSeries, fs::perms::owner_read | fs::perms::owner_exec);
    EXPECT_NE(message(dir_ / kSeries / "a.patient").find("cannot be written"), std::string::npos);
    fs::permissions(dir_ / kSeries, fs::perms::owner_all);
  }
  EXPECT_NE(message("/proc/a.patient").find("cannot be written"), std::string::npos) << message("/proc/a.patient");
  EXPECT_EQ(std::distance(fs::directory_iterator(dir_), fs::directory_iterator()), 1);
}

TEST_F(ImportErrors, AHeadlessSeriesIsNotAPatient) {
  for (int k = 0; k < 30; ++k) {
    test::DicomSlice d;
    d.columns = d.rows = 48;
    d.position = "0\\0\\" + std::to_string(2 * k);
    d.instance = std::to_string(k + 1);
    for (int i = 0; i < 48 * 48; ++i) d.stored.push_back(i % 48 < 24 ? 1064 : 24);
    test::write_dicom(d, dir_ / kSeries / (std::to_string(k) + ".dcm"));
  }
  const auto text = message(dir_ / "a.patient");
  EXPECT_EQ(text.rfind("series: ", 0), 0U) << text;
  EXPECT_EQ(text.find("Doe"), std::string::npos) << text;
  EXPECT_EQ(text.find(dir_.filename().string()), std::string::npos) << text;
  EXPECT_NE(text.find("must show"), std::string::npos) << text;
  EXPECT_FALSE(fs::exists(dir_ / "a.patient"));
}

}  // namespace
}  // namespace vallecula::pipeline
