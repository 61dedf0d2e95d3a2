#include "engine/tube/glottis.h"

#include <cmath>
#include <stdexcept>
#include <string>

namespace vallecula::engine {

namespace {

// All assumed but their order: cords close faster than they open.
constexpr double kAtEase = 0.55;  // opening of cords that nothing moves: neither open nor closed
constexpr double kBreathOut = 0.45, kBreathIn = 1.0;
constexpr double kInspiration = 0.4;                           // share of a breath
constexpr double kClosing = 1.0 / 0.08, kOpening = 1.0 / 0.4;  // 1/s
constexpr double kShortClosure = 0.6, kLongClosure = 1.4;      // of the median
constexpr double kWeary = 2.0;                                 // s
constexpr double kMostStep = 0.1;                              // s
constexpr double kLongest = 120.0;                             // s

double smooth(double x) noexcept { return x * x * (3.0 - 2.0 * x); }

double breathed(double phase) noexcept {
  const double in = phase < kInspiration ? smooth(phase / kInspiration) : smooth((1.0 - phase) / (1.0 - kInspiration));
  return kBreathOut + (kBreathIn - kBreathOut) * in;
}

void close(const Glottis& g, GlottisState& s) noexcept {
  s.spasm = g.spasm_s > 0;
  s.closed_s = s.spasm ? g.spasm_s : g.closure_s * s.draw.between(kShortClosure, kLongClosure);
}

}  // namespace

Glottis checked(const Glottis& g) {
  const auto need = [](bool good, const std::string& what, double value) {
    if (!good) throw std::invalid_argument("glottis: " + what + ", not " + std::to_string(value));
  };
  need(g.length_m >= 0.002 && g.length_m <= 0.015, "a length from 2 to 15 mm is needed (in m)", g.length_m);
  need(g.front_share > 0 && g.front_share <= 1, "the front's share must be above 0 and at most 1", g.front_share);
  need(g.widest_half_slope > 0 && g.widest_half_slope <= 1.5, "a half slope above 0 and up to 1.5 is needed",
       g.widest_half_slope);
  need(g.closure_s >= 0 && g.closure_s <= kLongest, "a closure from 0 to 120 s is needed", g.closure_s);
  need(g.spasm_s >= 0 && g.spasm_s <= kLongest, "a laryngospasm from 0 to 120 s is needed", g.spasm_s);
  if (g.spasm_from_start && !(g.spasm_s > 0))
    throw std::invalid_argument("glottis: a laryngospasm from the start needs its time");
  if (g.relaxed && g.spasm_s > 0) throw std::invalid_argument("glottis: no laryngospasm under a muscle relaxant");
  return g;
}

GlottisState start(const Glottis& g) noexcept {
  GlottisState s;
  s.draw.state = g.seed;
  s.spasm = g.spasm_from_start;
  s.closed_s = s.spasm ? g.spasm_s : 0.0;
  s.opening = s.spasm ? 0.0 : kAtEase;
  return s;
}

void step(const Glottis& g, GlottisState& s, const GlottisInput& input, double dt_s) noexcept {
  if (!std::isfinite(s.opening + s.closed_s + s.weary_s)) {
    s = start(g);
    s.faults = kGlottisFaultState;
    return;
  }
  const bool numbers = std::isfinite(input.breath_phase) && std::isfinite(dt_s);
  s.faults = numbers ? kGlottisFaultNone : kGlottisFaultInput;
  const double dt = std::isfinite(dt_s) ? std::clamp(dt_s, 0.0, kMostStep) : 0.0;

  const bool begins = input.touched && !s.touched;
  s.touched = input.touched;
  s.weary_s = std::max(0.0, s.weary_s - dt);
  if (input.held_closed && !g.relaxed) {
    // The last tick of it: let go, they open as after any closure.
    s.spasm = true;
    s.closed_s = std::max(s.closed_s, dt);
  } else if (s.closed_s > 0) {
    s.closed_s -= dt;
    if (!(s.closed_s > 0)) {
      s.closed_s = 0.0;
      s.spasm = false;
      s.weary_s = kWeary;
    }
  } else if (begins && s.weary_s == 0 && !g.relaxed) {
    close(g, s);
  }

  double target = kAtEase;
  if (s.closed_s > 0)
    target = 0.0;
  else if (input.breathing && numbers && !g.relaxed)
    target = breathed(std::clamp(input.breath_phase, 0.0, 1.0));
  s.opening += std::clamp(target - s.opening, -kClosing * dt, kOpening * dt);
}

}  // namespace vallecula::engine
