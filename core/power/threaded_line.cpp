// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/power/threaded_line.h"

#include "core/power/line_worker.h"

#include <utility>

namespace boresight::power {

LineWorker::LineWorker(const LineSettings& settings, const Clock& clock)
    : m_line(settings, clock, this), m_outlet(this, [this] { report(); })
{
    connect(&m_line, &PowerLine::received, this, &LineWorker::keep);
    connect(&m_line, &PowerLine::stateChanged, this, [this] { m_outlet.ask(); });
}

// Asks for no report: PowerLine emits stateChanged() after the values that it read, and that signal asks.
void LineWorker::keep(const Value& value)
{
    m_values.push_back(value);
    if (m_values.size() > ThreadedLine::kMost) {
        m_values.pop_front();
    }
}

void LineWorker::report()
{
    const std::deque<Value> values = std::exchange(m_values, {});
    Q_EMIT reported({.state = m_line.state(), .values = {values.begin(), values.end()}});
}

ThreadedLine::ThreadedLine(const LineSettings& settings, const Clock& clock, QObject* parent)
    : QObject(parent),
      m_settings(settings),
      m_clock(clock),
      m_worker(new LineWorker(settings, clock)),
      m_thread(QStringLiteral("power"), std::unique_ptr<QObject>(m_worker))
{
    connect(m_worker, &LineWorker::reported, this, &ThreadedLine::take);
    m_thread.post([worker = m_worker] { worker->open(); });
}

ThreadedLine::~ThreadedLine() = default;

void ThreadedLine::take(const LineReport& report)
{
    m_thread.post([worker = m_worker] { worker->taken(); });
    m_state = report.state;
    for (const Value& value : report.values) {
        Q_EMIT received(value);
    }
}

}  // namespace boresight::power

#include "moc_threaded_line.cpp"
