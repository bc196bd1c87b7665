// SPDX-License-Identifier: GPL-3.0-or-later
// A scan across the Sun with the received power of a small dish: what ends it, and where its readings count.
#include "tests/core/north/calibration_sun.h"
#include "tests/fakes/text_of.h"

#include <cmath>

namespace boresight {
namespace {

using namespace boresight::literals;
using ephemeris::Body;

// Received power in dB with a beam 6° wide.
double receivedPower(CalibrationRig& rig)
{
    const double off = apart(rig.beam(), rig.status().bodies.at(0).direction);
    return -60.0 - 12.0 * off * off / (6.0 * 6.0);
}

bool scans(CalibrationRig& rig)
{
    return rig.status().progress.run == CalibrationRun::CrossScan;
}

// Enters this number of powers, each as soon as the scan asks for it.
void givePowers(CalibrationRig& rig, int places)
{
    for (int i = 0; i < 200000 && places > 0 && scans(rig); ++i) {
        rig.tick();
        if (rig.status().wantsPower) {
            ASSERT_TRUE(rig.ask(request::GivePower{receivedPower(rig)}));
            --places;
        }
    }
}

void scanToTheEnd(CalibrationRig& rig)
{
    givePowers(rig, 18);
    rig.runOut();
    rig.tick();
}

void startScan(CalibrationRig& rig, Angle width = 8_deg, bool overTheTop = false)
{
    setHour(rig, 8.0);
    follow(rig, Body::Sun, overTheTop);
    const auto started = rig.ask(request::StartCrossScan{.width = width, .body = Body::Sun});
    ASSERT_TRUE(started) << textOf(started.error());
}

// REQ-NORTH-38d
// REQ-NORTH-38e (CalibrationScan.*): A reading counts for the place to which the beam was sent, once the beam is there.
// Before the scan begins, the cross through its middle must be permitted. Each place, also of the second line, is
// checked again when the beam is sent there. A scan ends when the beam cannot reach its place, or when it is nudged or
// stopped. After that the beam points beside the body and does not track it, so no point can be taken.
TEST(CalibrationScan, FindsTheSun)
{
    SwungRig rig;
    startScan(rig);
    scanToTheEnd(rig);
    ASSERT_TRUE(rig.status().scan) << rig.status().progress.outcome.toStdString();
    ASSERT_EQ(1U, rig.status().points.size());
    const PointStatus point = rig.status().points.front();
    EXPECT_LT(apart(rig.model.toSky(point.axes), point.truth), 0.1);
}

// REQ-NORTH-37e
TEST(CalibrationScan, EndsWhenTheClockIsSet)
{
    SwungRig rig;
    startScan(rig);
    givePowers(rig, 5);
    ASSERT_TRUE(scans(rig));
    rig.desk.clockWasSet();
    rig.run(Seconds(3.0));
    EXPECT_FALSE(scans(rig));
    EXPECT_TRUE(rig.status().progress.failed);
    EXPECT_TRUE(rig.status().progress.outcome.startsWith(QStringLiteral("The clock of this computer was set")))
        << rig.status().progress.outcome.toStdString();
    EXPECT_TRUE(rig.status().points.empty());
    EXPECT_EQ(StationState::Hold, rig.state());
}

// The peak of the last scan must not count as the peak of this one.
// REQ-NORTH-38d
TEST(CalibrationScan, ForgetsWhatTheLastOneFound)
{
    SwungRig rig;
    startScan(rig);
    scanToTheEnd(rig);
    ASSERT_TRUE(rig.status().scan);
    ASSERT_TRUE(rig.ask(request::StartCrossScan{.width = 8_deg, .body = Body::Sun}));
    ASSERT_TRUE(rig.ask(request::EndCalibration{}));
    rig.tick();
    EXPECT_FALSE(rig.status().scan);
}

// A Sun of 2 dB in a beam of 6° is the usual case with a small dish.
// REQ-NORTH-38d
TEST(CalibrationScan, FindsAWeakSun)
{
    SwungRig rig;
    startScan(rig, 12_deg);
    for (int i = 0; i < 200000 && scans(rig); ++i) {
        rig.tick();
        if (rig.status().wantsPower) {
            const double power = std::pow(10.0, (receivedPower(rig) + 60.0) / 10.0);
            ASSERT_TRUE(rig.ask(request::GivePower{-70.0 + 10.0 * std::log10(1.0 + 0.6 * power)}));
        }
    }
    rig.tick();
    ASSERT_TRUE(rig.status().scan) << rig.status().progress.outcome.toStdString();
    EXPECT_NEAR(6.0, rig.status().scan->across.halfPowerWidth.degrees(), 0.2);
    const PointStatus point = rig.status().points.front();
    EXPECT_LT(apart(rig.model.toSky(point.axes), point.truth), 0.1);
}

struct OverTheTopRig : CalibrationRig
{
    OverTheTopRig() : CalibrationRig({}, profileOverTheTop())
    {
        profile::Profile nearNorth = profile;
        nearNorth.pointing.azimuthOffset = 36.0_deg;
        nearNorth.pointing.elevationOffset = 0.8_deg;
        setProfile(nearNorth);
    }
};

// Over the top, left and right are exchanged, and up and down as well.
TEST(CalibrationScan, FindsTheSunOverTheTop)
{
    OverTheTopRig rig;
    startScan(rig, 8_deg, true);
    scanToTheEnd(rig);
    ASSERT_TRUE(rig.status().scan) << rig.status().progress.outcome.toStdString();
    ASSERT_EQ(1U, rig.status().points.size());
    const PointStatus point = rig.status().points.front();
    EXPECT_GT(point.axes.elevation, 90_deg);
    EXPECT_LT(apart(pointing::upright(rig.model.toSky(point.axes)), point.truth), 0.1);
}

// The Sun sinks during the scan: a place beyond the limits must not become a place on the other side of the zenith.
TEST(CalibrationScan, OverTheTopStaysThere)
{
    OverTheTopRig rig;
    setHour(rig, 14.0);
    follow(rig, Body::Sun, true);
    profile::Profile narrow = rig.profile;
    narrow.limits.elevation.max = rig.axes().elevation + 4.1_deg;
    rig.setProfile(narrow);
    const auto started = rig.ask(request::StartCrossScan{.width = 8_deg, .body = Body::Sun});
    ASSERT_TRUE(started) << textOf(started.error());
    rig.run(Seconds(60.0));  // the operator has not entered the power yet
    for (int i = 0; i < 200000 && scans(rig); ++i) {
        rig.tick();
        ASSERT_GT(rig.axes().elevation, 120_deg);
        if (rig.status().wantsPower) {
            static_cast<void>(rig.ask(request::GivePower{receivedPower(rig)}));
        }
    }
    rig.run(Seconds(20.0));
    EXPECT_GT(rig.axes().elevation, 120_deg);
    EXPECT_FALSE(rig.status().scan);
    EXPECT_TRUE(rig.status().points.empty());
    EXPECT_FALSE(rig.status().following);
}

// A few lost replies are no fault and do not end the stream, but they end the scan. The scan must not leave a beam that
// tracks four degrees beside the Sun and could be taken as a point.
TEST(CalibrationScan, OneThatIsCutShortLeavesNoBeamBesideTheSun)
{
    SwungRig rig(calibratedAtFullRate());
    startScan(rig);
    givePowers(rig, 2);
    rig.azimuth.mute = rig.elevation.mute = true;
    rig.run(Seconds(0.16));
    EXPECT_FALSE(rig.mount.seen());
    rig.azimuth.mute = rig.elevation.mute = false;
    rig.run(Seconds(3.0));
    if (scans(rig)) {
        scanToTheEnd(rig);
        ASSERT_TRUE(rig.status().scan);
        return;
    }
    EXPECT_FALSE(rig.status().following);
    EXPECT_EQ(StationState::Hold, rig.state());
    EXPECT_FALSE(rig.ask(request::TakePoint{}));
}

// At the place where a scan was held nobody has centred the Sun.
TEST(CalibrationScan, WhereItWasHeldIsNoPoint)
{
    SwungRig rig;
    startScan(rig);
    givePowers(rig, 2);
    ASSERT_TRUE(rig.ask(request::Hold{}));
    rig.run(Seconds(5.0));
    EXPECT_TRUE(rig.status().progress.failed);
    const auto refused = rig.ask(request::TakePoint{});
    ASSERT_FALSE(refused);
    EXPECT_NE(std::string::npos, textOf(refused.error()).find("Track the Sun"));
    follow(rig);
    EXPECT_TRUE(rig.ask(request::TakePoint{}));
}

// Angle on the sky between the peak that was found and the Sun.
double peakError(CalibrationRig& rig)
{
    if (rig.status().points.empty()) {
        ADD_FAILURE() << rig.status().progress.outcome.toStdString();
        return 360.0;
    }
    const PointStatus point = rig.status().points.front();
    return apart(rig.model.toSky(point.axes), point.truth);
}

CalibrationRig slowRig(AngularRate speed)
{
    profile::Profile slow = calibratedProfile();
    slow.azimuth.limits.speed = slow.elevation.limits.speed = speed;
    slow.pointing.azimuthOffset = 36_deg;
    return CalibrationRig({}, slow);
}

// The power is entered as soon as the scan asks for it: by then the beam must be at the place.
TEST(CalibrationScan, ASlowMountIsWaitedForAtEachPlace)
{
    for (const AngularRate speed : {2_deg_s, 0.5_deg_s}) {
        CalibrationRig rig = slowRig(speed);
        setHour(rig, 8.0);
        rig.goTo(60.0, 40.0);
        rig.run(Seconds(300.0));
        follow(rig);
        ASSERT_TRUE(rig.ask(request::StartCrossScan{.width = 8_deg, .body = Body::Sun}));
        while (scans(rig)) {
            rig.tick();
            if (rig.status().wantsPower) {
                EXPECT_TRUE(rig.control.onTarget(0.05_deg));
                ASSERT_TRUE(rig.ask(request::GivePower{receivedPower(rig)}));
            }
        }
        rig.tick();
        EXPECT_LT(peakError(rig), 0.03);
    }
}

// The beam does not go to a forbidden place, so its power would belong to another place.
TEST(CalibrationScan, IsRefusedWhereItsPlacesAreForbidden)
{
    SwungRig rig;
    setHour(rig, 3.2);
    follow(rig);
    ASSERT_LT(rig.status().bodies.at(0).direction.elevation, 3_deg);
    const auto refused = rig.ask(request::StartCrossScan{.width = 20_deg, .body = Body::Sun});
    ASSERT_FALSE(refused);
    // Story: the reason stood in the middle of a sentence, although the reason often has two sentences itself.
    const std::string why = textOf(refused.error());
    ASSERT_NE(std::string::npos, why.find("smaller width"));
    EXPECT_LT(why.find("smaller width"), why.find("permitted: "));
    EXPECT_TRUE(rig.ask(request::StartCrossScan{.width = 1_deg, .body = Body::Sun}));
}

TEST(CalibrationScan, EndsWhereTheBeamDoesNotGetToItsPlace)
{
    SwungRig rig;
    startScan(rig);
    givePowers(rig, 2);
    profile::Profile drawn = rig.profile;
    const AxisPosition here = rig.axes();
    // The keep-out lies across all places that are still to be scanned.
    drawn.limits.keepOuts.push_back({.name = "crane",
                                     .azimuthFrom = rig.beam().azimuth + 0.7_deg,
                                     .azimuthTo = rig.beam().azimuth + 5.0_deg,
                                     .elevationMin = here.elevation - 10_deg,
                                     .elevationMax = here.elevation + 10_deg});
    rig.setProfile(drawn);
    scanToTheEnd(rig);
    EXPECT_TRUE(rig.status().progress.failed);
    EXPECT_FALSE(rig.status().scan);
    EXPECT_FALSE(rig.status().following);
}

TEST(CalibrationScan, EndsWhenItIsNudged)
{
    SwungRig rig;
    startScan(rig);
    givePowers(rig, 4);
    ASSERT_TRUE(rig.ask(request::Nudge{.azimuth = 1.5_deg, .elevation = {}}));
    rig.run(Seconds(1.0));
    EXPECT_FALSE(scans(rig));
    EXPECT_TRUE(rig.status().progress.outcome.contains(QStringLiteral("by hand")));
    EXPECT_TRUE(rig.status().points.empty());
}

// The radio refraction applies to the scan only.
TEST(CalibrationScan, LeavesTheRefractionAsItWas)
{
    SwungRig rig;
    startScan(rig);
    EXPECT_EQ(ephemeris::Refraction::Radio, rig.status().refraction);
    scanToTheEnd(rig);
    ASSERT_TRUE(rig.status().scan);
    EXPECT_EQ(ephemeris::Refraction::Light, rig.status().refraction);
    ASSERT_TRUE(rig.ask(request::StartCrossScan{.width = 8_deg, .body = Body::Sun}));
    ASSERT_TRUE(rig.ask(request::EndCalibration{}));
    EXPECT_EQ(ephemeris::Refraction::Light, rig.status().refraction);
}

}  // namespace
}  // namespace boresight
