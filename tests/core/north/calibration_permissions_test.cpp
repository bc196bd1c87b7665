// SPDX-License-Identifier: GPL-3.0-or-later
// The permissions that the station publishes for each calibration action agree with the answers of the desk.
#include "core/north/calibration_gates.h"
#include "tests/core/north/calibration_sun.h"
#include "tests/core/north/calibration_swing.h"
#include "tests/fakes/text_of.h"

#include <array>
#include <ostream>
#include <string>

namespace boresight {
namespace {

using namespace boresight::literals;
using ephemeris::Body;
using Situation = void (*)(CalibrationRig&);

void atStart(CalibrationRig&) {}

void standing(CalibrationRig& rig)
{
    setHour(rig, 8.0);
    rig.goTo(200.0, 30.0);
}

void moving(CalibrationRig& rig)
{
    standing(rig);
    ASSERT_TRUE(rig.ask(request::PointAxes{{.azimuth = 260_deg, .elevation = 30_deg}}));
    rig.run(Seconds(2.0));
}

void silentSensor(CalibrationRig& rig)
{
    standing(rig);
    rig.speaks = false;
    rig.run(Seconds(30.5));  // the texts name whole seconds
}

void stopped(CalibrationRig& rig)
{
    standing(rig);
    ASSERT_TRUE(rig.ask(request::Stop{}));
    rig.run(Seconds(1.0));
}

void withoutASite(CalibrationRig& rig)
{
    standing(rig);
    profile::Profile nowhere = rig.profile;
    nowhere.site.known = false;
    rig.setProfile(nowhere);
    rig.run(Seconds(1.0));
}

void atNight(CalibrationRig& rig)
{
    standing(rig);
    setHour(rig, 23.0);
    rig.run(Seconds(1.0));
}

void following(CalibrationRig& rig)
{
    setHour(rig, 8.0);
    follow(rig);
}

void followingStopped(CalibrationRig& rig)
{
    following(rig);
    ASSERT_TRUE(rig.ask(request::Stop{}));
    rig.run(Seconds(1.0));
}

void swinging(CalibrationRig& rig)
{
    swingHalfWay(rig);
}

void scanning(CalibrationRig& rig)
{
    following(rig);
    ASSERT_TRUE(rig.ask(request::StartCrossScan{.width = 8_deg, .body = Body::Sun}));
}

void scanThatWantsAPower(CalibrationRig& rig)
{
    scanning(rig);
    for (int i = 0; i < 3000 && !rig.status().wantsPower; ++i) {
        rig.tick();
    }
    ASSERT_TRUE(rig.status().wantsPower);
}

void averaging(CalibrationRig& rig)
{
    standing(rig);
    ASSERT_TRUE(rig.ask(request::MeasureSensorOffset{}));
    rig.run(Seconds(1.0));
}

void withAPoint(CalibrationRig& rig)
{
    standing(rig);
    ASSERT_TRUE(rig.ask(request::TakeKnownPoint{.truth = {.azimuth = 10_deg, .elevation = 30_deg}, .label = {}}));
    rig.run(Seconds(0.5));
}

void swingingWithAPoint(CalibrationRig& rig)
{
    withAPoint(rig);
    swingHalfWay(rig);
}

void withAProposal(CalibrationRig& rig)
{
    standing(rig);
    ASSERT_TRUE(rig.ask(request::ProposeTerms{{.azimuthOffset = 12_deg}}));
    rig.run(Seconds(0.5));
}

void onTheWayWithAProposal(CalibrationRig& rig)
{
    withAProposal(rig);
    ASSERT_TRUE(rig.ask(request::PointSky{{.azimuth = 260_deg, .elevation = 30_deg}}));
    rig.run(Seconds(2.0));
}

void applied(CalibrationRig& rig)
{
    withAProposal(rig);
    ASSERT_TRUE(rig.apply());
    rig.run(Seconds(0.5));
}

void appliedAndChangedByHand(CalibrationRig& rig)
{
    applied(rig);
    profile::Profile changed = rig.profile;
    changed.pointing.azimuthOffset = 13_deg;
    rig.setProfile(changed);
    rig.run(Seconds(0.5));
}

void undone(CalibrationRig& rig)
{
    applied(rig);
    ASSERT_TRUE(rig.ask(request::UndoCalibration{}));
    rig.run(Seconds(0.5));
}

// The permissions as the station publishes them. Planning a swing changes nothing else but renews the status, so that
// no age in a text differs.
Permissions published(CalibrationRig& rig)
{
    EXPECT_TRUE(rig.ask(request::PlanSwing{.rate = kSweep.rate, .headings = kSweep.headings}));
    StationStatus status = rig.control.status();
    rig.desk.fill(status);
    judgeCalibration(status);
    return status.permissions;
}

constexpr std::array kAsked{
    Action::AverageSensor,       Action::Swing,           Action::FollowSun,      Action::FollowMoon,
    Action::FollowSunOverTheTop, Action::ScanSun,         Action::ScanMoon,       Action::GivePower,
    Action::TakeKnownPoint,      Action::ChangePoints,    Action::ProposeTerms,   Action::ApplyCalibration,
    Action::DiscardCalibration,  Action::UndoCalibration, Action::RedoCalibration};

// The request that the screen sends for this action.
CalibrationRequest requestOf(Action action, const std::optional<CalibrationProposal>& proposal)
{
    const std::uint64_t number = proposal ? proposal->number : 0;
    switch (action) {
        case Action::AverageSensor:
            return request::MeasureSensorOffset{};
        case Action::Swing:
            return kSweep;
        case Action::FollowSun:
            return request::FollowBody{.body = Body::Sun};
        case Action::FollowMoon:
            return request::FollowBody{.body = Body::Moon};
        case Action::FollowSunOverTheTop:
            return request::FollowBody{.body = Body::Sun, .overTheTop = true};
        case Action::TakeSun:
            return request::TakePoint{};
        case Action::ScanSun:
            return request::StartCrossScan{.width = 8_deg, .body = Body::Sun};
        case Action::ScanMoon:
            return request::StartCrossScan{.width = 8_deg, .body = Body::Moon};
        case Action::GivePower:
            return request::GivePower{-70.0};
        case Action::TakeKnownPoint:
            return request::TakeKnownPoint{.truth = {.azimuth = 20_deg, .elevation = 30_deg}, .label = {}};
        case Action::ChangePoints:
            return request::DropPoint{0};
        case Action::ProposeTerms:
            return request::ProposeTerms{{.azimuthOffset = 15_deg}};
        case Action::ApplyCalibration:
            return request::ApplyCalibration{number};
        case Action::DiscardCalibration:
            return request::DiscardCalibration{number};
        case Action::UndoCalibration:
            return request::UndoCalibration{};
        default:
            return request::RedoCalibration{};
    }
}

struct Scene
{
    const char* name;
    Situation situation;
};

void PrintTo(const Scene& one, std::ostream* out)
{
    *out << one.name;
}

class CalibrationPermissionsIn : public ::testing::TestWithParam<Scene>
{
protected:
    static void expectAgreement(CalibrationRig& rig, Action action)
    {
        const std::string told = published(rig).reason(action).toStdString();
        const Result<> answer = rig.ask(requestOf(action, rig.status().proposal));
        EXPECT_EQ(told, answer ? std::string() : textOf(answer.error())) << static_cast<int>(action);
    }
};

TEST_P(CalibrationPermissionsIn, AnActionIsAnsweredAsItWasPublished)
{
    CalibrationRig unchanged;
    GetParam().situation(unchanged);
    const Permissions may = published(unchanged);
    for (const Action action : kAsked) {
        if (may.allows(action)) {
            CalibrationRig changed;
            GetParam().situation(changed);
            expectAgreement(changed, action);
        } else {
            expectAgreement(unchanged, action);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(
    CalibrationPermissions, CalibrationPermissionsIn,
    ::testing::Values(Scene{"atStart", atStart}, Scene{"standing", standing}, Scene{"moving", moving},
                      Scene{"silentSensor", silentSensor}, Scene{"stopped", stopped},
                      Scene{"withoutASite", withoutASite}, Scene{"atNight", atNight}, Scene{"following", following},
                      Scene{"scanning", scanning}, Scene{"scanThatWantsAPower", scanThatWantsAPower},
                      Scene{"averaging", averaging}, Scene{"withAPoint", withAPoint},
                      Scene{"swingingWithAPoint", swingingWithAPoint}, Scene{"withAProposal", withAProposal},
                      Scene{"onTheWayWithAProposal", onTheWayWithAProposal}, Scene{"applied", applied},
                      Scene{"appliedAndChangedByHand", appliedAndChangedByHand}, Scene{"undone", undone}),
    [](const auto& one) { return std::string(one.param.name); });

TEST(CalibrationPermissions, ThePointOfABodyIsTakenAsItWasPublished)
{
    for (const Situation situation : {following, scanning, followingStopped}) {
        CalibrationRig rig;
        situation(rig);
        const std::string told = published(rig).reason(Action::TakeSun).toStdString();
        const Result<> answer = rig.ask(request::TakePoint{});
        EXPECT_EQ(told, answer ? std::string() : textOf(answer.error()));
    }
}

// Story: the Hold button was grey during a swing, although Hold ends the swing.
TEST(CalibrationPermissions, HoldIsOfferedDuringARunAndEndsIt)
{
    for (const Situation situation : {swinging, scanning}) {
        CalibrationRig rig;
        situation(rig);
        const Permissions may = published(rig);
        EXPECT_TRUE(may.allows(Action::Hold));
        EXPECT_FALSE(may.allows(Action::Move));
        ASSERT_TRUE(rig.ask(request::Hold{}));
        rig.run(Seconds(2.0));
        EXPECT_EQ(rig.status().progress.run, CalibrationRun::None);
        EXPECT_EQ(rig.state(), StationState::Hold);
    }
}

}  // namespace
}  // namespace boresight
