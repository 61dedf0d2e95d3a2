#include "tests/gui/block_patient.h"

#include <fstream>

#include "pipeline/package/label_map.h"

namespace vallecula::gui::test {

namespace fs = std::filesystem;
using pipeline::Anchor;
using pipeline::Point;
using pipeline::Surface;
using pipeline::Tissue;

namespace {

/// Adds a closed box with outward triangles.
void add_box(Surface& surface, const Point& low, const Point& high, Tissue tissue) {
  const int first = static_cast<int>(surface.points.size());
  for (int corner = 0; corner < 8; ++corner) {
    surface.points.push_back(
        {corner & 1 ? high[0] : low[0], corner & 2 ? high[1] : low[1], corner & 4 ? high[2] : low[2]});
  }
  constexpr int kFaces[12][3] = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                                 {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  for (const auto& face : kFaces) {
    surface.triangles.push_back({first + face[0], first + face[1], first + face[2]});
    surface.tissue.push_back(static_cast<std::uint8_t>(tissue));
  }
}

Surface closed_box(const Point& low, const Point& high) {
  Surface surface;
  add_box(surface, low, high, Tissue::mucosa);
  surface.tissue.clear();
  return surface;
}

/// Kuhn's six tetrahedra of every cell: neighbours share their faces' diagonals.
pipeline::TetMesh block_tongue() {
  constexpr int kX = 5, kY = 6, kZ = 3;
  pipeline::TetMesh mesh;
  const auto node = [](int x, int y, int z) { return (z * (kY + 1) + y) * (kX + 1) + x; };
  for (int z = 0; z <= kZ; ++z) {
    for (int y = 0; y <= kY; ++y) {
      for (int x = 0; x <= kX; ++x) {
        mesh.points.push_back({-10.0 + 4.0 * x, -15.0 + 5.0 * y, -12.0 + 4.0 * z});
        Anchor anchor = Anchor::free;
        if (z == 0) anchor = y < 4 ? Anchor::mandible : Anchor::hyoid;
        if (z == kZ - 1 && y == kY) anchor = Anchor::larynx;
        mesh.anchor.push_back(static_cast<std::uint8_t>(anchor));
      }
    }
  }
  // The ways from one corner of the cube to the opposite one along its edges; odd permutations are turned round.
  constexpr int kOrders[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {1, 0, 2}, {2, 1, 0}};
  for (int z = 0; z < kZ; ++z) {
    for (int y = 0; y < kY; ++y) {
      for (int x = 0; x < kX; ++x) {
        for (int order = 0; order < 6; ++order) {
          int at[3] = {x, y, z};
          std::array<int, 4> tet{};
          tet[0] = node(at[0], at[1], at[2]);
          for (int step = 0; step < 3; ++step) {
            ++at[kOrders[order][step]];
            tet[step + 1] = node(at[0], at[1], at[2]);
          }
          if (order >= 3) std::swap(tet[1], tet[2]);
          mesh.tets.push_back(tet);
          mesh.tissue.push_back(y == kY - 1 && z == kZ - 1 ? 1 : 0);
        }
      }
    }
  }
  return mesh;
}

}  // namespace

void write_text(const fs::path& file, const std::string& text) { std::ofstream(file, std::ios::binary) << text; }

pipeline::PatientPackage block_patient() {
  pipeline::PatientPackage package;
  package.name = "block";
  package.provenance = {{"modality", "synthetic"}};
  package.landmarks = {{"upper_gum_midline", {0, -28, 36}}, {"lower_gum_midline", {0, -17, 2}},
                       {"vallecula", {0, 12, -2}},          {"glottis_centre", {0, 40, -30}},
                       {"glottis_normal", {0, -0.6, 0.8}},  {"carina", {0, 45, -80}},
                       {"operator_eye", {0, -150, 120}},    {"hyoid", {0, 10, -14}},
                       {"epiglottis_tip", {0, 15, 1}},      {"condyle_axis", {0, 30, 10}}};
  package.materials["tongue"] = {6000.0, 0.45, 1040.0};
  package.materials["epiglottis"] = {90e3, 0.45, 1040.0};
  Surface& face = package.surfaces["face"];
  add_box(face, {-20, -25, 40}, {20, 30, 46}, Tissue::palate);
  add_box(face, {-20, -31, 36}, {20, -25.5, 46}, Tissue::gum);
  package.surfaces["airway"] = closed_box({-3, 35, -80}, {3, 45, -30});
  package.surfaces["mandible"] = closed_box({-20, -25, -25}, {20, -19, -5});
  package.surfaces["palate"] = closed_box({-18, -24, 41}, {18, 28, 45});
  Surface& glottis = package.surfaces["glottis"];
  glottis.points = {{-2, 38, -31.5}, {2, 38, -31.5}, {2, 42, -28.5}, {-2, 42, -28.5}};
  glottis.triangles = {{0, 1, 2}, {0, 2, 3}};
  package.tongue = block_tongue();
  package.quality = {{"tongue volume", 7.2, "ml", true, ""}};
  return package;
}

fs::path write_block_patient(const fs::path& folder) {
  pipeline::Grid grid;
  grid.size = {12, 16, 8};
  grid.spacing = {2.0, 2.0, 2.0};
  grid.origin = {-11.0, -15.0, -13.0};
  pipeline::Labels labels(grid, pipeline::kSkin);
  for (int z = 1; z < 7; ++z) {
    for (int y = 0; y < 15; ++y) {
      for (int x = 1; x < 11; ++x) labels.at(x, y, z) = pipeline::kTongue;
    }
  }
  const fs::path package = folder / "block.patient";
  pipeline::write_package(block_patient(), labels, package);
  return package;
}

fs::path write_press(const fs::path& folder) {
  // Half a turn about (1, -1, 0): the blade's length points to -y, its tongue-side face down.
  const std::string down = ",0,0.70710678118654752,-0.70710678118654752,0\n";
  std::string csv = "t,x,y,z,qw,qx,qy,qz\n";
  for (const char* row :
       {"0,0,0.005,0.006", "0.2,0,0.005,0.002", "0.6,0,0.005,-0.0025", "0.9,0,0.005,-0.0025", "1.2,0,0.005,0.006"}) {
    csv += row + down;
  }
  write_text(folder / "press.csv", csv);
  return folder / "press.csv";
}

std::string usual_demands(int max_attempt_s) {
  return R"(    manikin: { weight_kg: 3.2, seed: 1 }
    blade: miller-1
    sight_percent: 25
    max_attempt_s: )" +
         std::to_string(max_attempt_s) + R"(
    targets: { tongue_force_n: 5.0, gum_force_n: 2.0 }
    pass:
      peak_tongue_force_n: 6.8
      peak_gum_force_n: 3.0
      glottis_visible_percent: 50
      attempt_time_s: 30
      time_over_target_s: 3
      time_over_device_limit_s: 0.2
)";
}

fs::path write_curriculum(const fs::path& folder) {
  write_text(folder / "plain.yaml", R"(schema: 1
id: test-course
title: Test course
scenarios:
  - id: plain
    title: Blocks & <plain> shapes
    briefing: Press on the block.
    debriefing: A block has no glottis to see.
)" + usual_demands());
  return folder / "plain.yaml";
}

}  // namespace vallecula::gui::test
