// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/rotator_box/box_connection.h"

#include "core/alarms/catalogue.h"
#include "core/base/text.h"

#include <utility>

namespace boresight {
namespace {

const QString kSource = QStringLiteral("rotator");

}  // namespace

BoxConnection::BoxConnection(std::unique_ptr<BoxLine> line, std::unique_ptr<BoxMount> mount, bool simulated,
                             const Clock& clock, EventLog& log, AlarmBoard& alarms)
    : m_clock(clock),
      m_log(log),
      m_alarms(alarms),
      m_simulated(simulated),
      m_mount(std::move(mount)),
      m_line(std::move(line))
{
    m_line->setParent(this);  // so that it moves to the station thread together with this object
    connect(m_line.get(), &BoxLine::received, this, [this](const QByteArray& bytes) {
        const std::string_view text(bytes.constData(), static_cast<std::size_t>(bytes.size()));
        m_mount->console().take(text);
        m_mount->take(text, m_clock.now());
    });
    connect(m_line.get(), &BoxLine::stateChanged, this, &BoxConnection::showLine);
}

BoxConnection::~BoxConnection()
{
    m_line->setParent(nullptr);
    m_line->disconnect(this);
}

void BoxConnection::open()
{
    if (!m_closed) {
        m_line->open();
    }
}

// Sends the last command first, because no watchdog would stop the rotator.
void BoxConnection::close()
{
    send();
    m_closed = true;
    m_line->close();
}

void BoxConnection::showLine()
{
    if (m_line->state() == BoxLine::State::Up) {
        m_mount->lineOpened();
        m_alarms.clear(alarmEntry("rotator.line-down"));
        return;
    }
    m_mount->lineClosed();
    m_proof = RotatorTalk::Proof::Unknown;
    if (!m_closed && m_line->state() == BoxLine::State::Lost) {
        m_alarms.raise(alarmEntry("rotator.line-down"), {m_line->problem()});
    }
}

void BoxConnection::send()
{
    m_line->tick(m_clock.now());
    if (const std::string bytes = m_mount->send(); !bytes.empty()) {
        m_line->write(QByteArray::fromStdString(bytes));
    }
    watchProof();
    if (const auto answer = m_mount->console().takeAnswer()) {
        m_log.add(Severity::Advisory, kSource,
                  answer->isEmpty() ? Text::tr("no answer to the typed line")
                                    : Text::tr("answers the typed line: %1").arg(*answer));
    }
    if (m_mount->talk().wantsAnotherLine() && m_line->state() == BoxLine::State::Up) {
        m_line->close();  // open() is called again within a second
    }
}

Result<> BoxConnection::admits(const Request& request) const
{
    if (std::holds_alternative<request::MakeHomeRun>(request)) {
        return m_mount->mayMakeHomeRun();
    }
    const auto* const wanted = std::get_if<request::TypeLine>(&request);
    return wanted != nullptr && m_mount->talk().takesLines() ? m_mount->talk().mayType(wanted->line) : Result<>{};
}

Result<> BoxConnection::carryOut(const Request& request)
{
    if (std::holds_alternative<request::MakeHomeRun>(request)) {
        m_mount->home();
        return {};
    }
    const auto* const wanted = std::get_if<request::TypeLine>(&request);
    if (wanted != nullptr && m_mount->talk().takesLines()) {
        m_mount->leave(profile::OnExit::Hold);
        m_mount->console().type(wanted->line);
    }
    return {};
}

void BoxConnection::watchProof()
{
    const RotatorTalk::Proof proof = m_mount->talk().proof();
    if (m_line->state() != BoxLine::State::Up || std::exchange(m_proof, proof) == proof) {
        return;
    }
    if (proof == RotatorTalk::Proof::Box) {
        m_log.add(Severity::Advisory, kSource, Text::tr("%1 answers as a %2").arg(m_line->name(), m_mount->kind()));
    } else if (proof == RotatorTalk::Proof::Foreign) {
        m_closed = true;
        const QString strange = toQString(m_mount->talk().strange());
        m_line->close();
        m_alarms.clear(alarmEntry("rotator.no-answer"));
        m_alarms.raise(alarmEntry("rotator.foreign"), {m_line->name(), m_mount->kindInWords(), strange});
    }
}

void BoxConnection::describe(StationStatus& status) const
{
    const RotatorTalk& talk = m_mount->talk();
    status.line = {.state = m_line->state(),
                   .kind = m_mount->kind(),
                   .name = m_line->name(),
                   .problem = m_line->problem(),
                   .condition = m_mount->condition(),
                   .sensorOffsets = m_mount->sensorOffsets(),
                   .sent = talk.counts().sent,
                   .received = talk.counts().received,
                   .dropped = talk.counts().unknown};
    if (talk.takesLines()) {
        status.console = m_mount->console().lines();
    }
    for (const Axis axis : kAxes) {
        if (const auto starts = m_mount->starts(axis)) {
            (axis == Axis::Azimuth ? status.azimuth : status.elevation).starts = starts;
        }
    }
}

}  // namespace boresight

#include "moc_box_connection.cpp"
