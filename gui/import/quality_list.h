// A quality report as a person reads it: what is to be checked comes first.
#pragma once

#include <QTextBrowser>
#include <vector>

#include "pipeline/package/patient_package.h"

namespace vallecula::gui {

class QualityList : public QTextBrowser {
  Q_OBJECT
 public:
  enum class Remarks { beside, below };  ///< the figures: for a wide list, for a narrow one
  explicit QualityList(Remarks remarks, QWidget* parent = nullptr);
  /// Figures and remarks that are others than in the `before` report say what they were there.
  void show_items(const std::vector<pipeline::QualityItem>& items,
                  const std::vector<pipeline::QualityItem>& before = {});
  int to_check() const { return to_check_; }

 private:
  Remarks remarks_;
  int to_check_ = 0;
};

}  // namespace vallecula::gui
