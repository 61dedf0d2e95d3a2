// Stills of tissue, tools and spheres for the laboratory's figures: white ground, parallel projection, plain light.
#pragma once

#include <QColor>
#include <QImage>
#include <array>
#include <vector>

#include "engine/types.h"
#include "gui/views/gl_view.h"

namespace vallecula::gui {

/// Needs a QApplication with a display (WindowApplication). All lengths in m.
class TissuePicture : public GlView {
 public:
  TissuePicture(int width, int height);

  using Triangles = std::vector<std::array<int, 3>>;
  void add_surface(const std::vector<engine::Vec3>& points, const Triangles& triangles, const QColor& colour,
                   double opacity = 1.0);
  /// One colour a point, run into each other.
  void add_coloured(const std::vector<engine::Vec3>& points, const Triangles& triangles,
                    const std::vector<QColor>& colours);
  void add_wireframe(const std::vector<engine::Vec3>& points, const Triangles& triangles, const QColor& colour,
                     double opacity = 1.0);
  void add_tool(const engine::TriangleMesh& tool, const engine::Pose& pose, const QColor& colour, double opacity = 1.0);
  struct Ball {
    engine::Vec3 centre;
    double radius;
  };
  void add_balls(const std::vector<Ball>& balls, const QColor& colour);

  /// Looks at `centre` from the side `from` (any length), `up` upwards; `across` m fit into the picture's width.
  void look(const engine::Vec3& centre, const engine::Vec3& from, const engine::Vec3& up, double across);
  QImage still();
};

}  // namespace vallecula::gui
