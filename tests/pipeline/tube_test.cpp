// Infants scanned with a tube in place: the tube is drawn into the scan, the truth is that of the same infant without
// it.
#include "pipeline/segment/tube.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <limits>

#include "pipeline/dicom/read_series.h"
#include "pipeline/manikin/manikin.h"
#include "pipeline/manikin/shapes.h"
#include "pipeline/segment/segment.h"
#include "tests/pipeline/agreement.h"

namespace vallecula::pipeline {
namespace {

/// What is put in: measures in mm, grey values in HU.
struct Made {
  double outside_mm;
  double wall_mm;
  double wall_hu;
  double lumen_hu;
  double line_hu;  ///< of the line a quarter of a millimetre thick along its wall; 0: none
};

struct Placed {
  Made made;
  bool nasal;  ///< a feeding tube from the nose to the oesophagus; else a tracheal tube from the mouth
};

struct TubeCase {
  const char* name;
  double weight_kg;
  std::uint64_t seed;
  std::vector<Placed> tubes;  ///< tracheal before feeding: in the order in which they are told
};

/// The way of a tube at term scale, from outside the face inwards, as the infant's own shapes leave it room.
std::vector<manikin::Vec> way_of(const Placed& in, const Manikin& manikin) {
  const auto landmarks = manikin.landmarks();
  const double s = manikin.scale();
  if (in.nasal) {
    return manikin::curve(std::vector<manikin::Vec>{{4.4, -6.5, 11.2},
                                                    {3.6, 0.4, 16.6},
                                                    {2.8, 6.0, 15.5},
                                                    {2.5, 14.0, 10.5},
                                                    {2.5, 22.0, 6.5},
                                                    {2.2, 31.0, 3.0},
                                                    {1.0, 39.0, -2.5},
                                                    {0.5, 42.5, -10.0},
                                                    {0.0, 42.2, -20.0},
                                                    {0.0, 41.4, -32.0},
                                                    {0.0, 40.6, -42.0},
                                                    {0.0, 41.4, -50.5},
                                                    {0.0, 42.0, -57.0},
                                                    {0.0, 44.5, -65.0}},
                          40);
  }
  const auto& g = landmarks.at("glottis_centre");
  const auto& c = landmarks.at("carina");
  const manikin::Vec cords{0.0, g[1] / s, g[2] / s};
  const manikin::Vec below = cords + manikin::Vec{0.0, 1.8, -5.7};
  const manikin::Vec fork{0.0, c[1] / s, c[2] / s};
  const auto end = below + 0.6 * (fork - below);
  return manikin::curve(std::vector<manikin::Vec>{{0.0, -16.0, -9.0},
                                                  {0.0, 0.0, -10.0},
                                                  {0.0, 12.0, -12.0},
                                                  {0.0, 21.0, -14.2},
                                                  {0.0, 29.5, -20.5},
                                                  {0.0, 35.8, -28.5},
                                                  {0.0, 38.4, -34.5},
                                                  {0.0, 37.2, -41.5},
                                                  cords,
                                                  below,
                                                  end},
                        40);
}

/// Draws it into a scan: each voxel takes what the scanner's blur (0.32 mm across, 0.36 mm along) gathers around it.
/// Adds the voxels inside the tube's outer surface to `inside`.
void draw(const Placed& in, const Manikin& manikin, Hounsfield& ct, Mask& inside) {
  const auto& g = ct.grid;
  std::vector<Vector3> axis;
  for (const auto& p : way_of(in, manikin))
    axis.push_back({manikin.scale() * p.x, manikin.scale() * p.y, manikin.scale() * p.z});
  const double outer = 0.5 * in.made.outside_mm;
  const double reach = outer + 1.0;
  Volume<float> near(g, 1e9f);
  Volume<int> at(g, -1);
  for (std::size_t i = 0; i < axis.size(); ++i) {
    const Vector3 span{reach, reach, reach};
    const auto box = box_between(g, axis[i] - span, axis[i] + span);
    for (int z = box.low[2]; z <= box.high[2]; ++z) {
      for (int y = box.low[1]; y <= box.high[1]; ++y) {
        for (int x = box.low[0]; x <= box.high[0]; ++x) {
          const auto d = static_cast<float>(distance(g.position(x, y, z), axis[i]));
          const auto v = g.index(x, y, z);
          if (d >= near.voxels[v]) continue;
          near.voxels[v] = d;
          at.voxels[v] = static_cast<int>(i);
        }
      }
    }
  }
  struct Sample {
    Vector3 off;
    double weight;
  };
  std::vector<Sample> samples;
  double sum = 0.0;
  for (int k = 0; k < 7 * 7 * 5; ++k) {
    const double u = (k % 7 - 3) / 1.5;
    const double v = (k / 7 % 7 - 3) / 1.5;
    const double w = (k / 49 - 2) / 1.1;
    samples.push_back({{0.32 * u, 0.32 * v, 0.36 * w}, std::exp(-0.5 * (u * u + v * v + w * w))});
    sum += samples.back().weight;
  }
  for (std::size_t v = 0; v < g.count(); ++v) {
    if (at.voxels[v] < 0 || near.voxels[v] > reach) continue;
    if (near.voxels[v] <= outer) inside.voxels[v] = 1;
    const auto i = std::clamp<std::size_t>(static_cast<std::size_t>(at.voxels[v]), 1, axis.size() - 2);
    const auto along = unit(axis[i + 1] - axis[i - 1]);
    const auto aside = unit(cross(along, Vector3{0.3, 0.8, 0.5}));
    double value = 0.0;
    for (const auto& s : samples) {
      const auto off = Vector3(g.position(v)) + s.off - axis[i];
      const auto flat = off - dot(off, along) * along;
      const double r = norm(flat);
      double hu = ct.voxels[v];
      if (r < outer - in.made.wall_mm)
        hu = in.made.lumen_hu;
      else if (r < outer)
        hu = in.made.line_hu > 0.0 && dot(flat, aside) > 0.985 * r ? in.made.line_hu : in.made.wall_hu;
      value += s.weight / sum * hu;
    }
    ct.voxels[v] = static_cast<std::int16_t>(std::lround(value));
  }
}

class TubeInPlace : public ::testing::TestWithParam<TubeCase> {};

TEST_P(TubeInPlace, IsTakenOutAndTheInfantIsFoundAsWithoutIt) {
  const auto& in = GetParam();
  ManikinOptions options;
  options.weight_kg = in.weight_kg;
  options.seed = in.seed;
  auto scan = scan_manikin(options);
  const Manikin manikin(in.weight_kg, in.seed);
  Mask tube(scan.ct.grid);
  for (const auto& placed : in.tubes) draw(placed, manikin, scan.ct, tube);
  const auto s = segment(scan.ct, {});
  const auto found = on_series_grid(s, scan.ct.grid);

  const auto finding = s.findings.at("airway");
  EXPECT_EQ(finding.origin, Origin::inferred);
  std::size_t told = 0;
  for (const auto& placed : in.tubes) {
    const auto at = finding.how.find("about ", told);
    ASSERT_NE(at, std::string::npos) << finding.how;
    EXPECT_NEAR(std::atof(finding.how.c_str() + at + 6), placed.made.outside_mm, 0.25) << finding.how;
    told = finding.how.find(placed.nasal ? "from the nose to the gullet" : "from the mouth to the windpipe", at);
    ASSERT_NE(told, std::string::npos) << finding.how;
  }
  EXPECT_EQ(finding.how.find("about ", told), std::string::npos) << "no more than were put in: " << finding.how;

  auto agreement = test::agreement_of(scan.labels, found);
  EXPECT_GE(agreement[kAirway].dice, 0.97);
  EXPECT_GE(agreement[kTongue].dice, 0.95);
  EXPECT_GE(agreement[kSkull].dice, 0.95);
  EXPECT_GE(agreement[kMandible].dice, 0.95);
  EXPECT_GE(agreement[kEpiglottis].dice, 0.78);
  std::size_t solid = 0;
  std::size_t in_leaf = 0;
  for (std::size_t i = 0; i < tube.voxels.size(); ++i) {
    const auto label = found.voxels[i];
    in_leaf += tube.voxels[i] != 0 && scan.labels.voxels[i] == kEpiglottis ? 1 : 0;
    // Where the tube was drawn into an organ, that organ may stand again.
    if (tube.voxels[i] == 0 || scan.labels.voxels[i] != kAirway) continue;
    solid +=
        label == kTongue || label == kEpiglottis || label == kSkull || label == kMandible || label == kSpine ? 1 : 0;
  }
  EXPECT_LE(in_leaf, 20u) << "the way drawn must leave the epiglottis room";
  EXPECT_LE(static_cast<double>(solid), 0.005 * static_cast<double>(count(tube))) << "tube taken for tissue";

  double worst = 0.0;
  for (const auto& [name, truth] : manikin.landmarks()) {
    if (name == "operator_eye" || name == "glottis_normal") continue;
    const double off = distance(s.landmarks.at(name), truth);
    EXPECT_LE(off, 1.5) << name;
    worst = std::max(worst, off);
  }
  std::printf(
      "[ figures  ] %s: %s; airway %.3f tongue %.3f epiglottis %.3f skull %.3f | %zu of %zu solid | worst landmark "
      "%.2f mm\n",
      in.name, finding.how.c_str(), agreement[kAirway].dice, agreement[kTongue].dice, agreement[kEpiglottis].dice,
      agreement[kSkull].dice, solid, count(tube), worst);
}

constexpr Made kTracheal25{3.4, 0.5, 300.0, -1000.0, 1500.0};
constexpr Made kFeeding{2.0, 0.45, 700.0, 0.0, 0.0};

constexpr Made kFeedingOfAir{2.0, 0.45, 700.0, -1000.0, 0.0};

std::vector<TubeCase> tube_cases() {
  std::vector<TubeCase> list{{"TrachealTube", 0.9, 0, {{kTracheal25, false}}},
                             {"FeedingTube", 0.9, 0, {{kFeeding, true}}},
                             {"FeedingTubeFullOfAir", 0.9, 0, {{kFeedingOfAir, true}}},
                             {"TrachealAndFeedingTube", 0.9, 0, {{kTracheal25, false}, {kFeeding, true}}}};
  if (std::getenv("VALLECULA_SLOW") != nullptr) {
    const Made term{4.9, 0.7, 500.0, -1000.0, 1500.0};
    list.push_back({"SmallestTracheal", 0.6, 2, {{{2.9, 0.45, 200.0, -1000.0, 1200.0}, false}}});
    list.push_back({"TrachealWithoutLine", 1.5, 3, {{{4.2, 0.6, 80.0, -1000.0, 0.0}, false}}});
    list.push_back({"TermTracheal", 3.2, 1, {{term, false}}});
    list.push_back({"TermFeeding", 3.2, 1, {{{2.7, 0.5, 500.0, 0.0, 1000.0}, true}}});
    list.push_back({"TermFeedingFullOfAir", 3.2, 1, {{kFeedingOfAir, true}}});
    list.push_back({"TermTrachealAndFeeding", 3.2, 1, {{term, false}, {kFeeding, true}}});
  }
  return list;
}

INSTANTIATE_TEST_SUITE_P(Tubes, TubeInPlace, ::testing::ValuesIn(tube_cases()),
                         [](const auto& info) { return info.param.name; });

class NoTube : public ::testing::TestWithParam<std::pair<double, std::uint64_t>> {};

TEST_P(NoTube, LeavesEveryVoxelAsItIs) {
  ManikinOptions options;
  options.weight_kg = GetParam().first;
  options.seed = GetParam().second;
  options.noise_hu = 40.0;  // noise must not look like one either
  auto ct = scan_manikin(options).ct;
  const auto before = ct.voxels;
  const auto t = thresholds_of(ct);
  EXPECT_TRUE(take_out_tubes(ct, t, frame_of(ct, find_body(ct, t), t)).empty());
  EXPECT_EQ(ct.voxels, before);
}

std::vector<std::pair<double, std::uint64_t>> bare_infants() {
  std::vector<std::pair<double, std::uint64_t>> list{{0.6, 2}};
  if (std::getenv("VALLECULA_SLOW") != nullptr) list = {{0.6, 0}, {0.9, 3}, {1.5, 8}, {3.2, 1}, {4.5, 5}};
  return list;
}

INSTANTIATE_TEST_SUITE_P(Infants, NoTube, ::testing::ValuesIn(bare_infants()), [](const auto& info) {
  return "Grams" + std::to_string(std::lround(1000.0 * info.param.first));
});

TEST(NoTubeRealCt, TeethMetalTurbinatesUvulaAndEpiglottisStay) {
  namespace fs = std::filesystem;
  const char* data = std::getenv("VALLECULA_DATA");
  const fs::path root = data != nullptr ? fs::path(data) : fs::path(VALLECULA_SOURCE_DIR) / ".." / "shared" / "data";
  const auto series = root / "cerr_head_neck_ct" / "dicom";
  if (!fs::exists(series)) GTEST_SKIP() << "no real CT at hand";
  auto ct = read_ct_series(series).hu;
  const auto before = ct.voxels;
  const auto t = thresholds_of(ct);
  const auto frame = frame_of(ct, find_body(ct, t), t);
  const auto start = std::chrono::steady_clock::now();
  EXPECT_TRUE(take_out_tubes(ct, t, frame).empty());
  std::printf("[ figures  ] %d x %d x %d: %.2f s\n", ct.grid.size[0], ct.grid.size[1], ct.grid.size[2],
              std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  EXPECT_EQ(ct.voxels, before);
  // The same as it is segmented: cut out and, where it lay askew, put upright.
  Edits edits;
  edits.seeds["tongue"] = {244, -341, -138};
  EXPECT_EQ(segment(ct, edits).findings.at("airway").how, "");
}

}  // namespace
}  // namespace vallecula::pipeline
