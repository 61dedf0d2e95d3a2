// A quality report as a person reads it: what is to be looked at first.
#pragma once

#include <QTreeWidget>
#include <vector>

#include "pipeline/package/patient_package.h"

namespace vallecula::gui {

class QualityList : public QTreeWidget {
  Q_OBJECT
 public:
  explicit QualityList(QWidget* parent = nullptr);
  void show_items(const std::vector<pipeline::QualityItem>& items);
  int to_look_at() const { return to_look_at_; }

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void fit_rows();
  int to_look_at_ = 0;
};

}  // namespace vallecula::gui
