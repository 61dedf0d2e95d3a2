// A line of short hints, of which as many are shown as a few lines hold; the last always, and the whole as a tooltip.
#pragma once

#include <QLabel>
#include <QStringList>

namespace vallecula::gui {

class PartsLabel : public QLabel {
  Q_OBJECT
 public:
  explicit PartsLabel(QWidget* parent = nullptr);
  void set_parts(const QStringList& parts);

 protected:
  void resizeEvent(QResizeEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  void fit();
  QStringList parts_;
};

}  // namespace vallecula::gui
