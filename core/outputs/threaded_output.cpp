// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/outputs/threaded_output.h"

#include <utility>

namespace boresight::outputs {

ThreadedOutput::ThreadedOutput(Write write, QObject* parent) : Output(parent), m_write(std::move(write))
{
    m_worker.setMaxThreadCount(1);
    m_worker.setExpiryTimeout(-1);
}

ThreadedOutput::~ThreadedOutput()
{
    m_worker.waitForDone();
    if (m_asked) {
        (void)m_write(m_wanted);
    }
}

void ThreadedOutput::set(bool on)
{
    m_wanted = on;
    if (m_begun) {
        m_asked = true;
    } else {
        begin();
    }
}

void ThreadedOutput::begin()
{
    m_asked = false;
    m_begun = m_wanted;
    m_worker.start([this, on = m_wanted] {
        QMetaObject::invokeMethod(
            this, [this, on, outcome = m_write(on)] { finish(on, outcome); }, Qt::QueuedConnection);
    });
}

void ThreadedOutput::finish(bool on, const Result<>& outcome)
{
    m_begun.reset();
    if (m_asked) {
        begin();
    }
    if (outcome) {
        Q_EMIT reached(on);
    } else {
        Q_EMIT failed(outcome.error().text);
    }
}

}  // namespace boresight::outputs

#include "moc_threaded_output.cpp"
