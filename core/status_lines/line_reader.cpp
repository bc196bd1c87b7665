// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/status_lines/line_reader.h"

#include "core/base/text.h"

#include <utility>

namespace boresight::status_lines {
namespace {

bool isHigh(const StatusLines& lines, contacts::InputKind line)
{
    switch (line) {
        case contacts::InputKind::Cts:
            return lines.cts;
        case contacts::InputKind::Dsr:
            return lines.dsr;
        case contacts::InputKind::Dcd:
            return lines.dcd;
        default:
            return lines.ri;
    }
}

}  // namespace

LineReader::LineReader(Read read, const Clock& clock, QObject* parent)
    : QObject(parent), m_read(std::move(read)), m_clock(clock)
{
    m_worker.setMaxThreadCount(1);
    m_worker.setExpiryTimeout(-1);
}

LineReader::~LineReader()
{
    m_worker.waitForDone();
}

void LineReader::poll()
{
    if (m_isBusy || (m_retry && m_clock.now() < *m_retry)) {
        return;
    }
    m_isBusy = true;
    m_worker.start([this] {
        QMetaObject::invokeMethod(
            this, [this, read = m_read()] { finish(read); }, Qt::QueuedConnection);
    });
}

void LineReader::finish(const Result<StatusLines>& read)
{
    m_isBusy = false;
    m_received = m_clock.now();
    m_lines = read ? std::optional(*read) : std::nullopt;
    m_problem = read ? QString() : read.error().text;
    m_retry = read ? std::nullopt : std::optional(m_clock.now() + kRetry);
}

contacts::InputReading LineReader::reading(contacts::InputKind line) const
{
    if (!m_lines) {
        return {.problem = m_problem};
    }
    return m_clock.now() - m_received > kLongestAge ? contacts::InputReading{.problem = Text::tr("the port hangs")}
                                                    : contacts::InputReading{.isOn = isHigh(*m_lines, line)};
}

}  // namespace boresight::status_lines

#include "moc_line_reader.cpp"
