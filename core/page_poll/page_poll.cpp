// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/page_poll/page_poll.h"

#include "core/page_poll/page_worker.h"

namespace boresight::page {

PagePoll::PagePoll(const QString& name, const QUrl& url, std::chrono::milliseconds period, QObject* parent)
    : QObject(parent), m_worker(new PageWorker(url, period)), m_thread(name, std::unique_ptr<QObject>(m_worker))
{
    connect(m_worker, &PageWorker::answered, this, &PagePoll::take);
    m_thread.post([worker = m_worker] { worker->open(); });
}

PagePoll::~PagePoll() = default;

void PagePoll::take(const Answer& answer)
{
    m_trouble = answer.trouble;
    if (answer.page) {
        Q_EMIT received(*answer.page);
    }
}

}  // namespace boresight::page

#include "moc_page_poll.cpp"
