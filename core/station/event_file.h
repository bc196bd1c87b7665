// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/station/station_status.h"

#include <QFile>
#include <QString>

// The event log on disk: one line per entry in STATE_DIR/events.log, UTC first. At kLargest bytes the file becomes
// events.log.1 and a new one begins. Station thread only; a line is handed to the system at once, so that the last
// words of a dying program are kept.
namespace boresight {

class EventFile
{
public:
    static constexpr qint64 kLargest = 5'000'000;

    explicit EventFile(const QString& stateDir);

    // Errors come once: at the first line that cannot be written.
    Result<> add(const LogEntry& entry);

private:
    Result<> open();
    void rotate();

    QFile m_file;
    bool m_failed = false;
};

}  // namespace boresight
