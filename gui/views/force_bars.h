// Force as bars, the display that trainees read best (CLINICAL.md): on the tongue and on the gum, apart, each with its
// training target; of the tongue's load what the hand lifts and what is levered on the upper jaw; the device's own
// limit is marked as what it is.
#pragma once

#include <QWidget>
#include <array>
#include <optional>

#include "curricula/scenario.h"
#include "engine/tick_record.h"
#include "gui/session/peaks_so_far.h"

namespace vallecula::gui {

struct ForceMarks {
  double tongue_target_n = 0.0;  ///< training target
  double gum_target_n = 0.0;
  double device_limit_n = 0.0;  ///< what the device can give
  /// A trial with a higher peak is not passed; 0: there is no such mark.
  double tongue_pass_n = 0.0, gum_pass_n = 0.0;
  double over_target_s = 0.0;  ///< so long the tongue's target may be exceeded in a trial that passes
};
/// All of a scenario's.
ForceMarks force_marks(const curricula::Scenario& scenario, double device_limit_n);

/// Model forces at a moment, N.
struct BladeForces {
  double tongue_n = 0.0, gum_n = 0.0;      ///< magnitudes
  double lifted_n = 0.0, levered_n = 0.0;  ///< of what the blade bears, as the score has it (handle_loads)
};
BladeForces blade_forces(const std::array<engine::StructureLoad, engine::kLoadedStructures>& loads,
                         const engine::Pose& blade);

class ForceBars : public QWidget {
  Q_OBJECT
 public:
  explicit ForceBars(QWidget* parent = nullptr);
  void set_marks(const ForceMarks& marks);
  /// `peaks`: the largest so far; left out, of what was shown. They are kept until clear().
  void show_forces(const BladeForces& now, const std::optional<PeaksSoFar>& peaks = std::nullopt);
  /// An expert's, in place of one's own, whose peaks stay kept; until show_forces().
  void show_expert(const BladeForces& now);
  void clear();
  PeaksSoFar peaks() const;
  double tongue_peak_n() const { return tongue_.peak; }
  double gum_peak_n() const { return gum_.peak; }
  /// Share of the track's width that a force takes, 0..1.
  double share_of_track(double newton) const;
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  struct Bar {
    double now = 0.0, peak = 0.0, target = 0.0, pass = 0.0;
  };
  void show(const BladeForces& now, bool of_expert);
  void paint_bar(class QPainter& painter, const QRectF& place, const QString& name, const Bar& bar,
                 bool with_limit) const;
  void paint_parts(class QPainter& painter, const QRectF& place) const;
  QRectF track_of(const QRectF& place) const;
  double names_wide() const;    ///< px: what stands before the tracks
  double figures_wide() const;  ///< px: and behind them
  /// Of a line of small type, px.
  double parts_high() const;  ///< strip and words of lift and lever, px
  double line() const;
  Bar tongue_, gum_;
  double lifted_ = 0.0, levered_ = 0.0;
  double device_limit_ = 0.0, scale_ = 10.0;
  bool of_expert_ = false;
};

}  // namespace vallecula::gui
