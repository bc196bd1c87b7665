// SPDX-License-Identifier: GPL-3.0-or-later
// The complete system: simulated mount, its sensor, and the station that compares both.
#include "core/moteus_mount/moteus_connection.h"
#include "core/sim_sensor/simulated_source.h"
#include "core/station/station.h"
#include "tests/core/geomagnetism/synthetic_model.h"
#include "tests/fakes/manual_clock.h"
#include "tests/fakes/text_of.h"
#include "tests/fakes/wait_until.h"

#include <QFile>
#include <QTemporaryDir>

#include <gmock/gmock.h>

namespace boresight {
namespace {

using orientation::Presence;
using testing::HasSubstr;

profile::Profile withSimulatedSensor()
{
    profile::Profile profile;
    profile.rotctld.listen.port = 0;
    profile.sensor.source = profile::SensorSource::Simulated;
    profile.sensor.mounting.azimuthOffset = 37.4_deg;
    return profile;
}

struct SensedRig
{
    explicit SensedRig(const profile::Profile& profile = withSimulatedSensor())
        : mount(std::make_shared<SimulatedMount>(clock, sim::commissionedPair()))
    {
        mount->sensor.truth().mountingOffset = 37.4_deg;
        auto owned = std::make_unique<SimulatedLink>(clock, mount);
        link = owned.get();
        station = std::make_unique<Station>(
            profile, moteusRotator(std::move(owned), {stateDir.path(), Simulation::Reference}), stateDir.path(), clock);
        station->setSensorMaker(
            [this](const profile::Profile& wanted, mqtt::Connection& broker) { return make(wanted, broker); });
        station->openAll();
    }

    std::unique_ptr<orientation::SensorSource> make(const profile::Profile& wanted, mqtt::Connection& broker)
    {
        auto made = sensorMaker(clock, mount)(wanted, broker);
        source = dynamic_cast<SimulatedSource*>(made.get());
        return made;
    }

    void run(double seconds)
    {
        for (int i = 0; i < static_cast<int>(seconds * 50.0 + 0.5); ++i) {
            clock.advance(Seconds(0.02));
            link->deliver();
            station->tick();
            if (++ticks % 10 == 0 && source != nullptr) {
                source->read();
            }
        }
    }

    Result<> ask(const Request& request)
    {
        std::optional<Error> error;
        const auto listening = QObject::connect(station.get(), &Station::updated, [&](const StationUpdate& update) {
            error = update.answers.empty() ? std::nullopt : update.answers.back().error;
        });
        station->request({.id = 1, .request = request});
        station->updateTaken();
        station->publish();
        QObject::disconnect(listening);
        return error ? Result<>(tl::unexpected(*error)) : Result<>{};
    }

    [[nodiscard]] SensorStatus sensor() const { return station->status().sensor; }
    [[nodiscard]] std::string alarms() const
    {
        std::string text;
        for (const Alarm& alarm : station->status().alarms) {
            text += alarm.active ? alarm.what.toStdString() + "\n" : "";
        }
        return text;
    }

