// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/supervision/axis_supervisor.h"
#include "tests/system/gpredict_client.h"
#include "tests/system/satellite_pass.h"
#include "tests/system/simulated_station.h"

#include <gtest/gtest.h>

#include <array>
#include <optional>
#include <set>
#include <string>

// A second pair of supervisors checks the whole station by its status alone. During a complete satellite pass, slews at
// full speed and jogs they must find nothing.
namespace boresight::system_test {
namespace {

using supervision::AxisObservation;
using supervision::AxisSupervisor;
using supervision::Observed;

class OverTheShoulder
{
public:
    explicit OverTheShoulder(SimulatedStation& station) : m_station(station)
    {
        station.onTick = [this] { look(); };
    }
    ~OverTheShoulder() { m_station.onTick = nullptr; }
    OverTheShoulder(const OverTheShoulder&) = delete;
    OverTheShoulder& operator=(const OverTheShoulder&) = delete;

    [[nodiscard]] std::string report() const
    {
        std::string text;
        for (const std::string& what : m_found) {
            text += what + "\n";
        }
        return text;
    }
    [[nodiscard]] int looks() const { return m_looks; }

private:
    void look()
    {
        const StationStatus status = m_station.status();
        look(status.azimuth, m_azimuth);
        look(status.elevation, m_elevation);
    }
    void look(const AxisStatus& axis, AxisSupervisor& supervisor)
    {
        if (!axis.actual || !axis.age) {
            return;
        }
        const SteadyTime now = m_station.clock.now();
        const AxisObservation seen{.now = now,
                                   .received = now - *axis.age,
                                   .fresh = *axis.age < SimulatedStation::kTick,
                                   .actual = *axis.actual,
                                   .engaged = axis.commanded.has_value(),
                                   .commanded = axis.commanded.value_or(Angle{}),
                                   .commandedRate = axis.commandedRate.value_or(AngularRate{}),
                                   .torque = axis.torque.value_or(0.0),
                                   .voltage = axis.busVoltage.value_or(0.0),
                                   .boardTemperature = axis.boardTemperature.value_or(0.0),
                                   .motorTemperature = axis.motorTemperature,
                                   .turnKnown = true};
        for (const Observed& one : supervisor.observe(seen)) {
            m_found.insert(one.what.toStdString());
        }
        m_looks += seen.fresh && seen.engaged ? 1 : 0;
    }

    SimulatedStation& m_station;
    const profile::InForce m_profile{anyPort()};
    AxisSupervisor m_azimuth{Axis::Azimuth, m_profile};
    AxisSupervisor m_elevation{Axis::Elevation, m_profile};
    std::set<std::string> m_found;
    int m_looks = 0;
};

// REQ-SUPERVISION-11 (SupervisedStation.*)
TEST(SupervisedStation, FindsNothingInAWholePass)
{
    const SatellitePass pass({.maxElevation = 80_deg, .culmination = 350_deg});
    SimulatedStation rig(anyPort(), sim::commissionedPair({.azimuth = 200_deg, .elevation = 10_deg}));
    GpredictClient gpredict(rig.connect(), pass);
    OverTheShoulder shoulder(rig);
    Seconds time = -pass.halfDuration() - Seconds(30.0);
    for (; time < pass.halfDuration() + Seconds(10.0); time += SimulatedStation::kTick) {
        rig.tick();
        gpredict.tick(time);
    }
    EXPECT_EQ(shoulder.report(), "");
    EXPECT_GT(shoulder.looks(), 2 * 50 * 500) << "the station held or moved the mount, and was watched";
}

TEST(SupervisedStation, FindsNothingInSlewsAndJogs)
{
    SimulatedStation rig;
    OverTheShoulder shoulder(rig);
    for (const double azimuth : {440.0, -80.0}) {
        EXPECT_EQ(rig.ask(request::PointAxes{{.azimuth = Angle::fromDegrees(azimuth), .elevation = 80_deg}}), "");
        EXPECT_TRUE(rig.settle());
    }
    for (const double rate : {6.0, -6.0, 2.0, -0.2}) {
        for (int i = 0; i < 15; ++i) {
            EXPECT_EQ(rig.ask(request::Jog{{.azimuth = AngularRate::fromDegrees(rate),
                                            .elevation = AngularRate::fromDegrees(-0.5 * rate)}}),
                      "");
            rig.run(Seconds(0.1));
        }
    }
    EXPECT_EQ(rig.ask(request::Stop{}), "");
    rig.run(Seconds(3.0));
    EXPECT_EQ(rig.ask(request::ResetStop{}), "");
    rig.run(Seconds(3.0));
    EXPECT_EQ(shoulder.report(), "");
    EXPECT_GT(shoulder.looks(), 2 * 50 * 60);
}

}  // namespace
}  // namespace boresight::system_test
