// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/moteus_mount/moteus_connection.h"

#include "core/alarms/catalogue.h"
#include "core/base/bus_name.h"
#include "core/base/text.h"
#include "core/can/bus_advice.h"

#include <algorithm>
#include <iterator>
#include <vector>

namespace boresight {
namespace {

const QString kJournalSource = QStringLiteral("position journal");

MountLine::State stateOf(LinkState state)
{
    switch (state) {
        case LinkState::Up:
            return MountLine::State::Up;
        case LinkState::Down:
            return MountLine::State::Down;
        case LinkState::Lost:
            return MountLine::State::Lost;
        case LinkState::Closed:
            break;
    }
    return MountLine::State::Closed;
}

MountLine lineOf(const CanLink& link)
{
    const LinkStatus status = link.status();
    return {.state = stateOf(status.state),
            .kind = QStringLiteral("CAN"),
            .name = link.name(),
            .problem = status.text,
            .sent = status.sent,
            .received = status.received,
            .dropped = status.dropped,
            .errors = status.busErrors};
}

}  // namespace

MoteusConnection::MoteusConnection(std::unique_ptr<CanLink> link, const MountStart& start,
                                   const profile::InForce& profile, const Clock& clock, EventLog& log,
                                   AlarmBoard& alarms)
    : m_clock(clock),
      m_log(log),
      m_alarms(alarms),
      m_simulated(start.simulation != Simulation::Off),
      m_journalFile(start.stateDir, QString::fromStdString(profile->mount.name), this),
      m_mount(profile, clock, log, alarms, remembered(start), start.axes),
      m_care(profile, m_mount, alarms, log),
      m_pins(profile),
      m_link(std::move(link))
{
    m_link->setParent(this);  // so that it moves to the station thread together with this object
    connect(m_link.get(), &CanLink::frameReceived, this, [this](const CanFrame& frame) {
        m_mount.take(frame);
        m_care.take(frame);
        m_pins.take(frame);
        for (const QPointer<BoardOutput>& output : m_outputs) {
            if (output) {
                output->take(frame);
            }
        }
    });
    connect(m_link.get(), &CanLink::statusChanged, this, &MoteusConnection::showBus);
    watchJournal();
    if (const auto bus = m_simulated ? Result<BusName>(BusName{}) : parseBusName(profile->bus)) {
        m_mount.setSilenceAdvice(silenceAdvice(*bus));
    }
}

MoteusConnection::~MoteusConnection()
{
    m_link->setParent(nullptr);
}

TurnKeeper::Start MoteusConnection::remembered(const MountStart& start)
{
    if (m_simulated) {
        return {.trustFirstContact = true};
    }
    m_claim = m_journalFile.claim();
    if (!m_claim) {
        return {};
    }
    journal::LoadedJournal loaded = m_journalFile.load();
    if (!loaded.problem.isEmpty()) {
        m_log.add(Severity::Warning, kJournalSource, loaded.problem);
    }
    TurnKeeper::Start known{.journal = std::move(loaded.journal), .problem = std::move(loaded.problem)};
    if (start.standingAt) {
        known.standingAt = {start.standingAt->place.azimuth, start.standingAt->place.elevation};
        known.looked = start.standingAt->looked;
    }
    return known;
}

void MoteusConnection::watchJournal()
{
    connect(&m_journalFile, &journal::JournalFile::saveFailed, this,
            [this](const QString& reason) { m_alarms.raise(alarmEntry("journal.not-stored"), {reason}); });
    connect(&m_journalFile, &journal::JournalFile::saved, this,
            [this] { m_alarms.clear(alarmEntry("journal.not-stored")); });
}

void MoteusConnection::open()
{
    const LinkState state = m_link->status().state;
    if (!m_claim || state == LinkState::Up || state == LinkState::Down || m_closed || m_mount.busLeft()) {
        return;
    }
    LinkStatus status;
    if (const Result<> opened = m_link->open(); !opened) {
        status = m_link->status();
        status.text = opened.error().text;
    } else {
        status = m_link->status();
        m_mount.lineOpened();
    }
    showBus(status);
}

// An output that is still on would stay on.
void MoteusConnection::close()
{
    m_closed = true;
    std::vector<CanFrame> last;
    for (const QPointer<BoardOutput>& output : m_outputs) {
        if (const auto frame = output ? output->lastFrame() : std::nullopt) {
            last.push_back(*frame);
        }
    }
    if (!last.empty() && isLineOpen()) {
        [[maybe_unused]] const Result<> sent = m_link->send(last);
    }
    m_link->close();
}

void MoteusConnection::showBus(const LinkStatus& status)
{
    if (status.state == LinkState::Up && status.text.isEmpty()) {
        m_alarms.clear(alarmEntry("bus.down"));
        return;
    }
    if (m_closed || (status.state == LinkState::Closed && status.text.isEmpty())) {
        return;  // closed in order to be opened again: the alarm stays, because its cause lasts
    }
    const auto trouble = [&status]() -> const AlarmEntry& {
        if (status.state == LinkState::Up) {
            return alarmEntry("bus.trouble");
        }
        return status.leftAlone ? alarmEntry("bus.left-alone") : alarmEntry("bus.down");
    };
    m_alarms.raise(trouble(), {status.text});
}

bool MoteusConnection::isLineOpen() const
{
    const LinkState state = m_link->status().state;
    return state == LinkState::Up || state == LinkState::Down;
}

std::unique_ptr<outputs::Output> MoteusConnection::pinOutput(const contacts::BoardPin& pin)
{
    std::erase_if(m_outputs, [](const QPointer<BoardOutput>& output) { return output.isNull(); });
    auto output = std::make_unique<BoardOutput>(pin, [this](const CanFrame& frame) {
        if (isLineOpen() && !m_mount.busLeft()) {
            [[maybe_unused]] const Result<> sent = m_link->send(std::vector{frame});
        }
    });
    m_outputs.emplace_back(output.get());
    return output;
}

void MoteusConnection::addOutputs(std::vector<CanFrame>& frames)
{
    for (const QPointer<BoardOutput>& output : m_outputs) {
        if (output && !isLineOpen()) {
            output->restWithoutLine();
        } else if (const auto frame = output ? output->frame(m_clock.now()) : std::nullopt) {
            frames.push_back(*frame);
        }
    }
}

void MoteusConnection::send()
{
    std::vector<CanFrame> frames = m_mount.frames();
    std::ranges::copy(m_care.tick(m_clock.now()), std::back_inserter(frames));
    std::ranges::copy(m_pins.frames(m_clock.now(), m_care.areConsolesFree()), std::back_inserter(frames));
    addOutputs(frames);
    if (isLineOpen()) {
        // Also while the bus is down, because an adapter needs a new frame to detect that it works again. A frame that
        // could not be sent shows as a missing reply and in the status of the link.
        [[maybe_unused]] const Result<> sent = m_link->send(frames);
        m_mount.framesTaken();
    }
    m_mount.framesSent();
    if (m_mount.takeJournalChange() && !m_simulated && m_claim) {
        m_journalFile.save(m_mount.journal());
    }
}

Result<> MoteusConnection::carryOut(const Request& request)
{
    if (std::holds_alternative<request::ReleaseBus>(request)) {
        m_link->close();
        m_alarms.clear(alarmEntry("bus.down"));
        return {};
    }
    if (std::holds_alternative<request::TakeBus>(request)) {
        open();
        return {};
    }
    return m_care.carryOut(request, m_clock.now());
}

void MoteusConnection::describe(StationStatus& status) const
{
    status.line = lineOf(*m_link);
    if (status.drives) {
        m_care.fill(*status.drives);
    }
    m_care.judge(status.permissions);
}

MountMaker moteusRotator(std::unique_ptr<CanLink> link, const MountStart& start)
{
    // A std::function must be copyable, and a unique_ptr is not.
    return [link = std::make_shared<std::unique_ptr<CanLink>>(std::move(link)), start](
               const profile::InForce& profile, const Clock& clock, EventLog& log, AlarmBoard& alarms) {
        return std::make_unique<MoteusConnection>(std::move(*link), start, profile, clock, log, alarms);
    };
}

}  // namespace boresight

#include "moc_moteus_connection.cpp"
