// The passivity observer (Hannaford and Ryu, 2002): the energy the hand has put into the device so far. A passive
// device gives back no more than it was given, so it never falls below zero.
#pragma once

#include "engine/types.h"

namespace vallecula::engine {

/// J. A force is held from one tick to the next, so a tick's energy is the force shown times the way the hand then
/// went.
class PassivityObserver {
 public:
  /// The hand has gone `way` (m) and turned by `turn` (rad, rotation vector) while `force_n` was shown and the coupling
  /// would have shown `torque_nm`, both on the hand.
  void add(const Vec3& force_n, const Vec3& way, const Vec3& torque_nm, const Vec3& turn) noexcept {
    const double work = -force_n.dot(way);
    (work > 0 ? pushed_in_ : given_back_) += work > 0 ? work : -work;
    turned_in_ -= torque_nm.dot(turn);
    lowest_ = energy() < lowest_ ? energy() : lowest_;
    lowest_pushed_ = pushed_in_ - given_back_ < lowest_pushed_ ? pushed_in_ - given_back_ : lowest_pushed_;
  }
  double pushed_in() const noexcept { return pushed_in_; }    ///< by the forces, while the hand worked against them
  double given_back() const noexcept { return given_back_; }  ///< by the forces, while they drove the hand
  /// By turning the tool, less what turned it back. A device of three forces shows no torque: this is work that the
  /// hand does in the scene unfelt, and that can come back as force where a blade is levered.
  double turned_in() const noexcept { return turned_in_; }
  double energy() const noexcept { return pushed_in_ - given_back_ + turned_in_; }
  double lowest() const noexcept { return lowest_; }                   ///< of energy(); 0 or less
  double lowest_of_forces() const noexcept { return lowest_pushed_; }  ///< of pushed_in() - given_back()

 private:
  double pushed_in_ = 0.0, given_back_ = 0.0, turned_in_ = 0.0, lowest_ = 0.0, lowest_pushed_ = 0.0;
};

}  // namespace vallecula::engine
