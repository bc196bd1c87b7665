// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/sim_bus/simulated_link.h"
#include "core/station/station.h"
#include "tests/fakes/manual_clock.h"
#include "tests/fakes/rotctld_case_runner.h"
#include "tests/fakes/tcp_peer.h"

#include <QTemporaryDir>

#include <functional>
#include <memory>

// The complete chain in one process: TCP → rotctld → station → bus → simulated drives with all their physics. Time is
// turned by hand in ticks, so a pass of ten minutes takes seconds and each run is the same. Angles are those of the
// profile's axes. "Truth" is the real position of the antenna.
namespace boresight::system_test {

// The built-in profile on a free port.
[[nodiscard]] profile::Profile anyPort();

class SimulatedStation
{
public:
    static constexpr Seconds kTick{0.02};  // as in the built-in profile

    // The drives are checked and fit, and they stand where they report.
    explicit SimulatedStation(const profile::Profile& profile = anyPort(),
                              const sim::PairSettings& pair = sim::commissionedPair());

    void tick();
    void run(Seconds time);
    // Returns false when the time limit is reached first.
    [[nodiscard]] bool runUntil(const std::function<bool()>& condition, Seconds limit);
    [[nodiscard]] bool ready() const;                           // the mount may be pointed, apart from latches
    [[nodiscard]] bool settle(Seconds limit = Seconds(120.0));  // until the set-points and the antenna stand still

    // A client. Its waiting costs no mount time: the clock stands still meanwhile.
    [[nodiscard]] std::unique_ptr<fakes::TcpPeer> connect() const;
    [[nodiscard]] fakes::CaseTarget caseTarget();
    // Sends a request of the operator. Returns an empty text when accepted, else the reason.
    [[nodiscard]] std::string ask(const Request& request);

    [[nodiscard]] StationStatus status() const { return station->status(); }
    [[nodiscard]] double truth(Axis axis) const { return link->truth(axis).angle.degrees(); }
    [[nodiscard]] AxisPosition truth() const;
    [[nodiscard]] Angle farthestFrom(const AxisPosition& place) const;  // of the axis that is farther away
    // Whether an active or unacknowledged alarm with all three parts contains these words in `what`, ignoring case.
    [[nodiscard]] bool alarmSays(const QString& words) const;
    [[nodiscard]] bool logSays(const QString& words);

    fakes::ManualClock clock;
    SimulatedLink* link = nullptr;
    const Seconds step;  // what the clock advances in one tick, by the profile
    std::unique_ptr<Station> station;
    std::vector<LogEntry> log;
    std::function<void()> onTick;  // is called after each tick

private:
    void collectLog();

    QTemporaryDir m_stateDir;
    std::vector<Answer> m_answers;
    std::uint16_t m_port = 0;
    std::uint64_t m_lastRequest = 0;
};

}  // namespace boresight::system_test
