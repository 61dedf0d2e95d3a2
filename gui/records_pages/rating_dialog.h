// An instructor rates one trial: the checklist's items that no log can know, and all in all.
#pragma once

#include <QDialog>
#include <map>
#include <string>
#include <vector>

#include "curricula/records/ratings.h"

class QButtonGroup;
class QLabel;
class QPushButton;
class QVBoxLayout;

namespace vallecula::gui {

class RatingDialog : public QDialog {
  Q_OBJECT
 public:
  struct Item {
    std::string id;
    QString text;
  };
  /// `before`: what this instructor gave earlier, by item; `remark`: why there are no items, empty where there are.
  RatingDialog(QWidget* parent, const QString& trial, const std::vector<Item>& items,
               const std::map<std::string, double>& before, const QString& remark);
  std::vector<curricula::Rating> ratings() const;  ///< an instructor's; those that were judged
  void refuse(const QString& message);             ///< could not be kept: may be tried again

 signals:
  void given();  ///< closed by whoever takes it

 private:
  void add_global(QVBoxLayout* column, const std::map<std::string, double>& before);
  void add_items(QVBoxLayout* column, const std::vector<Item>& items, const std::map<std::string, double>& before);

  QButtonGroup* global_;
  std::vector<std::pair<std::string, QButtonGroup*>> items_;
  QLabel* message_;
  QPushButton* take_;
};

}  // namespace vallecula::gui
