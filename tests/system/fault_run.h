// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/system/fault_case.h"
#include "tests/system/gpredict_client.h"
#include "tests/system/satellite_pass.h"

#include <array>
#include <optional>
#include <string>

// One row of FAULTS.md: brings a mount to the moment, causes the fault, and records where the antenna really is until
// it was re-armed and has moved again. Meanwhile clients keep asking for motion. Times are seconds from the fault.
namespace boresight::system_test {

struct FaultOutcome
{
    std::optional<Seconds> alarm;    // empty if no alarm had the expected words
    std::array<Seconds, 2> still{};  // azimuth, elevation: the end of the last motion
    std::array<Angle, 2> beyond{};   // the farthest outside the travel
    std::array<Angle, 2> strayed{};  // the farthest from where it stood still when the fault began
    std::array<double, 2> torque{};  // Nm, when the fault ends
    std::array<Angle, 2> moved{};    // from where it stood still at the end of the fault, until the re-arm
    std::array<bool, 2> off{};       // the drive gives no torque then
    bool stoppedByThen = false;      // both axes, before the end of the fault
    std::string state;               // the state word just before the re-arm
    std::string text;                // the text of the alarm
    std::string again;               // what was needed to move again; empty if it did not move
    Angle movedByRearming;
};

class FaultRun
{
public:
    static constexpr Seconds kAfter{5.0};  // clients ask for motion, nobody re-arms

    explicit FaultRun(const FaultCase& faultCase);
    [[nodiscard]] FaultOutcome run();

private:
    void reach();
    void breakDown();
    void stayUntilRearmed();
    void rearm();
    void moveAgain();

    void tick();
    void watchUntilTick();
    void look(Seconds sinceFault);
    void ask();  // requests of clients and operator in this tick
    void jog();
    void noteAlarm();
    [[nodiscard]] Seconds sinceFault() const { return rig.clock.now() - m_began; }

    FaultCase m_case;
    SatellitePass m_pass{{.maxElevation = 60_deg, .culmination = 100_deg}};
    Seconds m_passTime{-40.0};
    SimulatedStation rig;
    std::unique_ptr<fakes::TcpPeer> m_client;
    std::optional<GpredictClient> m_gpredict;
    std::vector<sim::FaultSchedule::Handle> m_handles;
    SteadyTime m_began{};
    AxisPosition m_stood;
    SteadyTime m_nextAsk{};
    bool m_faulty = false;
    bool m_left = false;  // nobody has re-armed or asked for something new
    bool m_keysHeld = false;
    FaultOutcome m_outcome;
};

}  // namespace boresight::system_test
