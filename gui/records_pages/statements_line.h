// Below all tabs: which trials wait for the learning record store, and sending them now.
#pragma once

#include <QPointer>
#include <QThread>
#include <QWidget>
#include <atomic>
#include <memory>

class QLabel;
class QPushButton;

namespace vallecula::gui {

class RecordsDesk;

/// Not seen where no store is set and nothing was told.
class StatementsLine : public QWidget {
  Q_OBJECT
 public:
  StatementsLine(RecordsDesk& desk, QWidget* parent);
  ~StatementsLine() override;  ///< breaks off sending: what was not acknowledged is sent the next time
  void refresh();
  void tell(const QString& line);  ///< what became of sending

 private:
  void send();

  RecordsDesk& desk_;
  QLabel *waiting_, *told_;
  QPushButton* send_;
  std::shared_ptr<std::atomic<bool>> stop_ = std::make_shared<std::atomic<bool>>(false);
  QPointer<QThread> sending_;
};

}  // namespace vallecula::gui
