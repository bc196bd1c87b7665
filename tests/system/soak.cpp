// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/system/soak.h"

#include "core/journal/journal_file.h"
#include "core/moteus/codec.h"
#include "core/moteus_mount/moteus_connection.h"
#include "tests/fakes/text_of.h"

#include <QTest>

#include <malloc.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace boresight::system_test {
namespace {

constexpr double kLostReply = 1e-4;
// The drives stop after their watchdog time of 0.1 s, and for the station a silence begins at 0.25 s. Troubles near
// these limits are left out, so that each trouble has one expected result.
constexpr int kShortCut = 3;  // ticks
constexpr int kLongCut = 7;
constexpr int kShortSilence = 8;
constexpr int kLongSilence = 16;
constexpr int kLongest = 150;
constexpr Seconds kBraking{2.0};  // from full speed by the drive's own ramp, until the arm stands still
constexpr Seconds kOperatorPeriod{0.5};
constexpr Seconds kCalm{5.0};  // armed for this time before the next trouble
constexpr Seconds kLeadIn{90.0};
constexpr Seconds kHour{3600.0};

void turnLoop()
{
    QTest::qWait(0);
}

profile::Profile soakProfile()
{
    profile::Profile profile;
    profile.rotctld.listen.port = 0;
    profile.bus = "socketcan:soak";  // any real bus: the position of the built-in simulated mount is not journalled
    return profile;
}

std::size_t bytesInUse()
{
    const struct mallinfo2 info = mallinfo2();
    return info.uordblks + info.hblkhd;
}

}  // namespace

// The bus outlives the program, as a real bus does.
class Soak::LentLink final : public CanLink
{
public:
    explicit LentLink(Soak& soak) : m_soak(soak), m_bus(soak.m_bus)
    {
        connect(&m_bus, &CanLink::statusChanged, this, &CanLink::statusChanged);
        connect(&m_bus, &CanLink::frameReceived, this, [this](const CanFrame& frame) {
            ++m_soak.m_counts.received;
            Q_EMIT frameReceived(frame);
        });
    }
    [[nodiscard]] QString name() const override { return m_bus.name(); }
    [[nodiscard]] LinkStatus status() const override { return m_bus.status(); }
    Result<> open() override { return m_bus.open(); }
    void close() override { m_bus.close(); }
    Result<> send(std::span<const CanFrame> frames) override
    {
        for (const CanFrame& frame : frames) {
            count(moteus::fromCanId(frame.id));
        }
        return m_bus.send(frames);
    }

private:
    void count(const moteus::Arbitration& to)
    {
        ++m_soak.m_counts.frames;
        const auto concerns = [&](int id) { return to.destination == id || to.destination == moteus::kBroadcastId; };
        for (const Axis axis : kAxes) {
            const profile::Profile& profile = m_soak.m_profile;
            if (!to.replyWanted || !concerns(profile.axis(axis).id)) {
                continue;
            }
            ++m_soak.m_counts.questions;
            if (m_soak.m_cut && m_soak.m_cutAxis.value_or(axis) == axis) {
                ++m_soak.m_counts.unheard;
            }
        }
    }

    Soak& m_soak;
    SimulatedLink& m_bus;
};

Soak::Soak(unsigned seed)
    : m_random(seed),
      m_profile(soakProfile()),
      m_bus(m_clock, sim::commissionedPair({.azimuth = 0_deg, .elevation = 10_deg}))
{
    m_bus.inject({.kind = sim::FaultKind::LostReply, .value = kLostReply});
    start(EnteredPlace{.place = truth(), .looked = m_clock.utc()});
    m_troubles = true;
}

Soak::~Soak() = default;

void Soak::start(const std::optional<EnteredPlace>& standingAt)
{
    m_station = std::make_unique<Station>(
        m_profile, moteusRotator(std::make_unique<LentLink>(*this), {m_stateDir.path(), Simulation::Off, standingAt}),
        m_stateDir.path(), m_clock);
    QObject::connect(m_station.get(), &Station::started,
                     [this](const QString& listening) { m_port = listening.section(QLatin1Char(':'), -1).toUShort(); });
    QObject::connect(m_station.get(), &Station::updated, [this](const StationUpdate& update) {
        m_answers = update.answers;
        m_shown = update.status;
    });
    m_station->openAll();
    wait(Seconds(10.0));  // until the drive check is done
}

void Soak::restart()
{
    end();
    start(std::nullopt);
}

void Soak::end()
{
    m_client.reset();
    m_station.reset();
    journal::JournalFile file(m_stateDir.path(), QString::fromStdString(m_profile.mount.name));
    m_journal = file.load();
}

