#include "gui/session/statement_delivery.h"

#include <chrono>
#include <exception>

#include "curricula/export/delivery.h"
#include "gui/session/lrs_settings.h"
#include "gui/session/trial_record.h"

namespace vallecula::gui {
namespace {

constexpr double kPatienceS = 1.0;  ///< the window's end waits for it

}  // namespace

StatementDelivery::StatementDelivery(QObject* parent) : QObject(parent), thread_([this] { run(); }) {}

StatementDelivery::~StatementDelivery() {
  stop_ = true;
  wake();
  thread_.join();
}

void StatementDelivery::wake() {
  const std::lock_guard lock(mutex_);
  wanted_ = true;
  woken_.notify_all();
}

void StatementDelivery::run() {
  int failures = 0;
  double pause_s = 0.0;
  std::unique_lock lock(mutex_);
  while (!stop_) {
    const auto is_wanted = [this] { return wanted_; };
    if (pause_s > 0.0)
      woken_.wait_for(lock, std::chrono::duration<double>(pause_s), is_wanted);
    else
      woken_.wait(lock, is_wanted);
    if (stop_) return;
    wanted_ = false;
    lock.unlock();
    pause_s = send_once(failures + 1);
    failures = pause_s > 0.0 ? failures + 1 : 0;
    lock.lock();
  }
}

double StatementDelivery::send_once(int failures) {
  try {
    const auto chosen = chosen_lrs();
    if (!chosen) return 0.0;
    curricula::RecordsLocation location = records_location();
    location.patience_s = kPatienceS;
    curricula::Records records(location);
    if (stop_) return 0.0;
    const curricula::Delivery delivery =
        curricula::send_waiting(records, chosen->lrs, curricula::xapi_source(records, chosen->home_page), &stop_);
    if (stop_) return 0.0;
    if (delivery.sent > 0) emit told(tr("%n trial(s) sent to the learning record store", "", delivery.sent));
    if (delivery.refused > 0)
      emit told(tr("%n trial(s) refused by the learning record store: %1", "", delivery.refused)
                    .arg(QString::fromStdString(curricula::waiting_statements(records).last_refusal)));
    if (delivery.problem.empty()) return 0.0;
    emit told(tr("%n trial(s) not sent yet: %1", "", delivery.left).arg(QString::fromStdString(delivery.problem)));
  } catch (const std::exception& error) {
    if (stop_) return 0.0;
    emit told(QString::fromStdString(error.what()));
  }
  return curricula::pause_after_s(failures);
}

}  // namespace vallecula::gui
