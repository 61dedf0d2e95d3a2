#include "gui/authoring/compare_view.h"

#include <QEvent>
#include <QLabel>
#include <QTextBrowser>
#include <QVBoxLayout>
#include <algorithm>

#include "curricula/authoring/line_diff.h"
#include "gui/views/theme.h"

namespace vallecula::gui {

namespace {

constexpr std::size_t kAround = 3;  ///< unchanged lines shown before and after a change

QString row_of(const curricula::DiffLine& line) {
  using Kind = curricula::DiffLine::Kind;
  const QString colour = line.kind == Kind::added     ? theme::new_line().name()
                         : line.kind == Kind::removed ? theme::gone_line().name()
                                                      : QString();
  const char* sign = line.kind == Kind::added ? "+" : line.kind == Kind::removed ? "-" : "&nbsp;";
  const auto number = [](int n) { return n > 0 ? QString::number(n) : QString(); };
  return QString(
             "<tr bgcolor='%1'><td width='44' align='right'>%2</td><td width='44' align='right'>%3</td><td "
             "width='20'>%4</td>"
             "<td><pre style='margin:0'>%5</pre></td></tr>")
      .arg(colour, number(line.old_line), number(line.new_line), sign,
           QString::fromStdString(line.text).toHtmlEscaped());
}

}  // namespace

CompareView::CompareView(QWidget* parent) : QWidget(parent) {
  title_ = new QLabel(this);
  title_->setWordWrap(true);
  lines_ = new QTextBrowser(this);
  lines_->setAccessibleName(tr("Differences"));
  lines_->setOpenLinks(false);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(title_);
  column->addWidget(lines_, 1);
}

void CompareView::show_difference(const QString& name, const std::string& other, const std::string& course) {
  using Kind = curricula::DiffLine::Kind;
  anew_ = [=] { show_difference(name, other, course); };
  const std::vector<curricula::DiffLine> lines = curricula::line_diff(other, course);
  const auto count = [&](Kind kind) {
    return std::count_if(lines.begin(), lines.end(), [kind](const auto& line) { return line.kind == kind; });
  };
  const auto added = count(Kind::added), removed = count(Kind::removed);
  title_->setText(
      added + removed == 0
          ? tr("This course is the same as %1.").arg(name)
          : tr("Against %1: %2 lines are new (green, +), %3 are gone (brown, -).").arg(name).arg(added).arg(removed));
  std::vector<bool> shown(lines.size(), false);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (lines[i].kind == Kind::same) continue;
    for (std::size_t k = i < kAround ? 0 : i - kAround; k <= std::min(lines.size() - 1, i + kAround); ++k)
      shown[k] = true;
  }
  QString html = "<table cellspacing='0' cellpadding='0'>";
  bool gap = false;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (!shown[i]) {
      gap = true;
      continue;
    }
    if (gap) html += "<tr><td colspan='4'>...</td></tr>";
    gap = false;
    html += row_of(lines[i]);
  }
  lines_->setHtml(html + "</table>");
}

void CompareView::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() != QEvent::PaletteChange && event->type() != QEvent::StyleChange) return;
  if (const auto anew = anew_) anew();  // its colours stand in the text; a copy, for it puts another in its place
}

}  // namespace vallecula::gui
