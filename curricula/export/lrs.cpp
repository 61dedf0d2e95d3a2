#include "curricula/export/lrs.h"

#include <QEventLoop>
#include <QHostAddress>
#include <QJsonArray>
#include <QJsonDocument>
#include <QNetworkAccessManager>
#include <QNetworkReply>
#include <QNetworkRequest>
#include <QTimer>
#include <QUrl>
#include <algorithm>
#include <set>

#include "curricula/qt_text.h"

namespace vallecula::curricula {
namespace {

constexpr qint64 kLargestAnswer = 4 << 20;  // bytes; ours are lists of ids
constexpr int kWatchMs = 50;
constexpr int kReasonLetters = 200;

bool this_computer(const QString& host) {
  return host == "localhost" || QHostAddress(host).isLoopback();
}

/// The ids in an answer; nothing when it is no list of ids.
std::set<std::string> ids_in(const QByteArray& body) {
  std::set<std::string> ids;
  for (const QJsonValue& id : QJsonDocument::fromJson(body).array()) ids.insert(id.toString().toLower().toStdString());
  return ids;
}

}  // namespace

LrsSettings checked(LrsSettings settings) {
  const QUrl url(text(settings.address), QUrl::StrictMode);
  const bool web = url.isValid() && !url.host().isEmpty() && (url.scheme() == "https" || url.scheme() == "http");
  if (!web || !url.userInfo().isEmpty() || url.hasQuery() || url.hasFragment())
    throw RecordsError(
        "[lrs] address is no address of a learning record store; give one as https://lrs.example.org/xapi, with key and "
        "secret as settings of their own");
  if (url.scheme() == "http" && !this_computer(url.host()))
    throw RecordsError(
        "[lrs] address begins with http: on the way to another computer everybody could read the statements and the "
        "secret; use https");
  if (settings.key.empty() || settings.secret.empty())
    throw RecordsError("[lrs] key or secret is not set; the learning record store's administrator hands both out");
  while (!settings.address.empty() && settings.address.back() == '/') settings.address.pop_back();
  return settings;
}

struct LrsClient::Impl {
  LrsSettings settings;
  QNetworkAccessManager network;
};

LrsClient::LrsClient(const LrsSettings& settings) : impl_(std::make_unique<Impl>()) {
  impl_->settings = checked(settings);
}
LrsClient::~LrsClient() = default;

LrsClient::Answer LrsClient::post(const std::vector<XapiStatement>& statements, const std::atomic<bool>* stop) {
  const LrsSettings& lrs = impl_->settings;
  QNetworkRequest request(QUrl(text(lrs.address) + "/statements"));
  request.setHeader(QNetworkRequest::ContentTypeHeader, "application/json");
  request.setRawHeader("X-Experience-API-Version", "1.0.3");
  request.setRawHeader("Authorization", "Basic " + QByteArray::fromStdString(lrs.key + ":" + lrs.secret).toBase64());
  request.setAttribute(QNetworkRequest::RedirectPolicyAttribute, QNetworkRequest::ManualRedirectPolicy);
  const std::unique_ptr<QNetworkReply> reply(
      impl_->network.post(request, QByteArray::fromStdString(json_array(statements))));

  QEventLoop loop;
  QTimer late, watch;
  bool in_time = true;
  late.setSingleShot(true);
  QObject::connect(&late, &QTimer::timeout, [&] {
    in_time = false;
    reply->abort();
  });
  QObject::connect(&watch, &QTimer::timeout, [&] {
    if ((stop != nullptr && *stop) || reply->bytesAvailable() > kLargestAnswer) reply->abort();
  });
  QObject::connect(reply.get(), &QNetworkReply::finished, &loop, &QEventLoop::quit);
  late.start(static_cast<int>(1e3 * lrs.timeout_s));
  watch.start(kWatchMs);
  if (!reply->isFinished()) loop.exec();

  const std::string where = "the learning record store at " + QUrl(text(lrs.address)).host().toStdString();
  const int status = reply->attribute(QNetworkRequest::HttpStatusCodeAttribute).toInt();
  const QByteArray body = reply->isReadable() ? reply->readAll() : QByteArray();
  QString said = QString::fromUtf8(body.left(4 * kReasonLetters)).simplified().left(kReasonLetters);
  said.replace(text(lrs.secret), "***");
  const auto answered = [&](const std::string& mend) {
    return where + " answered " + std::to_string(status) + (said.isEmpty() ? "" : " (" + said.toStdString() + ")") +
           "; " + mend;
  };
  if (!in_time)
    return {LrsAnswer::not_now, where + " did not answer within " + std::to_string(static_cast<int>(lrs.timeout_s)) +
                                    " s; what is left is sent later"};
  const QNetworkReply::NetworkError error = reply->error();
  // Below 200 are the errors of the connection itself; with a status they mean that the answer was cut off.
  if (status == 0 || (error != QNetworkReply::NoError && error < QNetworkReply::ContentAccessDenied))
    return {LrsAnswer::not_now, where + " cannot be reached (" + reply->errorString().toStdString() +
                                    "); what is left is sent later: check the network and [lrs] address"};
  if (status == 409) return {LrsAnswer::conflict, answered("it has one of these statements already, in other words")};
  if (status == 413) return {LrsAnswer::too_large, answered("it takes no statement of this size")};
  if (status == 401 || status == 403) return {LrsAnswer::unusable, answered("check [lrs] key and secret")};
  if (status == 404 || status == 405 || (status >= 300 && status < 400))
    return {LrsAnswer::unusable, answered("check [lrs] address: its xAPI is elsewhere")};
  if (status == 408 || status == 429 || status >= 500)
    return {LrsAnswer::not_now, answered("what is left is sent later")};
  if (status >= 400) return {LrsAnswer::refused, answered("it does not take this statement")};
  const std::set<std::string> ids = ids_in(body);
  const bool named = std::all_of(statements.begin(), statements.end(),
                                 [&ids](const XapiStatement& one) { return ids.count(one.id) != 0; });
  // A page to log in to some network says 200 as well.
  if (status != 204 && !named)
    return {LrsAnswer::unusable, answered("that is no answer of a learning record store: check [lrs] address")};
  return {LrsAnswer::taken, ""};
}

}  // namespace vallecula::curricula
