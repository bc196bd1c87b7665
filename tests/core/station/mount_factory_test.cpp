// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/station/mount_factory.h"

#include "core/mount/mount_service.h"
#include "core/mqtt/broker_client.h"
#include "core/sim_bus/simulated_link.h"
#include "tests/fakes/manual_clock.h"
#include "tests/fakes/text_of.h"

#include <QTemporaryDir>

#include <gtest/gtest.h>

#include <memory>

namespace boresight {
namespace {

constexpr Simulation kSimple{.on = true, .driver = profile::AxisDriver::Simple};

// Story: the program switched to a stored profile of a simple rotator, and took two moteus drives on its bus for that
// rotator.
// REQ-STATION-49: A profile that is only fit for a simulation does not open the bus of a real mount. The alarm gives
// the reason.
TEST(MountFactory, AProfileForASimulationOpensNoBus)
{
    profile::Profile profile;
    profile.bus = "fdcanusb:/dev/does-not-exist";
    profile.azimuth.driver = profile.elevation.driver = profile::AxisDriver::Simple;
    const QTemporaryDir stateDir;
    fakes::ManualClock clock;
    EventLog log(clock);
    AlarmBoard alarms(log, clock);
    const profile::InForce inForce(profile);
    const MountFactory mounts(profile, clock);
    const auto mount = mounts.make(profile, {stateDir.path(), Simulation::Off})(inForce, clock, log, alarms);
    mount->open();
    ASSERT_EQ(alarms.list().size(), 1U);
    const QString what = alarms.list().front().what;
    EXPECT_TRUE(what.contains(QStringLiteral("only simulated"))) << what.toStdString();
}

// Story: with the simple rotator the sensor still showed the two moteus drives, which nobody moved, and disagreed with
// the axes.
TEST(MountFactory, TheSimulatedSensorIsOnTheTwoMoteusOnly)
{
    fakes::ManualClock clock;
    mqtt::BrokerClient broker(clock);
    profile::Profile profile;
    profile.sensor.source = profile::SensorSource::Simulated;
    const MountFactory mounts(profile, clock);
    EXPECT_TRUE(mounts.sensors(profile, Simulation::Reference)(profile, broker));
    EXPECT_FALSE(mounts.sensors(profile, kSimple)(profile, broker));
    EXPECT_FALSE(mounts.sensors(profile, Simulation::Off)(profile, broker));
    profile.elevation.driver = profile::AxisDriver::None;
    EXPECT_FALSE(mounts.sensors(profile, Simulation::Reference)(profile, broker));
    profile.elevation.driver = profile::AxisDriver::Simple;
    EXPECT_FALSE(mounts.sensors(profile, Simulation::Reference)(profile, broker));
    profile.azimuth.driver = profile::AxisDriver::Simple;
    profile.elevation.driver = profile::AxisDriver::None;
    EXPECT_FALSE(mounts.sensors(profile, Simulation::Reference)(profile, broker));
}

// REQ-STATION-965: Only a simulated mount shows faults on request. A real mount refuses and gives the way to a
// simulated one. A simulated rotator without a moteus drive refuses, too.
TEST(MountFactory, OnlySimulatedDrivesShowFaults)
{
    const fakes::ManualClock clock;
    profile::Profile profile;
    profile.bus = "fdcanusb:/dev/does-not-exist";
    const MountFactory mounts(profile, clock);
    EXPECT_TRUE(mounts.faults(profile, Simulation::Reference)("stall el"));
    const auto real = mounts.faults(profile, Simulation::Off)("stall el");
    ASSERT_FALSE(real);
    EXPECT_EQ(textOf(real.error()),
              "This station moves a real mount, which shows no faults on request. Start it with --simulate.");
    EXPECT_FALSE(mounts.faults(profile, kSimple)("stall el"));
    profile.elevation.driver = profile::AxisDriver::Simple;
    EXPECT_TRUE(mounts.faults(profile, Simulation::Reference)("stall az"));
    EXPECT_FALSE(mounts.faults(profile, Simulation::Reference)("stall el"));
}

// A simulated mount with these drivers, and its line.
class Made
{
public:
    Made(profile::AxisDriver azimuth, profile::AxisDriver elevation,
         const Simulation& simulation = Simulation::Reference)
    {
        m_profile.azimuth.driver = azimuth;
        m_profile.elevation.driver = elevation;
        m_inForce = std::make_unique<profile::InForce>(m_profile);
        m_mount = MountFactory(m_profile, m_clock)
                      .make(m_profile, {m_stateDir.path(), simulation})(*m_inForce, m_clock, m_log, m_alarms);
    }