void Soak::powerCycle()
{
    end();
    const auto off = m_bus.inject({.kind = sim::FaultKind::PowerLoss});
    m_clock.advance(Seconds(5.0));
    m_bus.deliver();
    m_bus.pair().faults().remove(off);
    start(std::nullopt);
}

void Soak::tick()
{
    m_clock.advance(kTick);
    m_time += kTick;
    m_bus.deliver();
    m_station->tick();
    m_bus.deliver();
    turnLoop();
    ++m_counts.ticks;
}

void Soak::wait(Seconds time)
{
    for (Seconds passed{0.0}; passed < time; passed += kTick) {
        tick();
        m_station->updateTaken();
        m_station->publish();
    }
}

void Soak::run(Seconds time)
{
    const auto ticks = std::llround(time / kTick);
    for (long long i = 1; i <= ticks; ++i) {
        trouble();
        tick();
        judge();
        stream();
        if (std::fmod(static_cast<double>(i) * kTick.count(), kHour.count()) < kTick.count() / 2.0) {
            m_findings.memory.push_back(bytesInUse());
        }
    }
}

void Soak::comeToRest()
{
    m_troubles = false;
    for (int i = 0; i < 3000 && (m_lost || m_outage); ++i) {
        trouble();
        tick();
        judge();
    }
    static_cast<void>(m_client->ask("S\n"));
    wait(Seconds(10.0));
}

AxisPosition Soak::truth()
{
    return {.azimuth = m_bus.truth(Axis::Azimuth).angle, .elevation = m_bus.truth(Axis::Elevation).angle};
}

void Soak::judge()
{
    for (const Axis axis : kAxes) {
        const sim::AxisTruth now = m_bus.truth(axis);
        const TravelRange& travel = m_profile.axis(axis).geometry.travel;
        m_findings.outside = std::max({m_findings.outside, travel.min - now.angle, now.angle - travel.max});
        const AngularRate limit = m_profile.axis(axis).limits.speed;
        m_findings.fastest = std::max(m_findings.fastest, abs(now.rate) / limit);
    }
    if (m_lost && m_time - m_lostSince > kBraking) {
        const AxisPosition here = truth();
        m_restingAt = m_restingAt.value_or(here);
        m_findings.movedUnarmed = std::max({m_findings.movedUnarmed, abs(here.azimuth - m_restingAt->azimuth),
                                            abs(here.elevation - m_restingAt->elevation)});
    }
    m_station->updateTaken();
    m_station->publish();
    for (const Axis axis : kAxes) {
        const AxisStatus& told = axis == Axis::Azimuth ? m_shown.azimuth : m_shown.elevation;
        if (told.turnKnown && told.age && *told.age <= kTick) {
            m_findings.astray = std::max(m_findings.astray, abs(*told.actual - m_bus.truth(axis).angle));
        }
    }
    operate(m_shown);
}

// Re-arms, and gives control back to the client.
void Soak::operate(const StationStatus& status)
{
    const bool lost = status.state == StationState::Fault || status.state == StationState::Disconnected;
    if (lost != m_lost) {
        m_lost = lost;
        m_lostSince = m_time;
        m_armedSince = m_time;
        m_restingAt.reset();
        (lost ? m_counts.losses : m_counts.recoveries) += 1;
    }
    if (m_time < m_nextOperation) {
        return;
    }
    m_nextOperation = m_time + kOperatorPeriod;
    if (status.state == StationState::Fault && m_time - m_lostSince > kBraking) {
        m_counts.rearms += ask(request::Rearm{}).empty() ? 1 : 0;
    } else if (!lost && (status.drives->azimuth.turnQuestion || status.drives->elevation.turnQuestion)) {
        tellTurns(status);
    } else if (!lost && status.authority == Authority::Operator) {
        static_cast<void>(ask(request::AcknowledgeAlarms{}));
        static_cast<void>(ask(request::GiveAuthority{}));
    }
}

// The operator has looked at the mount and answers. The drive knows the position within its wrap.
void Soak::tellTurns(const StationStatus& status)
{
    const AxisPosition seen = truth();
    if (status.drives->azimuth.turnQuestion) {
        m_counts.turnsTold += ask(request::ChooseTurn{Axis::Azimuth, seen.azimuth}).empty() ? 1 : 0;
    }
    if (status.drives->elevation.turnQuestion) {
        m_counts.turnsTold += ask(request::ChooseTurn{Axis::Elevation, seen.elevation}).empty() ? 1 : 0;
    }
}

