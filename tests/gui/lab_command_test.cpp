// `vallecula lab`: the figures of a run, bad input, and the paper's overshoot.
#include <gtest/gtest.h>

#include <QImage>
#include <QJsonDocument>
#include <QJsonObject>
#include <array>
#include <set>
#include <sstream>

#include "engine/tool/shapes.h"
#include "tests/gui/block_patient.h"
#include "tests/gui/program.h"
#include "tests/gui/tool_file.h"

namespace vallecula::gui::test {
namespace {

namespace fs = std::filesystem;

using Point = std::array<double, 3>;
using Tet = std::array<int, 4>;

/// A block of 20 x 20 x 10 mm (m in the file), of cubes of six tetrahedra.
struct Block {
  std::vector<Point> points;
  std::vector<Tet> tets;
};
Block block() {
  constexpr int kX = 4, kY = 4, kZ = 2;
  constexpr double kEdge = 0.005;
  constexpr int kWays[6][2] = {{1, 3}, {3, 2}, {2, 6}, {6, 4}, {4, 5}, {5, 1}};
  const auto number = [](int i, int j, int k) { return i + (kX + 1) * (j + (kY + 1) * k); };
  Block b;
  for (int k = 0; k <= kZ; ++k)
    for (int j = 0; j <= kY; ++j)
      for (int i = 0; i <= kX; ++i) b.points.push_back({kEdge * i, kEdge * j, kEdge * k});
  for (int k = 0; k < kZ; ++k)
    for (int j = 0; j < kY; ++j)
      for (int i = 0; i < kX; ++i) {
        int c[8];
        for (int q = 0; q < 8; ++q) c[q] = number(i + (q & 1), j + (q >> 1 & 1), k + (q >> 2 & 1));
        for (const auto& way : kWays) b.tets.push_back({c[0], c[way[0]], c[way[1]], c[7]});
      }
  return b;
}

void write_mesh(const Sandbox& box, const std::string& name, const Block& b) {
  std::ostringstream nodes, eles;
  nodes << b.points.size() << " 3 0 0\n";
  for (std::size_t i = 0; i < b.points.size(); ++i)
    nodes << i << " " << b.points[i][0] << " " << b.points[i][1] << " " << b.points[i][2] << "\n";
  eles << b.tets.size() << " 4 0\n";
  for (std::size_t i = 0; i < b.tets.size(); ++i)
    eles << i << " " << b.tets[i][0] << " " << b.tets[i][1] << " " << b.tets[i][2] << " " << b.tets[i][3] << "\n";
  write_text(box / (name + ".node"), nodes.str());
  write_text(box / (name + ".ele"), eles.str());
}

/// The options of a run that works; a test changes what it is about.
struct LabRun {
  explicit LabRun(const Sandbox& sandbox) : box(sandbox) {
    write_mesh(box, "block", block());
    // A plate of 3 mm comes from 3 mm above the block and presses 1 mm into it.
    write_text(box / "press.csv", "t,x,y,z\n0,0.01,0.01,0.0145\n0.2,0.01,0.01,0.0105\n0.3,0.01,0.01,0.0105\n");
    options = {{"--tet", (box / "block.node").string()},       {"--tool", "box:0.02x0.02x0.003"},
               {"--trajectory", (box / "press.csv").string()}, {"--fix", "z<0.001"},
               {"--json", (box / "out.json").string()},        {"--csv", (box / "out.csv").string()},
               {"--spheres", (box / "spheres.csv").string()},  {"--final", (box / "final.vtu").string()}};
  }
  LabRun& with(const std::string& option, const std::string& value) {
    for (auto& [name, was] : options)
      if (name == option) {
        was = value;
        return *this;
      }
    options.emplace_back(option, value);
    return *this;
  }
  LabRun& without(const std::string& option) {
    for (std::size_t i = 0; i < options.size(); ++i)
      if (options[i].first == option) options.erase(options.begin() + static_cast<std::ptrdiff_t>(i));
    return *this;
  }
  Outcome go() const {
    std::vector<std::string> arguments = {"lab"};
    for (const auto& [name, value] : options) {
      arguments.push_back(name);
      arguments.push_back(value);
    }
    return box.run(arguments);
  }
  /// One line that names `naming`, the exit code, and no file.
  void refused(int exit_code, const std::string& naming) const {
    const Outcome outcome = go();
    EXPECT_EQ(outcome.exit_code, exit_code) << outcome.err;
    ASSERT_EQ(outcome.messages().size(), 1u) << outcome.err;
    EXPECT_EQ(outcome.err, outcome.messages()[0] + "\n") << "nothing but the message";
    EXPECT_NE(outcome.err.find(naming), std::string::npos) << "names '" << naming << "': " << outcome.err;
    EXPECT_EQ(outcome.out, "");
    for (const char* name : {"out.json", "out.csv", "spheres.csv", "final.vtu"})
      EXPECT_FALSE(fs::exists(box / name)) << name << " after: " << outcome.err;
  }
  const Sandbox& box;
  std::vector<std::pair<std::string, std::string>> options;
};

QJsonObject json_in(const fs::path& file) {
  return QJsonDocument::fromJson(QByteArray::fromStdString(text_of(file))).object();
}

// The keys that others read.
TEST(LabCommand, TheFiguresHaveTheirAgreedKeys) {
  const Sandbox box;
  const Outcome outcome = LabRun(box).go();
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  const QJsonObject json = json_in(box / "out.json");
  const std::vector<std::pair<const char*, std::vector<const char*>>> keys = {
      {"settings", {}},
      {"mesh", {"nodes", "tets", "mean_tet_volume_m3"}},
      {"aist", {"spheres_per_level", "coarse_radius_m", "uncovered_depth_m", "covered_surface_fraction"}},
      {"step_ms", {"min", "p50", "p99", "p999", "max"}},
      {"share_ms", {"collision", "response", "elasticity", "solve", "other"}},
      {"contacts", {"p50", "max"}},
      {"force_n", {"p50", "max", "max_change_per_tick"}},
      {"tissue", {"volume_change_max", "inverted_max", "residual_m", "finite"}},
      {"penetration_m", {"p50", "max"}},
      {"limit", {"entered", "time_limited_s", "time_lost_s"}}};
  for (const auto& [group, members] : keys) {
    ASSERT_TRUE(json[group].isObject()) << group;
    for (const char* key : members)
      EXPECT_FALSE(json[group].toObject()[key].isUndefined() || json[group].toObject()[key].isNull())
          << group << "." << key;
  }
  EXPECT_TRUE(json.contains("realtime"));
  EXPECT_EQ(json["mesh"].toObject()["nodes"].toInt(), 75);
  EXPECT_EQ(json["mesh"].toObject()["tets"].toInt(), 192);
  EXPECT_GT(json["force_n"].toObject()["max"].toDouble(), 0.05);
  EXPECT_LT(json["penetration_m"].toObject()["max"].toDouble(), 0.0005);

  std::istringstream csv(text_of(box / "out.csv"));
  std::string line;
  std::getline(csv, line);
  EXPECT_EQ(line, "t_s,step_ms,contacts,fx_n,fy_n,fz_n,tx_nm,ty_nm,tz_nm,state,proxy_x_m,proxy_y_m,proxy_z_m");
  int rows = 0;
  while (std::getline(csv, line)) ++rows;
  EXPECT_EQ(rows, 301);
  EXPECT_EQ(text_of(box / "spheres.csv").rfind("level,x_m,y_m,z_m,radius_m,tet,w0,w1,w2,w3,tied\n", 0), 0u);
  EXPECT_TRUE(fs::exists(box / "final.vtu"));
}

// Withheld steps and steps twice as long, their forces predicted: nearer to the full run than held forces are.
TEST(LabCommand, PredictionIsMeasuredAgainstTheFullRun) {
  const Sandbox box;
  const Outcome outcome = LabRun(box).with("--serve-every", "2").go();
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const QJsonObject json = json_in(box / "out.json");
  const QJsonObject prediction = json["prediction"].toObject();
  double last = 0.0;
  for (const char* withheld : {"1", "2", "3", "5", "10"}) {
    const QJsonObject error = prediction[withheld].toObject();
    EXPECT_GT(error["rms_n"].toDouble(), 0.0) << withheld;
    // The touch itself nobody foresees; of one or two steps it is most of the error.
    const double share = std::atoi(withheld) < 3 ? 1.0 : 0.6;
    EXPECT_LT(error["rms_n"].toDouble(), share * error["hold_rms_n"].toDouble()) << withheld;
    EXPECT_GE(error["max_n"].toDouble(), error["p99_n"].toDouble()) << withheld;
    EXPECT_GT(error["hold_rms_n"].toDouble(), last) << withheld;
    last = error["hold_rms_n"].toDouble();
  }
  const QJsonObject multirate = json["multirate"].toObject();
  EXPECT_EQ(multirate["serve_every"].toInt(), 2);
  EXPECT_GT(multirate["rms_n"].toDouble(), 0.0);
  EXPECT_LT(multirate["rms_n"].toDouble(), multirate["hold_rms_n"].toDouble());
  const Sandbox other;
  LabRun(other).with("--serve-every", "0").refused(2, "--serve-every");
  LabRun(other).with("--serve-every", "2").with("--force-limit", "7.9").refused(2, "--serve-every");
}

TEST(LabCommand, InRealTimeItCountsWhatWasLate) {
  const Sandbox box;
  const std::vector<std::string> run = {"lab",          "--tet",        (box / "block.ele").string(), "--tool",
                                        "sphere:0.004", "--trajectory", (box / "press.csv").string(), "--fix",
                                        "z<0.001",      "--realtime"};
  const LabRun files(box);
  const Outcome outcome = box.run(run);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const QJsonObject json = QJsonDocument::fromJson(QByteArray::fromStdString(outcome.out)).object();
  const QJsonObject realtime = json["realtime"].toObject();
  for (const char* key : {"requested_hz", "achieved_hz", "deadline_misses", "ticks", "late_p999_ms"})
    EXPECT_TRUE(realtime[key].isDouble()) << key;
  EXPECT_EQ(realtime["ticks"].toInt(), 301);
}

TEST(LabCommand, AMeshThatCannotBeSteppedIsRefused) {
  const Sandbox box;
  LabRun run(box);
  Block inverted = block();
  std::swap(inverted.tets[5][2], inverted.tets[5][3]);
  write_mesh(box, "inverted", inverted);
  run.with("--tet", (box / "inverted.node").string()).refused(1, "tetrahedron 5 is inverted");

  Block two = block();
  const int count = static_cast<int>(two.points.size());
  for (int i = 0; i < count; ++i) two.points.push_back({two.points[i][0] + 0.1, two.points[i][1], two.points[i][2]});
  for (const Tet& t : block().tets) two.tets.push_back({t[0] + count, t[1] + count, t[2] + count, t[3] + count});
  write_mesh(box, "two", two);
  run.with("--tet", (box / "two.ele").string()).refused(1, "not joined (points 0 and 75)");

  Block flat = block();
  flat.points[31] = flat.points[30];
  write_mesh(box, "flat", flat);
  run.with("--tet", (box / "flat.node").string()).refused(1, "is flat");
  run.with("--tet", (box / "none.node").string()).refused(1, "none.node");
}

TEST(LabCommand, ToolAndTrajectoryAreChecked) {
  const Sandbox box;
  LabRun run(box);
  write_text(box / "open.obj", "v 0 0 0\nv 0.01 0 0\nv 0 0.01 0\nv 0 0 0.01\nf 1 3 2\nf 1 2 4\nf 1 4 3\n");
  run.with("--tool", (box / "open.obj").string()).refused(1, "not closed (3 edges");
  run.with("--tool", "box:0.02x0x0.003").refused(1, "'0' is not a length");
  run.with("--tool", "paddle:0.01x0.02x0.003").refused(1, "at least as long as wide");
  run.with("--tool", "paddle:0.01x0.02").refused(1, "write paddle:LxWxH");
  run.with("--tool", "cube").refused(1, "paddle:LxWxH, sphere:R");
  run.with("--tool", (box / "none.ply").string()).refused(1, "none.ply");
  run.with("--tool", "box:0.02x0.02x0.003");
  write_text(box / "nan.csv", "t,x,y,z\n0,0.01,0.01,0.013\n0.2,nan,0.01,0.0095\n");
  run.with("--trajectory", (box / "nan.csv").string()).refused(1, "line 3: column 2 is 'nan'");
  write_text(box / "back.csv", "t,x,y,z\n0,0.01,0.01,0.013\n0.2,0.01,0.01,0.0095\n0.1,0.01,0.01,0.0095\n");
  run.with("--trajectory", (box / "back.csv").string()).refused(1, "line 4: time 0.1 s");
}

TEST(LabCommand, APaddleFromAFilePressesAsTheNamedOneDoes) {
  const Sandbox box;
  LabRun run(box);
  // Off the block's middle: centred, the paddle's edges lie exactly over the block's, and the 1e-9 m that a file's
  // single precision moves a point by decides whether an edge touches.
  write_text(box / "press.csv", "t,x,y,z\n0,0.0107,0.0096,0.0145\n0.2,0.0107,0.0096,0.0105\n0.3,0.0107,0.0096,0.0105\n");
  run.with("--tool", "paddle:0.02x0.012x0.003");
  ASSERT_EQ(run.go().exit_code, 0);
  const double named_n = json_in(box / "out.json")["force_n"].toObject()["max"].toDouble();
  ASSERT_GT(named_n, 0.01);
  for (const char* file : {"paddle.stl", "paddle.obj", "paddle.ply"}) {
    write_tool_file(box / file, engine::paddle_surface({0.02, 0.012, 0.003}), 1.0);
    run.with("--tool", (box / file).string());
    ASSERT_EQ(run.go().exit_code, 0) << file;
    EXPECT_NEAR(json_in(box / "out.json")["force_n"].toObject()["max"].toDouble(), named_n, 1e-3 * named_n) << file;
  }
}

TEST(LabCommand, NumbersOutOfTheirRangeAreNamed) {
  const Sandbox box;
  const LabRun good(box);
  const auto with = [&](const char* option, const char* value) { return LabRun(good).with(option, value); };
  with("--poisson", "0.5").refused(1, "0.500000");
  with("--poisson", "nan").refused(1, "nan");
  with("--young", "-1").refused(1, "-1.000000");
  with("--density", "0").refused(1, "0.000000");
  with("--sphere-ratio", "-2").refused(1, "-2.000000");
  with("--levels", "0").refused(1, "0 levels");
  with("--force-limit", "0").refused(2, "'0'");
  with("--force-limit", "nan").refused(2, "'nan'");
  with("--steps-per-second", "5").refused(2, "5.0");
  with("--young", "soft").refused(2, "soft");
  with("--fix", "z<-5").refused(1, "fixes 0 nodes");
  LabRun(good).without("--fix").refused(2, "--fix");
  LabRun(good).without("--tet").refused(2, "--tet");
  LabRun(good).without("--tool").refused(2, "--tool");
  LabRun(good).without("--trajectory").refused(2, "--trajectory");
}

TEST(LabCommand, AFigureBringsItsOwnScene) {
  const Sandbox box;
  const LabRun run(box);
  LabRun(run).with("--figure", "7").refused(2, "--tet");
  LabRun(run).with("--out", (box / "figure").string()).refused(2, "--out");
  const Outcome other = box.run({"lab", "--figure", "9", "--out", (box / "figure").string()});
  EXPECT_EQ(other.exit_code, 2) << other.err;
  EXPECT_NE(other.err.find("9 not in"), std::string::npos) << other.err;
  EXPECT_FALSE(fs::exists(box / "figure"));
  const Outcome file = box.run({"lab", "--figure", "7", "--out", (box / "press.csv").string()});
  EXPECT_EQ(file.exit_code, 1) << file.err;
  ASSERT_EQ(file.messages().size(), 1u) << file.err;
  EXPECT_NE(file.err.find("press.csv"), std::string::npos) << file.err;
}

// The whole way, manikin and import included.
TEST(LabCommand, AfterAnOvershootTheTongueReturns) {
  const Sandbox box;
  const Outcome outcome = box.run({"lab", "--figure", "7", "--out", (box / "figure").string()});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(box.names("figure"), (std::vector<std::string>{"figure-7.json", "figure-7.png"}));
  const QJsonObject json = json_in(box / "figure" / "figure-7.json");
  EXPECT_EQ(json["figure"].toString(), "7");
  for (const char* run : {"penalty", "compliant_without_limit", "ours", "ours_with_blade"}) {
    ASSERT_TRUE(json[run].isObject()) << run;
    for (const char* key : {"finite", "residual_mm", "recovered", "largest_displacement_mm", "force_max_n",
                            "force_change_per_step_max_n", "inverted_max", "tool_depth_max_mm", "limit"})
      EXPECT_FALSE(json[run].toObject()[key].isUndefined()) << run << "." << key;
  }
  const QJsonObject ours = json["ours"].toObject(), settings = json["settings"].toObject();
  EXPECT_EQ(settings["depth_mm"].toDouble(), 25.0);
  EXPECT_TRUE(ours["finite"].toBool());
  EXPECT_TRUE(ours["recovered"].toBool());
  EXPECT_LT(ours["residual_mm"].toDouble(1e9), 0.1);  // the target of the paper's experiment, one second after
  EXPECT_TRUE(ours["limit"].toObject()["entered"].toBool());
  EXPECT_GT(ours["limit"].toObject()["time_lost_s"].toDouble(), 0.0);  // held for longer than 0.5 s
  EXPECT_LE(ours["force_max_n"].toDouble(), settings["force_limit_n"].toDouble() * (1 + 1e-9));
  EXPECT_LE(ours["force_change_per_step_max_n"].toDouble(), 0.4 * (1 + 1e-9));  // 400 N/s at 1 kHz
  EXPECT_LT(ours["tool_depth_max_mm"].toDouble(), 24.0) << "the limit stops the tool before the hand";

  QImage picture(QString::fromStdString((box / "figure" / "figure-7.png").string()));
  ASSERT_GE(picture.width(), 1200);
  std::set<QRgb> colours;
  int dark = 0;
  for (int y = 0; y < picture.height(); y += 2)
    for (int x = 0; x < picture.width(); x += 2) {
      colours.insert(picture.pixel(x, y) & 0xF0F0F0);
      dark += qGray(picture.pixel(x, y)) < 100 ? 1 : 0;
    }
  EXPECT_GT(colours.size(), 100u) << "tissue is drawn, not a blank picture";
  EXPECT_GT(dark, 2000) << "axes and letters";
}

}  // namespace
}  // namespace vallecula::gui::test
