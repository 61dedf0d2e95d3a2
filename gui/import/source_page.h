// Step 1: where the CT is, which series of it, and what the new patient is called.
#pragma once

#include <QWidget>
#include <vector>

#include "gui/import/import_choice.h"
#include "gui/import/series_rows.h"

class QCheckBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QTableWidget;

namespace vallecula::gui {

class ImportWork;
class WorkStrip;

class SourcePage : public QWidget {
  Q_OBJECT
 public:
  explicit SourcePage(ImportWork& work, QWidget* parent = nullptr);
  /// Empties the page and proposes a name.
  void begin();
  /// As if a person had chosen it: lists the series there, once what is still being done has been left.
  void look_at(const QString& source);
  void show_message(const QString& message);
  ImportChoice choice() const;

 signals:
  void chosen(const vallecula::gui::ImportChoice& choice);
  void left();

 private:
  void show_rows(const std::vector<SeriesRow>& rows);
  void forget_rows();
  void look_at_wanted();
  void show_state();
  ImportWork& work_;
  std::vector<SeriesRow> rows_;
  QString wanted_;  ///< to be looked at as soon as nothing else is being done; mostly empty
  QLineEdit *source_, *name_;
  QTableWidget* table_;
  QLabel *name_problem_, *message_;
  QCheckBox* generic_face_;
  QPushButton *folder_, *file_, *go_;
  WorkStrip* strip_;
};

}  // namespace vallecula::gui
