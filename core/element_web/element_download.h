// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QNetworkReply>
#include <QNetworkRequest>
#include <QObject>
#include <QString>
#include <QTimer>
#include <QUrl>

#include <chrono>
#include <memory>

class QNetworkAccessManager;

// One request to a server for a text. The server is not trusted: size, time and redirects are limited. Lives on the
// thread of its network manager.
namespace boresight::orbit {

struct DownloadAnswer
{
    enum class Kind
    {
        Content,
        Unchanged,  // since the answer with the etag and date in the request
        NoNetwork,  // no server was reached, because the name of the server could not be resolved
        Failed
    };

    Kind kind = Kind::Failed;
    QString problem;  // a sentence; only for the last two
    QString saying;   // the first line of a plain text, as a sentence; may be empty
    QByteArray content;
    QByteArray etag;
    QByteArray lastModified;
};

class ElementDownload final : public QObject
{
    Q_OBJECT

public:
    static constexpr std::chrono::seconds kLongestSilence{30};
    static constexpr std::chrono::minutes kLongest{5};
    static constexpr int kMostRedirects = 3;

    // Sends the request at once. `etag` and `lastModified` are from the last known answer, or empty. The manager must
    // outlive this object.
    ElementDownload(QNetworkAccessManager& manager, const QUrl& url, const QByteArray& etag,
                    const QByteArray& lastModified, QObject* parent);
    ~ElementDownload() override;

Q_SIGNALS:
    // Emitted once, from the event loop.
    void finished(const boresight::orbit::DownloadAnswer& answer);

private:
    void ask(const QUrl& url);
    [[nodiscard]] bool follow();
    void look();
    void read();
    void giveUp(const QString& problem);
    void finish();
    [[nodiscard]] DownloadAnswer answer();

    struct Delete
    {
        void operator()(QNetworkReply* reply) const;
    };

    QNetworkAccessManager& m_manager;
    QByteArray m_etag;
    QByteArray m_lastModified;
    std::unique_ptr<QNetworkReply, Delete> m_reply;
    QByteArray m_content;
    QString m_problem;  // why the download was aborted
    int m_redirects = 0;
    QTimer m_silence{this};
    QTimer m_whole{this};
};

}  // namespace boresight::orbit
