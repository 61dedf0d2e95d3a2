// A trial with a laryngoscope of one's own: placed by tip and handle, kept with the trial, replayed and scored.
#include <gtest/gtest.h>
#include <vtkCellLocator.h>
#include <vtkNew.h>
#include <vtkPolyData.h>

#include <cmath>

#include "curricula/trial_log.h"
#include "engine/tool/miller_blade.h"
#include "gui/session/placed_tool.h"
#include "gui/views/tool_look.h"
#include "tests/gui/block_patient.h"
#include "tests/gui/program.h"
#include "tests/gui/tool_file.h"

namespace vallecula::gui::test {
namespace {

namespace fs = std::filesystem;
using engine::Mat3;
using engine::TriangleMesh;
using engine::Vec3;

std::string numbers(const Vec3& p) {
  return std::to_string(p.x()) + "," + std::to_string(p.y()) + "," + std::to_string(p.z());
}

class TrialTool : public ::testing::Test {
 protected:
  Outcome trial(const std::string& out, const std::vector<std::string>& more) {
    std::vector<std::string> arguments = {"trial",
                                          "--patient",
                                          patient_.string(),
                                          "--scenario",
                                          curriculum_.string() + ":plain",
                                          "--device",
                                          "scripted:" + press_.string(),
                                          "--headless",
                                          "--asap",
                                          "--out",
                                          (box_ / out).string()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return box_.run(arguments);
  }
  /// Writes `tool` (tool frame) in millimetres and a frame of its own, and gives the options that place it.
  std::vector<std::string> placed(const std::string& name, const TriangleMesh& tool, const Vec3& handle, bool face) {
    const Mat3 turn = axes(Vec3(0.6, -0.64, 0.48), Vec3(0.2, 0.7, 0.3));
    const Vec3 shift(0.12, -0.04, 0.3);
    write_tool_file(box_ / name, moved(tool, turn, shift), 1e-3);
    std::vector<std::string> options = {"--tool",        (box_ / name).string(),
                                        "--tool-tip",    numbers(1e3 * shift),
                                        "--tool-handle", numbers(1e3 * (shift + turn * handle))};
    if (face) options.insert(options.end(), {"--tool-face", numbers(turn.col(2))});
    return options;
  }

  Sandbox box_;
  fs::path patient_ = write_block_patient(box_.folder());
  fs::path press_ = write_press(box_.folder());
  fs::path curriculum_ = write_curriculum(box_.folder());
  const std::vector<std::string> laryngoscope_ =
      placed("scope.stl", laryngoscope(0.102, 0.11), Vec3(0.102, 0, 0), false);
};

TEST_F(TrialTool, TheShippedBladeGivenAsAFilePressesAsItself) {
  ASSERT_EQ(trial("shipped", {}).exit_code, 0);
  const TriangleMesh miller = engine::blade_surface(engine::miller_blade("miller-1"));
  const Outcome own = trial("own", placed("miller.stl", miller, Vec3(0.102, 0, 0), true));
  ASSERT_EQ(own.exit_code, 0) << own.err;
  const curricula::TrialLog a = curricula::read_trial_log(box_ / "shipped"),
                            b = curricula::read_trial_log(box_ / "own");
  ASSERT_EQ(a.ticks.size(), b.ticks.size());
  double peak = 0.0, own_peak = 0.0, sum = 0.0, most = 0.0;
  for (std::size_t i = 0; i < a.ticks.size(); ++i) {
    const auto &f = a.ticks[i].model_force_n, &g = b.ticks[i].model_force_n;
    const double apart = std::hypot(f[0] - g[0], f[1] - g[1], f[2] - g[2]);
    peak = std::max(peak, std::hypot(f[0], f[1], f[2]));
    own_peak = std::max(own_peak, std::hypot(g[0], g[1], g[2]));
    most = std::max(most, apart);
    sum += apart * apart;
  }
  const double rms = std::sqrt(sum / static_cast<double>(a.ticks.size()));
  ASSERT_GT(peak, 0.1);
  // Single precision at 0.3 m and six decimals of a millimetre: points are off by 2e-8 m. Which of a flat face's points
  // touches first changes with that, by a tick or two.
  EXPECT_NEAR(own_peak, peak, 0.01 * peak);
  EXPECT_LT(rms, 0.01 * peak);
  EXPECT_LT(most, 0.1 * peak);
  EXPECT_GT(most, 0.0) << "it was another mesh";
}

TEST_F(TrialTool, ATrialIsKeptWithItsToolAndVerifies) {
  const Outcome outcome = trial("out", laryngoscope_);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  EXPECT_EQ(box_.names("out"),
            (std::vector<std::string>{"force.png", "report.html", "score.json", "tool.ply", "trial.vtrial"}));
  const curricula::TrialLog log = curricula::read_trial_log(box_ / "out");
  double peak = 0.0;
  for (const auto& tick : log.ticks) peak = std::max(peak, std::abs(tick.loads[curricula::kTongue].force_n[2]));
  EXPECT_GT(peak, 0.1) << "the blade was pressed 2.5 mm into the tongue";
  EXPECT_NE(text_of(box_ / "out" / "report.html").find("a tool of its own"), std::string::npos);

  fs::remove(box_ / "scope.stl");  // the trial's folder is all that is needed
  fs::rename(box_ / "out", box_ / "moved");
  const std::string folder = (box_ / "moved").string();
  const Outcome verified = box_.run({"replay", folder, "--verify"});
  EXPECT_EQ(verified.exit_code, 0) << verified.err;
  EXPECT_NE(box_.run({"replay", folder}).out.find("done with a tool of its own, tool.ply"), std::string::npos);
  const Outcome scored = box_.run({"score", folder, "--json"});
  EXPECT_EQ(scored.out, text_of(box_ / "moved" / "score.json"));

  // The kept mesh is itself a tool, in metres and already in its frame.
  const Outcome again = trial("again", {"--tool", folder + "/tool.ply", "--tool-unit", "m", "--tool-tip", "0,0,0",
                                        "--tool-handle", "0.102,0,0"});
  EXPECT_EQ(again.exit_code, 0) << again.err;

  const std::string whole = text_of(box_ / "moved" / "tool.ply");
  std::string changed = whole;
  changed[changed.size() / 2] ^= 0x01;
  const auto refused = [&](const std::string& naming) {
    for (const auto& arguments :
         {std::vector<std::string>{"replay", folder, "--verify"}, {"replay", folder}}) {
      const Outcome one = box_.run(arguments);
      EXPECT_EQ(one.exit_code, 1) << arguments[0];
      ASSERT_EQ(one.messages().size(), 1u) << one.err;
      EXPECT_NE(one.err.find(naming), std::string::npos) << one.err;
    }
    // A score is of the log alone.
    const Outcome anew = box_.run({"score", folder, "--json"});
    EXPECT_EQ(anew.exit_code, 0) << anew.err;
    EXPECT_EQ(anew.out, scored.out);
  };
  write_text(box_ / "moved" / "tool.ply", changed);
  refused("tool.ply: is not the tool of this trial");
  fs::remove(box_ / "moved" / "tool.ply");
  refused("tool.ply: is missing");
}

TEST_F(TrialTool, ALaterTrialWithTheBladeTakesTheToolAway) {
  ASSERT_EQ(trial("out", laryngoscope_).exit_code, 0);
  ASSERT_EQ(trial("out", {}).exit_code, 0);
  EXPECT_EQ(box_.names("out"), (std::vector<std::string>{"force.png", "report.html", "score.json", "trial.vtrial"}));
  fs::create_directory(box_ / "theirs");
  write_text(box_ / "theirs" / "tool.ply", "somebody else's");
  const Outcome outcome = trial("theirs", laryngoscope_);
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_EQ(text_of(box_ / "theirs" / "tool.ply"), "somebody else's");
}

TEST_F(TrialTool, WhatIsMissingOrWrongIsSaidInOneLine) {
  const std::string scope = laryngoscope_[1], tip = laryngoscope_[3], handle = laryngoscope_[5];
  struct Case {
    int exit_code;
    std::string naming;
    std::vector<std::string> options;
  };
  write_text(box_ / "bad.stl", "no mesh");
  for (const Case& one : std::vector<Case>{
           {2, "needs both --tool-tip", {"--tool", scope}},
           {2, "needs both --tool-tip", {"--tool", scope, "--tool-tip", tip}},
           {2, "needs both --tool-tip", {"--tool", scope, "--tool-handle", handle}},
           {2, "none is given", {"--tool-tip", tip, "--tool-handle", handle}},
           {2, "'1,2' is not X,Y,Z", {"--tool", scope, "--tool-tip", "1,2", "--tool-handle", handle}},
           {2, "'1,2,3,4' is not X,Y,Z", {"--tool", scope, "--tool-tip", tip, "--tool-handle", "1,2,3,4"}},
           {2, "'1,nan,3' is not X,Y,Z", {"--tool", scope, "--tool-tip", "1,nan,3", "--tool-handle", handle}},
           {2,
            "is no direction",
            {"--tool", scope, "--tool-tip", tip, "--tool-handle", handle, "--tool-face", "0,0,0"}},
           {2, "--tool-unit", {"--tool", scope, "--tool-tip", tip, "--tool-handle", handle, "--tool-unit", "inch"}},
           {1, "are the same point", {"--tool", scope, "--tool-tip", tip, "--tool-handle", tip}},
           {1, "off the tool's surface", {"--tool", scope, "--tool-tip", "0,0,0", "--tool-handle", handle}},
           {1, "see --tool-unit", {"--tool", scope, "--tool-tip", tip, "--tool-handle", handle, "--tool-unit", "m"}},
           {1,
            "bad.stl: holds no triangles",
            {"--tool", (box_ / "bad.stl").string(), "--tool-tip", tip, "--tool-handle", handle}}}) {
    const Outcome outcome = trial("never", one.options);
    EXPECT_EQ(outcome.exit_code, one.exit_code) << one.naming << ": " << outcome.err;
    ASSERT_EQ(outcome.messages().size(), 1u) << outcome.err;
    EXPECT_EQ(outcome.err, outcome.messages()[0] + "\n") << "nothing but the message";
    EXPECT_NE(outcome.err.find(one.naming), std::string::npos) << outcome.err;
    EXPECT_FALSE(fs::exists(box_ / "never"));
  }
}

TEST(ToolLook, AToolWithAHandleIsDrawnAsItselfAndABladeGetsOne) {
  const TriangleMesh scope = laryngoscope(0.102, 0.11);
  const Extent extent = extent_of(scope);
  double bounds[6];
  blade_surface(scope)->GetBounds(bounds);
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(bounds[2 * axis], 1e3 * extent.low[axis], 1e-4);
    EXPECT_NEAR(bounds[2 * axis + 1], 1e3 * extent.high[axis], 1e-4);
  }
  EXPECT_EQ(handle_surface(scope)->GetNumberOfPoints(), 0);
  // A handle that stands to another side than the tongue's is one too.
  const TriangleMesh aside = moved(scope, axes(Vec3(1, 0, 0), Vec3(0, 1, 0)), Vec3::Zero()),
                     behind = moved(scope, axes(Vec3(1, 0, 0), Vec3(0, 0, -1)), Vec3::Zero());
  EXPECT_LT(extent_of(aside).high.z(), 0.030);
  EXPECT_EQ(handle_surface(aside)->GetNumberOfPoints(), 0);
  EXPECT_EQ(handle_surface(behind)->GetNumberOfPoints(), 0);
  for (const char* blade : {"miller-00", "miller-0", "miller-1"})
    EXPECT_GT(handle_surface(engine::blade_surface(engine::miller_blade(blade)))->GetNumberOfPoints(), 0) << blade;
  // The bulb sits under the blade (its lower face is at -1 mm), within its width, near the tip.
  ToolLook look(scope);
  look.place(engine::Pose{});
  EXPECT_NEAR(look.bulb_mm().x(), 16.0, 1e-9);
  EXPECT_NEAR(look.bulb_mm().y(), 2.5, 1e-9);
  EXPECT_LT(look.bulb_mm().z(), -1.0);
  EXPECT_GT(look.bulb_mm().z(), -4.0);
}

TEST(ToolLook, TheBulbIsLetIntoTheBladeAndHangsNowhereInTheAir) {
  for (const char* name : {"miller-00", "miller-0", "miller-1"}) {  // with a flange that hangs below the plate
    const TriangleMesh blade = engine::blade_surface(engine::miller_blade(name));
    ToolLook look(blade);
    look.place(engine::Pose{});
    double b[6];
    look.actors().back()->GetBounds(b);
    ASSERT_LT(b[1] - b[0], 1.5) << "mm: the bulb";
    const double centre[3] = {0.5 * (b[0] + b[1]), 0.5 * (b[2] + b[3]), 0.5 * (b[4] + b[5])};
    vtkNew<vtkCellLocator> surface;
    surface->SetDataSet(blade_surface(blade));
    surface->BuildLocator();
    double nearest[3], distance2 = 0.0;
    vtkIdType cell = 0;
    int part = 0;
    surface->FindClosestPoint(centre, nearest, cell, part, distance2);
    EXPECT_LT(std::sqrt(distance2), 0.45) << name << ": half in its plate";
    EXPECT_GT(std::sqrt(distance2), 0.05) << name << ": and to be seen";
  }
}

}  // namespace
}  // namespace vallecula::gui::test
