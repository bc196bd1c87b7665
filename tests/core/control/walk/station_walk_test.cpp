// SPDX-License-Identifier: GPL-3.0-or-later
// Random walks through the rules of the station. The promises hold after each event, whatever is requested by any
// source, and whatever happens to drives, drive check, bus and computer.
#include "tests/core/control/walk/station_promises.h"

#include <QLoggingCategory>

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace boresight {
namespace {

#ifdef BORESIGHT_SANITIZED
constexpr int kEvents = 1000;
#else
constexpr int kEvents = 10000;
#endif
constexpr Angle kPlace = Angle::fromTurns(0.01);  // positions that look the same to a drive that has lost its wrap

// Boresight re-arms by itself after temporary faults, and does not restrict the clients.
profile::Profile unattended()
{
    profile::Profile profile;
    profile.recovery = {.overTemperature = profile::Retry::Interval,
                        .supply = profile::Retry::Interval,
                        .bus = profile::Retry::Interval,
                        .interval = Seconds(2.0)};
    profile.rotctld.control = profile::ControlRule::Last;
    return profile;
}

profile::Profile braked()
{
    profile::Profile profile;
    profile.brake = {.output = "rts:/dev/ttyUSB0", .switching = Seconds(0.2), .setAfter = Seconds(0.5)};
    return profile;
}

class Walk
{
public:
    Walk(unsigned seed, const profile::Profile& profile) : m_random(seed), m_rig(profile), m_promises(m_rig)
    {
        come(kClient);
        come(kOtherClient);
        tick(StationRig::kTick);
    }

    void event()
    {
        switch (m_random() % 8) {
            case 0:
            case 1:
            case 2:
                askForMotion();
                break;
            case 3:
                askOtherwise();
                break;
            case 4:
                mend();
                break;
            case 5:
                if (m_random() % 4 == 0) {
                    disturb();
                }
                break;
            default:
                break;  // time passes
        }
        for (unsigned long ticks = 1 + m_random() % 8; ticks > 0; --ticks) {
            tick(StationRig::kTick);
        }
        static_cast<void>(m_rig.control.status());  // with all permissions, in whatever state the station is
    }

    [[nodiscard]] const StationPromises& promises() const { return m_promises; }

    // The last lines of the log, to see what led to a broken promise.
    [[nodiscard]] std::string lastLines() const
    {
        std::string text;
        for (const LogEntry& line : m_rig.log.since(0, 40)) {
            const Seconds age = m_rig.clock.utc() - line.utc;
            text += "\n" + std::to_string(-age.count()) + " s " + line.source.toStdString() + ": " +
                    line.text.toStdString();
        }
        return text;
    }

private:
    double number(double low, double high) { return std::uniform_real_distribution(low, high)(m_random); }
    Angle angle(double low, double high) { return Angle::fromDegrees(number(low, high)); }
    Source anybody() { return m_random() % 2 == 0 ? kOperator : m_random() % 2 == 0 ? kClient : kOtherClient; }
    std::optional<Axis> oneOrBoth()
    {
        const auto which = m_random() % 3;
        return which == 0 ? std::nullopt : std::optional(kAxes[which - 1]);
    }
    std::uint64_t anyClient() { return m_random() % 2 == 0 ? kClient.clientId : kOtherClient.clientId; }
    void come(const Source& client)
    {
        if (client.kind == SourceKind::Client) {
            m_rig.control.clientCame(client, "10.0.0." + std::to_string(client.clientId));
        }
    }
    AxisRates rates()
    {
        const double fastest = m_random() % 2 == 0 ? 2.0 : 8.0;  // 2°/s is allowed on an unknown wrap
        return {AngularRate::fromDegrees(number(-fastest, fastest)),
                AngularRate::fromDegrees(number(-fastest, fastest))};
    }
    Request aPlace()
    {
        const Request places[] = {request::Park{}, request::Home{}, request::Unwind{}};
        return places[m_random() % std::size(places)];
    }
    fakes::IdealDrive& drive(Axis axis) { return axis == Axis::Azimuth ? m_rig.azimuth : m_rig.elevation; }
    Axis anyAxis() { return m_random() % 2 == 0 ? Axis::Azimuth : Axis::Elevation; }

    void askForMotion()
    {
        switch (m_random() % 8) {
            case 0:
            case 1:
                return ask(request::PointSky{{angle(-400, 800), angle(-90, 180)}}, anybody());
            case 2:
                return ask(request::PointAxes{{angle(-100, 460), angle(-5, 95)}}, anybody());
            case 3:
                return ask(request::Jog{rates()}, anybody());
            case 4:
                return ask(request::Move{rates()}, anybody());
            case 5:
                return ask(request::Step{angle(-5, 5), angle(-5, 5)}, anybody());
            case 6:
                return ask(aPlace(), anybody());
            default:
                return ask(request::ProveCrashStop{AngularRate::fromDegrees(number(0.2, 6.0))}, anybody());
        }
    }

    void askOtherwise()
    {
        switch (m_random() % 14) {
            case 0:
                return ask(request::Stop{}, anybody());
            case 1:
            case 2:
                return ask(request::Hold{}, anybody());
            case 3:
                return ask(request::EndProof{}, anybody());
            case 4:
                return ask(request::TakeAuthority{}, kOperator);
            case 5:
                return ask(request::Jog{}, anybody());
            case 6:
                return ask(request::ReadDrives{}, anybody());
            case 7:
                return ask(request::FixDrives{}, anybody());
            case 8:
                return ask(request::SwitchOff{oneOrBoth()}, anybody());
            case 9:
                return ask(request::ReleaseBus{}, anybody());
            case 10: {
                const Source gone = anybody();
                m_rig.control.sourceGone(gone);
                m_promises.sourceGone(gone);
                return come(gone);
            }
            case 11:
                return ask(request::GiveControl{.clientId = anyClient()}, anybody());
            case 12:
                return ask(request::SetReadOnly{.clientId = anyClient(), .readOnly = m_random() % 4 == 0}, kOperator);
            default:
                ask(request::AcknowledgeAlarms{}, kOperator);
                return m_rig.control.positionRead(anybody().clientId);
        }
    }

    // Brings the station back to work. Otherwise the walk would stand still for most of its length.
    void mend()
    {
        if (m_random() % 2 == 0) {
            return mendAll();
        }
        const Axis axis = anyAxis();
        switch (m_random() % 8) {
            case 0:
                return ask(request::ResetStop{}, kOperator);
            case 1:
                return ask(request::Rearm{}, anybody());
            case 2:
                return ask(request::GiveAuthority{}, kOperator);
            case 3:
                return ask(request::TakeBus{}, kOperator);
            case 4:
                return look(axis);
            case 5:
                drive(axis).silent = drive(axis).deaf = false;
                drive(axis).voltage = 24.0;
                drive(axis).temperature = 31.0;
                return;
            case 6:
                return m_rig.learn(axis, m_facts[index(axis)]);
            default:
                m_rig.mount.setInterlock({});
                return m_promises.interlock(true);
        }
    }

    void mendAll()
    {
        for (const Axis axis : kAxes) {
            drive(axis).silent = drive(axis).deaf = false;
            drive(axis).voltage = 24.0;
            drive(axis).temperature = 31.0;
            m_rig.learn(axis, m_facts[index(axis)]);
        }
        m_rig.mount.setInterlock({});
        m_promises.interlock(true);
        ask(request::TakeBus{}, kOperator);
        wait();
        ask(request::ResetStop{}, kOperator);
        ask(request::Rearm{}, kOperator);
        wait();
        look(Axis::Azimuth);
        look(Axis::Elevation);
        wait();
        ask(request::GiveAuthority{}, kOperator);
    }

    void wait()
    {
        for (int i = 0; i < 60; ++i) {
            tick(StationRig::kTick);
        }
    }

    // The operator at the mast enters the wrap, sometimes a wrong one.
    void look(Axis axis)
    {
        const StationStatus status = m_rig.control.status();
        const auto& question =
            axis == Axis::Azimuth ? status.drives->azimuth.turnQuestion : status.drives->elevation.turnQuestion;
        if (question && !question->candidates.empty()) {
            ask(request::ChooseTurn{axis, question->candidates[m_random() % question->candidates.size()]}, kOperator);
        } else {
            ask(request::ChooseTurn{axis, angle(-100, 460)}, anybody());
        }
    }

    void disturb()
    {
        const Axis axis = anyAxis();
        switch (m_random() % 17) {
            case 0:
                drive(axis).mode = moteus::Mode::Fault;
                drive(axis).fault = 38;
                break;
            case 1:
                drive(axis).mode = moteus::Mode::PositionTimeout;
                break;
            case 2:
            case 3:
                drive(axis).silent = true;
                break;
            case 4:
                drive(axis).deaf = true;
                break;
            case 5:
            case 6:
                restart(axis);
                break;
            case 7:
                drive(axis).position += number(-0.05, 0.05);
                m_promises.slipped(axis);
                break;
            case 8:
                drive(axis).voltage = number(8.0, 50.0);
                break;
            case 9:
                drive(axis).temperature = number(20.0, 90.0);
                break;
            case 10:
                m_rig.mount.setInterlock(failure(ErrorCode::Refused, QStringLiteral("not as it should be")));
                m_promises.interlock(false);
                break;
            case 11:
                m_rig.mount.learn(axis, std::nullopt);
                break;
            case 12:
                stall();
                break;
            case 13:
            case 14:
            case 15:
                sayFalsePlaces(axis);
                break;
            default:
                m_rig.clock.stepUtc(Seconds(number(-7200.0, 7200.0)));
                break;
        }
    }

    // Up to 0.3 s of replies that agree with each other, differ, or are no numbers. The axis stays where it is.
    void sayFalsePlaces(Axis axis)
    {
        const double offset = number(-0.4, 0.4);
        const unsigned long kind = m_random() % 4;
        for (unsigned long replies = 1 + m_random() % 15; replies > 0; --replies) {
            const double places[] = {drive(axis).position + offset, drive(axis).position + number(-0.4, 0.4),
                                     std::nan(""), m_random() % 2 == 0 ? drive(axis).position : offset};
            drive(axis).falsePlaces.push_back(places[kind]);
        }
    }

    // A drive that has lost its home: it knows its position only within one turn of its rotor.
    void restart(Axis axis)
    {
        drive(axis).mode = moteus::Mode::Stopped;
        drive(axis).fault = 0;
        drive(axis).home = moteus::HomeState::Rotor;
        drive(axis).position = std::remainder(drive(axis).position, kPlace.turns());
        m_facts[index(axis)].bootedAt = m_rig.clock.now();
        m_promises.slipped(axis);
        if (m_random() % 2 == 0) {
            drive(axis).silent = true;  // until another event ends it
        } else {
            m_rig.mount.driveRestarted(axis);
            m_rig.learn(axis, m_facts[index(axis)]);
        }
    }

    // This computer stalls or sleeps. The watchdogs of the drives end their motion.
    void stall()
    {
        const bool sleeps = m_random() % 2 == 0;
        const Seconds time(sleeps ? number(0.15, 30.0) : number(0.02, 1.0));
        for (const Axis axis : kAxes) {
            if (time > m_rig.profile.control.watchdog && drive(axis).mode == moteus::Mode::Position) {
                drive(axis).mode = moteus::Mode::PositionTimeout;
            }
        }
        sleeps ? m_rig.clock.sleep(time) : m_rig.clock.advance(time);
        tick(StationRig::kTick + time);
    }

    void ask(const Request& request, const Source& source)
    {
        const StationStatus before = m_rig.control.status();
        m_promises.asked(request, source, m_rig.ask(request, source).has_value(), before);
    }

    // The output of the brake answers after up to ten ticks. Now and then it fails for half a second.
    void switchBrake()
    {
        if (!m_rig.profile.brake.isUsed()) {
            return;
        }
        const bool wanted = m_rig.control.releasesBrake();
        if (wanted != m_brake.ordered) {
            m_brake.ordered = wanted;
            m_brake.delay = m_random() % 10;
        }
        if (m_random() % 3000 == 0) {
            m_brake.failing = 25;
        }
        m_brake.failing -= m_brake.failing > 0 ? 1 : 0;
        m_brake.delay -= m_brake.delay > 0 ? 1 : 0;
        const bool isReached = m_brake.failing == 0 && m_brake.delay == 0;
        const bool isOn = isReached ? wanted : m_brake.isOn && m_brake.failing == 0;
        if (isOn != m_brake.isOn) {
            m_brake.isOn = isOn;
            m_brake.since = m_rig.clock.now();
        }
        m_rig.control.takeBrake({.isOn = isReached ? std::optional(isOn) : std::nullopt,
                                 .problem = m_brake.failing > 0 ? QStringLiteral("unplugged") : QString()});
        // The next tick is a step later.
        const Seconds open = m_rig.clock.now() + StationRig::kTick - m_brake.since;
        m_promises.brake(isOn && open >= m_rig.profile.brake.switching);
    }

    void tick(Seconds step)
    {
        switchBrake();
        m_rig.azimuth.seen.clear();
        m_rig.elevation.seen.clear();
        m_rig.tick();
        m_promises.ticked(step);
    }

    struct Brake
    {
        bool ordered = false;
        bool isOn = false;
        SteadyTime since{};
        unsigned long delay = 0;  // ticks until the output answers
        int failing = 0;          // ticks
    };

    std::minstd_rand m_random;
    StationRig m_rig;
    StationPromises m_promises;
    Brake m_brake;
    std::array<drive_check::DriveFacts, 2> m_facts{m_rig.factsOf(Axis::Azimuth), m_rig.factsOf(Axis::Elevation)};
};

class StationWalk : public testing::TestWithParam<unsigned>
{
protected:
    void SetUp() override { QLoggingCategory::setFilterRules(QStringLiteral("boresight.*=false")); }
    void TearDown() override { QLoggingCategory::setFilterRules({}); }

    static void go(const profile::Profile& profile)
    {
        Walk walk(GetParam(), profile);
        for (int i = 0; i < kEvents; ++i) {
            walk.event();
            ASSERT_EQ(walk.promises().broken(), "") << "after " << i + 1 << " events" << walk.lastLines();
        }
        EXPECT_GT(walk.promises().motions(), kEvents / 50) << "the walk must not stand still";
        EXPECT_GT(walk.promises().losses(), kEvents / 400);
        RecordProperty("motions", static_cast<int>(walk.promises().motions()));
        RecordProperty("losses", static_cast<int>(walk.promises().losses()));
    }
};

// REQ-CONTROL-09 (StationWalk.*): Whatever is requested, and whatever happens to drives, drive check, bus and computer:
// set-points never leave the travel, never jump and never exceed the speed limit. No motion starts without a request,
// STOP wins, and a fault waits for a re-arm.
// REQ-AXES-19a (StationWalk.*)
// REQ-CONTROL-27 (StationWalk.*)
TEST_P(StationWalk, PromisesHoldAmongHillsAndMasts)
{
    profile::Profile profile;
    profile.limits.azimuth = {-60_deg, 430_deg};
    profile.limits.horizon = {{20_deg, 5_deg}, {120_deg, 30_deg}, {200_deg, 0_deg}, {300_deg, 12_deg}};
    profile.limits.keepOuts = {{"mast", 310_deg, 330_deg, 0_deg, 50_deg}, {"wires", 350_deg, 60_deg, 55_deg, 70_deg}};
    go(profile);
}

TEST_P(StationWalk, PromisesHold)
{
    go({});
}

TEST_P(StationWalk, PromisesHoldWhereNobodyRearms)
{
    go(unattended());
}

class BrakeWalk : public StationWalk
{};

// REQ-BRAKE-26 (BrakeWalk.*): Whatever happens, no motion begins before the brake is open, and the brake is not set
// under a moving antenna while the drives hold it.
TEST_P(BrakeWalk, PromisesHoldWithABrake)
{
    go(braked());
}

INSTANTIATE_TEST_SUITE_P(Seeds, StationWalk, testing::Range(1U, 9U));
INSTANTIATE_TEST_SUITE_P(Seeds, BrakeWalk, testing::Range(2U, 10U));

}  // namespace
}  // namespace boresight
