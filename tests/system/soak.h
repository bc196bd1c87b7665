// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/memory/memory_file.h"
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

// Days of work in minutes: a station with its journal on disk, a client that streams satellite passes, a bus that loses
// replies and breaks now and then, a computer that stalls and whose UTC is set, and an operator who re-arms. The mount
// is simulated with all its physics; only the clock is turned by hand, in ticks of 20 ms. What happens depends on the
// seed alone. Every tick is judged by where the antenna really is.
namespace boresight::system_test {

struct SoakCounts
{
    std::uint64_t ticks = 0;
    std::uint64_t frames = 0;     // sent by the station
    std::uint64_t questions = 0;  // of these, to a drive and with a reply wanted
    std::uint64_t unheard = 0;    // of the questions: sent while the cable was cut
    std::uint64_t received = 0;   // replies that reached the station
    std::uint64_t passes = 0;
    std::uint64_t points = 0;         // `P` answered with RPRT 0
    std::uint64_t refusedPoints = 0;  // while the mount was not armed
    std::uint64_t shortTroubles = 0;  // outages and stalls that must not matter
    std::uint64_t longTroubles = 0;   // that must each stop the mount once
    std::uint64_t clockSteps = 0;
    std::uint64_t losses = 0;      // told by the station
    std::uint64_t recoveries = 0;  // to an armed mount
    std::uint64_t rearms = 0;      // asked for and accepted
    std::uint64_t turnsTold = 0;   // by the operator, where the clocks left no proof
};

// The worst that was seen, and what must never be.
struct SoakFindings
{
    Angle outside;                    // beyond the travel, of the worse axis
    double fastest = 0.0;             // of the worse axis, in parts of its speed limit
    Angle astray;                     // told by the station as known, away from the truth
    Angle movedUnarmed;               // between coming to rest after a loss and the re-arm
    std::vector<std::size_t> memory;  // bytes in use at the end of each hour
};

class Soak
{
public:
    static constexpr Seconds kTick{0.02};

    explicit Soak(unsigned seed);
    ~Soak();

    void run(Seconds time);
    void comeToRest();  // the client stops the mount; no more troubles
    // The program ends as if killed, and is started again on the same state folder.
    void restart();
    void powerCycle();  // of the mount, while no program runs; then as restart()

    [[nodiscard]] const SoakCounts& counts() const { return m_counts; }
    [[nodiscard]] const SoakFindings& findings() const { return m_findings; }
    [[nodiscard]] const sim::ReplyCounts& saidByDrives() { return m_bus.pair().replyCounts(); }
    [[nodiscard]] StationStatus status() const { return m_station->status(); }
    [[nodiscard]] AxisPosition truth();
    [[nodiscard]] const memory::LoadedMemory& journal() const { return m_journal; }  // as the last program left it

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
    memory::LoadedMemory m_journal;
    std::uint16_t m_port = 0;

    bool m_troubles = false;
    Seconds m_time{0.0};  // of the mount
    Seconds m_nextTrouble{60.0};
    Seconds m_nextClockStep{100.0};
    std::optional<sim::FaultSchedule::Handle> m_outage;
    std::optional<Axis> m_cutAxis;
    bool m_cut = false;
    Seconds m_outageEnd{0.0};
    bool m_lost = false;  // the station has told a loss, and is not re-armed yet
    Seconds m_lostSince{0.0};
    std::optional<AxisPosition> m_restingAt;
    Seconds m_armedSince{0.0};
    Seconds m_nextOperation{0.0};

    std::optional<SatellitePass> m_pass;
    Seconds m_culmination{0.0};
    Seconds m_passEnd{0.0};  // and of the pause after it
    Seconds m_nextPoint{0.0};
    bool m_rests = false;
};

}  // namespace boresight::system_test
