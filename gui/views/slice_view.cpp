#include "gui/views/slice_view.h"

#include <QLineF>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "gui/session/words_from_below.h"
#include "gui/views/theme.h"

namespace vallecula::gui {
namespace {

constexpr double kLandmarkReach = 3.0;  // mm before and behind the slice in which a landmark is still shown
const QColor kCross(86, 180, 233, 190), kRuler(240, 228, 66), kFound(255, 255, 255), kMoved(230, 159, 0);

/// Light text stays readable over bone when it has a dark rim.
void rimmed_text(QPainter& painter, const QPointF& at, const QString& text, const QColor& colour) {
  painter.setPen(QColor(0, 0, 0, 200));
  for (const QPointF& d : {QPointF(-1, 0), QPointF(1, 0), QPointF(0, -1), QPointF(0, 1)})
    painter.drawText(at + d, text);
  painter.setPen(colour);
  painter.drawText(at, text);
}

}  // namespace

/// What stands beside marks: collected first, then placed so that no name covers a mark or another name.
class SliceView::Names {
 public:
  void add(const QPointF& mark, const QString& text, const QColor& colour) { all_.push_back({mark, text, colour}); }
  /// Those nearest to `focus` first: where there is little room, they are the ones that matter.
  /// `taken`: by letters at the edges.
  void draw(QPainter& painter, const QRectF& within, const QPointF& focus, std::vector<QRectF> taken) {
    std::stable_sort(all_.begin(), all_.end(), [&](const Name& a, const Name& b) {
      return QLineF(a.mark, focus).length() < QLineF(b.mark, focus).length();
    });
    for (const Name& name : all_) taken.emplace_back(name.mark - QPointF(6, 6), QSizeF(12, 12));
    for (const Name& name : all_) {
      const double wide = painter.fontMetrics().horizontalAdvance(name.text), high = painter.fontMetrics().height();
      const double middle = -0.5 * wide;
      for (const QPointF& place :
           {QPointF(9, 4), QPointF(-9 - wide, 4), QPointF(middle, -9), QPointF(middle, 8 + 0.8 * high),
            QPointF(9, 4 + high), QPointF(9, 4 - high), QPointF(-9 - wide, 4 - high)}) {
        const QRectF box(name.mark.x() + place.x(), name.mark.y() + place.y() - 0.8 * high, wide, high);
        const auto meets = [&](const QRectF& other) { return other.intersects(box); };
        if (!within.contains(box) || std::any_of(taken.begin(), taken.end(), meets)) continue;
        rimmed_text(painter, name.mark + place, name.text, name.colour);
        taken.push_back(box);
        break;  // where there is no room the mark stands alone; pointed at, it says its name
      }
    }
  }

 private:
  struct Name {
    QPointF mark;
    QString text;
    QColor colour;
  };
  std::vector<Name> all_;
};

SliceView::SliceView(SliceScene& scene, SlicePlane plane, QWidget* parent)
    : QWidget(parent), scene_(scene), plane_(plane), axes_(axes_of(plane)) {
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  setMinimumSize(150, 120);
  setAttribute(Qt::WA_OpaquePaintEvent);
  setAccessibleName(tr("%1 slice").arg(in_words(axes_.name)));
  setAccessibleDescription(tr(
      "Arrows move the crosshair, Page Up and Page Down change the slice, plus, minus and 0 zoom, Enter puts a point "
      "of the tool at the crosshair, Escape puts the tool away, Delete removes the last measure, F shows this view "
      "alone"));
  connect(&scene_, &SliceScene::changed, this, &SliceView::scan_changed);
  connect(&scene_, &SliceScene::focus_changed, this, [this] {
    if (fitted_) fit();
  });
  connect(&scene_, &SliceScene::tool_changed, this,
          [this] { setCursor(scene_.tool() == SliceTool::crosshair ? Qt::ArrowCursor : Qt::CrossCursor); });
  scan_changed();
}

void SliceView::scan_changed() {
  if (scene_.scan() != shown_) {
    shown_ = scene_.scan();
    picture_version_ = -1;
    fit();
  }
  update();
}

QPointF SliceView::pixel_of(const pipeline::Point& at) const {
  return {0.5 * width() + scale_ * (at[axes_.across] - middle_.x()),
          0.5 * height() + axes_.down_sign * scale_ * (at[axes_.down] - middle_.y())};
}

pipeline::Point SliceView::point_at(const QPointF& pixel) const {
  pipeline::Point at = scene_.crosshair();
  if (shown_ != nullptr)  // the slice that is shown, not where between two the crosshair stands
    at[axes_.through] =
        shown_->grid.origin[axes_.through] + scene_.slice_index(plane_) * shown_->grid.spacing[axes_.through];
  at[axes_.across] = middle_.x() + (pixel.x() - 0.5 * width()) / scale_;
  at[axes_.down] = middle_.y() + axes_.down_sign * (pixel.y() - 0.5 * height()) / scale_;
  return at;
}

void SliceView::fit() {
  fitted_ = true;
  if (shown_ == nullptr) return;
  const auto& [low, high] = scene_.focus();
  const auto extent = [&, low = low, high = high](int a) { return high[a] - low[a]; };
  const auto centre = [&, low = low, high = high](int a) { return 0.5 * (low[a] + high[a]); };
  scale_ = 0.98 * std::min(width() / extent(axes_.across), height() / extent(axes_.down));
  middle_ = {centre(axes_.across), centre(axes_.down)};
  update();
}

void SliceView::zoom(double factor, const QPointF& about) {
  const auto before = point_at(about);
  scale_ = std::clamp(scale_ * factor, 0.2, 60.0);
  const auto after = point_at(about);
  middle_ += QPointF(before[axes_.across] - after[axes_.across], before[axes_.down] - after[axes_.down]);
  fitted_ = false;
  update();
}

void SliceView::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  if (fitted_) fit();
}

