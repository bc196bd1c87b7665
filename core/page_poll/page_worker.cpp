// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/page_poll/page_worker.h"

#include "core/base/text.h"
#include "core/base/version.h"

#include <QNetworkProxy>
#include <QNetworkRequest>

#include <utility>

namespace boresight::page {

void PageWorker::Delete::operator()(QNetworkReply* reply) const
{
    reply->disconnect();
    reply->abort();
    reply->deleteLater();
}

PageWorker::PageWorker(QUrl url, std::chrono::milliseconds period) : m_url(std::move(url))
{
    m_period.setInterval(period);
    connect(&m_period, &QTimer::timeout, this, &PageWorker::ask);
}

PageWorker::~PageWorker() = default;

// The server is in the local network, so no proxy is used. A query of the desktop for its proxy would block.
void PageWorker::open()
{
    m_manager = std::make_unique<QNetworkAccessManager>();
    m_manager->setProxy(QNetworkProxy::NoProxy);
    m_period.start();
    ask();
}

void PageWorker::ask()
{
    if (m_reply) {
        return;
    }
    QNetworkRequest request(m_url);
    request.setHeader(QNetworkRequest::UserAgentHeader, QStringLiteral("Boresight/") + toQString(kVersion));
    request.setAttribute(QNetworkRequest::RedirectPolicyAttribute, QNetworkRequest::ManualRedirectPolicy);
    request.setAttribute(QNetworkRequest::CacheLoadControlAttribute, QNetworkRequest::AlwaysNetwork);
    request.setAttribute(QNetworkRequest::CookieLoadControlAttribute, QNetworkRequest::Manual);
    request.setAttribute(QNetworkRequest::CookieSaveControlAttribute, QNetworkRequest::Manual);
    request.setTransferTimeout(static_cast<int>(PagePoll::kLongestWait.count()));
    m_page.clear();
    m_reply.reset(m_manager->get(request));
    m_reply->setReadBufferSize(PagePoll::kLongest + 1);
    connect(m_reply.get(), &QNetworkReply::readyRead, this, &PageWorker::read);
    connect(m_reply.get(), &QNetworkReply::finished, this, &PageWorker::finish, Qt::QueuedConnection);
}

void PageWorker::read()
{
    m_page += m_reply->read(PagePoll::kLongest + 1 - m_page.size());
    if (m_page.size() > PagePoll::kLongest) {
        m_reply->abort();
    }
}

void PageWorker::finish()
{
    if (m_page.size() <= PagePoll::kLongest && m_reply->isOpen()) {
        read();
    }
    constexpr int kWell = 200;
    const int status = m_reply->attribute(QNetworkRequest::HttpStatusCodeAttribute).toInt();
    const bool isLong = m_page.size() > PagePoll::kLongest;
    Answer answer;
    if (!isLong && m_reply->error() != QNetworkReply::NoError) {
        answer.trouble = Text::tr("%1: %2").arg(m_url.toDisplayString(QUrl::RemoveQuery), m_reply->errorString());
    } else if (!isLong && status != kWell) {
        answer.trouble =
            Text::tr("%1: The server answers %2.").arg(m_url.toDisplayString(QUrl::RemoveQuery)).arg(status);
    } else {
        answer.page = std::exchange(m_page, {});
    }
    m_reply.reset();
    Q_EMIT answered(answer);
}

}  // namespace boresight::page

#include "moc_page_worker.cpp"
