// SPDX-License-Identifier: GPL-3.0-or-later
// The whole way: the simulated mount with its own sensor, and the station that calibrates it.
#include "core/sim/simulated_source.h"
#include "core/station/station.h"
#include "tests/fakes/manual_clock.h"

#include <QDir>
#include <QTemporaryDir>

#include <gtest/gtest.h>

namespace boresight {
namespace {

profile::Profile withSensor()
{
    profile::Profile profile;
    profile.rotctld.listen.port = 0;
    profile.sensor.source = profile::SensorSource::Simulated;
    return profile;
}

class CalibratedStation
{
public:
    CalibratedStation() : m_mount(std::make_shared<SimulatedMount>(clock, sim::commissionedPair()))
    {
        auto owned = std::make_unique<SimulatedLink>(clock, m_mount);
        m_link = owned.get();
        station = std::make_unique<Station>(withSensor(), std::move(owned), folder.path(), clock);
        station->setSensorMaker([this](const profile::Profile& wanted, mqtt::Client& client) {
            auto made = sensorMaker(clock, m_mount)(wanted, client);
            m_source = dynamic_cast<SimulatedSource*>(made.get());
            return made;
        });
        QObject::connect(station.get(), &Station::profileApplied,
                         [this](const profile::Profile& profile) { saved = profile; });
        QObject::connect(station.get(), &Station::updated, [this](const StationUpdate& update) {
            for (const Answer& answer : update.answers) {
                m_error = answer.error;
            }
        });
        station->openAll();
        run(Seconds(5.0));  // the drives are surveyed
    }

    void run(Seconds time)
    {
        for (int i = 0; i < static_cast<int>(time / Seconds(0.02)); ++i) {
            clock.advance(Seconds(0.02));
            m_link->deliver();
            station->tick();
            if (++m_ticks % 10 == 0 && m_source != nullptr) {
                m_source->read();
            }
        }
    }

    Result<> ask(const Request& request)
    {
        m_error.reset();
        station->request({.id = 1, .request = request});
        station->updateTaken();
        station->publish();
        run(Seconds(0.1));
        return m_error ? Result<>(tl::unexpected(*m_error)) : Result<>{};
    }

    [[nodiscard]] std::shared_ptr<const CalibrationStatus> calibration() const { return station->status().calibration; }
    [[nodiscard]] sim::SensorTruth& truth() { return m_mount->sensor.truth(); }

    QTemporaryDir folder;
    fakes::ManualClock clock;
    std::unique_ptr<Station> station;
    std::optional<profile::Profile> saved;

private:
    std::shared_ptr<SimulatedMount> m_mount;
    SimulatedLink* m_link = nullptr;
    SimulatedSource* m_source = nullptr;
    int m_ticks = 0;
    std::optional<Error> m_error;
};

TEST(StationCalibration, ASwingOfTheSimulatedMountFindsItsHiddenNorth)
{
    CalibratedStation rig;
    rig.truth().mount.azimuthOffset = 37.4_deg;
    rig.truth().mount.tiltNorth = 0.6_deg;
    rig.truth().a1 = 8_deg;
    rig.truth().b2 = 3_deg;
    rig.truth().noise = 0.5_deg;
    ASSERT_TRUE(rig.ask(request::TakeAuthority{}));
    ASSERT_TRUE(rig.ask(request::PointAxes{{.azimuth = 60_deg, .elevation = 30_deg}}));
    rig.run(Seconds(30.0));
    const auto started = rig.ask(request::StartSwing{.rate = 5_deg_s, .headings = 0});
    ASSERT_TRUE(started) << started.error().text;
    rig.run(Seconds(60.0));
    EXPECT_EQ(StationState::Calibrate, rig.station->status().state);
    rig.run(Seconds(150.0));
    ASSERT_TRUE(rig.calibration()->proposal) << rig.calibration()->progress.outcome.toStdString();
    EXPECT_EQ(StationState::Hold, rig.station->status().state);

    const AxisPosition before{*rig.station->status().azimuth.actual, *rig.station->status().elevation.actual};
    ASSERT_TRUE(rig.ask(request::ApplyCalibration{rig.calibration()->proposal->number}));
    ASSERT_TRUE(rig.saved);
    EXPECT_EQ(*rig.saved, *rig.station->status().profile);
    EXPECT_NEAR(37.4, rig.saved->pointing.azimuthOffset.degrees(), 2.0);
    EXPECT_NEAR(0.6, rig.saved->pointing.tiltNorth.degrees(), 0.2);
    rig.run(Seconds(5.0));
    EXPECT_NEAR(before.azimuth.degrees(), rig.station->status().azimuth.actual->degrees(), 0.01);
    EXPECT_NEAR(before.elevation.degrees(), rig.station->status().elevation.actual->degrees(), 0.01);
    // The sensor is now corrected and agrees with the axes all around.
    ASSERT_TRUE(rig.ask(request::PointAxes{{.azimuth = 250_deg, .elevation = 40_deg}}));
    rig.run(Seconds(60.0));
    ASSERT_TRUE(rig.station->status().sensor.azimuthDifference);
    EXPECT_LT(abs(*rig.station->status().sensor.azimuthDifference), 2.5_deg);
    EXPECT_EQ(1, QDir(rig.folder.path()).entryList({QStringLiteral("*.calibrations.toml")}).size());

    ASSERT_TRUE(rig.ask(request::UndoCalibration{}));
    EXPECT_EQ(withSensor(), *rig.saved);
}

TEST(StationCalibration, NoSensorIsSaidAndRefused)
{
    CalibratedStation rig;
    profile::Profile without = withSensor();
    without.sensor.source = profile::SensorSource::None;
    ASSERT_TRUE(rig.ask(request::ApplyProfile{without}));
    ASSERT_TRUE(rig.ask(request::TakeAuthority{}));
    const auto refused = rig.ask(request::StartSwing{});
    ASSERT_FALSE(refused);
    EXPECT_EQ(ErrorCode::NotAvailable, refused.error().code);
    EXPECT_FALSE(rig.calibration()->swingPlan.obstacle.isEmpty());
}

}  // namespace
}  // namespace boresight
