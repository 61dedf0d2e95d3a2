#include "gui/records_pages/statements_line.h"

#include <QCoreApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "curricula/export/delivery.h"
#include "gui/pages/background.h"
#include "gui/records_pages/records_desk.h"
#include "gui/session/lrs_settings.h"
#include "gui/session/trial_record.h"

namespace vallecula::gui {
namespace {

QString words_of(const curricula::Waiting& waiting) {
  QString text = waiting.waiting == 0
                     ? QCoreApplication::translate("StatementsLine", "Learning record store: nothing waits to be sent")
                     : QCoreApplication::translate(
                           "StatementsLine", "Learning record store: %n trial(s) wait to be sent", "", waiting.waiting);
  if (waiting.refused > 0)
    text += ", " + QCoreApplication::translate("StatementsLine", "%n trial(s) refused (%1)", "", waiting.refused)
                       .arg(QString::fromStdString(waiting.last_refusal));
  return text + ".";
}

}  // namespace

StatementsLine::StatementsLine(RecordsDesk& desk, QWidget* parent) : QWidget(parent), desk_(desk) {
  const auto line = [this](const char* name) {
    auto* label = new QLabel(this);
    label->setObjectName(name);
    label->setWordWrap(true);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    label->hide();
    return label;
  };
  waiting_ = line("statements_waiting");
  told_ = line("statements");
  send_ = new QPushButton(tr("&Send now"), this);
  send_->hide();
  auto* lines = new QVBoxLayout;
  lines->addWidget(waiting_);
  lines->addWidget(told_);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->addLayout(lines, 1);
  row->addWidget(send_);
  connect(send_, &QPushButton::clicked, this, &StatementsLine::send);
}

StatementsLine::~StatementsLine() {
  *stop_ = true;
  if (sending_) sending_->wait();
}

void StatementsLine::refresh() {
  const bool set = chosen_lrs().has_value();
  send_->setVisible(set);
  waiting_->setVisible(set);
  if (!set) return;
  desk_.ask<curricula::Waiting>(
      this, [](curricula::Records& records) { return curricula::waiting_statements(records); },
      [this](curricula::Waiting waiting) {
        waiting_->setText(words_of(waiting));
        send_->setEnabled(!sending_ && waiting.waiting + waiting.refused > 0);
      },
      [this](const QString& message) { waiting_->setText(message); });
}

void StatementsLine::tell(const QString& line) {
  told_->setText(line);
  told_->show();
  if (isVisible()) refresh();
}

void StatementsLine::send() {
  send_->setEnabled(false);
  tell(tr("Sending ..."));
  sending_ = run_in_background<curricula::Delivery>(
      this,
      [stop = stop_] {
        const auto chosen = chosen_lrs();
        if (!chosen) throw std::runtime_error("No learning record store is set any more.");
        curricula::Records records(records_location());
        curricula::send_refused_again(records);  // who asks for it knows of them
        return curricula::send_waiting(records, chosen->lrs, curricula::xapi_source(records, chosen->home_page),
                                       stop.get());
      },
      [this](curricula::Delivery delivery) {
        sending_.clear();
        QString text = tr("%n trial(s) sent", "", delivery.sent);
        if (delivery.refused > 0) text += ", " + tr("%n trial(s) refused", "", delivery.refused);
        if (!delivery.problem.empty())
          text += ", " +
                  tr("%n trial(s) not sent yet: %1", "", delivery.left).arg(QString::fromStdString(delivery.problem));
        tell(text);
      },
      [this](const QString& message) {
        sending_.clear();
        tell(message);
      });
}

}  // namespace vallecula::gui
