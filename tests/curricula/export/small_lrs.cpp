#include "tests/curricula/export/small_lrs.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <algorithm>
#include <stdexcept>

#include "tests/curricula/export/xapi_rules.h"

namespace vallecula::curricula::testing {
namespace {

std::string reply(const std::string& status, const std::string& body, const std::string& more = "") {
  return "HTTP/1.1 " + status + "\r\nX-Experience-API-Version: 1.0.3\r\nConnection: close\r\n" + more +
         "Content-Length: " + std::to_string(body.size()) + "\r\n\r\n" + body;
}

/// Head and body; what there is of them when the sender goes away.
std::pair<std::string, std::string> request_of(int connection) {
  std::string all;
  char bytes[65536];
  for (;;) {
    const std::size_t head = all.find("\r\n\r\n");
    if (head != std::string::npos) {
      std::string lower = all.substr(0, head);
      std::transform(lower.begin(), lower.end(), lower.begin(), ::tolower);
      const std::size_t length = lower.find("content-length: ");
      const std::size_t wanted = length == std::string::npos ? 0 : std::stoul(lower.substr(length + 16));
      if (all.size() >= head + 4 + wanted) return {all.substr(0, head), all.substr(head + 4)};
    }
    const ssize_t got = ::read(connection, bytes, sizeof bytes);
    if (got <= 0) return {all, ""};
    all.append(bytes, static_cast<std::size_t>(got));
  }
}

}  // namespace

SmallLrs::SmallLrs() {
  listener_ = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof address;
  if (::bind(listener_, reinterpret_cast<sockaddr*>(&address), size) != 0 || ::listen(listener_, 16) != 0 ||
      ::getsockname(listener_, reinterpret_cast<sockaddr*>(&address), &size) != 0)
    throw std::runtime_error("no port on this computer can be listened to");
  port_ = ntohs(address.sin_port);
  thread_ = std::thread([this] { serve(); });
}

SmallLrs::~SmallLrs() {
  over_ = true;
  thread_.join();
  ::close(listener_);
  for (const int connection : hanging_) ::close(connection);
}

std::string SmallLrs::address() const { return "http://127.0.0.1:" + std::to_string(port_) + "/xapi/"; }

void SmallLrs::refuse(const std::string& text) {
  const std::lock_guard lock(mutex_);
  refused_text_ = text;
}

std::map<std::string, std::string> SmallLrs::kept() const {
  const std::lock_guard lock(mutex_);
  return kept_;
}

std::vector<std::string> SmallLrs::offences() const {
  const std::lock_guard lock(mutex_);
  return offences_;
}

void SmallLrs::serve() {
  while (!over_) {
    pollfd waiting{listener_, POLLIN, 0};
    if (::poll(&waiting, 1, 20) <= 0) continue;
    const int connection = ::accept4(listener_, nullptr, nullptr, SOCK_CLOEXEC);
    if (connection >= 0) answer(connection);
  }
}

void SmallLrs::answer(int connection) {
  const auto [head, body] = request_of(connection);
  const auto demand = [this, head = head](const std::string& line) {
    if (head.find(line) == std::string::npos) offences_.push_back("no '" + line + "' in the request");
  };
  std::string answer;
  const Does what = does_;
  {
    const std::lock_guard lock(mutex_);
    demand("POST /xapi/statements HTTP/1.1");
    demand("X-Experience-API-Version: 1.0.3");
    demand("Content-Type: application/json");
    demand("Authorization: Basic a2V5OnMzY3JldA==");  // key:s3cret
    switch (what) {
      case Does::answers:
      case Does::keeps_and_hangs:
      case Does::closes_half_way:
        answer = store(body);
        break;
      case Does::server_error:
        answer = reply("503 Service Unavailable", "down for the night");
        break;
      case Does::too_many:
        answer = reply("429 Too Many Requests", "");
        break;
      case Does::not_let_in:
        answer = reply("401 Unauthorized", "s3cret is no secret of ours", "WWW-Authenticate: Basic realm=\"lrs\"\r\n");
        break;
      case Does::elsewhere:
        answer = reply("302 Found", "", "Location: http://127.0.0.1:1/statements\r\n");
        break;
      case Does::garbage:
        answer = reply("200 OK", "<html>Welcome to our network. Please sign in.</html>");
        break;
      case Does::hangs:
        break;
    }
  }
  ++posts_;
  if (what == Does::hangs || what == Does::keeps_and_hangs) {
    hanging_.push_back(connection);
    return;
  }
  if (what == Does::closes_half_way) answer.resize(answer.size() - 10);
  if (::send(connection, answer.data(), answer.size(), MSG_NOSIGNAL) < 0) {
    // The sender is gone: so be it.
  }
  ::close(connection);
}

std::string SmallLrs::store(const std::string& body) {
  const QJsonArray statements = QJsonDocument::fromJson(QByteArray::fromStdString(body)).array();
  if (statements.isEmpty()) {
    offences_.push_back("a body that is no list of statements");
    return reply("400 Bad Request", "no statements");
  }
  QJsonArray ids;
  std::map<std::string, std::string> more;
  for (const QJsonValue& one : statements) {
    const std::string json = QJsonDocument(one.toObject()).toJson(QJsonDocument::Compact).toStdString();
    const std::string id = one.toObject()["id"].toString().toStdString();
    for (const std::string& offence : xapi_offences(one.toObject())) offences_.push_back(offence);
    if (!refused_text_.empty() && json.find(refused_text_) != std::string::npos)
      return reply("400 Bad Request", "we do not like '" + refused_text_ + "' here");
    const auto known = kept_.find(id);
    if (known != kept_.end() && known->second != json) return reply("409 Conflict", "");
    more[id] = json;
    ids.append(one.toObject()["id"]);
  }
  if (more.size() != static_cast<std::size_t>(statements.size())) offences_.push_back("one id twice in a POST");
  kept_.insert(more.begin(), more.end());
  return reply("200 OK", QJsonDocument(ids).toJson(QJsonDocument::Compact).toStdString());
}

}  // namespace vallecula::curricula::testing
