#include "gui/pages/chart_view.h"

#include <QEvent>
#include <QFontInfo>
#include <QHelpEvent>
#include <QPainter>
#include <QToolTip>
#include <algorithm>
#include <cmath>

#include "gui/pages/background.h"
#include "gui/views/theme.h"

namespace vallecula::gui {
namespace {

constexpr double kOfThePage = 0.9;  // a chart's letters beside the page's
constexpr int kLeastWide = 300;     // px

}  // namespace

ChartView::ChartView(const QString& name, double least_em, bool titled, QWidget* parent)
    : QWidget(parent), least_em_(least_em), titled_(titled) {
  setAccessibleName(name);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
  soon_.setSingleShot(true);
  soon_.setInterval(150);  // while a window is being drawn larger, once
  connect(&soon_, &QTimer::timeout, this, &ChartView::draw_now);
}

ChartView::~ChartView() {
  if (drawing_) drawing_->wait();
}

void ChartView::show_chart(Draw draw, const QImage& meanwhile) {
  draw_ = std::move(draw);
  meanwhile_ = meanwhile;
  chart_ = {};
  problem_.clear();
  draw_soon();
  update();
}

void ChartView::show_problem(const QString& problem) {
  show_chart({});
  ++asked_;  // nor what is being drawn
  problem_ = problem;
}

ChartForm ChartView::form() const {
  return {std::max(kLeastWide, width()), std::max(minimumSizeHint().height(), height()), em(), titled_};
}

double ChartView::em() const { return std::max(8.0, kOfThePage * QFontInfo(font()).pixelSize()); }

QSize ChartView::minimumSizeHint() const { return {kLeastWide, static_cast<int>(std::ceil(least_em_ * em()))}; }

QSize ChartView::sizeHint() const { return {700, minimumSizeHint().height()}; }

void ChartView::draw_soon() {
  ++asked_;
  if (draw_ && isVisible()) soon_.start();
}

void ChartView::draw_now() {
  if (drawing_) return soon_.start();  // one at a time
  if (!draw_) return;
  drawing_ = run_in_background<Chart>(
      this, [draw = draw_, of = form()] { return draw(of); },
      [this, of = asked_](const Chart& chart) {
        if (of != asked_) return;
        chart_ = chart;
        problem_.clear();
        shown_ = QImage();
        update();
      },
      [this, of = asked_](const QString& message) {
        if (of != asked_) return;
        chart_ = {};
        problem_ = message;
        update();
      });
}

void ChartView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), theme::panel());
  if (drawn()) {
    if (shown_.isNull()) shown_ = theme::of_this_ground(chart_.picture);
    return painter.drawImage(rect(), shown_);
  }
  if (problem_.isEmpty() && !meanwhile_.isNull()) {
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    const QSize fitting = meanwhile_.size().scaled(size(), Qt::KeepAspectRatio);
    return painter.drawImage(QRect(QPoint((width() - fitting.width()) / 2, (height() - fitting.height()) / 2), fitting),
                             theme::of_this_ground(meanwhile_));
  }
  painter.setPen(theme::faint());
  painter.drawText(rect().adjusted(8, 8, -8, -8), Qt::AlignCenter | Qt::TextWordWrap,
                   problem_.isEmpty() ? tr("Drawing ...") : problem_);
}

void ChartView::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  draw_soon();
}

void ChartView::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  draw_soon();
}

void ChartView::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::FontChange) draw_soon();
  if (event->type() != QEvent::PaletteChange && event->type() != QEvent::StyleChange) return;
  shown_ = QImage();
  update();
}

bool ChartView::event(QEvent* event) {
  if (event->type() != QEvent::ToolTip) return QWidget::event(event);
  const auto* help = static_cast<QHelpEvent*>(event);
  // The innermost of those that were cut: a mark may lie in a wider one.
  const ChartLabel* cut = nullptr;
  for (const ChartLabel& label : chart_.labels)
    if (label.cut() && label.box.adjusted(-2, -2, 2, 2).contains(help->pos()) &&
        (cut == nullptr || label.box.width() * label.box.height() < cut->box.width() * cut->box.height()))
      cut = &label;
  const QString words = cut != nullptr ? cut->whole : toolTip();
  if (words.isEmpty())
    QToolTip::hideText();
  else
    QToolTip::showText(help->globalPos(), words, this);
  return true;
}

}  // namespace vallecula::gui
