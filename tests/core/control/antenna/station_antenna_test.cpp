// SPDX-License-Identifier: GPL-3.0-or-later
// Several antennas on one mount: which of their beams the station points.
#include "core/ephemeris/almanac.h"
#include "core/ephemeris/refraction.h"
#include "core/targets/target_path.h"
#include "core/units/angle_between.h"
#include "tests/core/control/station_rig.h"
#include "tests/fakes/low_orbit.h"
#include "tests/fakes/text_of.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

namespace boresight {
namespace {

using testing::HasSubstr;

constexpr Site kMast{.latitude = 38.757_deg, .longitude = -9.117_deg, .heightMetres = 80.0};

profile::Profile withAntennas()
{
    profile::Profile profile;
    profile.site = {
        .known = true, .latitude = kMast.latitude, .longitude = kMast.longitude, .heightMetres = kMast.heightMetres};
    profile.antennas = {{.name = "70 cm", .beamWidth = 20_deg, .across = 2_deg, .up = 3_deg},
                        {.name = "13 cm", .beamWidth = 1_deg, .across = -8_deg}};
    profile.satellites = {{.number = 25544, .note = {}, .antenna = "70 cm"}};
    profile.control.tickHz = 20;  // the lowest, because passes last for minutes
    profile.control.watchdog = Seconds(0.2);
    return profile;
}

class StationAntenna : public ::testing::Test
{
protected:
    explicit StationAntenna(const profile::Profile& profile = withAntennas()) : rig(profile) { rig.run(Seconds(0.5)); }

    // Empty if accepted, else the reason.
    std::string ask(const Request& request, const Source& by = kOperator)
    {
        const Result<> answer = rig.ask(request, by);
        return answer ? std::string() : textOf(answer.error());
    }
    std::string use(const std::string& name, const Source& by = kOperator)
    {
        return ask(request::UseAntenna{name}, by);
    }
    [[nodiscard]] std::string inUse() const { return rig.control.status().antenna; }
    [[nodiscard]] AxisPosition axes() const
    {
        const StationStatus status = rig.control.status();
        return {*status.azimuth.commanded, *status.elevation.commanded};
    }
    // A pass that begins within half an hour and reaches a high elevation, and its path.
    [[nodiscard]] targets::Target risingSoon() const
    {
        for (int anomaly = 0; anomaly < 360; anomaly += 3) {
            for (int node = 0; node < 360; node += 15) {
                const targets::Target target = targets::satelliteTarget(
                    fakes::lowOrbit(rig.clock.utc(), Angle::fromDegrees(node), Angle::fromDegrees(anomaly)));
                targets::TargetPath path(target, kMast);
                const auto up = path.nextUp(rig.clock.utc());
                const bool isSoon = up && up->sets && up->rises - rig.clock.utc() < std::chrono::minutes(2) &&
                                    up->rises - rig.clock.utc() > std::chrono::minutes(1);
                if (!isSoon) {
                    continue;
                }
                const SkyPointing middle = path.at(up->rises + (*up->sets - up->rises) / 2).value();
                if (middle.elevation > 30_deg && middle.elevation < 60_deg) {
                    return target;
                }
            }
        }
        ADD_FAILURE() << "no orbit has such a pass";
        return {};
    }
    [[nodiscard]] Angle offTarget(const targets::Target& target) const
    {
        return angleBetween(*rig.control.status().commanded,
                            targets::TargetPath(target, kMast).at(rig.clock.utc()).value());
    }
    void runUntil(UtcTime utc)
    {
        while (rig.clock.utc() < utc) {
            rig.tick();
        }
    }
    [[nodiscard]] bool logged(const char* words) const
    {
        return std::ranges::any_of(rig.log.since(0, EventLog::kCapacity),
                                   [&](const LogEntry& line) { return line.text.contains(QLatin1String(words)); });
    }

