// The adaptive inner sphere tree (AIST; paper section 3.1, DESIGN 4.2): spheres that fill the soft body at rest, tied to
// its tetrahedra by barycentric coordinates, and the clusters of them that a query prunes by.
#pragma once

#include <vector>

#include "engine/mesh/soft_mesh.h"
#include "engine/scene.h"

namespace vallecula::engine {

struct InnerSphere {
  Vec3 centre;                     ///< at rest, m
  double radius = 0.0;             ///< m
  int level = 0;                   ///< 0 coarse, 1 the split cells', above: the surface levels of `full`
  std::int32_t tet = -1;           ///< that contains the centre
  std::array<double, 4> weight{};  ///< of that tet's nodes, in file order
  std::int32_t tied = 0;           ///< number of tetrahedra the sphere encloses (their centroids lie in it)
  std::int32_t first_tied = 0, tied_count = 0;  ///< range of SphereTree::tied_nodes: the nodes of those and of `tet`
  std::int32_t triangle = -1;      ///< face of the soft body's surface that its surface point lies in
  std::array<double, 3> surface_weight{};  ///< of the surface point next to it, in that face
  double area = 0.0;               ///< surface area the sphere answers for, m^2 (contact stiffness is per area)
  bool core = false;               ///< of the grid, behind surface spheres: the second line of contact
  /// Contact resists once the tool is this near, m: zero at the surface's vertices, which carry the force; negative on
  /// faces (a flat face cannot follow a round tool), positive for the core.
  double standoff = 0.0;
  bool touchable = true;           ///< false where every node it hangs on is anchored: nothing gets there
};

/// Spheres that lie together; bounded by the box of the tissue nodes they hang on (a centre is a convex combination of
/// its nodes, so the box of the nodes holds it however the tissue deforms: refitting needs no sphere).
struct SphereCluster {
  std::int32_t first = 0, count = 0;   ///< range of spheres
  std::int32_t first_node = 0, node_count = 0;  ///< range of SphereTree::cluster_nodes
};

/// Two neighbouring spheres of the grid, which resist being pressed together (paper 3.1).
struct SphereDistance {
  std::int32_t a = -1, b = -1;     ///< spheres
  double rest = 0.0;               ///< distance of the centres at rest, m
};

struct SphereTree {
  std::vector<InnerSphere> spheres;    ///< ordered by cluster
  std::vector<SphereCluster> clusters;
  std::vector<std::int32_t> cluster_nodes;
  std::vector<std::int32_t> tied_nodes;  ///< per sphere in ascending order
  std::vector<float> tied_weights;       ///< a sphere's sum to 1 and give its centre
  std::vector<SphereDistance> distances; ///< of grid spheres that touch or nearly do
  std::vector<int> spheres_per_level;
  double coarse_radius = 0.0;          ///< m
  double mean_tet_volume = 0.0;        ///< m^3
};

/// What a flat face gives way, between its vertices, before it resists: the sag of a round tool's surface over a chord as long
/// as its longest edge (m), within bounds. Held off everywhere, a 5 mm sphere on 2 mm cells reads 30 to 90 % too much force.
double face_sag(double longest_edge);

struct FillSettings {
  Coverage coverage = Coverage::full;
  double sphere_ratio = 10.0;          ///< sphere volume over mean tetrahedron volume (the paper's optimum)
  int levels = 2;                      ///< of the paper's grid: coarse and split cells
  double surface_spacing = 0.001;    ///< `full`: largest distance of surface spheres along an edge, m
  double surface_radius = 0.001;       ///< `full`: their largest radius, m
};

/// Throws std::invalid_argument when no sphere fits.
SphereTree fill_spheres(const SoftBodyDescription& soft, const SoftSurface& surface, const FillSettings& settings);

/// Largest and mean gap of area-sampled surface points to the nearest sphere's surface, and the share with a gap of at
/// most 0.25 mm (DESIGN 4.2 `uncovered_depth_m`).
struct CoverageReport {
  double uncovered_depth_m = 0.0;
  double mean_gap_m = 0.0;
  double covered_fraction = 0.0;
};
CoverageReport measure_coverage(const SphereTree& tree, const SoftBodyDescription& soft, const SoftSurface& surface,
                                int samples);

}  // namespace vallecula::engine
