// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cross_check/sensor_curve.h"
#include "tests/core/cross_check/sensor_watch_rig.h"

#include <cmath>
#include <utility>

namespace boresight {
namespace {

using orientation::Presence;
using testing::HasSubstr;

TEST(SensorWatch, WithoutASensorThereIsNothingToTell)
{
    SensorWatchRig rig;
    rig.watch.begin({});
    rig.speaking = false;
    rig.run(60.0);
    EXPECT_EQ(rig.watch.status(), SensorStatus());
    EXPECT_EQ(rig.alarmText(), "");
}

TEST(SensorWatch, ShowsTheTrueDirectionAndItsAge)
{
    profile::Profile profile;
    profile.sensor.mounting.azimuthOffset = 37.4_deg;
    profile.sensor.mounting.elevationOffset = 1_deg;
    SensorWatchRig rig(profile);
    rig.heading = 62.6_deg;
    rig.elevation = 19_deg;
    rig.run(10.5);
    const SensorStatus status = rig.watch.status();
    EXPECT_EQ(status.presence, Presence::Present);
    ASSERT_TRUE(status.direction);
    EXPECT_NEAR(status.direction->azimuth.degrees(), 100.0, 1e-9);
    EXPECT_NEAR(status.direction->elevation.degrees(), 20.0, 1e-9);
    EXPECT_NEAR(static_cast<double>(status.age->count()), 500.0, 25.0);
    EXPECT_NEAR(status.azimuthDifference->degrees(), 0.0, 1e-9);
    EXPECT_EQ(status.doubt, QString());
    EXPECT_THAT(rig.logText(), HasSubstr("sensor: the orientation sensor sends data: serial"));
}

TEST(SensorWatch, LateThenLostThenBack)
{
    SensorWatchRig rig;
    rig.run(10.0);
    rig.speaking = false;
    rig.run(3.5);
    EXPECT_EQ(rig.watch.status().presence, Presence::Late);
    EXPECT_TRUE(rig.watch.status().direction);
    EXPECT_EQ(rig.alarmText(), "");
    rig.watch.show({.open = false, .problem = QStringLiteral("/dev/ttyUSB0 is gone. Plug the sensor in again")});
    rig.run(2.0);
    EXPECT_EQ(rig.watch.status().presence, Presence::Lost);
    EXPECT_FALSE(rig.watch.status().direction);
    EXPECT_EQ(rig.watch.evidence(), SensorEvidence());
    EXPECT_THAT(rig.alarmText(), HasSubstr("is gone. Plug the sensor in again"));
    rig.speaking = true;
    rig.run(2.0);
    EXPECT_EQ(rig.alarmText(), "");
}

TEST(SensorWatch, AFirstWordIsWaitedForTenSeconds)
{
    SensorWatchRig rig;
    rig.speaking = false;
    rig.run(9.9);
    EXPECT_EQ(rig.alarmText(), "");
    rig.run(0.2);
    EXPECT_THAT(rig.alarmText(), HasSubstr("sends no data"));
}

TEST(SensorWatch, ADeadOneIsToldAsThat)
{
    SensorWatchRig rig;
    rig.run(3.0);
    orientation::Orientation dead = rig.value();
    dead.heading = orientation::SensorHeading::folded(5.07_deg);
    dead.elevation = Angle{};
    dead.temperature = 0.0;
    dead.calibration = orientation::Calibration{};
    rig.watch.take(dead);
    rig.speaking = false;
    rig.run(0.1);
    EXPECT_THAT(rig.alarmText(), HasSubstr("only zeros"));
    EXPECT_FALSE(rig.watch.status().direction);
    EXPECT_EQ(rig.watch.evidence(), SensorEvidence());
}

TEST(SensorWatch, TheDeclinationOfAnotherSiteIsForgotten)
{
    profile::Profile profile;
    profile.sensor.declinationBy = geomagnetism::DeclinationBy::Boresight;
    profile.sensor.declinationFile = "WMM.COF";
    SensorWatchRig rig(profile);
    rig.watch.setSiteDeclination(Result<Angle>(12_deg));
    EXPECT_NEAR(12.0, rig.watch.status().declination.degrees(), 1e-9);
    rig.watch.setSiteDeclination(std::nullopt);
    EXPECT_THAT(rig.watch.status().declinationText.toStdString(), HasSubstr("not known"));
}

// The mount turns clockwise by 500°. The course counts more than a full turn, whichever way the sensor counts.
// REQ-WITNESS-46
TEST(SensorWatch, ItsCourseIsThatOfTheMount)
{
    for (const bool clockwise : {true, false}) {
        profile::Profile profile;
        profile.sensor.mounting.azimuthOffset = 37.4_deg;
        profile.sensor.mounting.sense =
            clockwise ? orientation::Sense::Clockwise : orientation::Sense::CounterClockwise;
        SensorWatchRig rig(profile);
        rig.run(2.0);
        const auto before = rig.watch.evidence().course;
        ASSERT_TRUE(before);
        for (int second = 0; second < 100; ++second) {
            rig.heading += clockwise ? 5_deg : -5_deg;
            rig.run(1.0);
        }
        const auto after = rig.watch.evidence().course;
        ASSERT_TRUE(after);
        EXPECT_EQ(after->unbroken, before->unbroken);
        EXPECT_NEAR((after->azimuth - before->azimuth).degrees(), 500.0, 1e-6) << clockwise;
        EXPECT_EQ(rig.watch.status().turns, clockwise ? 1 : 2) << "it began at 100° of its own circle";
        EXPECT_NEAR((after->azimuth - rig.watch.status().direction->azimuth).turns(),
                    std::round((after->azimuth - rig.watch.status().direction->azimuth).turns()), 1e-9);
    }
}

// REQ-WITNESS-46
TEST(SensorWatch, ItsCourseBreaksWhereItProvesNothing)
{
    SensorWatchRig rig;
    const auto unbroken = [&rig] {
        rig.run(2.0);
        const auto course = rig.watch.evidence().course;
        return course ? course->unbroken : 0;
    };
    auto before = unbroken();
    const auto isAnother = [&] { return std::exchange(before, unbroken()) != before; };
    EXPECT_FALSE(isAnother());
    rig.elevation = 80_deg;
    rig.run(6.0);
    EXPECT_FALSE(rig.watch.evidence().course) << "near the zenith";
    rig.elevation = 20_deg;
    rig.run(6.0);
    EXPECT_TRUE(isAnother());
    rig.calibration->magnetometer = 1;
    rig.run(2.0);
    EXPECT_FALSE(rig.watch.evidence().course) << "not tied to north";
    rig.calibration->magnetometer = 3;
    EXPECT_TRUE(isAnother());
    rig.profile.sensor.mounting.azimuthOffset = 1_deg;
    rig.setProfile(rig.profile);
    EXPECT_TRUE(isAnother());
    rig.speaking = false;
    rig.run(6.0);
    EXPECT_FALSE(rig.watch.evidence().course) << "not heard";
    rig.speaking = true;
    EXPECT_TRUE(isAnother());
    EXPECT_FALSE(isAnother());
}

TEST(SensorWatch, AnUncalibratedCompassIsNoWitness)
{
    SensorWatchRig rig;
    rig.calibration->magnetometer = 1;
    rig.heading = 180_deg;
    rig.run(10.0);
    EXPECT_EQ(rig.alarmText(), "");
    EXPECT_THAT(rig.watch.status().doubt.toStdString(), HasSubstr("magnetometer 1"));
    EXPECT_EQ(rig.watch.evidence(),
              (SensorEvidence{.azimuth = std::nullopt, .elevation = 20_deg, .course = std::nullopt}));
    rig.calibration->magnetometer = 2;
    rig.run(2.0);
    EXPECT_EQ(rig.watch.evidence().azimuth, 180_deg);
    EXPECT_EQ(rig.watch.evidence().elevation, 20_deg);
}

// MQTT brings few calibration levels, so the sensor is not evidence. A difference is still reported.
TEST(SensorWatch, WithoutACalibrationItWarnsButProvesNothing)
{
    SensorWatchRig rig(withNorth());
    rig.calibration.reset();
    rig.heading = 150_deg;
    rig.run(5.0);
    EXPECT_NE(rig.alarmText(), "");
    EXPECT_FALSE(rig.watch.evidence().azimuth);
}

TEST(SensorWatch, WhatASwingFoundStandsForTheMounting)
{
    const calibration::DeviationCurve curve{.constant = -37_deg, .a1 = 8_deg, .b2 = 3_deg};
    profile::Profile profile;
    profile.sensor.mounting.azimuthOffset = 37_deg;
    profile.sensor.deviation = {.a1 = curve.a1, .b1 = curve.b1, .a2 = curve.a2, .b2 = curve.b2};
    SensorWatchRig rig(profile);
    rig.heading = curve.reading(100_deg).angle();
    rig.run(3.0);
    EXPECT_NEAR(rig.watch.status().direction->azimuth.degrees(), 100.0, 1e-6);
}

// A swing reports its own accuracy, and where steel deflects the needle.
// REQ-WITNESS-41: The quality of a swing is kept with its curve: the sigma of north, the elevation at which the curve
// is valid, and where steel deflects the needle. In such a sector the sensor is no evidence for a wrap and raises no
// alarm.
TEST(SensorWatch, WhatASwingFoundSaysHowFarItIsToBeBelieved)
{
    profile::Profile profile;
    profile.sensor.deviation = {.a1 = 8_deg, .sigma = 1.5_deg, .elevation = 20_deg};
    SensorWatchRig rig(profile);
    rig.heading = curveOf(profile.sensor, profile.sensor.declinationInSensor).reading(100_deg).angle();
    rig.run(3.0);
    EXPECT_NEAR(rig.watch.status().azimuthSigma->degrees(), 1.5, 1e-9);
    rig.elevation = 80_deg;
    rig.run(5.0);
    EXPECT_GT(*rig.watch.status().azimuthSigma, 5_deg) << "swung lower down";
    rig.elevation = 20_deg;
    rig.run(6.0);
    ASSERT_TRUE(rig.watch.evidence().azimuth);

    rig.profile.sensor.deviation.unreliable = {{.from = 90_deg, .to = 130_deg}};
    rig.setProfile(rig.profile);
    EXPECT_FALSE(rig.watch.status().azimuthSigma);
    EXPECT_FALSE(rig.watch.evidence().azimuth);
    EXPECT_THAT(rig.watch.status().doubt.toStdString(),
                HasSubstr("steel disturbs its compass near 100.0° (result of the swing)"));
    rig.heading = curveOf(profile.sensor, profile.sensor.declinationInSensor).reading(120_deg).angle();
    rig.run(10.0);
    EXPECT_EQ(rig.alarmText(), "") << "20° off, but nothing is to be made of it there";
    rig.axes->azimuth = 140_deg;
    rig.run(8.0);
    EXPECT_THAT(rig.alarmText(), HasSubstr("differ by 20.0° in azimuth"));
}

// Story: beside steel the warning stayed after the swing. The steel had turned the heading out of its own sector.
// REQ-WITNESS-41a: The azimuth of the mount decides whether steel disturbs a value of the sensor. The heading of the
// sensor decides only while the position of the mount is unknown.
TEST(SensorWatch, TheMountAndNotTheDeflectedHeadingIsInASectorWithSteel)
{
    profile::Profile profile;
    profile.sensor.deviation = {
        .a1 = 8_deg, .sigma = 1.5_deg, .elevation = 20_deg, .unreliable = {{.from = 200_deg, .to = 230_deg}}};
    SensorWatchRig rig(profile);
    const auto read = [&](Angle azimuth, Angle heading) {
        rig.axes = SkyPointing{.azimuth = azimuth, .elevation = 20_deg};
        rig.heading = curveOf(profile.sensor, profile.sensor.declinationInSensor).reading(heading).angle();
        rig.run(10.0);
    };
    read(218_deg, 233_deg);
    EXPECT_EQ(rig.alarmText(), "");
    EXPECT_FALSE(rig.watch.status().azimuthDifference);
    EXPECT_FALSE(rig.watch.status().azimuthSigma);
    EXPECT_FALSE(rig.watch.evidence().azimuth);
    EXPECT_THAT(rig.watch.status().doubt.toStdString(), HasSubstr("near 218.0°"));
    read(190_deg, 205_deg);
    EXPECT_THAT(rig.alarmText(), HasSubstr("differ by 15.0° in azimuth"));
    EXPECT_TRUE(rig.watch.evidence().azimuth);

    rig.axes.reset();
    rig.run(2.0);
    EXPECT_FALSE(rig.watch.evidence().azimuth) << "only the heading is known, and it is in the sector";
}

// The sensor averages. While the mount enters a sector, a part of the average comes from there.
// REQ-WITNESS-41a
TEST(SensorWatch, AValueThatIsPartlyFromASectorDoesNotCount)
{
    profile::Profile profile;
    profile.sensor.deviation = {.a1 = 8_deg, .unreliable = {{.from = 200_deg, .to = 230_deg}}};
    SensorWatchRig rig(profile);
    const auto counts = [&](Angle azimuth) {
        rig.axes->azimuth = azimuth;
        rig.heading = curveOf(profile.sensor, profile.sensor.declinationInSensor).reading(azimuth).angle();
        rig.run(1.0);
        return rig.watch.status().azimuthDifference.has_value();
    };
    rig.axes->azimuth = 196_deg;
    rig.run(3.0);
    EXPECT_TRUE(counts(196_deg));
    EXPECT_TRUE(counts(199_deg));
    EXPECT_FALSE(counts(202_deg));
    EXPECT_FALSE(counts(231_deg)) << "it was measured on the way";
    EXPECT_TRUE(counts(231_deg));
}

TEST(SensorWatch, TheDeclinationOfTheSiteCountsOnceItIsKnown)
{
    profile::Profile profile;
    profile.sensor.declinationBy = geomagnetism::DeclinationBy::Boresight;
    profile.sensor.declinationFile = "WMM.COF";
    SensorWatchRig rig(profile);
    rig.run(2.0);
    EXPECT_NEAR(rig.watch.status().direction->azimuth.degrees(), 100.0, 1e-9);
    rig.watch.setSiteDeclination(-14.93_deg);
    rig.run(2.0);
    EXPECT_NEAR(rig.watch.status().direction->azimuth.degrees(), 80.0, 1e-9);
    EXPECT_NEAR(rig.watch.status().declination.degrees(), -14.93, 1e-9);
    EXPECT_THAT(rig.watch.status().declinationText.toStdString(), HasSubstr("magnetic model"));
    rig.watch.setSiteDeclination(failure(ErrorCode::NoDevice, QStringLiteral("WMM.COF: no such file")));
    rig.run(2.0);
    EXPECT_NEAR(rig.watch.status().direction->azimuth.degrees(), 100.0, 1e-9) << "not known is not 0";
}

TEST(SensorWatch, TellsTheMagneticModelAndWhatIsWrongWithTheDeclination)
{
    profile::Profile profile;
    {
        SensorWatchRig typed(profile);
        EXPECT_EQ(QString(), typed.watch.status().declinationDoubt) << "nobody has typed one";
    }
    profile.sensor.declination = 12_deg;  // and the sensor adds the declination of Berlin
    {
        SensorWatchRig typed(profile);
        EXPECT_THAT(typed.watch.status().declinationDoubt.toStdString(), HasSubstr("off"));
    }
    profile.sensor.declinationBy = geomagnetism::DeclinationBy::Boresight;
    profile.sensor.declinationFile = "WMM.COF";
    SensorWatchRig rig(profile);
    rig.watch.setSiteDeclination(12_deg, QStringLiteral("WMM-2025, 2025.0 to 2030.0"));
    EXPECT_EQ(QStringLiteral("WMM-2025, 2025.0 to 2030.0"), rig.watch.status().declinationModel);
    EXPECT_EQ(QString(), rig.watch.status().declinationDoubt);
    rig.watch.setSiteDeclination(12_deg, QStringLiteral("WMM-2020, 2020.0 to 2025.0"), QStringLiteral("it has ended"));
    EXPECT_EQ(QStringLiteral("it has ended"), rig.watch.status().declinationDoubt);
    rig.watch.setSiteDeclination(failure(ErrorCode::NoDevice, QStringLiteral("WMM.COF: no such file")));
    EXPECT_EQ(QStringLiteral("WMM.COF: no such file"), rig.watch.status().declinationDoubt);
    EXPECT_EQ(QString(), rig.watch.status().declinationModel);
}

TEST(SensorWatch, TellsRestartsAndUnknownFieldsOnce)
{
    SensorWatchRig rig;
    rig.unknown = "12.5,hPa";
    rig.run(5.0);
    rig.calibration = orientation::Calibration{};
    rig.run(5.0);
    const std::string log = rig.logText();
    EXPECT_THAT(log, HasSubstr("contain unknown fields: 12.5,hPa"));
    EXPECT_THAT(log, HasSubstr("sensor restarted"));
    EXPECT_EQ(std::ranges::count(log, '\n'), 3) << log;
}

}  // namespace
}  // namespace boresight