    [[nodiscard]] MountDriver& driver() { return m_mount->driver(); }
    [[nodiscard]] Capabilities can() { return driver().capabilities(); }
    // Serves the mount as the station does.
    void run(Seconds time)
    {
        constexpr Seconds kTick{0.02};
        m_mount->open();
        for (Seconds left = time; left > Seconds(0.0); left -= kTick) {
            m_clock.advance(kTick);
            if (auto* const link = m_mount->findChild<SimulatedLink*>()) {
                link->deliver();
            }
            driver().observe(m_clock.now());
            (void)driver().supervise({});
            m_mount->send();
        }
    }
    [[nodiscard]] DrivesStatus drives()
    {
        StationStatus status;
        status.drives.emplace();
        driver().service()->describe(*status.drives);
        m_mount->describe(status);
        return *status.drives;
    }
    [[nodiscard]] MountLine line() const
    {
        StationStatus status;
        m_mount->describe(status);
        return status.line;
    }

private:
    profile::Profile m_profile;
    const QTemporaryDir m_stateDir;
    fakes::ManualClock m_clock;
    EventLog m_log{m_clock};
    AlarmBoard m_alarms{m_log, m_clock};
    std::unique_ptr<profile::InForce> m_inForce;
    std::unique_ptr<MountConnection> m_mount;
};

using profile::AxisDriver;

// REQ-STATION-50: The mount has the axes of the profile, each with its own driver. In a simulation the bus has exactly
// one drive for each axis that needs one, so no drive is reported as unknown.
TEST(MountFactory, OneDriveIsAMountWithOneAxis)
{
    for (const Axis axis : kAxes) {
        const bool azimuth = axis == Axis::Azimuth;
        Made made(azimuth ? AxisDriver::Moteus : AxisDriver::None, azimuth ? AxisDriver::None : AxisDriver::Moteus);
        EXPECT_EQ(made.can().has(Axis::Azimuth), azimuth);
        EXPECT_EQ(made.can().has(Axis::Elevation), !azimuth);
        made.run(Seconds(8.0));
        EXPECT_TRUE(made.driver().answers());
        EXPECT_TRUE(made.driver().interlock()) << textOf(made.driver().interlock().error());
        EXPECT_EQ(made.drives().driveCheck, DriveCheckState::Done);
        EXPECT_TRUE(made.drives().unknownBoards.empty());
    }
}

// REQ-STATION-50
TEST(MountFactory, TwoKindsOfDriversAreOneMount)
{
    for (const Axis axis : kAxes) {
        const bool azimuth = axis == Axis::Azimuth;
        Made made(azimuth ? AxisDriver::Moteus : AxisDriver::Simple, azimuth ? AxisDriver::Simple : AxisDriver::Moteus);
        const Capabilities can = made.can();
        ASSERT_TRUE(can.has(Axis::Azimuth) && can.has(Axis::Elevation));
        EXPECT_EQ(can.axes[0]->watchdog, azimuth);
        EXPECT_EQ(can.axes[1]->watchdog, !azimuth);
        EXPECT_EQ(made.line().kind, QStringLiteral("CAN")) << "the other one has none";
        made.run(Seconds(8.0));
        EXPECT_TRUE(made.driver().answers());
        EXPECT_TRUE(made.driver().interlock()) << textOf(made.driver().interlock().error());
        EXPECT_TRUE(made.drives().unknownBoards.empty());
    }
}

// REQ-STATION-50
TEST(MountFactory, TheSimpleSimulationHasTheAxesOfTheProfile)
{
    Made made(AxisDriver::Moteus, AxisDriver::None, kSimple);
    ASSERT_TRUE(made.can().has(Axis::Azimuth));
    EXPECT_FALSE(made.can().axes[0]->watchdog);
    EXPECT_FALSE(made.can().has(Axis::Elevation));
}

// REQ-STATION-930: Each driver that a profile can name makes a mount.
TEST(MountFactory, EveryDriverOfTheListIsMade)
{
    for (const profile::DriverKind& kind : profile::kDriverKinds) {
        ASSERT_EQ(&profile::kindOf(kind.driver), &kind) << "in the order of the enumerators";
        if (kind.driver == AxisDriver::None) {
            continue;
        }
        for (const bool named : {true, false}) {
            const AxisDriver other = kind.driver == AxisDriver::Simple ? AxisDriver::Moteus : AxisDriver::Simple;
            Made made(named ? kind.driver : other, named ? kind.driver : other, {.on = true, .driver = kind.driver});
            EXPECT_TRUE(made.can().has(Axis::Azimuth) && made.can().has(Axis::Elevation)) << kind.name;
            EXPECT_EQ(made.can().axes[0]->watchdog, kind.driver == AxisDriver::Moteus) << kind.name;
            made.run(Seconds(8.0));
            EXPECT_TRUE(made.driver().answers()) << kind.name;
        }
    }
}

}  // namespace
}  // namespace boresight
