// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fuzz/spoken_reply.h"

#include <QUrl>

#include <algorithm>

namespace boresight::fuzz {
namespace {

constexpr qsizetype kSpaces = qsizetype(1) << 22;

bool leadsElsewhere(int status)
{
    return (status >= 301 && status <= 303) || status == 305 || status == 307 || status == 308;
}

}  // namespace

// As tolerant as possible, so that wrong answers of a server reach Boresight.
SpokenAnswer readAnswer(const QByteArray& bytes)
{
    const qsizetype empty = bytes.indexOf("\r\n\r\n");
    const QByteArray head = bytes.left(empty);
    SpokenAnswer answer;
    answer.content = empty < 0 ? QByteArray() : bytes.mid(empty + 4);
    const qsizetype firstEnd = head.indexOf("\r\n");
    const QByteArray first = head.left(firstEnd);
    answer.status = first.mid(first.indexOf(' ') + 1).left(3).toInt();
    answer.phrase = first.mid(first.indexOf(' ') + 5);
    qsizetype declared = -1;
    for (QByteArray line : firstEnd < 0 ? QList<QByteArray>() : head.mid(firstEnd + 2).split('\n')) {
        line = line.trimmed();
        const qsizetype colon = line.indexOf(':');
        if (colon > 0) {
            answer.headers.append({line.left(colon), line.mid(colon + 1).trimmed()});
            declared =
                line.toLower().startsWith("content-length:") ? answer.headers.back().second.toLongLong() : declared;
        }
    }
    answer.piece = 1 + (bytes.size() * 37) % 700;
    if (!first.startsWith("HTTP/")) {
        answer.end = SpokenAnswer::End::NoServer;
    } else if (empty < 0) {
        answer.end = SpokenAnswer::End::Never;
    } else if (declared > answer.content.size()) {
        answer.end = SpokenAnswer::End::IsCut;
    }
    return answer;
}

SpokenReply::SpokenReply(const QNetworkRequest& request, const SpokenAnswer& answer, bool& isSilent, QObject* parent)
    : QNetworkReply(parent), m_answer(answer), m_isSilent(isSilent)
{
    setRequest(request);
    setUrl(request.url());
    setOperation(QNetworkAccessManager::GetOperation);
    open(QIODevice::ReadOnly | QIODevice::Unbuffered);
    m_isSilent = false;
    QMetaObject::invokeMethod(
        this, [this] { speak(); }, Qt::QueuedConnection);
}

void SpokenReply::speak()
{
    if (m_answer.end == SpokenAnswer::End::NoServer) {
        end(HostNotFoundError);
        return;
    }
    setAttribute(QNetworkRequest::HttpStatusCodeAttribute, m_answer.status);
    setAttribute(QNetworkRequest::HttpReasonPhraseAttribute, QString::fromLatin1(m_answer.phrase));
    for (const auto& [name, value] : m_answer.headers) {
        setRawHeader(name, value);
        if (leadsElsewhere(m_answer.status) && name.toLower() == "location") {
            setAttribute(QNetworkRequest::RedirectionTargetAttribute, QUrl::fromEncoded(value));
        }
    }
    Q_EMIT metaDataChanged();
    later();
}

void SpokenReply::later()
{
    if (!isFinished()) {
        QMetaObject::invokeMethod(
            this, [this] { next(); }, Qt::QueuedConnection);
    }
}

void SpokenReply::next()
{
    if (isFinished()) {
        return;
    }
    const bool goesOn = m_answer.end == SpokenAnswer::End::GoesOn;
    const QByteArray piece =
        goesOn ? QByteArray(kSpaces, ' ') : m_answer.content.mid(m_said, std::max<qsizetype>(m_answer.piece, 1));
    if (!piece.isEmpty()) {
        m_said += piece.size();
        m_ready = m_ready.mid(m_read) + piece;
        m_read = 0;
        Q_EMIT readyRead();
        later();
    } else if (m_answer.end == SpokenAnswer::End::IsCut) {
        end(RemoteHostClosedError);
    } else if (m_answer.end == SpokenAnswer::End::Never) {
        m_isSilent = true;
    } else {
        end(m_answer.status >= 400 ? UnknownContentError : NoError);
    }
}

void SpokenReply::end(NetworkError error)
{
    if (error != NoError) {
        setError(error, QStringLiteral("error %1").arg(int(error)));
        Q_EMIT errorOccurred(error);
    }
    setFinished(true);
    Q_EMIT finished();
}

void SpokenReply::abort()
{
    if (!isFinished()) {
        end(OperationCanceledError);
    }
}

qint64 SpokenReply::readData(char* data, qint64 most)
{
    const auto count = std::min<qint64>(most, m_ready.size() - m_read);
    std::copy_n(m_ready.constData() + m_read, count, data);
    m_read += count;
    return count;
}

QNetworkReply* SpokenNetwork::createRequest(Operation, const QNetworkRequest& request, QIODevice*)
{
    return new SpokenReply(request, m_answer, m_isSilent, this);  // as in Qt, the caller deletes it
}

}  // namespace boresight::fuzz
