#include "engine/tissue/tissue_model.h"

#include <algorithm>
#include <map>
#include <set>
#include <stdexcept>

#include "engine/mesh/soft_mesh.h"

namespace vallecula::engine {

namespace {

constexpr double kStiff = 4.0;  // times the softest material: there block Jacobi alone is too slow

double lame_lambda(const TissueMaterial& m) {
  return m.young_pa * m.poisson / ((1 + m.poisson) * (1 - 2 * m.poisson));
}

}  // namespace

TissueModel::TissueModel(const SoftBodyDescription& soft, double step, bool hold_volume) {
  check_soft_body(soft);
  nodes = static_cast<int>(soft.nodes.size());
  tets = static_cast<int>(soft.tets.size());
  step_s = step;
  rest = soft.nodes;
  anchor = soft.node_anchor;
  bodies = soft.bodies;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const SprungBody& body = bodies[b];
    if (body.motion == SprungBody::Motion::fixed) continue;
    if (!(body.inertia > 0) || !(body.stiffness > 0) || body.damping < 0)
      throw std::invalid_argument("sprung body " + std::to_string(b) + ": inertia and stiffness must be above 0");
  }
  mass.assign(nodes, 0.0f);

  std::vector<double> node_mass(nodes, 0.0);
  std::map<std::pair<int, int>, int> pressure_index;
  std::vector<double> pressure_volume;
  std::vector<std::set<int>> neighbours(nodes);
  std::vector<int> stepped;  // tetrahedra of which a node can move; the others stay as they are
  for (int t = 0; t < tets; ++t) {
    const auto& k = soft.tets[t];
    const TissueMaterial& material = soft.materials[soft.tet_material[t]];
    const double volume = tet_volume(rest[k[0]], rest[k[1]], rest[k[2]], rest[k[3]]);
    bool moves = false;
    for (int c = 0; c < 4; ++c) {
      const auto [it, fresh] =
          pressure_index.try_emplace({k[c], soft.tet_material[t]}, static_cast<int>(pressure_index.size()));
      if (fresh) {
        pressure_volume.push_back(0.0);
        pressure_lambda.push_back(static_cast<float>(lame_lambda(material)));
        pressure_held.push_back(hold_volume && material.poisson >= kHeldFromPoisson ? 1.0f : 0.0f);
      }
      pressure_volume[it->second] += volume / 4;
      held_volume += pressure_held[it->second] * volume / 4;
      held_lambda += pressure_held[it->second] * volume / 4 * lame_lambda(material);
      node_mass[k[c]] += material.density_kg_m3 * volume / 4;
      if (fixed(k[c])) continue;
      moves = true;
      for (int d = 0; d < 4; ++d)
        if (!fixed(k[d])) neighbours[k[c]].insert(k[d]);
    }
    if (moves) stepped.push_back(t);
  }
  for (int i = 0; i < nodes; ++i) mass[i] = static_cast<float>(node_mass[i]);
  if (held_volume > 0) held_lambda /= held_volume;
  for (double v : pressure_volume) pressure_inverse_volume.push_back(static_cast<float>(1.0 / v));

  row_start.push_back(0);
  diagonal.assign(nodes, -1);
  for (int i = 0; i < nodes; ++i) {
    for (int j : neighbours[i]) {
      if (j == i) diagonal[i] = static_cast<std::int32_t>(column.size());
      column.push_back(j);
    }
    if (column.size() % 2 != 0) column.push_back(i);
    row_start.push_back(static_cast<std::int32_t>(column.size()));
    if (diagonal[i] >= 0) moving.push_back(i);
  }

