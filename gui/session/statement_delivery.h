// Sends statements to the learning record store of the settings while the window is used.
#pragma once

#include <QObject>
#include <atomic>
#include <condition_variable>
#include <mutex>
#include <thread>

namespace vallecula::gui {

/// On a thread of its own: sends what waits when it is made and when it is woken; what could not be sent then is tried
/// again, after longer and longer pauses. Without an address in the settings it does nothing. Its end
/// waits for a question to the records, a second or two where they do not answer, and breaks off what is being sent: what
/// has not been acknowledged is sent the next time.
class StatementDelivery : public QObject {
  Q_OBJECT

 public:
  explicit StatementDelivery(QObject* parent = nullptr);
  ~StatementDelivery() override;

  void wake();  ///< a trial has its row, or the settings are others

 signals:
  /// What became of it, one line for a person; never of a store that is not set.
  void told(const QString& line);

 private:
  void run();
  /// Seconds until it is tried again; 0: not before it is woken.
  double send_once(int failures);

  std::mutex mutex_;
  std::condition_variable woken_;
  bool wanted_ = true;
  std::atomic<bool> stop_{false};
  std::thread thread_;
};

}  // namespace vallecula::gui
