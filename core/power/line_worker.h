// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/paced_outlet.h"
#include "core/power/threaded_line.h"

#include <QObject>

#include <deque>

// The part of ThreadedLine that lives on the thread "power": it owns the PowerLine and reports about it.
namespace boresight::power {

class LineWorker final : public QObject
{
    Q_OBJECT

public:
    LineWorker(const LineSettings& settings, const Clock& clock);

    void open() { m_line.open(); }
    // The last report has been taken.
    void taken() { m_outlet.taken(); }

Q_SIGNALS:
    void reported(const boresight::power::LineReport& report);

private:
    void keep(const Value& value);
    void report();

    PowerLine m_line;
    std::deque<Value> m_values;  // the newest, at most ThreadedLine::kMost
    PacedOutlet m_outlet;
};

}  // namespace boresight::power