    QTemporaryDir stateDir;
    fakes::ManualClock clock;
    std::shared_ptr<SimulatedMount> mount;
    SimulatedLink* link = nullptr;
    SimulatedSource* source = nullptr;
    std::unique_ptr<Station> station;
    int ticks = 0;
};

constexpr double kDriveCheck = 4.0;  // s; it takes 2.4

// REQ-WITNESS-40 (StationSensor.*)
TEST(StationSensor, AgreesWithTheAxesAtRestAndInMotion)
{
    SensedRig rig;
    rig.run(kDriveCheck);
    EXPECT_EQ(rig.sensor().presence, Presence::Present);
    ASSERT_TRUE(rig.sensor().direction);
    EXPECT_LT(abs(rig.sensor().direction->azimuth.wrapped180()), 0.5_deg);
    EXPECT_NEAR(rig.sensor().direction->elevation.degrees(), 10.0, 0.5);
    ASSERT_TRUE(rig.ask(request::PointAxes{{200_deg, 60_deg}}));
    rig.run(45.0);
    EXPECT_NEAR(rig.station->status().actual->azimuth.degrees(), 200.0, 0.1);
    EXPECT_NEAR(rig.sensor().direction->azimuth.degrees(), 200.0, 0.6);
    EXPECT_EQ(rig.alarms(), "");
    EXPECT_FALSE(rig.sensor().disagrees);
}

TEST(StationSensor, ADisturbedCompassIsToldWithinThreeSecondsAndMovesNothing)
{
    SensedRig rig;
    rig.run(kDriveCheck);
    ASSERT_TRUE(rig.ask(request::PointAxes{{100_deg, 30_deg}}));
    rig.run(30.0);
    ASSERT_EQ(rig.alarms(), "");
    const StationStatus before = rig.station->status();
    rig.mount->sensor.truth().b1 = 20_deg;
    rig.mount->sensor.truth().a1 = 20_deg;
    rig.run(3.0);
    EXPECT_THAT(rig.alarms(), HasSubstr("The orientation sensor and the axes differ by"));
    rig.run(3.0);
    const StationStatus after = rig.station->status();
    EXPECT_EQ(after.state, before.state);
    EXPECT_NEAR(after.actual->azimuth.degrees(), before.actual->azimuth.degrees(), 0.01);
    EXPECT_EQ(*after.profile, *before.profile);
    rig.mount->sensor.truth().a1 = rig.mount->sensor.truth().b1 = Angle{};
    rig.run(6.0);
    EXPECT_EQ(rig.alarms(), "");
}

// Story: the warning was amber although the north that explained the difference was found and waited for Apply.
// REQ-WITNESS-40a
TEST(StationSensor, ADifferenceThatTheFoundNorthExplainsIsNoAlarm)
{
    profile::Profile profile = withSimulatedSensor();
    profile.sensor.mounting.azimuthOffset = 10_deg;
    profile.pointing.azimuthOffset = 5_deg;
    SensedRig rig(profile);
    rig.run(kDriveCheck + 6.0);
    ASSERT_THAT(rig.alarms(), HasSubstr("The orientation sensor and the axes differ by"));
    ASSERT_TRUE(rig.ask(request::TakeAuthority{}));
    const auto asked = rig.ask(request::MeasureSensorOffset{});
    ASSERT_TRUE(asked) << textOf(asked.error());
    rig.run(30.0);
    ASSERT_TRUE(rig.station->status().calibration->proposal)
        << rig.station->status().calibration->progress.outcome.toStdString();
    EXPECT_EQ(rig.alarms(), "");
    ASSERT_TRUE(rig.ask(request::ApplyCalibration{rig.station->status().calibration->proposal->number}));
    rig.run(10.0);
    EXPECT_EQ(rig.alarms(), "") << "in force it explains it as well";
}

// The field of the working motors deflects the needle. Slews back and forth show this.
// REQ-WITNESS-45
TEST(StationSensor, ADisturbanceThatGoesWithTheMotorsCurrentIsToldAsThat)
{
    SensedRig rig;
    rig.run(kDriveCheck);
    rig.mount->sensor.truth().perAmpere = 12_deg;
    const auto remedies = [&rig] {
        std::string text;
        for (const Alarm& alarm : rig.station->status().alarms) {
            text += alarm.remedy.toStdString() + "\n";
        }
        return text;
    };
    const profile::Profile before = *rig.station->status().profile;
    double strongest = 0.0;
    std::string told;
    for (int leg = 0; leg < 6; ++leg) {
        ASSERT_TRUE(rig.ask(request::PointAxes{{leg % 2 == 0 ? 40_deg : 0_deg, 10_deg}}));
        for (int second = 0; second < 16; ++second) {
            rig.run(1.0);
            strongest = std::max(strongest, std::abs(rig.link->truth(Axis::Azimuth).current));
            told += remedies();
        }
    }
    EXPECT_THAT(told, HasSubstr("The difference follows the motor current, 1")) << strongest << " A";
    EXPECT_EQ(*rig.station->status().profile, before);
    EXPECT_NEAR(rig.station->status().actual->azimuth.wrapped180().degrees(), 0.0, 0.1);
}

TEST(StationSensor, ASensorThatFailsIsAWarningAndThePointingGoesOn)
{
    SensedRig rig;
    rig.run(kDriveCheck);
    rig.mount->sensor.setFault(sim::SensorFault::Silent);
    rig.run(6.0);
    EXPECT_THAT(rig.alarms(), HasSubstr("The orientation sensor (simulated) sends no data"));
    EXPECT_EQ(rig.sensor().presence, Presence::Lost);
    ASSERT_TRUE(rig.ask(request::PointAxes{{20_deg, 30_deg}}));
    rig.run(10.0);
    EXPECT_NEAR(rig.station->status().actual->azimuth.degrees(), 20.0, 0.1);
    rig.mount->sensor.setFault(sim::SensorFault::Dead);
    rig.run(3.0);
    EXPECT_THAT(rig.alarms(), HasSubstr("only zeros"));
    rig.mount->sensor.setFault(sim::SensorFault::None);
    rig.run(3.0);
    EXPECT_EQ(rig.alarms(), "");
}

TEST(StationSensor, TheProfileTakesItAwayAndBringsItBack)
{
    SensedRig rig;
    rig.run(kDriveCheck);
    ASSERT_TRUE(rig.sensor().configured());
    profile::Profile without = withSimulatedSensor();
    without.sensor.source = profile::SensorSource::None;
    ASSERT_TRUE(rig.ask(request::ApplyProfile{without}));
    rig.source = nullptr;
    rig.run(20.0);
    EXPECT_EQ(rig.sensor(), SensorStatus());
    EXPECT_EQ(rig.alarms(), "");
    ASSERT_TRUE(rig.ask(request::ApplyProfile{withSimulatedSensor()}));
    rig.run(3.0);
    EXPECT_EQ(rig.sensor().presence, Presence::Present);
}

TEST(StationSensor, AnotherOffsetIsTakenWithoutLosingTheSource)
{
    SensedRig rig;
    rig.run(kDriveCheck);
    const std::uint64_t heard = rig.sensor().counts.accepted;
    profile::Profile turned = withSimulatedSensor();
    turned.sensor.mounting.azimuthOffset = 127.4_deg;
    ASSERT_TRUE(rig.ask(request::ApplyProfile{turned}));
    EXPECT_NEAR(rig.sensor().direction->azimuth.degrees(), 90.0, 1.0);
    EXPECT_EQ(rig.sensor().counts.accepted, heard);
    rig.run(5.0);
    EXPECT_THAT(rig.alarms(), HasSubstr("in azimuth"));
}

// Story: the declination of the previous site was used until the magnetic model was read again.
TEST(StationSensor, TheDeclinationOfASiteThatIsLeftIsForgotten)
{
    profile::Profile profile = withSimulatedSensor();
    profile.site = {.known = true, .latitude = 10_deg, .longitude = 0_deg, .heightMetres = 100.0};
    profile.sensor.declinationBy = geomagnetism::DeclinationBy::Boresight;
    QTemporaryDir folder;
    QFile file(folder.filePath(QStringLiteral("WMM.COF")));
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(QByteArray::fromStdString(
        geomagnetism::coefficientText({{{1, 0}, {.main = {.g = -30000.0}}}, {{1, 1}, {.main = {.h = 5000.0}}}},
                                      "    2025.0            WMM-2025        11/13/2024")));
    file.close();
    profile.sensor.declinationFile = file.fileName().toStdString();
    SensedRig rig(profile);
    rig.run(kDriveCheck);
    ASSERT_TRUE(fakes::waitUntil([&] { return !rig.sensor().declinationText.contains(QStringLiteral("not known")); }))
        << rig.sensor().declinationText.toStdString();
    profile.site.latitude = 40_deg;
    ASSERT_TRUE(rig.ask(request::ApplyProfile{profile}));
    rig.run(0.1);
    EXPECT_THAT(rig.sensor().declinationText.toStdString(), HasSubstr("not known"));
}

TEST(StationSensor, AMagneticModelThatCannotBeReadIsTold)
{
    profile::Profile profile = withSimulatedSensor();
    profile.site = {.known = true, .latitude = 38.7_deg, .longitude = -9.1_deg, .heightMetres = 100.0};
    profile.sensor.declinationBy = geomagnetism::DeclinationBy::Boresight;
    profile.sensor.declinationFile = "/nowhere/WMM.COF";
    SensedRig rig(profile);
    rig.run(kDriveCheck);
    const auto told = [&rig] {
        QFile log(rig.stateDir.filePath(QStringLiteral("events.log")));
        rig.run(0.02);
        return log.open(QIODevice::ReadOnly) && log.readAll().contains("/nowhere/WMM.COF");
    };
    EXPECT_TRUE(fakes::waitUntil(told));
    EXPECT_THAT(rig.sensor().declinationText.toStdString(), HasSubstr("not known"));
}

}  // namespace
}  // namespace boresight
