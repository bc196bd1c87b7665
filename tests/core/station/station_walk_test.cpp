// SPDX-License-Identifier: GPL-3.0-or-later
// Random walks through the station's rules: whatever is asked, by whomever, and whatever the drives do, the promises
// at the end of each tick hold.
#include "tests/core/station/station_rig.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace boresight {
namespace {

constexpr int kSteps = 4000;

class Walk
{
public:
    explicit Walk(unsigned seed) : m_random(seed) {}

    void step()
    {
        act(m_random() % 24);
        const auto before = m_rig.control.status();
        m_rig.tick();
        check(before);
    }

private:
    double number(double low, double high) { return std::uniform_real_distribution(low, high)(m_random); }
    Source anybody() { return m_random() % 2 == 0 ? kOperator : m_random() % 2 == 0 ? kClient : kOtherClient; }
    AngularRate rate() { return AngularRate::fromDegrees(number(-8.0, 8.0)); }

    void act(unsigned long choice)
    {
        switch (choice) {
            case 0:
            case 1:
            case 2:
                ask(request::PointSky{{Angle::fromDegrees(number(-400, 800)), Angle::fromDegrees(number(-90, 180))}});
                break;
            case 3:
                ask(request::PointAxes{{Angle::fromDegrees(number(-200, 600)), Angle::fromDegrees(number(-30, 120))}});
                break;
            case 4:
                ask(request::Jog{{rate(), rate()}});
                break;
            case 5:
                ask(request::Move{{rate(), rate()}});
                break;
            case 6:
                ask(request::Step{Angle::fromDegrees(number(-5, 5)), Angle::fromDegrees(number(-5, 5))});
                break;
            case 7:
                ask(request::Hold{});
                break;
            case 8:
                ask(request::Stop{}, kOperator);
                break;
            case 9:
                ask(request::ResetStop{}, kOperator);
                break;
            case 10:
                ask(request::Park{});
                break;
            case 11:
                ask(request::Rearm{});
                break;
            case 12:
                ask(request::GiveAuthority{}, kOperator);
                break;
            case 13:
                m_rig.control.sourceGone(anybody());
                break;
            case 14:
                disturb();
                break;
            default:
                break;  // time passes
        }
    }

    void ask(const Request& request) { ask(request, anybody()); }
    void ask(const Request& request, const Source& source) { (void)m_rig.ask(request, source); }

    void disturb()
    {
        fakes::IdealDrive& drive = m_random() % 2 == 0 ? m_rig.azimuth : m_rig.elevation;
        switch (m_random() % 8) {
            case 0:
                drive.mode = moteus::Mode::Fault;
                drive.fault = 38;
                break;
            case 1:
                drive.mode = moteus::Mode::PositionTimeout;
                break;
            case 2:
                drive.silent = true;
                break;
            default:
                drive.silent = false;
                break;
        }
    }

    void check(const StationStatus& before)
    {
        const StationStatus now = m_rig.control.status();
        const profile::Profile& profile = m_rig.profile;
        for (const auto& [axis, was, limits] :
             {std::tuple(now.azimuth, before.azimuth, profile.azimuth.limits),
              std::tuple(now.elevation, before.elevation, profile.elevation.limits)}) {
            if (!axis.commanded) {
                continue;
            }
            ASSERT_GE(axis.commanded->degrees(), axis.travel.min.degrees() - 1e-6);
            ASSERT_LE(axis.commanded->degrees(), axis.travel.max.degrees() + 1e-6);
            ASSERT_LE(abs(*axis.commandedRate).degrees(), limits.speed.degrees() * 1.001);
            if (was.commanded) {
                const double step = 0.02;
                const double moved = (*axis.commanded - *was.commanded).degrees();
                const double mean = (axis.commandedRate->degrees() + was.commandedRate->degrees()) / 2.0;
                ASSERT_NEAR(moved, mean * step, limits.acceleration.degrees() * step * step) << "a step in position";
                ASSERT_LE(std::abs((*axis.commandedRate - *was.commandedRate).degrees()),
                          limits.acceleration.degrees() * step * 1.01)
                    << "a step in speed";
                ASSERT_LE(abs(*axis.commanded - *was.commanded).degrees(), limits.speed.degrees() * 0.021);
            }
        }
        if (now.state == StationState::Stopped || now.state == StationState::Fault) {
            m_still += 1;
        } else {
            m_still = 0;
        }
        if (m_still > 200) {  // 4 s: longer than any deceleration
            ASSERT_NE(now.azimuth.state, AxisState::Moving);
            ASSERT_NE(now.elevation.state, AxisState::Moving);
        }
        for (fakes::IdealDrive* const drive : {&m_rig.azimuth, &m_rig.elevation}) {
            for (const auto& seen : drive->seen) {
                if (seen.mode == moteus::Mode::Position) {
                    ASSERT_GT(seen.fields.at(moteus::Register::CommandWatchdogTimeout), 0.0);
                }
            }
            drive->seen.clear();
        }
    }

    std::minstd_rand m_random;
    StationRig m_rig;
    int m_still = 0;
};

class StationWalk : public testing::TestWithParam<unsigned>
{};

TEST_P(StationWalk, PromisesHold)
{
    Walk walk(GetParam());
    for (int i = 0; i < kSteps && !HasFatalFailure(); ++i) {
        walk.step();
    }
}

INSTANTIATE_TEST_SUITE_P(Seeds, StationWalk, testing::Range(1U, 9U));

}  // namespace
}  // namespace boresight
