// Widgets in a row; in two and more, as many in each, where the width is too little for their words.
#pragma once

#include <QLayout>
#include <memory>
#include <vector>

namespace vallecula::gui {

class WrapRow : public QLayout {
 public:
  explicit WrapRow(QWidget* parent) : QLayout(parent) { setContentsMargins(0, 0, 0, 0); }
  ~WrapRow() override;
  void addItem(QLayoutItem* item) override;
  int count() const override { return static_cast<int>(items_.size()); }
  QLayoutItem* itemAt(int index) const override;
  QLayoutItem* takeAt(int index) override;
  Qt::Orientations expandingDirections() const override { return {}; }
  bool hasHeightForWidth() const override { return true; }
  int heightForWidth(int width) const override;
  QSize sizeHint() const override;
  QSize minimumSize() const override;
  void setGeometry(const QRect& place) override;

 private:
  using Row = std::vector<QLayoutItem*>;
  std::vector<Row> rows_for(int width) const;
  int wide(const Row& row) const;
  static int high(const Row& row);

  std::vector<std::unique_ptr<QLayoutItem>> items_;
};

}  // namespace vallecula::gui
