// Ctrl+Z within a field goes to the course's own undo, not to the field's.
#pragma once

#include <QObject>

namespace vallecula::gui {

class UndoKeys : public QObject {
  Q_OBJECT
 public:
  using QObject::QObject;
  /// From now on for every event of `application` whose receiver lies in `page`.
  void watch(QWidget* page);

 protected:
  bool eventFilter(QObject* receiver, QEvent* event) override;

 private:
  QWidget* page_ = nullptr;
};

}  // namespace vallecula::gui
