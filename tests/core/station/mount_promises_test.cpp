// SPDX-License-Identifier: GPL-3.0-or-later
// What every rotator promises behind the port of the mount, tried with the control above it. A new driver costs one
// bench here.
#include "core/control/station_control.h"
#include "core/simple_mount/simple_mount.h"
#include "core/sources/motion_sources.h"
#include "tests/core/station/station_rig.h"
#include "tests/fakes/manual_clock.h"

#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <string>
#include <tuple>

namespace boresight {
namespace {

constexpr Seconds kOneTick{0.02};

// Slow enough for every rotator here.
profile::Profile slowProfile()
{
    profile::Profile profile;
    for (const Axis axis : kAxes) {
        profile::AxisSettings& settings = axis == Axis::Azimuth ? profile.azimuth : profile.elevation;
        settings.limits.speed = AngularRate::fromDegrees(5.0);
    }
    return profile;
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
    [[nodiscard]] virtual Seconds silence() const = 0;  // within this it is reported
    [[nodiscard]] virtual Angle resolution() const = 0;

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
    StationControl& control() override { return m_rig.control; }
    void tick() override { m_rig.tick(); }
    AxisPosition truth() override
    {
        return {.azimuth = m_rig.profile.azimuth.geometry.toAxis(MotorTurns::fromTurns(m_rig.azimuth.position)),
                .elevation = m_rig.profile.elevation.geometry.toAxis(MotorTurns::fromTurns(m_rig.elevation.position))};
    }
    bool ordered() override { return m_rig.commands() > 0; }
    void setLine(bool connected) override { m_rig.azimuth.silent = m_rig.elevation.silent = !connected; }
    Seconds silence() const override { return Drive::kSilence; }
    Angle resolution() const override { return Angle::fromDegrees(0.01); }

private:
    StationRig m_rig{slowProfile()};
};

class SimpleBench final : public Bench
{
public:
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
    Seconds silence() const override { return SimpleMount::kSilence; }
    Angle resolution() const override { return Angle::fromDegrees(1.0); }

private:
    const profile::InForce m_profile{slowProfile()};
    fakes::ManualClock m_clock;
    EventLog m_log{m_clock};
    AlarmBoard m_alarms{m_log, m_clock};
    SimpleBox m_box{{.azimuth = Angle::fromDegrees(10.4), .elevation = Angle::fromDegrees(20.6)}};
    SimpleMount m_mount{m_box};
    StationControl m_control{m_profile, m_clock, m_log, m_alarms, m_mount, motionSources};
};

struct Kind
{
    const char* name;
    std::function<std::unique_ptr<Bench>()> make;
};

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

TEST_P(MountPromises, TheFirstCommandHoldsWhatWasMeasured)
{
    bench->run(Seconds(1.0));
    const AxisPosition before = bench->truth();
    const AxisPosition measured = *bench->control().mount().measured();
    ASSERT_TRUE(bench->ask(request::PointAxes{measured}));
    bench->run(Seconds(2.0));
    EXPECT_LE(abs(bench->truth().azimuth - before.azimuth), bench->resolution() / 2.0);
    EXPECT_LE(abs(bench->truth().elevation - before.elevation), bench->resolution() / 2.0);
}

TEST_P(MountPromises, GoesWhereItIsSent)
{
    bench->run(Seconds(1.0));
    ASSERT_TRUE(bench->goTo(60.0, 45.0));
    bench->run(Seconds(25.0));
    EXPECT_LE(abs(bench->truth().azimuth - 60_deg), bench->resolution());
    EXPECT_LE(abs(bench->truth().elevation - 45_deg), bench->resolution());
}

TEST_P(MountPromises, LimitsHold)
{
    bench->run(Seconds(1.0));
    const TravelRange travel = bench->control().status().elevation.travel;
    EXPECT_FALSE(bench->goTo(60.0, travel.min.degrees() - 5.0)) << "a place outside is refused";
    ASSERT_TRUE(bench->ask(request::Move{{.elevation = AngularRate::fromDegrees(-5.0)}}));
    for (int i = 0; i < 1500; ++i) {
        bench->tick();
        ASSERT_GE(bench->truth().elevation, travel.min - bench->resolution() / 2.0);
    }
    EXPECT_LE(bench->truth().elevation, travel.min + bench->resolution()) << "it went that far";
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

INSTANTIATE_TEST_SUITE_P(Drivers, MountPromises,
                         testing::Values(Kind{"TwoMoteus", [] { return std::make_unique<MoteusBench>(); }},
                                         Kind{"Simple", [] { return std::make_unique<SimpleBench>(); }}),
                         [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace boresight