  double softest = soft.materials[soft.tet_material[0]].young_pa;
  for (std::uint8_t m : soft.tet_material) softest = std::min(softest, soft.materials[m].young_pa);
  packs.resize((stepped.size() + kLanes - 1) / kLanes);
  tet_block.resize(packs.size() * kLanes);
  for (std::size_t s = 0; s < packs.size() * kLanes; ++s) {
    TetPack& pack = packs[s / kLanes];
    const std::size_t lane = s % kLanes;
    tet_block[s].fill(-1);
    if (s >= stepped.size()) {  // a lane that only pads: weightless and stiffless
      pack.tet[lane] = -1;
      for (int c = 0; c < 4; ++c) {
        pack.node[c][lane] = 0;
        pack.pressure[c][lane] = 0;
        for (int a = 0; a < 3; ++a) pack.gradient[c][a][lane] = 0.0f;
      }
      pack.volume[lane] = pack.mu[lane] = pack.lambda[lane] = pack.guarded[lane] = pack.tolerance[lane] = 0.0f;
      continue;
    }
    const int t = stepped[s];
    const auto& k = soft.tets[t];
    const TissueMaterial& material = soft.materials[soft.tet_material[t]];
    const auto gradients = shape_gradients(rest[k[0]], rest[k[1]], rest[k[2]], rest[k[3]]);
    pack.tet[lane] = t;
    pack.volume[lane] = static_cast<float>(tet_volume(rest[k[0]], rest[k[1]], rest[k[2]], rest[k[3]]));
    pack.mu[lane] = static_cast<float>(material.young_pa / (2 * (1 + material.poisson)));
    pack.lambda[lane] = static_cast<float>(lame_lambda(material));
    pack.guarded[lane] = material.young_pa < kStiff * softest ? 1.0f : 0.0f;
    pack.tolerance[lane] = static_cast<float>(kRefreshTolerance * softest / material.young_pa);
    for (int c = 0; c < 4; ++c) {
      pack.node[c][lane] = k[c];
      for (int a = 0; a < 3; ++a) pack.gradient[c][a][lane] = static_cast<float>(gradients(a, c));
      pack.pressure[c][lane] = pressure_index.at({k[c], soft.tet_material[t]});
      for (int d = 0; d < 4; ++d) {
        if (fixed(k[c]) || fixed(k[d])) continue;
        const auto begin = column.begin() + row_start[k[c]], end = column.begin() + row_start[k[c] + 1];
        tet_block[s][4 * c + d] = static_cast<std::int32_t>(std::find(begin, end, k[d]) - column.begin());
      }
    }
  }

  for (int i = 0; i < nodes; ++i) {
    if (fixed(i)) fixed_nodes.push_back(i);
    if (anchor[i] < 0 || fixed(i)) continue;
    const SprungBody& body = bodies[anchor[i]];
    const Vec3 arm = body.axis.normalized().cross(rest[i] - body.pivot);
    anchored.push_back({i, anchor[i], from_vec3(arm)});
  }
  build_coarse_space(soft);
}

void TissueModel::build_coarse_space(const SoftBodyDescription& soft) {
  constexpr std::size_t kGroupSize = 40;  // nodes: small enough to bend as a chain of rigid groups
  coarse_index.assign(nodes, -1);
  double softest = soft.materials[soft.tet_material[0]].young_pa;
  for (std::uint8_t m : soft.tet_material) softest = std::min(softest, soft.materials[m].young_pa);
  std::set<int> stiff;
  for (int t = 0; t < tets; ++t)
    if (soft.materials[soft.tet_material[t]].young_pa >= kStiff * softest)
      for (int v : soft.tets[t])
        if (anchor[v] < 0) stiff.insert(v);
  if (stiff.empty()) return;
  std::vector<std::vector<int>> groups = {std::vector<int>(stiff.begin(), stiff.end())};
  for (std::size_t g = 0; g < groups.size();) {
    if (groups[g].size() <= kGroupSize) {
      ++g;
      continue;
    }
    Vec3 low = rest[groups[g][0]], high = low;
    for (int v : groups[g]) {
      low = low.cwiseMin(rest[v]);
      high = high.cwiseMax(rest[v]);
    }
    int axis = 0;
    (high - low).maxCoeff(&axis);
    std::sort(groups[g].begin(), groups[g].end(), [&](int a, int b) {
      return rest[a][axis] != rest[b][axis] ? rest[a][axis] < rest[b][axis] : a < b;
    });
    const auto half = groups[g].begin() + static_cast<std::ptrdiff_t>(groups[g].size() / 2);
    std::vector<int> upper(half, groups[g].end());
    groups[g].erase(half, groups[g].end());
    groups.push_back(std::move(upper));
  }
  coarse_groups = static_cast<int>(groups.size());
  for (int g = 0; g < coarse_groups; ++g) {
    coarse_count.push_back(static_cast<std::int32_t>(groups[g].size()));
    for (int v : groups[g]) {
      coarse_index[v] = static_cast<std::int32_t>(coarse_nodes.size());
      coarse_nodes.push_back({v, g});
    }
  }
}

}  // namespace vallecula::engine
