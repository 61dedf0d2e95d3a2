#include "curricula/export/delivery.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "curricula/records/connection.h"
#include "curricula/records/trial_rows.h"

namespace vallecula::curricula {
namespace {

constexpr int kTrialsAtOnce = 20;
constexpr double kFirstPauseS = 2.0, kLongestPauseS = 600.0;
constexpr const char* kWaiting =  // "draft": a scenario that its author only tried
    "id NOT IN (SELECT trial_id FROM deliveries) AND curriculum_id <> 'draft'";

using Statements = std::vector<XapiStatement>;

int count(Connection& connection, const QString& sql) {
  int number = 0;
  connection.read([&] {
    QSqlQuery query = connection.run(sql, {}, Connection::kCannotBeRead);
    query.next();
    number = query.value(0).toInt();
  });
  return number;
}

int count_waiting(Connection& connection) {
  return count(connection, QString("SELECT COUNT(*) FROM trials WHERE ") + kWaiting);
}

/// The trial may have been deleted meanwhile; then there is nothing to keep.
void keep(Connection& connection, long long trial_id, const std::string& refused) {
  connection.write([&] {
    connection.run(
        "INSERT INTO deliveries (trial_id, refused, at_utc) SELECT id, ?, ? FROM trials WHERE id = ? "
        "ON CONFLICT (trial_id) DO NOTHING",
        {bound(refused), connection.now_utc(), bound_id(trial_id)});
  });
}

/// A store takes all of a POST or nothing, and does not say of which statement it speaks: halves, until it is one.
/// Returns the first answer that is not about the statements; `refusal` gets the reason of those refused, `any` that one
/// was not.
LrsClient::Answer post_each(LrsClient& client, const Statements& statements, std::string& refusal, bool& any,
                            const std::atomic<bool>* stop) {
  const LrsClient::Answer answer = client.post(statements, stop);
  const bool about_them = answer.answer == LrsAnswer::conflict || answer.answer == LrsAnswer::refused ||
                          answer.answer == LrsAnswer::too_large;
  if (answer.answer == LrsAnswer::taken || answer.answer == LrsAnswer::conflict) any = true;
  if (!about_them) return answer;
  if (statements.size() == 1) {
    // It has this id: it was sent before, by a program that did not live to see the answer, or by another version.
    if (answer.answer != LrsAnswer::conflict) refusal = answer.reason;
    if (answer.answer == LrsAnswer::too_large) any = true;  // of its size it speaks, not of itself
    return {LrsAnswer::taken, ""};
  }
  const auto half = statements.begin() + static_cast<std::ptrdiff_t>(statements.size() / 2);
  const LrsClient::Answer first = post_each(client, Statements(statements.begin(), half), refusal, any, stop);
  if (first.answer != LrsAnswer::taken) return first;
  return post_each(client, Statements(half, statements.end()), refusal, any, stop);
}

}  // namespace

Waiting waiting_statements(Records& records) {
  Connection& connection = records.connection();
  Waiting waiting;
  waiting.waiting = count_waiting(connection);
  waiting.refused = count(connection, "SELECT COUNT(*) FROM deliveries WHERE refused <> ''");
  connection.read([&] {
    QSqlQuery query = connection.run(
        "SELECT refused FROM deliveries WHERE refused <> '' ORDER BY at_utc DESC, trial_id DESC LIMIT 1", {},
        Connection::kCannotBeRead);
    if (query.next()) waiting.last_refusal = query.value(0).toString().toStdString();
  });
  return waiting;
}

Delivery send_waiting(Records& records, const LrsSettings& settings, const XapiSource& source,
                      const std::atomic<bool>* stop) {
  Connection& connection = records.connection();
  LrsClient client(settings);
  Delivery delivery;
  const auto leave = [&](const LrsClient::Answer& answer) {
    delivery.again_later = answer.answer == LrsAnswer::not_now;
    delivery.problem = answer.reason;
    delivery.left = count_waiting(connection);
    return delivery;
  };
  for (;;) {
    if (stop != nullptr && *stop) return leave({LrsAnswer::not_now, "sending was ended; what is left is sent later"});
    const std::vector<RecordRow> rows =
        trial_rows(connection, QString(kWaiting) + " ORDER BY id LIMIT ?", {kTrialsAtOnce}, WithFigures::yes);
    if (rows.empty()) return delivery;
    Statements together;
    for (const RecordRow& row : rows)
      for (XapiStatement& one : statements_of(row, source)) together.push_back(std::move(one));
    LrsClient::Answer answer = client.post(together, stop);
    if (answer.answer == LrsAnswer::taken) {
      for (const RecordRow& row : rows) keep(connection, row.id, "");
      delivery.sent += static_cast<int>(rows.size());
      continue;
    }
    if (answer.answer == LrsAnswer::not_now || answer.answer == LrsAnswer::unusable) return leave(answer);
    std::vector<std::pair<long long, std::string>> answered;
    bool any = false;
    for (const RecordRow& row : rows) {  // one of them is not to its liking: trial by trial
      std::string refusal;
      answer = post_each(client, statements_of(row, source), refusal, any, stop);
      if (answer.answer != LrsAnswer::taken) break;
      answered.emplace_back(row.id, refusal);
    }
    if (any) {
      for (const auto& [id, refusal] : answered) {
        keep(connection, id, refusal);
        ++(refusal.empty() ? delivery.sent : delivery.refused);
      }
    }
    if (answer.answer != LrsAnswer::taken) return leave(answer);
    if (!any)
      return leave({LrsAnswer::unusable, "the store refuses every statement (" + answered.back().second +
                                             "); check its address and version; all of them wait"});
  }
}

void send_refused_again(Records& records) {
  Connection& connection = records.connection();
  connection.write([&] { connection.run("DELETE FROM deliveries WHERE refused <> ''"); });
}

void send_all_again(Records& records) {
  Connection& connection = records.connection();
  connection.write([&] { connection.run("DELETE FROM deliveries"); });
}

double pause_after_s(int failures) {
  return failures <= 0 ? 0.0 : std::min(kLongestPauseS, kFirstPauseS * std::pow(2.0, std::min(failures, 20) - 1));
}

}  // namespace vallecula::curricula