std::string Soak::ask(const Request& request)
{
    m_station->request({.id = 1, .request = request});
    m_station->updateTaken();
    m_station->publish();
    if (m_answers.empty()) {
        return "no answer";
    }
    return m_answers.back().error ? textOf(*m_answers.back().error) : std::string();
}

void Soak::trouble()
{
    endOutage();
    if (m_troubles && m_time > m_nextClockStep) {
        m_nextClockStep = m_time + Seconds(random(60.0, 1200.0));
        m_clock.stepUtc(Seconds((chance(0.5) ? 90.0 : 3600.0) * (chance(0.5) ? 1.0 : -1.0)));
        ++m_counts.clockSteps;
    }
    const auto armed = [this] {  // asked last: a status takes longer than a tick
        const StationStatus status = m_station->status();
        return status.azimuth.commanded && status.elevation.commanded && status.drives->armingObstacle.isEmpty();
    };
    if (!m_troubles || m_time < m_nextTrouble || m_lost || m_outage || m_time - m_armedSince < kCalm || !armed()) {
        return;
    }
    m_nextTrouble = m_time + Seconds(random(10.0, 300.0));
    if (chance(0.2)) {
        stall();
    } else {
        beginOutage();
    }
}

void Soak::beginOutage()
{
    m_cut = chance(0.6);  // else the drives receive, but cannot reply
    m_cutAxis = chance(0.5) ? std::nullopt : std::optional(chance(0.5) ? Axis::Azimuth : Axis::Elevation);
    const bool matters = chance(0.6);
    const int shortest = m_cut ? kShortCut : kShortSilence;
    const int longer = m_cut ? kLongCut : kLongSilence;
    const auto ticks = std::floor(matters ? random(longer, kLongest) : random(1, shortest + 1));
    (matters ? m_counts.longTroubles : m_counts.shortTroubles) += 1;
    m_outage = m_bus.inject({.kind = m_cut ? sim::FaultKind::LostCommand : sim::FaultKind::Silence,
                             .axis = m_cutAxis,
                             .value = m_cut ? std::optional(1.0) : std::nullopt});
    m_outageEnd = m_time + kTick * (ticks - 0.5);
}

void Soak::endOutage()
{
    if (m_outage && m_time > m_outageEnd) {
        m_bus.pair().faults().remove(*m_outage);
        m_outage.reset();
        m_cut = false;
        m_armedSince = m_time;
    }
}

// This computer stalls. After a stall of up to 2 s the motion is resumed.
void Soak::stall()
{
    const bool matters = chance(0.5);
    (matters ? m_counts.longTroubles : m_counts.shortTroubles) += 1;
    const Seconds time{matters ? random(2.1, 4.0) : random(0.01, 1.9)};
    m_clock.advance(time);
    m_time += time;
    m_armedSince = m_time;
}

void Soak::planPass()
{
    // One connection for each pass, because the peer keeps a record of its reads, which would count as memory of the
    // station.
    m_client = std::make_unique<fakes::TcpPeer>("127.0.0.1", m_port, &turnLoop);
    m_pass.emplace(SatellitePass::Shape{
        .heightKm = random(400.0, 1200.0),
        .maxElevation = Angle::fromDegrees(random(10.0, 88.0)),
        .culmination = Angle::fromDegrees(random(0.0, 360.0)),
        .sense = chance(0.5) ? SatellitePass::Sense::Clockwise : SatellitePass::Sense::CounterClockwise});
    m_culmination = m_time + kLeadIn + m_pass->halfDuration();
    m_passEnd = m_culmination + m_pass->halfDuration() + Seconds(random(20.0, 300.0));
    m_rests = false;
    ++m_counts.passes;
}

// Sends a target once a second, like any tracking program. Between passes the mount holds or is parked.
void Soak::stream()
{
    if (m_time < m_nextPoint) {
        return;
    }
    m_nextPoint = m_time + Seconds(1.0);
    if (!m_pass || m_time > m_passEnd) {
        planPass();
    }
    const Seconds fromCulmination = m_time - m_culmination;
    if (fromCulmination > m_pass->halfDuration()) {
        if (!std::exchange(m_rests, true) && chance(0.5)) {
            static_cast<void>(m_client->ask("K\n"));
        }
        return;
    }
    const SatellitePass::Look look = m_pass->at(std::max(fromCulmination, -m_pass->halfDuration()));
    char line[64];
    std::snprintf(line, sizeof line, "P %.2f %.2f\n", look.azimuth.wrapped360().degrees(),
                  std::max(look.elevation.degrees(), 0.0));
    const bool accepted = m_client->ask(line) == "RPRT 0\n";
    (accepted ? m_counts.points : m_counts.refusedPoints) += 1;
}

}  // namespace boresight::system_test
