// SPDX-License-Identifier: GPL-3.0-or-later
// What every rotator promises behind the port of the mount, tried with the control above it. A new driver costs one
// bench here.
#include "core/control/station_control.h"
#include "core/mount/paired_mount.h"
#include "core/simple_mount/simple_mount.h"
#include "core/sources/motion_sources.h"
#include "tests/core/control/station_rig.h"
#include "tests/fakes/manual_clock.h"
#include "tests/fakes/text_of.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <functional>
#include <memory>
#include <string>
#include <tuple>
#include <utility>

namespace boresight {
namespace {

constexpr Seconds kOneTick{0.02};

using profile::AxisDriver;

// Slow enough for every rotator here.
profile::Profile slowProfile(AxisDriver azimuth = AxisDriver::Moteus, AxisDriver elevation = AxisDriver::Moteus)
{
    profile::Profile profile;
    profile.azimuth.driver = azimuth;
    profile.elevation.driver = elevation;
    for (const Axis axis : kAxes) {
        profile::AxisSettings& settings = axis == Axis::Azimuth ? profile.azimuth : profile.elevation;
        settings.limits.speed = AngularRate::fromDegrees(5.0);
    }
    return profile;
}

Angle of(Axis axis, const AxisPosition& place)
{
    return axis == Axis::Azimuth ? place.azimuth : place.elevation;
}

// A rotator, a control above it and a clock that is turned by hand.
class Bench
{
public:
    virtual ~Bench() = default;

    virtual StationControl& control() = 0;
    virtual void tick() = 0;
    [[nodiscard]] virtual AxisPosition truth() = 0;  // where the axes really are
    [[nodiscard]] virtual bool ordered() = 0;        // anything but questions was heard so far
    virtual void setLine(bool connected) = 0;

    [[nodiscard]] Capabilities can() { return control().mount().capabilities(); }
    [[nodiscard]] bool has(Axis axis) { return can().has(axis); }
    // The last that there is.
    [[nodiscard]] Axis someAxis() { return has(Axis::Elevation) ? Axis::Elevation : Axis::Azimuth; }
    [[nodiscard]] Seconds silence() { return can().axes[index(someAxis())]->silence; }  // within this it is reported
    // Of the coarsest axis; of the simulation, at least.
    [[nodiscard]] Angle resolution()
    {
        Angle resolution = Angle::fromDegrees(0.01);
        for (const auto& axis : can().axes) {
            resolution = axis ? std::max(resolution, axis->step) : resolution;
        }
        return resolution;
    }
    // A missing axis has not moved at all.
    void expectAt(const AxisPosition& place, const AxisPosition& before, Angle tolerance)
    {
        for (const Axis axis : kAxes) {
            const Angle expected = has(axis) ? of(axis, place) : of(axis, before);
            EXPECT_LE(abs(of(axis, truth()) - expected), has(axis) ? tolerance : Angle{}) << index(axis);
        }
    }
    [[nodiscard]] bool warns(const char* alarm)
    {
        return std::ranges::any_of(control().status().alarms,
                                   [alarm](const Alarm& one) { return one.name == QLatin1String(alarm); });
    }

