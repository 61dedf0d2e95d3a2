#include "gui/pages/parts_label.h"

#include <QEvent>
#include <algorithm>

namespace vallecula::gui {
namespace {

constexpr int kShareOfTheWindow = 16;  // of its height: what is looked at meanwhile needs the rest

QString joined(const QStringList& parts) { return parts.join("   |   "); }

}  // namespace

PartsLabel::PartsLabel(QWidget* parent) : QLabel(parent) { setWordWrap(true); }

void PartsLabel::set_parts(const QStringList& parts) {
  parts_ = parts;
  fit();
}

void PartsLabel::fit() {
  if (parts_.isEmpty()) return;
  const int line = fontMetrics().lineSpacing();
  const int most = std::max(2, window()->height() / kShareOfTheWindow / line) * line + line / 2;
  const auto high = [&](const QString& text) {
    return fontMetrics().boundingRect(QRect(0, 0, std::max(1, width()), 10000), Qt::TextWordWrap, text).height();
  };
  QStringList shown = parts_;
  for (int kept = parts_.size() - 2; kept >= 0 && high(joined(shown)) > most; --kept)
    shown = parts_.mid(0, kept) + QStringList{QString(QChar(0x2026)), parts_.back()};
  setText(joined(shown));
  setToolTip(shown == parts_ ? QString() : joined(parts_));
}

void PartsLabel::resizeEvent(QResizeEvent* event) {
  QLabel::resizeEvent(event);
  fit();
}

void PartsLabel::changeEvent(QEvent* event) {
  QLabel::changeEvent(event);
  if (event->type() == QEvent::FontChange) fit();
}

}  // namespace vallecula::gui
