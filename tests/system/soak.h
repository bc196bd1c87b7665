// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/journal/journal_file.h"
#include "core/mount/entered_place.h"
#include "core/sim_bus/simulated_link.h"
#include "core/station/station.h"
#include "tests/fakes/manual_clock.h"
#include "tests/fakes/tcp_peer.h"
#include "tests/system/satellite_pass.h"

#include <QTemporaryDir>

#include <cstdint>
#include <memory>
#include <optional>
#include <random>
#include <string>
#include <vector>

// Days of work in minutes. A station with its journal on disk, a client that streams satellite passes, a bus that loses
// replies and fails from time to time, a computer that stalls and whose UTC is set, and an operator who re-arms. The
// mount is simulated with all its physics. Only the clock is turned by hand, in ticks of 20 ms. The seed alone
// determines the events. Every tick is judged by the true position of the antenna.
namespace boresight::system_test {

struct SoakCounts
{
    std::uint64_t ticks = 0;
    std::uint64_t frames = 0;     // sent by the station
    std::uint64_t questions = 0;  // of these, queries to a drive that want a reply
    std::uint64_t unheard = 0;    // of these queries, the ones sent while the cable was cut
    std::uint64_t received = 0;   // replies that reached the station
    std::uint64_t passes = 0;
    std::uint64_t points = 0;         // `P` answered with RPRT 0
    std::uint64_t refusedPoints = 0;  // while the mount was not armed
    std::uint64_t shortTroubles = 0;  // outages and stalls that must have no effect
    std::uint64_t longTroubles = 0;   // outages and stalls that must each stop the mount once
    std::uint64_t clockSteps = 0;
    std::uint64_t losses = 0;      // reported by the station
    std::uint64_t recoveries = 0;  // back to an armed mount
    std::uint64_t rearms = 0;      // requested and accepted
    std::uint64_t turnsTold = 0;   // wraps entered by the operator where the clocks left no proof
};

// The worst values seen, and what must never happen.
struct SoakFindings
{
    Angle outside;                    // outside the travel, of the worse axis
    double fastest = 0.0;             // of the worse axis, as a part of its speed limit
    Angle astray;                     // difference between a position reported as known and the truth
    Angle movedUnarmed;               // between standing still after a loss and the re-arm
    std::vector<std::size_t> memory;  // bytes in use at the end of each hour
};

class Soak
{
public:
    static constexpr Seconds kTick{0.02};

    explicit Soak(unsigned seed);
    ~Soak();

    void run(Seconds time);
    void comeToRest();  // the client stops the mount, and there is no more trouble
    // The program ends as if it was killed, and starts again with the same state folder.
    void restart();
    void powerCycle();  // power cycle of the mount while no program runs, then as restart()

    [[nodiscard]] const SoakCounts& counts() const { return m_counts; }
    [[nodiscard]] const SoakFindings& findings() const { return m_findings; }
    [[nodiscard]] const sim::ReplyCounts& saidByDrives() { return m_bus.pair().replyCounts(); }
    [[nodiscard]] StationStatus status() const { return m_station->status(); }
    [[nodiscard]] AxisPosition truth();
    [[nodiscard]] const journal::LoadedJournal& journal() const { return m_journal; }  // as the last program left it

private:
    class LentLink;

    void start(const std::optional<EnteredPlace>& standingAt);
    void end();
    void tick();
    void wait(Seconds time);
    void judge();
    void trouble();
    void beginOutage();
    void endOutage();
    void stall();
    void operate(const StationStatus& status);
    void tellTurns(const StationStatus& status);
    std::string ask(const Request& request);
    void stream();
    void planPass();
    double random(double low, double high) { return std::uniform_real_distribution(low, high)(m_random); }
    bool chance(double probability) { return random(0.0, 1.0) < probability; }

    std::mt19937 m_random;
    fakes::ManualClock m_clock;
    QTemporaryDir m_stateDir;
    profile::Profile m_profile;
    SimulatedLink m_bus;
    std::unique_ptr<Station> m_station;
    std::unique_ptr<fakes::TcpPeer> m_client;
    SoakCounts m_counts;
    SoakFindings m_findings;
    std::vector<Answer> m_answers;
    StationStatus m_shown;  // by the last update
    journal::LoadedJournal m_journal;
    std::uint16_t m_port = 0;

    bool m_troubles = false;
    Seconds m_time{0.0};  // mount time
    Seconds m_nextTrouble{60.0};
    Seconds m_nextClockStep{100.0};
    std::optional<sim::FaultSchedule::Handle> m_outage;
    std::optional<Axis> m_cutAxis;
    bool m_cut = false;
    Seconds m_outageEnd{0.0};
    bool m_lost = false;  // the station has reported a loss and is not re-armed yet
    Seconds m_lostSince{0.0};
    std::optional<AxisPosition> m_restingAt;
    Seconds m_armedSince{0.0};
    Seconds m_nextOperation{0.0};

    std::optional<SatellitePass> m_pass;
    Seconds m_culmination{0.0};
    Seconds m_passEnd{0.0};  // end of the pass and of the pause after it
    Seconds m_nextPoint{0.0};
    bool m_rests = false;
};

}  // namespace boresight::system_test