    void run(Seconds time)
    {
        for (Seconds left = time; left > Seconds(0.0); left -= kOneTick) {
            tick();
        }
    }
    Result<> ask(const Request& request) { return control().request(request, kOperator); }
    Result<> goTo(double azimuth, double elevation)
    {
        return ask(request::PointAxes{{Angle::fromDegrees(azimuth), Angle::fromDegrees(elevation)}});
    }
    // Whether the axes stand where they did `time` ago.
    [[nodiscard]] bool stands(Seconds time)
    {
        const AxisPosition before = truth();
        run(time);
        return truth() == before;
    }
};

class MoteusBench final : public Bench
{
public:
    explicit MoteusBench(const profile::Profile& profile = slowProfile()) : m_rig(profile) {}
    StationControl& control() override { return m_rig.control; }
    [[nodiscard]] StationRig& rig() { return m_rig; }
    void tick() override { m_rig.tick(); }
    AxisPosition truth() override
    {
        return {.azimuth = m_rig.profile.azimuth.geometry.toAxis(MotorTurns::fromTurns(m_rig.azimuth.position)),
                .elevation = m_rig.profile.elevation.geometry.toAxis(MotorTurns::fromTurns(m_rig.elevation.position))};
    }
    bool ordered() override { return m_rig.commands() > 0; }
    void setLine(bool connected) override { m_rig.azimuth.silent = m_rig.elevation.silent = !connected; }

private:
    StationRig m_rig;
};

const AxisPosition kBetweenDegrees{.azimuth = Angle::fromDegrees(10.4), .elevation = Angle::fromDegrees(20.6)};

class SimpleBench final : public Bench
{
public:
    explicit SimpleBench(const SimpleMount::Axes& axes = {}, const profile::Profile& profile = slowProfile())
        : m_profile(profile), m_mount(m_box, axes)
    {}
    StationControl& control() override { return m_control; }
    void tick() override
    {
        m_clock.advance(kOneTick);
        m_control.tick();
        m_mount.send();
    }
    AxisPosition truth() override { return m_box.truth(); }
    bool ordered() override { return m_box.orders() > 0; }
    void setLine(bool connected) override { m_box.setPower(connected, m_clock.now()); }

private:
    const profile::InForce m_profile;
    fakes::ManualClock m_clock;
    EventLog m_log{m_clock};
    AlarmBoard m_alarms{m_log, m_clock};
    SimpleBox m_box{kBetweenDegrees};
    SimpleMount m_mount;
    StationControl m_control{m_profile, m_clock, m_log, m_alarms, m_mount, motionSources};
};

// Two rotators, each with a box, a line and an axis of its own.
class PairBench final : public Bench
{
public:
    StationControl& control() override { return m_control; }
    void tick() override
    {
        m_clock.advance(kOneTick);
        m_control.tick();
        m_azimuth.send();
        m_elevation.send();
    }
    AxisPosition truth() override
    {
        return {.azimuth = m_azimuthBox.truth().azimuth, .elevation = m_elevationBox.truth().elevation};
    }
    bool ordered() override { return m_azimuthBox.orders() + m_elevationBox.orders() > 0; }
    void setLine(bool connected) override
    {
        m_azimuthBox.setPower(connected, m_clock.now());
        m_elevationBox.setPower(connected, m_clock.now());
    }
    void setElevationLine(bool connected) { m_elevationBox.setPower(connected, m_clock.now()); }
    // What one of them has turned of the axis that is the other's.
    [[nodiscard]] bool turnedForeignAxes() const
    {
        return m_azimuthBox.truth().elevation != kBetweenDegrees.elevation ||
               m_elevationBox.truth().azimuth != kBetweenDegrees.azimuth;
    }

private:
    const profile::InForce m_profile{slowProfile()};
    fakes::ManualClock m_clock;
    EventLog m_log{m_clock};
    AlarmBoard m_alarms{m_log, m_clock};
    SimpleBox m_azimuthBox{kBetweenDegrees};
    SimpleBox m_elevationBox{kBetweenDegrees};
    SimpleMount m_azimuth{m_azimuthBox, {.azimuth = true, .elevation = false}};
    SimpleMount m_elevation{m_elevationBox, {.azimuth = false, .elevation = true}};
    PairedMount m_mount{m_azimuth, m_elevation};
    StationControl m_control{m_profile, m_clock, m_log, m_alarms, m_mount, motionSources};
};

// A moteus and a simple rotator, an axis each.
class MixedBench final : public Bench
{
public:
    explicit MixedBench(Axis moteus) : m_axis(moteus)
    {
        m_moteus.setFitness({});
        learn();
    }
    StationControl& control() override { return m_control; }
    void tick() override
    {
        m_clock.advance(kOneTick);
        if (m_moteus.needsOrigin(m_axis)) {
            learn();
        }
        m_control.tick();
        for (const CanFrame& frame : m_moteus.frames()) {
            for (fakes::IdealDrive& drive : m_onBus) {
                if (const auto reply = drive.answer(frame, m_clock.now())) {
                    m_moteus.take(*reply);
                }
            }
        }
        m_moteus.framesSent();
        m_simple.send();
    }
    AxisPosition truth() override
    {
        const Angle turned = m_profile->axis(m_axis).geometry.toAxis(MotorTurns::fromTurns(drive().position));
        const AxisPosition box = m_box.truth();
        return m_axis == Axis::Azimuth ? AxisPosition{turned, box.elevation} : AxisPosition{box.azimuth, turned};
    }
    bool ordered() override { return m_box.orders() > 0 || !m_onBus[0].seen.empty() || !m_onBus[1].seen.empty(); }
    void setLine(bool connected) override
    {
        drive().silent = !connected;
        m_box.setPower(connected, m_clock.now());
    }
    void setBoxLine(bool connected) { m_box.setPower(connected, m_clock.now()); }
    // What one of them has turned, or was ordered to, of the axis that is the other's.
    [[nodiscard]] bool turnedForeignAxes() const
    {
        const AxisPosition box = m_box.truth();
        return !m_onBus[1 - index(m_axis)].seen.empty() ||
               (m_axis == Axis::Azimuth ? box.azimuth != kBetweenDegrees.azimuth
                                        : box.elevation != kBetweenDegrees.elevation);
    }

private:
    [[nodiscard]] fakes::IdealDrive& drive() { return m_onBus[index(m_axis)]; }
    // As the survey tells it.
    void learn()
    {
        m_moteus.learn(m_axis, survey::DriveFacts{
                                   .uuid = QStringLiteral("a0000000-0000-0000-0000-000000000001"),
                                   .bootedAt = m_clock.now() - std::chrono::hours(1),
                                   .outputEncoder = false,
                                   .rotorToOutputRatio = 0.01,
                                   .holdsWhenNotFed = true,
                                   .origin = {.origin = moteus::CountOrigin{.beginning = 1, .offset = drive().origin()},
                                              .asked = m_clock.now()}});
    }