    StationRig rig;
};

// The axis angles are those of antenna_test.cpp for the same direction.
// REQ-ANTENNA-910: Go-to, actual, target and commanded direction belong to the beam of the antenna in use. After the
// start the main antenna is in use.
TEST_F(StationAntenna, DirectionsAreThoseOfItsBeam)
{
    EXPECT_EQ(inUse(), "main");
    ASSERT_EQ(use("70 cm"), "");
    EXPECT_EQ(inUse(), "70 cm");
    EXPECT_TRUE(logged("antenna \"70 cm\" is in use"));
    ASSERT_TRUE(rig.point(180.0, 60.0, kOperator));
    rig.settle();
    EXPECT_NEAR(rig.azimuthDegrees(), 175.9976, 0.01);
    EXPECT_NEAR(rig.elevationDegrees(), 57.0605, 0.01);
    const StationStatus status = rig.control.status();
    for (const auto& direction : {status.actual, status.commanded, status.target, rig.control.direction()}) {
        ASSERT_TRUE(direction);
        EXPECT_LT(angleBetween(*direction, {180_deg, 60_deg}), 0.01_deg);
    }
    EXPECT_NEAR(status.azimuth.beam.actual->degrees(), 180.0, 0.02);
    EXPECT_LT(angleBetween(*rig.control.directionBy(rig.profile.pointing), {175.9976_deg, 57.0605_deg}), 0.01_deg);
}

// REQ-ANTENNA-911: Choosing another antenna moves nothing. Clients cannot choose one. The choice is refused while a
// client's target is tracked, and while the mount is on its way to a target. An antenna that is not in the profile is
// refused, and the refusal lists the antennas of the profile.
TEST_F(StationAntenna, ToChooseItMovesNothing)
{
    ASSERT_EQ(ask(request::PointAxes{{100_deg, 30_deg}}), "");
    rig.settle();
    const AxisPosition before = axes();
    ASSERT_EQ(use("13 cm"), "");
    rig.run(Seconds(3.0));
    EXPECT_EQ(axes(), before);
    EXPECT_NEAR(rig.control.status().actual->azimuth.degrees(), 100.0 - 9.22, 0.02);  // atan(tan 8° / cos 30°)
    EXPECT_EQ(use("2 m"), "There is no antenna \"2 m\". The profile has \"main\", \"70 cm\", \"13 cm\".");
    EXPECT_NE(use("main", kClient), "");
    EXPECT_EQ(inUse(), "13 cm");

    ASSERT_TRUE(rig.point(200.0, 30.0, kOperator));
    rig.run(Seconds(1.0));
    EXPECT_THAT(use("main"), HasSubstr("moves to a target"));
    EXPECT_THAT(rig.control.status().permissions.reason(Action::UseAntenna).toStdString(),
                HasSubstr("moves to a target"));
    rig.settle();
    EXPECT_EQ(use("main"), "");
    ASSERT_EQ(ask(request::GiveAuthority{}), "");
    ASSERT_TRUE(rig.point(210.0, 30.0, kClient));
    rig.run(Seconds(0.5));
    EXPECT_THAT(use("70 cm"), HasSubstr("tracks a target"));
    EXPECT_EQ(inUse(), "main");
}

// REQ-ANTENNA-912: A satellite that has its own antenna is tracked with it. When the satellite has set, the antenna
// that was chosen by hand is in use again. A satellite without its own antenna is tracked with the one chosen by hand.
TEST_F(StationAntenna, ASatelliteHasItsOwn)
{
    ASSERT_EQ(use("13 cm"), "");
    targets::Target satellite = risingSoon();
    ASSERT_EQ(ask(request::Track{satellite}), "");
    EXPECT_EQ(inUse(), "70 cm");
    const targets::UpTime up = targets::TargetPath(satellite, kMast).nextUp(rig.clock.utc()).value();
    runUntil(up.rises + std::chrono::seconds(60));
    EXPECT_LT(offTarget(satellite), 0.02_deg);
    EXPECT_EQ(rig.control.antenna().beamWidth, 20_deg);
    runUntil(*up.sets + std::chrono::seconds(2));
    EXPECT_FALSE(rig.control.status().tracked);
    EXPECT_EQ(inUse(), "13 cm");

    std::get<orbit::ElementSet>(satellite.kind).number = 7;
    rig.clock.setUtc(up.rises + std::chrono::seconds(60));
    ASSERT_EQ(ask(request::Track{satellite}), "");
    EXPECT_EQ(inUse(), "13 cm");
}

// REQ-ANTENNA-913: While Boresight tracks a target itself another antenna may be chosen. Its beam goes to the target
// within the speed limits, without a jump of the set-points, and tracks it.
TEST_F(StationAntenna, MayBeChosenWhileATargetIsTracked)
{
    const targets::Target satellite = risingSoon();
    ASSERT_EQ(ask(request::Track{satellite}), "");
    const targets::UpTime up = targets::TargetPath(satellite, kMast).nextUp(rig.clock.utc()).value();
    runUntil(up.rises + std::chrono::seconds(90));
    ASSERT_LT(offTarget(satellite), 0.02_deg);
    ASSERT_EQ(use("13 cm"), "");
    EXPECT_GT(offTarget(satellite), 5_deg);
    AxisPosition before = axes();
    for (int i = 0; i < 400; ++i) {
        rig.tick();
        const AxisPosition now = axes();
        const double fastest = 1.001 / rig.profile.control.tickHz;
        ASSERT_LT(std::abs((now.azimuth - before.azimuth).degrees()),
                  rig.profile.azimuth.limits.speed.degrees() * fastest);
        ASSERT_LT(std::abs((now.elevation - before.elevation).degrees()),
                  rig.profile.elevation.limits.speed.degrees() * fastest);
        before = now;
    }
    EXPECT_LT(offTarget(satellite), 0.02_deg);
    EXPECT_EQ(inUse(), "13 cm") << "by hand goes before the antenna of the satellite";
    EXPECT_TRUE(rig.control.status().tracked);
}

// REQ-ANTENNA-914: A target that is refused does not change the antenna in use. Another command that ends the tracking
// applies to the beam in use. That antenna stays in use until the mount holds.
TEST_F(StationAntenna, GoesBackWhenTheMountRests)
{
    const targets::Target satellite = risingSoon();
    ASSERT_EQ(ask(request::Track{satellite}), "");
    ASSERT_EQ(inUse(), "70 cm");
    EXPECT_NE(ask(request::Track{{.name = QStringLiteral("low"), .kind = SkyPointing{100_deg, -20_deg}}}), "");
    EXPECT_EQ(inUse(), "70 cm");
    rig.run(Seconds(1.0));
    ASSERT_TRUE(rig.control.status().tracked);

    ASSERT_TRUE(rig.point(180.0, 60.0, kOperator));
    rig.settle();
    EXPECT_EQ(inUse(), "70 cm");
    EXPECT_LT(angleBetween(*rig.control.status().actual, {180_deg, 60_deg}), 0.01_deg);
    const AxisPosition there = axes();
    ASSERT_EQ(ask(request::Hold{}), "");
    rig.run(Seconds(1.0));
    EXPECT_EQ(inUse(), "main");
    EXPECT_EQ(axes(), there);
}

// REQ-ANTENNA-915: Travel and limits apply to the axes, whatever antenna is in use. Horizon and keep-outs apply to the
// beam of the antenna in use.
TEST_F(StationAntenna, LimitsHoldAtTheMount)
{
    ASSERT_EQ(use("70 cm"), "");
    EXPECT_THAT(ask(request::PointSky{{100_deg, 1_deg}}), HasSubstr("elevation -2.0° below limit 0.0°"));
    EXPECT_EQ(ask(request::PointSky{{100_deg, 4_deg}}), "");
    rig.settle();
    EXPECT_NEAR(rig.elevationDegrees(), 1.0, 0.02);

    profile::Profile drawn = rig.profile;
    drawn.limits.keepOuts = {{"mast", 150_deg, 160_deg, 0_deg, 50_deg}};
    rig.setProfile(drawn);
    EXPECT_THAT(ask(request::PointSky{{155_deg, 20_deg}}), HasSubstr("mast"));
    EXPECT_EQ(ask(request::PointAxes{{161_deg, 20_deg}}), "") << "beyond it is the beam";
    EXPECT_THAT(ask(request::PointAxes{{155_deg, 20_deg}}), HasSubstr("mast"));
    EXPECT_THAT(ask(request::PointAxes{{149.5_deg, 20_deg}}), HasSubstr("mast"));
}

// REQ-ANTENNA-916: If the antenna in use is removed from the profile, the main one is used. A change of its offsets
// that would move the mount is refused.
TEST_F(StationAntenna, FollowsTheProfile)
{
    ASSERT_EQ(use("70 cm"), "");
    ASSERT_EQ(ask(request::PointAxes{{100_deg, 30_deg}}), "");
    rig.settle();
    profile::Profile wider = rig.profile;
    wider.antennas[0].across = 6_deg;
    EXPECT_EQ(ask(request::ApplyProfile{wider}), "");
    rig.setProfile(wider);
    EXPECT_NEAR(rig.control.status().actual->azimuth.degrees(), 107.1432, 0.01);  // atan(tan 6° / cos 33°)
    ASSERT_EQ(ask(request::GiveAuthority{}), "");
    ASSERT_TRUE(rig.point(120.0, 30.0, kClient));
    rig.run(Seconds(0.5));
    profile::Profile without = wider;
    without.antennas.clear();
    without.satellites.clear();
    EXPECT_THAT(ask(request::ApplyProfile{without}), HasSubstr("would move the mount"));
    ASSERT_EQ(ask(request::Hold{}), "");
    rig.settle();
    EXPECT_EQ(ask(request::ApplyProfile{without}), "");
    rig.setProfile(without);
    EXPECT_EQ(inUse(), "main");
    EXPECT_EQ(rig.control.status().actual->azimuth.wrapped360(), rig.control.status().azimuth.actual->wrapped360());
}

// Story: from then on the main beam was pointed, without a report.
// REQ-ANTENNA-919: The antenna in use stays in use when it is renamed, also while a client's target is tracked.
TEST_F(StationAntenna, StaysInUseUnderAnotherName)
{
    ASSERT_EQ(use("70 cm"), "");
    ASSERT_EQ(ask(request::GiveAuthority{}), "");
    ASSERT_TRUE(rig.point(120.0, 30.0, kClient));
    rig.run(Seconds(0.5));
    profile::Profile renamed = rig.profile;
    renamed.antennas[0].name = "UHF";
    renamed.satellites[0].antenna = "UHF";
    EXPECT_EQ(ask(request::ApplyProfile{renamed}), "");
    rig.setProfile(renamed);
    EXPECT_EQ(inUse(), "UHF");
    ASSERT_EQ(ask(request::Hold{}), "");
    rig.settle();
    EXPECT_EQ(use("main"), "");
    EXPECT_EQ(use("UHF"), "");
}

// REQ-ANTENNA-918: After the tracking of a satellite was handed over to a client, another antenna for that satellite is
// refused, because it would move the client's beam.
TEST_F(StationAntenna, AnotherChoiceForASatelliteMovesNoClientsBeam)
{
    ASSERT_EQ(ask(request::Track{risingSoon()}), "");
    ASSERT_EQ(ask(request::GiveAuthority{}), "");
    ASSERT_TRUE(rig.point(120.0, 40.0, kClient));
    rig.run(Seconds(0.5));
    ASSERT_EQ(inUse(), "70 cm");
    profile::Profile other = rig.profile;
    other.satellites[0].antenna = "13 cm";
    EXPECT_THAT(ask(request::ApplyProfile{other}), HasSubstr("would move the mount"));
    other.satellites.clear();
    EXPECT_THAT(ask(request::ApplyProfile{other}), HasSubstr("would move the mount"));
    EXPECT_EQ(inUse(), "70 cm");
}

// Lisbon at noon: the Sun stands in the south.
// REQ-ANTENNA-917: Each antenna of the mount is kept away from the Sun, whether in use or not. The alarm names the beam
// that is nearest to the Sun.
TEST_F(StationAntenna, NoneIsPointedAtTheSun)
{
    rig.clock.stepUtc(std::chrono::hours(12));
    ephemeris::Almanac almanac(kMast);
    const SkyPointing sun = ephemeris::apparent(almanac.place(ephemeris::Body::Sun, rig.clock.utc()).direction,
                                                ephemeris::Refraction::Light);
    // In this direction the beam of "13 cm", 8° counterclockwise on the sky, points at the Sun.
    const Angle turn = Angle::fromRadians(std::atan(std::tan((8_deg).radians()) / std::cos(sun.elevation.radians())));
    const SkyPointing beside{.azimuth = sun.azimuth + turn, .elevation = sun.elevation};
    profile::Profile away = rig.profile;
    away.sun = {.keepAway = profile::KeepAway::On, .radius = 5_deg};
    away.antennas.clear();
    away.satellites.clear();
    rig.setProfile(away);
    rig.run(Seconds(0.2));
    EXPECT_EQ(ask(request::PointSky{beside}), "") << "the main beam alone may look there";
    rig.settle();
    EXPECT_TRUE(rig.control.alarms().list().empty());

    away.antennas = withAntennas().antennas;
    rig.setProfile(away);
    rig.run(Seconds(0.2));
    EXPECT_TRUE(std::ranges::any_of(rig.control.alarms().list(), [](const Alarm& alarm) {
        return alarm.name == QStringLiteral("sun.near") && alarm.active;
    }));
    ASSERT_EQ(ask(request::PointSky{{100_deg, 20_deg}}), "");
    rig.settle();
    EXPECT_THAT(ask(request::PointSky{beside}), HasSubstr("Sun"));
}

}  // namespace
}  // namespace boresight
