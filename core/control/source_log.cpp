// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/control/source_log.h"

namespace boresight {
namespace {

constexpr int kClientLinesPerSecond = 4;

}  // namespace

SourceLog::SourceLog(EventLog& log, const Clock& clock) : m_log(log), m_clientLines(log, clock, kClientLinesPerSecond)
{}

void SourceLog::add(Severity severity, const Source& by, const QString& what, LogKind kind)
{
    if (by.kind == SourceKind::Client) {
        m_clientLines.add(severity, by.name, what, kind);
    } else {
        m_log.add(severity, by.name, what, kind);
    }
}

}  // namespace boresight
