// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/base/edge_thread.h"
#include "core/power/power_line.h"

#include <QObject>

#include <memory>
#include <vector>

// A PowerLine on a thread of its own, for an owner whose thread must not wait for it (station thread). Whatever is sent
// to the line, the owner gets at most kMost values each PacedOutlet::kPeriod, the newest ones.
namespace boresight::power {

class LineWorker;

// What happened since the last report.
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

    // Opens the line. `clock` outlives it and may be read by any thread.
    ThreadedLine(const LineSettings& settings, const Clock& clock, QObject* parent = nullptr);
    ~ThreadedLine() override;

    // By the last report.
    [[nodiscard]] bool isOpen() const { return m_state.open; }
    [[nodiscard]] const LineState& state() const { return m_state; }
    [[nodiscard]] QString name() const { return nameOf(m_settings); }
    // By the last report and the clock.
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
