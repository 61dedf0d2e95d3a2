// What differs between the course and the one it is compared with, line by line.
#pragma once

#include <QWidget>
#include <functional>
#include <string>

class QLabel;
class QTextBrowser;

namespace vallecula::gui {

class CompareView : public QWidget {
  Q_OBJECT
 public:
  explicit CompareView(QWidget* parent);
  /// `name` of the other one, as people know it.
  void show_difference(const QString& name, const std::string& other, const std::string& course);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  std::function<void()> anew_;  ///< shows the same once more
  QLabel* title_;
  QTextBrowser* lines_;
};

}  // namespace vallecula::gui
