// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/edge_thread.h"

#include <QByteArray>
#include <QObject>
#include <QString>
#include <QUrl>

#include <chrono>
#include <optional>

// Reads a short page of a web server again and again, on a thread of its own, so that a slow server delays nobody.
// Sends one request at a time, and reads at most kLongest + 1 bytes of the answer. Station thread.
namespace boresight::page {

class PageWorker;

struct Answer
{
    QString trouble = {};  // why there is no page
    std::optional<QByteArray> page = {};
};

class PagePoll final : public QObject
{
    Q_OBJECT

public:
    // In bytes. Of a longer page, one byte more than this arrives, so that the reader can refuse it.
    static constexpr qint64 kLongest = 4096;
    static constexpr std::chrono::milliseconds kLongestWait{5000};  // for a server that sends nothing

    // `name`: the name of the thread.
    PagePoll(const QString& name, const QUrl& url, std::chrono::milliseconds period, QObject* parent = nullptr);
    ~PagePoll() override;

    // The problem of the last request. Empty if there was none, or no answer came yet.
    [[nodiscard]] const QString& trouble() const { return m_trouble; }

Q_SIGNALS:
    void received(const QByteArray& page);

private:
    void take(const Answer& answer);

    QString m_trouble;
    PageWorker* m_worker;  // lives on m_thread and belongs to it
    EdgeThread m_thread;
};

}  // namespace boresight::page
