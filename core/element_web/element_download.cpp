// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/element_web/element_download.h"

#include "core/base/text.h"
#include "core/base/version.h"
#include "core/elements/element_address.h"
#include "core/elements/element_check.h"
#include "core/elements/element_reader.h"

#include <QNetworkAccessManager>
#include <QNetworkProxyFactory>

#include <utility>

namespace boresight::orbit {

namespace {

constexpr qint64 kMostDownloadBytes = kMostElementMegabytes * (qint64(1) << 20);
constexpr std::size_t kLongestShown = 120;
constexpr qint64 kReadAtOnce = 1 << 20;
constexpr int kUnchanged = 304;
constexpr int kFirstRedirect = 300;

int statusOf(const QNetworkReply& reply)
{
    return reply.attribute(QNetworkRequest::HttpStatusCodeAttribute).toInt();
}

// The first line of a plain text, with which servers explain a refusal. Empty for HTML pages.
QString sayingOf(const QNetworkReply& reply, const QByteArray& content)
{
    const QByteArray line = content.left(content.indexOf('\n')).trimmed();
    const bool isPlain = reply.header(QNetworkRequest::ContentTypeHeader).toString().startsWith(u"text/plain");
    return isPlain && !line.isEmpty()
               ? Text::tr("The server sent: \"%1\".").arg(orbit::quoted(line.toStdString(), kLongestShown))
               : QString();
}

// For example "404 Not Found".
QString answerOf(const QNetworkReply& reply)
{
    const QString phrase = reply.attribute(QNetworkRequest::HttpReasonPhraseAttribute).toString();
    return QStringLiteral("%1 %2").arg(statusOf(reply)).arg(orbit::quoted(phrase.toStdString())).trimmed();
}

}  // namespace

void ElementDownload::Delete::operator()(QNetworkReply* reply) const
{
    reply->disconnect();
    reply->abort();
    reply->deleteLater();
}

ElementDownload::ElementDownload(QNetworkAccessManager& manager, const QUrl& url, const QByteArray& etag,
                                 const QByteArray& lastModified, QObject* parent)
    : QObject(parent), m_manager(manager), m_etag(etag), m_lastModified(lastModified)
{
    m_silence.setSingleShot(true);
    m_silence.setInterval(kLongestSilence);
    m_whole.setSingleShot(true);
    m_whole.setInterval(kLongest);
    connect(&m_silence, &QTimer::timeout, this,
            [this] { giveUp(Text::tr("The server has sent nothing for %1 s.").arg(kLongestSilence.count())); });
    connect(&m_whole, &QTimer::timeout, this,
            [this] { giveUp(Text::tr("The download has taken more than %1 minutes.").arg(kLongest.count())); });
    m_whole.start();
    ask(url);
}

ElementDownload::~ElementDownload() = default;

// Redirects are followed here and not by Qt, because Qt repeats a request several times if the server closes the
// connection.
void ElementDownload::ask(const QUrl& url)
{
    QNetworkRequest request(url);
    request.setHeader(QNetworkRequest::UserAgentHeader, QStringLiteral("Boresight/") + toQString(kVersion));
    request.setAttribute(QNetworkRequest::RedirectPolicyAttribute, QNetworkRequest::ManualRedirectPolicy);
    request.setAttribute(QNetworkRequest::CookieLoadControlAttribute, QNetworkRequest::Manual);
    request.setAttribute(QNetworkRequest::CookieSaveControlAttribute, QNetworkRequest::Manual);
    if (!m_etag.isEmpty()) {
        request.setRawHeader("If-None-Match", m_etag);
    }
    if (!m_lastModified.isEmpty()) {
        request.setRawHeader("If-Modified-Since", m_lastModified);
    }
    if (url.scheme() == QStringLiteral("https")) {
        m_manager.setProxy(QNetworkProxyFactory::systemProxyForQuery(QNetworkProxyQuery(url)).value(0));
    }
    m_content.clear();
    m_reply.reset(m_manager.get(request));
    m_reply->setReadBufferSize(kReadAtOnce);
    connect(m_reply.get(), &QNetworkReply::metaDataChanged, this, &ElementDownload::look);
    connect(m_reply.get(), &QNetworkReply::readyRead, this, &ElementDownload::read);
    connect(m_reply.get(), &QNetworkReply::finished, this, &ElementDownload::finish, Qt::QueuedConnection);
    m_silence.start();
}

// True if the server redirects to another address. The new address is then requested.
bool ElementDownload::follow()
{
    const QUrl target = m_reply->attribute(QNetworkRequest::RedirectionTargetAttribute).toUrl();
    if (target.isEmpty() || !m_problem.isEmpty()) {
        return false;
    }
    const QUrl to = m_reply->url().resolved(target);
    ++m_redirects;
    if (m_redirects > kMostRedirects) {
        m_problem = Text::tr("The server redirects more than %1 times.").arg(kMostRedirects);
    } else if (!isPermittedAddress(to)) {
        m_problem = Text::tr("The server redirects to %1. Only https:// is accepted.")
                        .arg(orbit::quoted(to.toDisplayString(QUrl::RemoveQuery).toStdString(), kLongestShown));
    } else {
        ask(to);
        return true;
    }
    return false;
}

void ElementDownload::look()
{
    if (m_reply->header(QNetworkRequest::ContentLengthHeader).toLongLong() > kMostDownloadBytes) {
        giveUp(Text::tr("The answer is larger than %1 MB.").arg(kMostElementMegabytes));
    }
}

void ElementDownload::read()
{
    if (!m_problem.isEmpty()) {
        return;
    }
    m_silence.start();
    m_content += m_reply->readAll();
    if (m_content.size() > kMostDownloadBytes) {
        giveUp(Text::tr("The answer is larger than %1 MB.").arg(kMostElementMegabytes));
    }
}

void ElementDownload::giveUp(const QString& problem)
{
    if (m_problem.isEmpty()) {
        m_problem = problem;
        m_reply->abort();
    }
}

void ElementDownload::finish()
{
    read();
    if (follow()) {
        return;
    }
    m_silence.stop();
    m_whole.stop();
    const DownloadAnswer known = answer();
    m_reply.reset();  // before the manager ends, because deleteLater() may come after that
    Q_EMIT finished(known);
}

DownloadAnswer ElementDownload::answer()
{
    using Kind = DownloadAnswer::Kind;
    const int status = statusOf(*m_reply);
    if (!m_problem.isEmpty()) {
        return {.problem = m_problem};
    }
    if (m_reply->error() == QNetworkReply::HostNotFoundError) {
        return {.kind = Kind::NoNetwork,
                .problem = Text::tr("No network, or no server %1.").arg(m_reply->url().host())};
    }
    if (status < kFirstRedirect && m_reply->error() != QNetworkReply::NoError) {
        return {.problem = Text::tr("The download has failed: %1.").arg(m_reply->errorString())};
    }
    if (status == kUnchanged && (!m_etag.isEmpty() || !m_lastModified.isEmpty())) {
        return {.kind = Kind::Unchanged};
    }
    if (status >= kFirstRedirect) {
        return {.problem = Text::tr("The server answers %1.").arg(answerOf(*m_reply)),
                .saying = sayingOf(*m_reply, m_content)};
    }
    return {.kind = Kind::Content,
            .saying = sayingOf(*m_reply, m_content),
            .content = std::exchange(m_content, {}),
            .etag = m_reply->rawHeader("ETag"),
            .lastModified = m_reply->rawHeader("Last-Modified")};
}

}  // namespace boresight::orbit

#include "moc_element_download.cpp"
