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

// One question to a server for a text, of which nothing but what comes back is trusted: its size, its time and where it
// leads are bounded. Lives on the thread of its manager.
namespace boresight::orbit {

struct DownloadAnswer
{
    enum class Kind
    {
        Content,
        Unchanged,  // since the answer of which the question tells the headers
        NoNetwork,  // no server was asked: its name is not known here
        Failed
    };

    Kind kind = Kind::Failed;
    QString problem;  // of the last two, a sentence
    QString saying;   // the first line of a plain text, a sentence; may be empty
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

    // Asks at once. `etag` and `lastModified` are those of the answer that is known already, or empty. The manager
    // outlives this.
    ElementDownload(QNetworkAccessManager& manager, const QUrl& url, const QByteArray& etag,
                    const QByteArray& lastModified, QObject* parent);
    ~ElementDownload() override;

Q_SIGNALS:
    // Once, from the event loop.
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
    QString m_problem;  // why we have given up
    int m_redirects = 0;
    QTimer m_silence{this};
    QTimer m_whole{this};
};

}  // namespace boresight::orbit
