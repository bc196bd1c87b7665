// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/gs232_mount/gs232_connection.h"

#include "core/alarms/catalogue.h"
#include "core/base/bus_name.h"
#include "core/base/text.h"
#include "core/gs232_mount/serial_box_line.h"
#include "core/gs232_mount/simulated_box_line.h"
#include "core/gs232_mount/tcp_box_line.h"

#include <utility>

namespace boresight::gs232 {
namespace {

const QString kSource = QStringLiteral("rotator");

QString nameOf(Dialect dialect)
{
    return dialect == Dialect::A ? QStringLiteral("GS-232A") : QStringLiteral("GS-232B");
}

// What the checks of the profile have let through.
std::unique_ptr<BoxLine> lineOf(const profile::Profile& profile)
{
    const auto bus = parseBusName(profile.bus);
    if (bus && bus->kind == BusKind::Tcp) {
        return std::make_unique<TcpBoxLine>(QString::fromStdString(bus->target), bus->port);
    }
    return std::make_unique<SerialBoxLine>(bus ? QString::fromStdString(bus->target) : QString(), profile.baud);
}

}  // namespace

Gs232Connection::Gs232Connection(std::unique_ptr<BoxLine> line, const MountStart& start,
                                 const profile::InForce& profile, const Clock& clock, EventLog& log, AlarmBoard& alarms)
    : m_clock(clock),
      m_log(log),
      m_alarms(alarms),
      m_simulated(start.simulation != Simulation::Off),
      m_mount(profile, alarms, start.axes),
      m_line(std::move(line))
{
    m_line->setParent(this);  // so that it moves to the station thread with us
    connect(m_line.get(), &BoxLine::received, this, [this](const QByteArray& bytes) {
        m_mount.take({bytes.constData(), static_cast<std::size_t>(bytes.size())}, m_clock.now());
    });
    connect(m_line.get(), &BoxLine::stateChanged, this, &Gs232Connection::showLine);
}

Gs232Connection::~Gs232Connection()
{
    m_line->setParent(nullptr);
    m_line->disconnect(this);
}

void Gs232Connection::open()
{
    if (!m_closed) {
        m_line->open();
    }
}

// The last order goes out first: there is no watchdog that would stop the rotator.
void Gs232Connection::close()
{
    send();
    m_closed = true;
    m_line->close();
}

void Gs232Connection::showLine()
{
    if (m_line->state() == BoxLine::State::Up) {
        m_mount.lineOpened();
        m_alarms.clear(alarmEntry("rotator.line-down"));
        return;
    }
    m_mount.lineClosed();
    m_proof = Proof::Unknown;
    if (!m_closed) {
        m_alarms.raise(alarmEntry("rotator.line-down"), {m_line->problem()});
    }
}

void Gs232Connection::send()
{
    m_line->tick(m_clock.now());
    if (const std::string bytes = m_mount.send(); !bytes.empty()) {
        m_line->write(QByteArray::fromStdString(bytes));
    }
    watchProof();
}

void Gs232Connection::watchProof()
{
    const Proof proof = m_mount.talk().proof();
    if (m_line->state() != BoxLine::State::Up || std::exchange(m_proof, proof) == proof) {
        return;
    }
    if (proof == Proof::Box) {
        m_log.add(Severity::Advisory, kSource,
                  Text::tr("%1 answers as a %2").arg(m_line->name(), nameOf(m_mount.talk().dialect())));
    } else if (proof == Proof::Foreign) {
        m_closed = true;
        const QString strange = toQString(m_mount.talk().strange());
        m_line->close();
        m_alarms.clear(alarmEntry("rotator.no-answer"));
        m_alarms.raise(alarmEntry("rotator.foreign"), {m_line->name(), strange});
    }
}

void Gs232Connection::describe(StationStatus& status) const
{
    const BoxTalk& talk = m_mount.talk();
    status.line = {.state = m_line->state(),
                   .kind = talk.proof() == Proof::Box ? nameOf(talk.dialect()) : QStringLiteral("GS-232"),
                   .name = m_line->name(),
                   .problem = m_line->problem(),
                   .sent = talk.counts().sent,
                   .received = talk.counts().received,
                   .dropped = talk.counts().unknown};
}

MountMaker gs232Rotator(std::unique_ptr<BoxLine> line, const MountStart& start)
{
    // A std::function is copied, a line is not.
    return [line = std::make_shared<std::unique_ptr<BoxLine>>(std::move(line)), start](
               const profile::InForce& profile, const Clock& clock, EventLog& log, AlarmBoard& alarms) {
        return std::make_unique<Gs232Connection>(std::move(*line), start, profile, clock, log, alarms);
    };
}

MountKind gs232Rotators()
{
    return [box = std::make_shared<Gs232Box>()](const profile::Profile& profile, const MountStart& start) {
        return gs232Rotator(start.simulation.on ? std::make_unique<SimulatedBoxLine>(box) : lineOf(profile), start);
    };
}

}  // namespace boresight::gs232

#include "moc_gs232_connection.cpp"
