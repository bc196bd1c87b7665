// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/page_poll/page_poll.h"

#include <QNetworkAccessManager>
#include <QNetworkReply>
#include <QObject>
#include <QTimer>

#include <memory>

// The part of PagePoll on the other thread: sends the requests, one at a time.
namespace boresight::page {

class PageWorker final : public QObject
{
    Q_OBJECT

public:
    PageWorker(QUrl url, std::chrono::milliseconds period);
    ~PageWorker() override;

    // Sends a request at once, and then one each period.
    void open();

Q_SIGNALS:
    void answered(const boresight::page::Answer& answer);

private:
    void ask();
    void read();
    void finish();

    struct Delete
    {
        void operator()(QNetworkReply* reply) const;
    };

    QUrl m_url;
    std::unique_ptr<QNetworkAccessManager> m_manager;  // made on the thread
    std::unique_ptr<QNetworkReply, Delete> m_reply;
    QByteArray m_page;
    QTimer m_period{this};
};

}  // namespace boresight::page
