// The lips and the skin about them: a membrane under tension on an elastic bed (Filonenko and Borodich's), which the
// blade pushes out of its way and which pushes back; it goes along with the jaw and comes back by itself.
#pragma once

#include <vector>

#include "engine/contact/tool_field.h"
#include "engine/haptics/proxy.h"
#include "engine/scene.h"

namespace vallecula::engine {

struct LipState {
  std::vector<Vec3> displacement, next;  ///< of each point, on top of what the jaw carries it by, m
  Wrench wrench;                         ///< on the tool, about its tip
  Mat6 stiffness = Mat6::Zero();         ///< what the wrench changes by as the tool moves
  bool at_rest = true;

  void set_rest() noexcept;
};

class Lips {
 public:
  Lips() = default;
  /// Throws std::invalid_argument naming what cannot be simulated.
  Lips(const LipDescription& lips, const std::vector<SprungBody>& bodies, double step_s);

  LipState make_state() const;
  /// One step with the tool standing at `tool`: each point goes back towards its rest and its neighbours, those the
  /// tool holds are put on its surface, and what holding them takes is the force on the tool (without friction).
  void step(const ToolField& tool, const Pose& pose, const std::vector<Vec3>& body_displacement,
            LipState& state) const noexcept;

 private:
  struct Point {
    Vec3 rest;
    double jaw_share = 0.0, bed = 0.0, tie = 0.0, rate = 0.0;  ///< bed, tie: N/m; rate: share of a step's way back
    int first = 0, last = 0;                                   ///< in ties_
  };
  struct Tie {
    int to;
    double stiffness;  ///< N/m
  };
  std::vector<Point> points_;
  std::vector<Tie> ties_;
  SprungBody jaw_;
  int jaw_index_ = -1;
  Vec3 low_ = Vec3::Zero(), high_ = Vec3::Zero();
};

}  // namespace vallecula::engine
