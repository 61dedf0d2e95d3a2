#include "gui/views/force_bars.h"

#include <QPainter>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "curricula/score/handle_loads.h"
#include "gui/report/judged_lines.h"
#include "gui/session/words_from_below.h"
#include "gui/views/theme.h"

namespace vallecula::gui {
namespace {

constexpr double kSmall = 8.0, kName = 10.5;  // points
constexpr double kBetweenWords = 6.0;         // px
constexpr double kLeastTrack = 130.0;         // px at a text scale of one

QString newtons(double force_n) { return decimal(force_n, 1); }

QFont with_points(QFont font, double points, bool bold = false) {
  font.setPointSizeF(theme::points(points));
  font.setBold(bold);
  return font;
}

/// Two patterns as well as two colours, so that the parts are told apart without colour.
void fill_lifted(QPainter& painter, const QRectF& place) { painter.fillRect(place, theme::within()); }
void fill_levered(QPainter& painter, const QRectF& place) {
  painter.fillRect(place, theme::bad());
  painter.fillRect(place, QBrush(theme::ground(), Qt::BDiagPattern));
}

}  // namespace

BladeForces blade_forces(const std::array<engine::StructureLoad, engine::kLoadedStructures>& loads,
                         const engine::Pose& blade) {
  std::array<std::array<double, 3>, curricula::kStructures> forces_n;
  std::transform(loads.begin(), loads.end(), forces_n.begin(), [](const engine::StructureLoad& load) {
    return std::array<double, 3>{load.force_n.x(), load.force_n.y(), load.force_n.z()};
  });
  const engine::Quat& q = blade.rotation;
  const curricula::HandleLoads handle = curricula::handle_loads(forces_n, {q.w(), q.x(), q.y(), q.z()});
  const auto magnitude = [&](engine::Structure structure) {
    return loads[static_cast<std::size_t>(structure)].force_n.norm();
  };
  return {magnitude(engine::Structure::tongue), magnitude(engine::Structure::gum), handle.lifted_n(), handle.levered_n};
}

ForceMarks force_marks(const curricula::Scenario& scenario, double device_limit_n) {
  return {scenario.targets.tongue_force_n,   scenario.targets.gum_force_n,   device_limit_n,
          scenario.pass.peak_tongue_force_n, scenario.pass.peak_gum_force_n, scenario.pass.time_over_target_s};
}

ForceBars::ForceBars(QWidget* parent) : QWidget(parent) {
  setAccessibleName(tr("Force on the tongue and on the gum"));
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
}

double ForceBars::line() const { return QFontMetricsF(with_points(font(), kSmall)).height(); }

// Two bars with their labels above, the tongue's with its parts and their words below.
// A bar's figure and its peak stand above each other: with large text they are what it must be high for.
QSize ForceBars::sizeHint() const { return {420, minimumSizeHint().height() + 10}; }
QSize ForceBars::minimumSizeHint() const {
  const double now = QFontMetricsF(with_points(font(), 13.0, true)).height();
  const QFontMetricsF small(with_points(font(), kSmall));
  double marks = 2.0 * kBetweenWords;  // each with its word: what it is stands nowhere else on the page
  for (const QString& word : {tr("target %1"), tr("pass limit %1"), tr("device limit %1")})
    marks += small.horizontalAdvance(word.arg(newtons(9.9))) + 2.0;
  const double bar = names_wide() + theme::points(kLeastTrack) + figures_wide();
  return {static_cast<int>(std::ceil(std::max(marks, bar))),
          static_cast<int>(std::max(4.2 * line() + 76.0, 2.0 * (2.0 * line() + now + 2.0) + parts_high()))};
}
double ForceBars::parts_high() const { return 9.0 + 4.0 + 1.2 * line(); }

void ForceBars::set_marks(const ForceMarks& marks) {
  tongue_.target = marks.tongue_target_n;
  gum_.target = marks.gum_target_n;
  tongue_.pass = marks.tongue_pass_n;
  gum_.pass = marks.gum_pass_n;
  device_limit_ = marks.device_limit_n;
  scale_ =
      std::max(1.0, std::ceil(1.2 * std::max({device_limit_, tongue_.target, gum_.target, tongue_.pass, gum_.pass})));
  // By how each looks, so that who wonders about a line finds it.
  QStringList lines;
  lines << tr("Bars: model force of the tissue on the blade, in newton. White line: the highest so far.");
  lines << tr("Target: yellow line of dashes and dots. What to train for, %1 N on the tongue and %2 N on the gum; a "
              "trial passes with at "
              "most %3 s above the tongue's.")
               .arg(newtons(tongue_.target), newtons(gum_.target), newtons(marks.over_target_s));
  lines << tr("Pass limit: red line. A peak above %1 N on the tongue or %2 N on the gum does not pass.")
               .arg(newtons(tongue_.pass), newtons(gum_.pass));
  if (device_limit_ > 0.0)
    lines << tr("Device limit: blue dashed line, hatched beyond it. Your device cannot push back with more than %1 N: "
                "there the blade stays where it is, and a grey one shows your hand.")
                 .arg(newtons(device_limit_));
  lines << tr(
      "Below the tongue's bar: what your hand lifts along the handle of all that lies on the blade, so it may be more "
      "than the tongue's share, and what is levered on the upper jaw (hatched).");
  setToolTip(lines.join('\n'));
  clear();
}

void ForceBars::show_forces(const BladeForces& now, const std::optional<PeaksSoFar>& peaks) {
  tongue_.peak = std::max(tongue_.peak, peaks ? static_cast<double>(peaks->tongue_n) : now.tongue_n);
  gum_.peak = std::max(gum_.peak, peaks ? static_cast<double>(peaks->gum_n) : now.gum_n);
  show(now, false);
}

void ForceBars::show_expert(const BladeForces& now) { show(now, true); }

void ForceBars::show(const BladeForces& now, bool of_expert) {
  of_expert_ = of_expert;
  tongue_.now = now.tongue_n;
  gum_.now = now.gum_n;
  lifted_ = now.lifted_n;
  levered_ = now.levered_n;
  const QString words = of_expert ? tr("An expert's: tongue %1 N, gum %2 N, lift %3 N, lever %4 N")
                                  : tr("tongue %1 N, gum %2 N, lift %3 N, lever %4 N");
  setAccessibleDescription(words.arg(newtons(now.tongue_n), newtons(now.gum_n), newtons(lifted_), newtons(levered_)));
  update();
}

PeaksSoFar ForceBars::peaks() const {
  PeaksSoFar peaks;
  peaks.tongue_n = static_cast<float>(tongue_.peak);
  peaks.gum_n = static_cast<float>(gum_.peak);
  return peaks;
}

void ForceBars::clear() {
  tongue_.now = tongue_.peak = gum_.now = gum_.peak = lifted_ = levered_ = 0.0;
  of_expert_ = false;
  update();
}

double ForceBars::share_of_track(double newton) const { return std::clamp(newton / scale_, 0.0, 1.0); }

double ForceBars::names_wide() const {
  const QFontMetricsF type(with_points(font(), kName));
  return std::max(
      {theme::points(64.0), type.horizontalAdvance(tr("Tongue")) + 10.0, type.horizontalAdvance(tr("Gum")) + 10.0});
}

double ForceBars::figures_wide() const {
  const QFontMetricsF now(with_points(font(), 13.0, true)), small(with_points(font(), kSmall));
  return 9.0 +
         std::max({now.horizontalAdvance(tr("%1 N").arg(newtons(88.8))),
                   small.horizontalAdvance(tr("peak %1").arg(newtons(88.8))), small.horizontalAdvance(tr("expert"))});
}

QRectF ForceBars::track_of(const QRectF& place) const {
  return place.adjusted(names_wide(), line() + 3.0, -figures_wide(), -4.0);
}

void ForceBars::paint_bar(QPainter& painter, const QRectF& place, const QString& name, const Bar& bar,
                          bool with_limit) const {
  const QRectF track = track_of(place);
  const auto at = [&](double newton) { return track.left() + track.width() * share_of_track(newton); };
  painter.setFont(with_points(font(), kName));
  painter.setPen(theme::text());
  painter.drawText(QRectF(place.left(), track.top(), track.left() - place.left() - 8.0, track.height()),
                   Qt::AlignVCenter | Qt::AlignLeft, name);

  painter.setPen(Qt::NoPen);
  painter.setBrush(theme::track());
  painter.drawRoundedRect(track, 4, 4);
  if (with_limit && device_limit_ > 0.0) {
    const QRectF beyond(at(device_limit_), track.top(), track.right() - at(device_limit_), track.height());
    painter.setBrush(QBrush(theme::faint(), Qt::FDiagPattern));
    painter.drawRect(beyond);
  }
  const bool over = bar.target > 0.0 && bar.now > bar.target;
  painter.setBrush(over ? theme::over() : theme::within());
  const QRectF filled(track.left(), track.top(), at(bar.now) - track.left(), track.height());
  if (filled.width() > 0.5) painter.drawRoundedRect(filled, 3, 3);
  if (over) {
    painter.setBrush(QBrush(theme::ground(), Qt::VerPattern));
    painter.drawRect(QRectF(at(bar.target), track.top(), at(bar.now) - at(bar.target), track.height()));
  }

  painter.setFont(with_points(font(), kSmall));
  // Their words stand in one line: the target's before its mark, the others after theirs, each after the one before,
  // and all as far to the left as the last one needs.
  struct Word {
    double from, wide;
    QString text;
    QColor colour;
  };
  std::vector<Word> words;
  const QFontMetricsF type(painter.font());
  const auto mark = [&](double newton, const JudgedLine& look, const QString& text, bool before) {
    if (!(newton > 0.0)) return;
    const QColor colour = theme::of_this_ground(look.on_paper);
    painter.setPen(QPen(colour, 2.0, look.style, Qt::FlatCap));
    painter.drawLine(QPointF(at(newton), track.top() - 3.0), QPointF(at(newton), track.bottom() + 3.0));
    const double wide = type.horizontalAdvance(text) + 2.0;
    const double free_from = words.empty() ? place.left() : words.back().from + words.back().wide + kBetweenWords;
    words.push_back({std::max(free_from, at(newton) + (before ? 3.0 - wide : -3.0)), wide, text, colour});
  };
  mark(bar.target, kTargetLine, tr("target %1").arg(newtons(bar.target)), true);
  mark(bar.pass, kPassLine, tr("pass limit %1").arg(newtons(bar.pass)), false);
  if (with_limit) mark(device_limit_, kDeviceLine, tr("device limit %1").arg(newtons(device_limit_)), false);
  const auto length = [&] {
    return std::accumulate(words.begin(), words.end(), -kBetweenWords,
                           [](double sum, const Word& word) { return sum + word.wide + kBetweenWords; });
  };
  while (length() > place.width()) words.pop_back();  // no room: the tooltip has it
  double free_to = place.right();
  std::for_each(words.rbegin(), words.rend(), [&](Word& word) {
    word.from = std::min(word.from, free_to - word.wide);
    free_to = word.from - kBetweenWords;
  });
  for (const Word& word : words) {
    painter.setPen(word.colour);
    painter.drawText(QRectF(word.from, place.top() - 1.0, word.wide, line()), Qt::AlignLeft | Qt::AlignVCenter,
                     word.text);
  }
  if (bar.peak > 0.05 && !of_expert_) {
    painter.setPen(QPen(theme::text(), 1.5));
    painter.drawLine(QPointF(at(bar.peak), track.top()), QPointF(at(bar.peak), track.bottom()));
  }
  const QRectF figures(track.right() + 8.0, track.top() - 3.0, place.right() - track.right() - 8.0,
                       track.height() + 6.0);
  painter.setFont(with_points(font(), 13.0, true));
  painter.setPen(over ? theme::over() : theme::text());
  painter.drawText(figures, Qt::AlignTop | Qt::AlignLeft, tr("%1 N").arg(newtons(bar.now)));
  painter.setFont(with_points(font(), kSmall));
  painter.setPen(theme::faint());
  painter.drawText(figures, Qt::AlignBottom | Qt::AlignLeft,
                   of_expert_ ? tr("expert") : tr("peak %1").arg(newtons(bar.peak)));
}

/// A strip on the same scale, lift first, then lever; their words with figures below it.
void ForceBars::paint_parts(QPainter& painter, const QRectF& place) const {
  const double strip = 9.0;
  const QRectF track(place.left(), place.top(), place.width(), strip);
  painter.fillRect(track, theme::track());
  const double lifted = track.width() * share_of_track(lifted_),
               both = track.width() * share_of_track(lifted_ + levered_);
  if (lifted > 0.5) fill_lifted(painter, QRectF(track.left(), track.top(), lifted, strip));
  if (both - lifted > 0.5) fill_levered(painter, QRectF(track.left() + lifted, track.top(), both - lifted, strip));
  painter.setFont(with_points(font(), kSmall + 0.5));
  const QFontMetricsF type(painter.font());
  const double box = 0.7 * type.ascent(), between = 16.0;
  const QString lift = tr("lift %1 N").arg(newtons(lifted_)), lever = tr("lever %1 N").arg(newtons(levered_));
  const double whole = 2.0 * (box + 5.0) + between + type.horizontalAdvance(lift) + type.horizontalAdvance(lever);
  double x = std::max(0.0, std::min(track.left(), width() - whole));  // where the track is short, from before it
  const auto word = [&](const QString& text, void (*fill)(QPainter&, const QRectF&)) {
    const double y = track.bottom() + 3.0;
    fill(painter, QRectF(x, y + type.ascent() - box, box, box));
    painter.setPen(theme::text());
    painter.drawText(QPointF(x + box + 5.0, y + type.ascent()), text);
    x += box + 5.0 + type.horizontalAdvance(text) + between;
  };
  word(lift, fill_lifted);
  word(lever, fill_levered);
}

void ForceBars::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const double parts = parts_high(), half = 0.5 * (height() - parts);
  const QRectF tongue(0, 1, width(), half);
  paint_bar(painter, tongue, tr("Tongue"), tongue_, true);
  const QRectF track = track_of(tongue);
  paint_parts(painter, QRectF(track.left(), track.bottom() + 5.0, track.width(), parts));
  paint_bar(painter, QRectF(0, half + parts, width(), half), tr("Gum"), gum_, false);
}

}  // namespace vallecula::gui
