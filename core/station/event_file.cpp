// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/station/event_file.h"

#include "core/base/text.h"

#include <QDateTime>

namespace boresight {
namespace {

QString line(const LogEntry& entry)
{
    const auto sinceEpoch = std::chrono::duration_cast<std::chrono::milliseconds>(entry.utc.time_since_epoch());
    const QString utc = QDateTime::fromMSecsSinceEpoch(sinceEpoch.count(), Qt::UTC).toString(Qt::ISODateWithMs);
    return utc + QLatin1Char(' ') + entry.source + QStringLiteral(": ") + entry.text + QLatin1Char('\n');
}

}  // namespace

EventFile::EventFile(const QString& stateDir) : m_file(stateDir + QStringLiteral("/events.log")) {}

Result<> EventFile::open()
{
    if (m_file.isOpen() || m_file.open(QIODevice::Append | QIODevice::Unbuffered)) {
        return {};
    }
    return failure(ErrorCode::Io, Text::tr("cannot write %1: %2").arg(m_file.fileName(), m_file.errorString()));
}

void EventFile::rotate()
{
    m_file.close();
    const QString old = m_file.fileName() + QStringLiteral(".1");
    QFile::remove(old);
    QFile::rename(m_file.fileName(), old);
}

Result<> EventFile::add(const LogEntry& entry)
{
    if (m_failed) {
        return {};
    }
    if (m_file.isOpen() && m_file.size() > kLargest) {
        rotate();
    }
    const Result<> opened = open();
    if (!opened) {
        m_failed = true;
        return opened;
    }
    const QByteArray text = line(entry).toUtf8();
    if (m_file.write(text) != text.size()) {
        m_failed = true;
        return failure(ErrorCode::Io, Text::tr("cannot write %1: %2").arg(m_file.fileName(), m_file.errorString()));
    }
    return {};
}

}  // namespace boresight