void SliceView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), Qt::black);
  if (shown_ != nullptr) {
    const int index = scene_.slice_index(plane_);
    if (index != picture_index_ || scene_.picture_version() != picture_version_) {
      picture_ = scene_.picture(plane_);
      picture_index_ = index;
      picture_version_ = scene_.picture_version();
    }
    // The picture's corners lie half a voxel outside the outer voxels' centres.
    const auto& g = shown_->grid;
    pipeline::Point low = g.position(-0.5, -0.5, -0.5);
    pipeline::Point high = g.position(g.size[0] - 0.5, g.size[1] - 0.5, g.size[2] - 0.5);
    if (axes_.down_sign < 0.0) std::swap(low[axes_.down], high[axes_.down]);
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    painter.drawImage(QRectF(pixel_of(low), pixel_of(high)), picture_);
    painter.setRenderHint(QPainter::Antialiasing);
    draw_crosshair(painter);
    Names names;
    draw_measures(painter, names);
    draw_seeds(painter, names);
    draw_landmarks(painter, names);
    // The letter of each edge, the slice's name and the scale keep their places.
    const double x = 0.5 * width(), y = 0.5 * height();
    names.draw(painter, rect(), pixel_of(scene_.crosshair()),
               {{0, y - 20, 26, 26},
                {width() - 26.0, y - 20, 26, 26},
                {x - 12, 0, 26, 26},
                {x - 12, height() - 28.0, 26, 28},
                {0, 0, 150, 24},
                {width() - 90.0, height() - 34.0, 90, 34}});
    draw_edges(painter);
  }
  painter.setRenderHint(QPainter::Antialiasing, false);
  painter.setPen(hasFocus() ? theme::device() : theme::track());
  painter.setBrush(Qt::NoBrush);
  painter.drawRect(rect().adjusted(0, 0, -1, -1));
}

void SliceView::draw_crosshair(QPainter& painter) const {
  const QPointF c = pixel_of(scene_.crosshair());
  constexpr double kGap = 12.0;  // what is pointed at stays uncovered
  painter.setPen(QPen(kCross, 1.0));
  painter.drawLine(QPointF(0, c.y()), QPointF(c.x() - kGap, c.y()));
  painter.drawLine(QPointF(c.x() + kGap, c.y()), QPointF(width(), c.y()));
  painter.drawLine(QPointF(c.x(), 0), QPointF(c.x(), c.y() - kGap));
  painter.drawLine(QPointF(c.x(), c.y() + kGap), QPointF(c.x(), height()));
}

