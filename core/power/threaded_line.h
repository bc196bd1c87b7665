// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/base/edge_thread.h"
#include "core/power/power_line.h"

#include <QObject>

#include <memory>
#include <vector>

// A PowerLine on a thread of its own. Its owner is the station thread, which must not wait for the line. However much
// is sent to the line, the owner gets only the newest kMost values in each PacedOutlet::kPeriod.
namespace boresight::power {

class LineWorker;

// The events of the line since the last report.
struct LineReport
{
    LineState state;
    std::vector<Value> values;  // oldest first
};

class ThreadedLine final : public QObject
{
    Q_OBJECT

public:
    static constexpr std::size_t kMost = 32;

    // Opens the line. `clock` must outlive the line and be readable from any thread.
    ThreadedLine(const LineSettings& settings, const Clock& clock, QObject* parent = nullptr);
    ~ThreadedLine() override;

    // As of the last report.
    [[nodiscard]] bool isOpen() const { return m_state.open; }
    [[nodiscard]] const LineState& state() const { return m_state; }
    [[nodiscard]] QString name() const { return nameOf(m_settings); }
    // From the last report and the time of the clock.
    [[nodiscard]] QString problem() const { return problemOf(m_settings, m_state, m_clock.now()); }

Q_SIGNALS:
    void received(const boresight::power::Value& value);

private:
    void take(const LineReport& report);

    LineSettings m_settings;
    const Clock& m_clock;
    LineState m_state;
    LineWorker* m_worker;  // lives on m_thread and belongs to it
    EdgeThread m_thread;
};

}  // namespace boresight::power
