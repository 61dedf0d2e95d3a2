// The first page: go on where one left off, or choose what else there is.
#pragma once

#include <QImage>
#include <QWidget>
#include <vector>

#include "gui/pages/recent_entry.h"

class QLabel;
class QListWidget;
class QPushButton;

namespace vallecula::gui {

class BigChoice;

struct NextTrial;
class HomePage : public QWidget {
  Q_OBJECT
 public:
  explicit HomePage(QWidget* parent = nullptr);
  void set_next(const NextTrial& next);
  /// Of the patient that would be practised on; null: there is none yet.
  void set_picture(const QImage& picture);
  /// Newest first; only what is there.
  void set_recent(const std::vector<RecentEntry>& recent);
  void set_message(const QString& message);  ///< what went wrong
  /// What a person should know and can follow: text with links, told by link_followed(); empty: nothing.
  void set_notice(const QString& html);

 signals:
  void practise_wanted();
  void course_wanted();
  void import_wanted();
  void records_wanted();
  void devices_wanted();
  void writing_wanted();
  void help_wanted();
  void recent_wanted(const QString& path);
  void link_followed(const QString& link);

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  QWidget* make_recent();

  BigChoice *practise_, *course_, *import_, *records_, *devices_;
  QListWidget* recent_;
  QLabel *no_recent_, *notice_, *message_;
};

}  // namespace vallecula::gui