    const Axis m_axis;  // of the moteus
    const profile::InForce m_profile{slowProfile(m_axis == Axis::Azimuth ? AxisDriver::Moteus : AxisDriver::Simple,
                                                 m_axis == Axis::Azimuth ? AxisDriver::Simple : AxisDriver::Moteus)};
    fakes::ManualClock m_clock;
    EventLog m_log{m_clock};
    AlarmBoard m_alarms{m_log, m_clock};
    std::array<fakes::IdealDrive, 2> m_onBus{fakes::IdealDrive{1, 0.0}, fakes::IdealDrive{2, -0.25}};
    SimpleBox m_box{kBetweenDegrees};
    MoteusMount m_moteus{m_profile,
                         m_clock,
                         m_log,
                         m_alarms,
                         {.trustFirstContact = true},
                         axesIf(m_axis == Axis::Azimuth, m_axis == Axis::Elevation)};
    SimpleMount m_simple{m_box, {.azimuth = m_axis != Axis::Azimuth, .elevation = m_axis != Axis::Elevation}};
    PairedMount m_mount{m_axis == Axis::Azimuth ? static_cast<MountDriver&>(m_moteus) : m_simple,
                        m_axis == Axis::Azimuth ? static_cast<MountDriver&>(m_simple) : m_moteus};
    StationControl m_control{m_profile, m_clock, m_log, m_alarms, m_mount, motionSources};
};

struct Kind
{
    const char* name;
    std::function<std::unique_ptr<Bench>()> make;
};

// REQ-MOUNT-01 (MountPromises.*): Every driver behind the port of the mount keeps the same promises. Opening it
// moves nothing. The first command holds what was measured. Limits hold. STOP works and latches. Silence is reported in
// the time that its capabilities state. Nothing moves after a fault without a re-arm. A place counts as reached as
// nearly as the rotator can reach it. A rotator without a watchdog is shown once, and that can be acknowledged.
class MountPromises : public testing::TestWithParam<Kind>
{
protected:
    std::unique_ptr<Bench> bench = GetParam().make();
};

TEST_P(MountPromises, OpeningMovesNothing)
{
    const AxisPosition before = bench->truth();
    bench->run(Seconds(3.0));
    EXPECT_FALSE(bench->ordered());
    EXPECT_EQ(bench->truth(), before);
    EXPECT_EQ(bench->control().state(), StationState::Standby);
}

// What can be read and set of its drives is reported by a mount that has a service for it, and by no other.
TEST_P(MountPromises, OnlyAMountWithAServiceReportsItsDrives)
{
    bench->run(Seconds(1.0));
    const StationStatus status = bench->control().status();
    EXPECT_EQ(status.drives.has_value(), bench->control().mount().service() != nullptr);
    EXPECT_TRUE(status.azimuth.turnKnown);
    EXPECT_TRUE(status.elevation.turnKnown);
}

TEST_P(MountPromises, TheFirstCommandHoldsWhatWasMeasured)
{
    bench->run(Seconds(1.0));
    const AxisPosition before = bench->truth();
    const AxisPosition measured = *bench->control().mount().measured();
    ASSERT_TRUE(bench->ask(request::PointAxes{measured}));
    bench->run(Seconds(2.0));
    bench->expectAt(before, before, bench->resolution() / 2.0);
}

TEST_P(MountPromises, GoesWhereItIsSent)
{
    bench->run(Seconds(1.0));
    const AxisPosition before = bench->truth();
    ASSERT_TRUE(bench->goTo(60.0, 45.0));
    bench->run(Seconds(25.0));
    bench->expectAt({60_deg, 45_deg}, before, bench->resolution());
}

// Story: a rotator of whole degrees was slewing for ever to a place between two of them.
TEST_P(MountPromises, APlaceBetweenItsStepsCountsAsReached)
{
    bench->run(Seconds(1.0));
    ASSERT_TRUE(bench->goTo(60.5, 45.4));
    bench->run(Seconds(3.0));
    EXPECT_EQ(bench->control().state(), StationState::Slew);
    bench->run(Seconds(22.0));
    EXPECT_EQ(bench->control().state(), StationState::Hold);
}

TEST_P(MountPromises, LimitsHold)
{
    bench->run(Seconds(1.0));
    const Axis axis = bench->someAxis();
    const StationStatus status = bench->control().status();
    const Angle end = axis == Axis::Azimuth ? status.azimuth.travel.min : status.elevation.travel.min;
    const double outside = end.degrees() - 5.0;
    EXPECT_FALSE(axis == Axis::Azimuth ? bench->goTo(outside, 45.0) : bench->goTo(60.0, outside))
        << "a place outside is refused";
    const AngularRate down = AngularRate::fromDegrees(-5.0);
    ASSERT_TRUE(
        bench->ask(request::Move{axis == Axis::Azimuth ? AxisRates{.azimuth = down} : AxisRates{.elevation = down}}));
    for (int i = 0; i < 1500; ++i) {
        bench->tick();
        ASSERT_GE(of(axis, bench->truth()), end - bench->resolution() / 2.0);
    }
    EXPECT_LE(of(axis, bench->truth()), end + bench->resolution()) << "it went that far";
}

TEST_P(MountPromises, StopWorksAndLatches)
{
    bench->run(Seconds(1.0));
    ASSERT_TRUE(bench->goTo(90.0, 60.0));
    bench->run(Seconds(3.0));
    ASSERT_TRUE(bench->ask(request::Stop{}));
    bench->run(Seconds(2.0));
    EXPECT_TRUE(bench->stands(Seconds(3.0)));
    EXPECT_LT(bench->truth().azimuth, 60_deg) << "far from where it was sent";
    EXPECT_LT(bench->truth().elevation, 55_deg);
    EXPECT_FALSE(bench->goTo(90.0, 60.0));
    ASSERT_TRUE(bench->ask(request::ResetStop{}));
    EXPECT_TRUE(bench->stands(Seconds(3.0)));
}

TEST_P(MountPromises, SilenceIsReportedInItsOwnTime)
{
    bench->run(Seconds(1.0));
    ASSERT_TRUE(bench->goTo(90.0, 60.0));
    bench->run(Seconds(3.0));
    bench->setLine(false);
    bench->run(bench->silence() + Seconds(0.1));
    EXPECT_EQ(bench->control().state(), StationState::Disconnected);
    EXPECT_TRUE(bench->control().faultLatched());
    EXPECT_FALSE(bench->goTo(90.0, 60.0));
}

TEST_P(MountPromises, NothingMovesAfterAFaultWithoutARearm)
{
    bench->run(Seconds(1.0));
    ASSERT_TRUE(bench->goTo(90.0, 60.0));
    bench->run(Seconds(3.0));
    bench->setLine(false);
    bench->run(Seconds(2.0));
    bench->setLine(true);
    bench->run(Seconds(1.0));
    EXPECT_TRUE(bench->stands(Seconds(5.0)));
    EXPECT_EQ(bench->control().state(), StationState::Fault);
    EXPECT_FALSE(bench->goTo(90.0, 60.0));
    ASSERT_TRUE(bench->ask(request::Rearm{}));
    bench->run(Seconds(1.0));
    EXPECT_TRUE(bench->stands(Seconds(3.0))) << "a re-arm moves nothing either";
}

TEST_P(MountPromises, TheEndOfTheProgramLeavesItStanding)
{
    bench->run(Seconds(1.0));
    ASSERT_TRUE(bench->goTo(90.0, 60.0));
    bench->run(Seconds(3.0));
    bench->control().shutDown();
    for (int i = 0; i < 500 && !bench->control().shutDownDone(); ++i) {
        bench->tick();
    }
    ASSERT_TRUE(bench->control().shutDownDone());
    EXPECT_TRUE(bench->stands(Seconds(3.0)));
}

TEST_P(MountPromises, AMissingWatchdogIsShownOnceAndCanBeAcknowledged)
{
    bench->run(Seconds(1.0));
    const bool watchdog =
        std::ranges::all_of(bench->can().axes, [](const auto& axis) { return !axis || axis->watchdog; });
    EXPECT_EQ(bench->warns("mount.no-watchdog"), !watchdog);
    ASSERT_TRUE(bench->ask(request::AcknowledgeAlarms{}));
    bench->run(Seconds(5.0));
    for (const Alarm& alarm : bench->control().status().alarms) {
        EXPECT_TRUE(alarm.acknowledged) << alarm.name.toStdString();
    }
}

std::unique_ptr<Bench> simpleBench(bool azimuth, bool elevation)
{
    return std::make_unique<SimpleBench>(SimpleMount::Axes{.azimuth = azimuth, .elevation = elevation});
}

std::unique_ptr<Bench> moteusBench(AxisDriver azimuth, AxisDriver elevation)
{
    return std::make_unique<MoteusBench>(slowProfile(azimuth, elevation));
}

INSTANTIATE_TEST_SUITE_P(
    Drivers, MountPromises,
    testing::Values(Kind{"TwoMoteus", [] { return std::make_unique<MoteusBench>(); }},
                    Kind{"MoteusAzimuthOnly", [] { return moteusBench(AxisDriver::Moteus, AxisDriver::None); }},
                    Kind{"MoteusElevationOnly", [] { return moteusBench(AxisDriver::None, AxisDriver::Moteus); }},
                    Kind{"MoteusAndSimple", [] { return std::make_unique<MixedBench>(Axis::Azimuth); }},
                    Kind{"SimpleAndMoteus", [] { return std::make_unique<MixedBench>(Axis::Elevation); }},
                    Kind{"Simple", [] { return simpleBench(true, true); }},
                    Kind{"SimpleAzimuthOnly", [] { return simpleBench(true, false); }},
                    Kind{"SimpleElevationOnly", [] { return simpleBench(false, true); }},
                    Kind{"Pair", [] { return std::make_unique<PairBench>(); }}),
    [](const auto& one) { return std::string(one.param.name); });

// REQ-MOUNT-07: Two axes on two drivers are one mount. A trouble of one driver stops both axes, and neither driver
// turns the axis of the other.
TEST(MountPort, ATroubleOfOneOfTwoDriversStopsBothAxes)
{
    PairBench bench;
    bench.run(Seconds(1.0));
    ASSERT_TRUE(bench.goTo(90.0, 60.0));
    bench.run(Seconds(3.0));
    bench.setElevationLine(false);
    bench.run(Seconds(4.0));
    EXPECT_TRUE(bench.control().faultLatched());
    EXPECT_TRUE(bench.stands(Seconds(3.0)));
    bench.setElevationLine(true);
    bench.run(Seconds(1.0));
    EXPECT_TRUE(bench.stands(Seconds(3.0)));
    ASSERT_TRUE(bench.ask(request::Rearm{}));
    bench.run(Seconds(1.0));
    EXPECT_TRUE(bench.stands(Seconds(3.0)));
    ASSERT_TRUE(bench.goTo(90.0, 60.0));
    bench.run(Seconds(25.0));
    EXPECT_EQ(bench.control().state(), StationState::Hold);
    EXPECT_FALSE(bench.turnedForeignAxes());
}

// REQ-MOUNT-07
TEST(MountPort, ATroubleOfAnotherKindOfDriverStopsBothAxes)
{
    for (const Axis moteus : kAxes) {
        MixedBench bench(moteus);
        bench.run(Seconds(1.0));
        ASSERT_TRUE(bench.goTo(90.0, 60.0));
        bench.run(Seconds(3.0));
        bench.setBoxLine(false);
        bench.run(Seconds(4.0));
        EXPECT_TRUE(bench.control().faultLatched());
        EXPECT_TRUE(bench.stands(Seconds(3.0)));
        bench.setBoxLine(true);
        bench.run(Seconds(2.0));
        EXPECT_TRUE(bench.stands(Seconds(3.0)));
        ASSERT_TRUE(bench.ask(request::Rearm{}));
        bench.run(Seconds(1.0));
        EXPECT_TRUE(bench.stands(Seconds(3.0)));
        ASSERT_TRUE(bench.goTo(90.0, 60.0));
        bench.run(Seconds(25.0));
        EXPECT_EQ(bench.control().state(), StationState::Hold);
        EXPECT_FALSE(bench.turnedForeignAxes());
    }
}

// REQ-MOUNT-09: What one of two drivers offers besides moving can be had, for its axis. What two offer can not.
TEST(MountPort, APairOffersWhatOneOfItsDriversOffers)
{
    MixedBench bench(Axis::Elevation);
    ASSERT_NE(bench.control().mount().service(), nullptr);
    PairBench simple;
    EXPECT_EQ(simple.control().mount().service(), nullptr);
    bench.run(Seconds(1.0));
    const auto refused = bench.ask(request::ChooseTurn{Axis::Azimuth, 10_deg});
    ASSERT_FALSE(refused);
    EXPECT_NE(textOf(refused.error()).find("No moteus turns this axis"), std::string::npos) << textOf(refused.error());
    const DrivesStatus drives = *bench.control().status().drives;
    EXPECT_FALSE(drives.azimuth.present);
    EXPECT_TRUE(drives.elevation.present);
}

// REQ-MOUNT-02: The set-points are never faster than the rotator, whatever the profile permits.
TEST(MountPort, SetPointsAreNoFasterThanTheRotator)
{
    profile::Profile fast;
    fast.azimuth.limits.speed = AngularRate::fromDegrees(20.0);
    fast.elevation.limits.speed = AngularRate::fromDegrees(20.0);
    SimpleBench bench({}, fast);
    bench.run(Seconds(1.0));
    ASSERT_TRUE(bench.goTo(150.0, 80.0));
    for (int i = 0; i < 500; ++i) {
        bench.tick();
        const AxisStatus azimuth = bench.control().status().azimuth;
        ASSERT_LE(azimuth.commandedRate.value_or(AngularRate{}), SimpleBox::kSpeed);
        ASSERT_LT(abs(azimuth.commanded.value_or(bench.truth().azimuth) - bench.truth().azimuth), 2_deg) << i;
    }
}

// Story: a rotator of whole degrees rounded its set-point to the degree beyond a limit of 60.7°.
// REQ-MOUNT-08: A rotator that goes in steps stays inside a travel and inside limits that end between two of them.
TEST(MountPort, ARotatorOfStepsStaysInsideLimitsBetweenTwoSteps)
{
    profile::Profile profile = slowProfile();
    profile.azimuth.geometry.travel = {.min = 5.4_deg, .max = 60.6_deg};
    profile.limits.elevation = {.min = 10.4_deg, .max = 60.7_deg};
    SimpleBench bench({}, profile);
    bench.run(Seconds(1.0));
    EXPECT_FALSE(bench.goTo(30.0, 60.7));
    for (const auto& [rate, end] :
         {std::pair{-5.0, AxisPosition{6_deg, 11_deg}}, std::pair{5.0, AxisPosition{60_deg, 60_deg}}}) {
        const AngularRate both = AngularRate::fromDegrees(rate);
        ASSERT_TRUE(bench.ask(request::Move{{.azimuth = both, .elevation = both}}));
        for (int i = 0; i < 1000; ++i) {
            bench.tick();
            ASSERT_TRUE(profile.azimuth.geometry.travel.contains(bench.truth().azimuth)) << i;
            ASSERT_TRUE(profile.limits.elevation.contains(bench.truth().elevation)) << i;
        }
        bench.expectAt(end, end, Angle::fromDegrees(1e-6));
    }
}

// REQ-MOUNT-03: A mount with one axis needs no answer, no wrap and no arming of the other one. That one is shown as
// missing, and can not be jogged. What is asked of it is ignored, and 0 is reported for it.
TEST(OneAxis, WhatIsAskedOfTheMissingAxisIsIgnored)
{
    for (const Axis missing : kAxes) {
        SimpleBench bench({.azimuth = missing != Axis::Azimuth, .elevation = missing != Axis::Elevation});
        bench.run(Seconds(1.0));
        const AxisPosition before = bench.truth();
        ASSERT_TRUE(bench.ask(request::PointAxes{{120_deg, 40_deg}}));
        bench.run(Seconds(30.0));
        bench.expectAt({120_deg, 40_deg}, before, bench.resolution() / 2.0);
        EXPECT_EQ(bench.control().state(), StationState::Hold);
        const SkyPointing direction = bench.control().direction().value_or(SkyPointing{-1_deg, -1_deg});
        EXPECT_EQ(missing == Axis::Azimuth ? direction.azimuth : direction.elevation, 0_deg);
        EXPECT_NEAR(missing == Axis::Azimuth ? direction.elevation.degrees() : direction.azimuth.degrees(),
                    missing == Axis::Azimuth ? 40.0 : 120.0, 1e-6);
    }
}

// REQ-MOUNT-10: Of an axis that no moteus turns nothing is asked, commanded, kept or believed, whoever answers under
// its id. The crash-stop proof is of the other one.
TEST(OneAxis, NothingOfADriveUnderTheIdOfTheMissingAxisCounts)
{
    StationRig foreign;  // has drives for both axes
    foreign.run(Seconds(0.1));
    for (const Axis missing : kAxes) {
        const bool azimuth = missing != Axis::Azimuth;
        const Axis there = azimuth ? Axis::Azimuth : Axis::Elevation;
        MoteusBench bench(slowProfile(azimuth ? AxisDriver::Moteus : AxisDriver::None,
                                      azimuth ? AxisDriver::None : AxisDriver::Moteus));
        StationRig& rig = bench.rig();
        const AxisPosition before = bench.truth();
        bench.run(Seconds(1.0));
        ASSERT_TRUE(bench.goTo(120.0, 40.0));
        for (int i = 0; i < 1500; ++i) {
            bench.tick();
            const auto frames = rig.mount.frames();
            ASSERT_EQ(frames.size(), 1U);
            ASSERT_EQ(moteus::fromCanId(frames.front().id).destination, rig.profile.axis(there).id);
            const CanFrame question = foreign.mount.frames()[index(missing)];
            rig.mount.take(foreign.drive(missing).answer(question, rig.clock.now()).value());
        }
        EXPECT_TRUE(rig.drive(missing).seen.empty());
        bench.expectAt({120_deg, 40_deg}, before, bench.resolution());
        EXPECT_EQ(rig.mount.report(missing).place, 0_deg);
        EXPECT_FALSE(rig.mount.memory().turns[index(missing)]);
        EXPECT_TRUE(rig.mount.memory().turns[index(there)]);
        EXPECT_FALSE(rig.mount.chooseWrap(missing, 0_deg, QStringLiteral("operator")));
        const DrivesStatus drives = *rig.control.status().drives;
        EXPECT_EQ(drives.azimuth.present, azimuth);
        EXPECT_EQ(drives.elevation.present, !azimuth);
    }
}

// REQ-MOUNT-10
TEST(OneAxis, TheCrashStopOfItIsProvenAlone)
{
    MoteusBench bench(slowProfile(AxisDriver::None, AxisDriver::Moteus));
    StationRig& rig = bench.rig();
    bench.run(Seconds(1.0));
    ASSERT_TRUE(bench.goTo(0.0, 45.0));
    bench.run(Seconds(15.0));
    const Result<> proving = bench.ask(request::ProveCrashStop{AngularRate::fromDegrees(2.0)});
    ASSERT_TRUE(proving) << textOf(proving.error());
    bench.run(Seconds(10.0));
    EXPECT_FALSE(rig.mount.proofRunning());
    const DrivesStatus drives = *rig.control.status().drives;
    EXPECT_EQ(drives.proofText, QStringLiteral("done"));
    EXPECT_FALSE(drives.azimuth.crashStop);
    EXPECT_TRUE(drives.elevation.crashStop);
    EXPECT_TRUE(rig.drive(Axis::Azimuth).seen.empty());
}

// REQ-MOUNT-03
TEST(OneAxis, TheMissingAxisIsShownAsMissingAndCanNotBeJogged)
{
    SimpleBench bench({.azimuth = true, .elevation = false});
    bench.run(Seconds(1.0));
    const StationStatus status = bench.control().status();
    EXPECT_EQ(status.elevation.state, AxisState::Missing);
    EXPECT_NE(status.azimuth.state, AxisState::Missing);
    EXPECT_FALSE(status.capabilities.has(Axis::Elevation));
    EXPECT_EQ(status.permissions.reason(Action::JogUp), QStringLiteral("This mount has no elevation axis."));
    EXPECT_EQ(status.permissions.reason(Action::StepDown), QStringLiteral("This mount has no elevation axis."));
    EXPECT_TRUE(status.permissions.allows(Action::JogLeft)) << status.permissions.reason(Action::JogLeft).toStdString();
}

// REQ-MOUNT-04: Nobody knows where the beam of a mount with one axis is in the other angle: a keep-out holds for all of
// it, and no horizon holds an azimuth back.
TEST(OneAxis, AKeepOutHoldsForTheWholeOfTheMissingAngle)
{
    profile::Profile profile = slowProfile();
    profile.limits.horizon = {{.azimuth = 0_deg, .elevation = 15_deg}};
    profile.limits.keepOuts = {
        {.name = "mast", .azimuthFrom = 80_deg, .azimuthTo = 100_deg, .elevationMin = 20_deg, .elevationMax = 40_deg}};
    SimpleBench bench({.azimuth = true, .elevation = false}, profile);
    bench.run(Seconds(1.0));
    EXPECT_FALSE(bench.goTo(90.0, 0.0));
    ASSERT_TRUE(bench.goTo(60.0, 0.0));
    bench.run(Seconds(20.0));
    EXPECT_NEAR(bench.truth().azimuth.degrees(), 60.0, 0.5);
    ASSERT_TRUE(bench.ask(request::Move{{.azimuth = AngularRate::fromDegrees(5.0)}}));
    bench.run(Seconds(10.0));
    EXPECT_LE(bench.truth().azimuth, 80.5_deg);
    EXPECT_GE(bench.truth().azimuth, 79_deg) << "it went that far";
}

// REQ-MOUNT-04
TEST(OneAxis, AKeepOutHoldsAtAllAzimuthsWithoutOne)
{
    profile::Profile profile = slowProfile();
    profile.limits.keepOuts = {
        {.name = "wire", .azimuthFrom = 80_deg, .azimuthTo = 100_deg, .elevationMin = 50_deg, .elevationMax = 55_deg}};
    SimpleBench bench({.azimuth = false, .elevation = true}, profile);
    bench.run(Seconds(1.0));
    EXPECT_FALSE(bench.goTo(0.0, 52.0));
    EXPECT_FALSE(bench.goTo(0.0, 80.0)) << "there is no way around it";
    EXPECT_TRUE(bench.goTo(0.0, 45.0));
}

}  // namespace
}  // namespace boresight