void SliceView::draw_measures(QPainter& painter, Names& names) const {
  for (const Measure& measure : scene_.measures()) {
    if (measure.plane != plane_ || measure.points.empty()) continue;
    const double apart = measure.points.front()[axes_.through] - point_at({0, 0})[axes_.through];
    if (std::abs(apart) > 0.5 * shown_->grid.spacing[axes_.through]) continue;
    painter.setPen(QPen(kRuler, 1.6));
    painter.setBrush(Qt::NoBrush);
    for (std::size_t i = 0; i < measure.points.size(); ++i) {
      const QPointF at = pixel_of(measure.points[i]);
      if (i > 0) painter.drawLine(pixel_of(measure.points[i - 1]), at);
      painter.drawEllipse(at, 2.5, 2.5);
    }
    const QPointF at = pixel_of(measure.points[measure.points.size() == 3 ? 1 : measure.points.size() - 1]);
    names.add(at, QString::fromStdString(text_of(measure)), kRuler);
  }
}

void SliceView::draw_landmarks(QPainter& painter, Names& names) const {
  for (const auto& [name, mark] : scene_.landmarks()) {
    if (!in_slice(mark.at)) continue;
    const QPointF at = pixel_of(mark.at);
    const QColor colour = mark.given ? kMoved : kFound;
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(QColor(0, 0, 0, 180), 3.5));
    painter.drawEllipse(at, 5.0, 5.0);
    painter.setPen(QPen(colour, 1.6));
    painter.drawEllipse(at, 5.0, 5.0);
    names.add(at, words_of(name), colour);
  }
}

void SliceView::draw_seeds(QPainter& painter, Names& names) const {
  for (const auto& [name, at] : scene_.seeds()) {
    if (!in_slice(at)) continue;
    const QPointF p = pixel_of(at);
    for (const QPen& pen : {QPen(QColor(0, 0, 0, 180), 4.0), QPen(theme::target(), 2.0)}) {
      painter.setPen(pen);
      painter.drawLine(p - QPointF(6, 6), p + QPointF(6, 6));
      painter.drawLine(p - QPointF(6, -6), p + QPointF(6, -6));
    }
    names.add(p, tr("seed of %1").arg(words_of(name)), theme::target());
  }
}

void SliceView::draw_edges(QPainter& painter) const {
  QFont font = painter.font();
  font.setBold(true);
  font.setPointSizeF(theme::points(12.0));
  painter.setFont(font);
  const double x = 0.5 * width(), y = 0.5 * height();
  rimmed_text(painter, {8, y}, axes_.left, theme::text());
  rimmed_text(painter, {width() - 20.0, y}, axes_.right, theme::text());
  rimmed_text(painter, {x - 5, 20}, axes_.top, theme::text());
  rimmed_text(painter, {x - 5, height() - 8.0}, axes_.bottom, theme::text());
  font.setBold(false);
  font.setPointSizeF(theme::points(10.0));
  painter.setFont(font);
  const int count = shown_->grid.size[axes_.through];
  rimmed_text(painter, {8, 18},
              QString("%1  %2 / %3").arg(in_words(axes_.name)).arg(scene_.slice_index(plane_) + 1).arg(count),
              theme::text());
  // A scale of a round length that takes about a fifth of the picture.
  double mm = 1.0;
  for (const double next : {2.0, 5.0, 10.0, 20.0, 50.0})
    if (next * scale_ < 0.22 * width()) mm = next;
  const QString length = QString("%1 mm").arg(mm);
  const QPointF to(width() - 14.0, height() - 14.0);
  painter.setPen(QPen(theme::text(), 2.0));
  painter.drawLine(to - QPointF(mm * scale_, 0), to);
  rimmed_text(painter, to - QPointF(painter.fontMetrics().horizontalAdvance(length), 5), length, theme::text());
}

bool SliceView::in_slice(const pipeline::Point& at) const {
  return shown_ != nullptr && std::abs(at[axes_.through] - point_at({0, 0})[axes_.through]) <=
                                  std::max(kLandmarkReach, 0.5 * shown_->grid.spacing[axes_.through]);
}

std::string SliceView::landmark_near(const QPointF& pixel) const {
  std::string nearest;
  double reach = 9.0;  // pixels
  for (const auto& [name, mark] : scene_.landmarks()) {
    if (!in_slice(mark.at)) continue;
    const QPointF d = pixel_of(mark.at) - pixel;
    if (std::hypot(d.x(), d.y()) > reach) continue;
    reach = std::hypot(d.x(), d.y());
    nearest = name;
  }
  return nearest;
}

}  // namespace vallecula::gui
