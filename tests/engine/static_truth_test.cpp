// The contact force at rest against static solutions that the engine did not make: tests/truth/static_indentation.json,
// with the recipe beside it. The names of the cases are those of that file.
#include <cmath>

#include <gtest/gtest.h>

#include "engine/lab/experiment.h"
#include "engine/scene_data.h"
#include "engine/state.h"
#include "tests/engine/box_mesh.h"

namespace vallecula::engine {
namespace {

constexpr double kBlockHeight = 0.020;

/// A block of 40 x 40 x 20 mm, E 6000 Pa, fixed at its base, with a tool over its centre.
SceneDescription block_under(const TriangleMesh& tool, double poisson, const std::array<int, 3>& cells) {
  SceneDescription d;
  d.soft = testing::box_body(Vec3(0.04, 0.04, kBlockHeight), cells, {6000.0, poisson, 1040.0});
  d.tool.surface = tool;
  return d;
}

/// Forces along z with the tool's lowest point held at each depth below the block's top: brought there in 0.15 s, held
/// for 0.35 s, the mean of the last 50 ms. `lowest`: of the tool below its origin. `volumes`, if given: at the end of
/// each, as a share of the volume at rest.
std::vector<double> resting_forces(const SceneDescription& description, double lowest,
                                   const std::vector<double>& depths, std::vector<double>* volumes = nullptr) {
  constexpr double kEach = 0.5, kWay = 0.15, kMean = 0.05;
  const auto scene = build_scene(description);
  ExperimentSettings settings;
  settings.duration_s = kEach * static_cast<double>(depths.size()) - description.step_s;
  settings.measure_tissue = volumes != nullptr;
  if (volumes != nullptr) volumes->assign(depths.size(), 0.0);
  const auto pose = [&](double t) {
    const auto n = std::min(depths.size() - 1, static_cast<std::size_t>(t / kEach + 1e-9));
    const double from = n == 0 ? 0.0 : depths[n - 1], share = std::min(1.0, (t - kEach * static_cast<double>(n)) / kWay);
    Pose p;
    p.position = Vec3(0.02, 0.02, kBlockHeight + lowest - from - (depths[n] - from) * share);
    return p;
  };
  std::vector<double> sums(depths.size(), 0.0), counts(depths.size(), 0.0);
  for (const ExperimentStep& s : run_experiment(*scene, pose, settings).steps) {
    const auto n = std::min(depths.size() - 1, static_cast<std::size_t>(s.time_s / kEach + 1e-9));
    if (s.time_s < kEach * static_cast<double>(n + 1) - kMean) continue;
    sums[n] += s.force_n.z();
    counts[n] += 1;
    if (volumes != nullptr) (*volumes)[n] = 1 + s.volume_change;
  }
  for (std::size_t n = 0; n < sums.size(); ++n) sums[n] /= counts[n];
  return sums;
}

const std::vector<double> kDepths = {0.0005, 0.001, 0.0015, 0.002};

TriangleMesh plate() { return testing::box_surface(Vec3::Zero(), Vec3(0.020, 0.020, 0.004)); }

TriangleMesh ball() { return testing::sphere_surface(0.005, 5); }

void expect_near(const std::vector<double>& forces, const std::vector<double>& truth, double share, const std::string& what) {
  for (std::size_t i = 0; i < truth.size(); ++i)
    EXPECT_NEAR(forces[i], truth[i], share * truth[i]) << what << ", depth " << 1e3 * kDepths[i] << " mm";
}

// Continuum, quadratic elements, refined until they changed by less than 1.5 %: "block/plate/small" and, for the sphere,
// "block/sphere/corotational". Ours are 11,664 linear tetrahedra. Beyond 1.5 mm at nu 0.49 the small-strain solution is no
// truth any more (finite strain adds 3 to 6 % to the sphere's).
TEST(StaticIndentation, ElevenThousandTetsAreNearTheContinuum) {
  struct Case {
    double poisson;
    std::vector<double> plate_n, sphere_n;
  };
  for (const Case& c : {Case{0.30, {.1235, .2469, .3704, .4938}, {.00734, .02094, .03868, .05948}},
                        Case{0.45, {.1446, .2891, .4337, .5782}, {.00830, .02349, .04329, .06640}},
                        Case{0.49, {.1546, .3092, .4638}, {.00871, .02457, .04522, .06932}}}) {
    const std::string nu = ", nu " + std::to_string(c.poisson);
    const std::array<int, 3> cells = {18, 18, 6};
    expect_near(resting_forces(block_under(plate(), c.poisson, cells), 0.002, kDepths), c.plate_n, 0.05, "plate" + nu);
    expect_near(resting_forces(block_under(ball(), c.poisson, cells), 0.005, kDepths), c.sphere_n, 0.15, "sphere" + nu);
  }
}

// The same tetrahedra and law solved by another code, touched at their vertices ("same-law/block-11664/...", lattice-1). Where
// faces between vertices resist as well, from a quarter of a millimetre inside a tool, ours is stiffer by a little: the
// sphere, and the plate beyond 1 mm.
TEST(StaticIndentation, AnotherCodeFindsTheSameOnTheSameTets) {
  const std::array<int, 3> cells = {18, 18, 6};
  expect_near(resting_forces(block_under(plate(), 0.45, cells), 0.002, {0.0005, 0.001}), {.1401, .2819}, 0.01, "plate");
  expect_near(resting_forces(block_under(ball(), 0.45, cells), 0.005, kDepths), {.00784, .02306, .04385, .06876}, 0.065,
              "sphere");
}

// Beyond a loss of 0.7 % of the whole volume a uniform pressure holds it: the same tetrahedra and law solved by another
// code with that bound as an inequality ("volume-held/block-12000/plate/0.45/lattice-1", held). It adds 4.4, 5.9 and
// 7.2 % to the force at 3, 4 and 5 mm, and nothing at 1 mm. There the vertices of the footprint's rim belong to the plate
// for good; ours is 0.9 mm wider on each side, since they bulge by up to 0.6 mm from under it, and a plate of 20 mm lets
// them slip out one after another (8 to 15 % less force). With 21.6 to 22.0 mm the contacts are the same, and what was
// measured is 0.1 % off at most; from 22.4 mm the faces beyond the rim are met as well. The bound, 0.5 %, is a ninth of
// the least that the hold adds.
TEST(StaticIndentation, AnotherCodeHoldsTheVolumeByTheSameForce) {
  const std::vector<double> depths = {0.001, 0.003, 0.004, 0.005}, truth = {.33142, 1.07602, 1.48261, 1.91248},
                            volume = {.99472, .993, .993, .993};
  const TriangleMesh wide = testing::box_surface(Vec3::Zero(), Vec3(0.0218, 0.0218, 0.016));
  std::vector<double> volumes;
  const auto forces = resting_forces(block_under(wide, 0.45, {20, 20, 5}), 0.008, depths, &volumes);
  for (std::size_t i = 0; i < truth.size(); ++i) {
    EXPECT_NEAR(forces[i], truth[i], 0.005 * truth[i]) << "depth " << 1e3 * depths[i] << " mm";
    EXPECT_NEAR(volumes[i], volume[i], 0.0005) << "depth " << 1e3 * depths[i] << " mm";
  }
}

/// Slope of a plate pressed by 0.5 mm, N/m, by response and step; `distances`: with spheres that keep theirs.
double plate_slope(Response response, double step_s, bool distances = false) {
  SceneDescription d = block_under(plate(), 0.45, {10, 10, 5});
  d.response = response;
  d.sphere_distances = distances;
  d.step_s = step_s;
  return resting_forces(d, 0.002, {0.0005})[0] / 0.0005;
}

TEST(StaticIndentation, CompliantForceDoesNotDependOnTheStep) {
  const double truth = plate_slope(Response::compliant, 0.001);
  for (double step : {0.0005, 0.002})
    EXPECT_NEAR(plate_slope(Response::compliant, step), truth, 0.02 * truth) << step;
}

// DESIGN 4.3: the paper's projection has no force but M dp / h^2, which under-reports and depends on the step. It is shown,
// never scored; this holds that it is measured for what it is.
TEST(StaticIndentation, ProjectionReadsLessForceTheLongerTheStep) {
  const double truth = plate_slope(Response::compliant, 0.001);
  const double half = plate_slope(Response::projection, 0.0005), one = plate_slope(Response::projection, 0.001),
               two = plate_slope(Response::projection, 0.002);
  std::printf("compliant %.1f N/m; projection at 0.5, 1, 2 ms: %.1f, %.1f, %.1f N/m; penalty at 1 ms: %.1f N/m\n", truth, half,
              one, two, plate_slope(Response::penalty, 0.001));
  EXPECT_LT(half, truth);
  EXPECT_LT(one, 0.9 * half);
  EXPECT_LT(two, 0.9 * one);
}

// Spheres that keep their distance (paper 3.1) make tissue stiffer than it is, the more the shorter the step: what they cost.
TEST(StaticIndentation, SphereDistancesStiffenTheTissue) {
  const double truth = plate_slope(Response::compliant, 0.001), half = plate_slope(Response::projection, 0.0005, true),
               one = plate_slope(Response::projection, 0.001, true);
  std::printf("compliant %.1f N/m; projection with sphere distances at 0.5, 1 ms: %.1f, %.1f N/m\n", truth, half, one);
  EXPECT_GT(one, plate_slope(Response::projection, 0.001));
  EXPECT_GT(half, 1.2 * truth);
}

}  // namespace
}  // namespace vallecula::engine
