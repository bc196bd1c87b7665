// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/newest_writer.h"

#include <utility>

namespace boresight {

NewestWriter::NewestWriter(QObject* parent) : QObject(parent)
{
    m_worker.setMaxThreadCount(1);
    m_worker.setExpiryTimeout(-1);
    connect(this, &NewestWriter::jobDone, this, &NewestWriter::finish, Qt::QueuedConnection);
}

NewestWriter::~NewestWriter()
{
    (void)flush();
}

void NewestWriter::write(Job job)
{
    if (m_writing) {
        m_next = std::move(job);
    } else {
        start(std::move(job));
    }
}

void NewestWriter::start(Job job)
{
    m_writing = true;
    m_worker.start([this, job = std::move(job), outcome = m_outcome] {
        *outcome = job();
        Q_EMIT jobDone();
    });
}

void NewestWriter::finish()
{
    const Result<> outcome = *m_outcome;
    m_writing = false;
    if (m_next) {
        start(std::exchange(m_next, nullptr));
    }
    if (outcome) {
        Q_EMIT written();
    } else {
        Q_EMIT failed(outcome.error().text);
    }
}

Result<> NewestWriter::flush()
{
    m_worker.waitForDone();
    if (m_next) {
        *m_outcome = std::exchange(m_next, nullptr)();
    }
    return *m_outcome;
}

}  // namespace boresight

#include "moc_newest_writer.cpp"
