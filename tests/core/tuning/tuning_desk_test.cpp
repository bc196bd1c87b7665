// SPDX-License-Identifier: GPL-3.0-or-later
// Tuning runs of a whole station on drives with all their physics.
#include "core/tuning/tuning_desk.h"

#include "tests/system/simulated_station.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

namespace boresight::system_test {
namespace {

using ::testing::HasSubstr;

const AxisPosition kMiddle{.azimuth = 30_deg, .elevation = 30_deg};

struct TuningRig : SimulatedStation
{
    explicit TuningRig(const sim::PairSettings& pair = sim::commissionedPair(), const AxisPosition& place = kMiddle)
        : SimulatedStation(anyPort(), pair)
    {
        EXPECT_EQ(ask(request::PointAxes{place}), "");
        EXPECT_TRUE(settle());
        run(Seconds(1.0));
    }

    [[nodiscard]] const TuningStatus& tuning()
    {
        m_tuning = status().tuning;
        return *m_tuning;
    }

    // The outcome of the last run.
    [[nodiscard]] TuningOutcome outcome() { return tuning().outcome.value_or(TuningOutcome{}); }

    std::string start(TuningRun kind, Axis axis = Axis::Azimuth) { return ask(request::StartTuning{axis, kind}); }

    bool ends()
    {
        return runUntil([this] { return !tuning().running; }, Seconds(150.0));
    }

    bool measures(TuningRun kind, Axis axis = Axis::Azimuth)
    {
        EXPECT_EQ(start(kind, axis), "");
        EXPECT_TRUE(ends());
        EXPECT_FALSE(outcome().failed) << outcome().text.toStdString();
        return !outcome().failed;
    }

    [[nodiscard]] const TuningResult& result(TuningRun kind, bool asFound = true)
    {
        const auto& all = tuning().results;
        const auto found = std::ranges::find_if(
            all, [&](const TuningResult& one) { return one.run == kind && one.asFound == asFound; });
        EXPECT_NE(found, all.end());
        return *found;
    }

    bool readsGains()
    {
        EXPECT_EQ(ask(request::ReadGains{}), "");
        return runUntil([this] { return status().drives->azimuth.gains.read; }, Seconds(10.0));
    }

    bool setsGain(Gain gain, double factor)
    {
        const GainLine line = status().drives->azimuth.gains.lines.at(static_cast<std::size_t>(gain));
        EXPECT_EQ(ask(request::SetGain{.gain = gain, .value = factor * line.value.value()}), "");
        return runUntil([this] { return !status().drives->azimuth.gains.busy; }, Seconds(10.0));
    }

    // The largest distance of the antenna from kMiddle while something runs.
    double farthest = 0.0;
    void watch()
    {
        onTick = [this] { farthest = std::max(farthest, std::abs(truth(Axis::Azimuth) - kMiddle.azimuth.degrees())); };
    }

private:
    std::shared_ptr<const TuningStatus> m_tuning;
};

// REQ-TUNING-13: A step run measures overshoot, settling time, tracking error and torque of one axis. It ends where it
// began, and the mount holds.
TEST(TuningDesk, AStepIsMeasured)
{
    TuningRig rig;
    rig.watch();
    ASSERT_EQ(rig.start(TuningRun::Step), "");
    rig.run(Seconds(2.5));
    EXPECT_EQ(rig.status().state, StationState::Calibrate);
    EXPECT_EQ(rig.tuning().running, TuningRun::Step);
    EXPECT_THAT(rig.start(TuningRun::Ramp), HasSubstr("moves the mount. End it first"));
    EXPECT_THAT(rig.ask(request::ReadGains{}), HasSubstr("A tuning run moves the mount"));
    ASSERT_TRUE(rig.ends());
    EXPECT_EQ(rig.status().state, StationState::Hold);
    const response::StepFigures step = rig.result(TuningRun::Step).step.value();
    EXPECT_NEAR(std::abs(step.size.degrees()), 2.0, 0.001);
    EXPECT_LT(step.overshoot, 0.05);
    EXPECT_LT(step.settling.value().count(), 0.5);
    EXPECT_GT(step.torque.value().peak, 3.0);
    EXPECT_GT(rig.farthest, 1.9);
    EXPECT_LT(rig.farthest, 2.2);
    EXPECT_NEAR(rig.truth(Axis::Azimuth), 30.0, 0.05);
    EXPECT_TRUE(rig.result(TuningRun::Step).good) << rig.outcome().text.toStdString();
}

// REQ-TUNING-14: A ramp run measures the tracking error at a constant rate. A sweep measures gain and phase at each
// frequency.
TEST(TuningDesk, ARampAndASweepAreMeasured)
{
    TuningRig rig;
    ASSERT_TRUE(rig.measures(TuningRun::Ramp, Axis::Elevation));
    const response::RampFigures ramp = rig.result(TuningRun::Ramp).ramp.value();
    EXPECT_NEAR(abs(ramp.rate).degrees(), 0.5, 0.001);
    EXPECT_LT(ramp.steady.peak.degrees(), 0.05);

    rig.watch();
    ASSERT_TRUE(rig.measures(TuningRun::Sweep));
    const auto& sweep = rig.result(TuningRun::Sweep).sweep;
    ASSERT_EQ(sweep.size(), kSweepHertz.size());
    EXPECT_NEAR(sweep.front().gain, 1.0, 0.1);
    EXPECT_NEAR(sweep.front().phase.degrees(), 0.0, 10.0);
    EXPECT_LT(rig.farthest, 0.5);
    EXPECT_NEAR(rig.truth(Axis::Azimuth), 30.0, 0.05);
}

// REQ-TUNING-15: The figures before and after a change of the gains are shown side by side.
TEST(TuningDesk, BeforeAndAfterAreKept)
{
    TuningRig rig;
    ASSERT_TRUE(rig.readsGains());
    ASSERT_TRUE(rig.measures(TuningRun::Step));
    ASSERT_TRUE(rig.setsGain(Gain::Damping, 0.26));
    ASSERT_TRUE(rig.measures(TuningRun::Step));
    const TuningResult before = rig.result(TuningRun::Step, true);
    const TuningResult after = rig.result(TuningRun::Step, false);
    EXPECT_GT(after.step->overshoot, before.step->overshoot);
    const auto damping = static_cast<std::size_t>(Gain::Damping);
    EXPECT_NEAR(*after.gains.at(damping), 0.26 * *before.gains.at(damping), 1.0);
    EXPECT_EQ(rig.tuning().results.size(), 2U);
}

// REQ-TUNING-16: STOP, Hold, a fault, a jog or any other motion ends a run at once, without a result.
TEST(TuningDesk, EverythingElseEndsARun)
{
    const std::vector<std::pair<Request, const char*>> all{
        {request::Stop{}, "STOP ended the run"},
        {request::Hold{}, "Another command"},
        {request::Jog{{.elevation = 1_deg_s}}, "Another command"},
        {request::PointAxes{{.azimuth = 30_deg, .elevation = 40_deg}}, "Another command"},
        {request::EndTuning{}, "The operator ended the run"}};
    for (const TuningRun kind : {TuningRun::Step, TuningRun::Sweep}) {
        for (const auto& [other, words] : all) {
            TuningRig rig;
            ASSERT_EQ(rig.start(kind), "");
            rig.run(Seconds(2.0));
            ASSERT_EQ(rig.ask(other), "");
            rig.run(Seconds(0.1));
            EXPECT_FALSE(rig.tuning().running) << words;
            EXPECT_TRUE(rig.outcome().failed);
            EXPECT_THAT(rig.outcome().text.toStdString(), HasSubstr(words));
            EXPECT_TRUE(rig.tuning().results.empty());
            rig.run(Seconds(3.0));
            if (!std::holds_alternative<request::PointAxes>(other)) {
                EXPECT_TRUE(rig.settle());
                const double place = rig.truth(Axis::Azimuth);
                rig.run(Seconds(3.0));
                EXPECT_NEAR(rig.truth(Axis::Azimuth), place, 0.02) << "nothing goes on by itself";
            }
        }
    }
}

// Story: after one run was ended by STOP, every kind of run of both axes was shown as ended by STOP.
// REQ-TUNING-21: The result of a run is reported with its axis and its kind.
TEST(TuningDesk, TheOutcomeNamesItsAxisAndRun)
{
    TuningRig rig;
    EXPECT_FALSE(rig.tuning().outcome);
    ASSERT_EQ(rig.start(TuningRun::Ramp, Axis::Elevation), "");
    rig.run(Seconds(2.0));
    ASSERT_EQ(rig.ask(request::Stop{}), "");
    rig.run(Seconds(0.1));
    EXPECT_TRUE(rig.outcome().failed);
    EXPECT_EQ(rig.outcome().axis, Axis::Elevation);
    EXPECT_EQ(rig.outcome().run, TuningRun::Ramp);
}

// REQ-TUNING-16
TEST(TuningDesk, AFaultEndsARun)
{
    TuningRig rig;
    ASSERT_EQ(rig.start(TuningRun::Sweep), "");
    rig.run(Seconds(3.0));
    rig.link->pair().drive(Axis::Azimuth).raiseFault(38);
    rig.run(Seconds(0.5));
    EXPECT_FALSE(rig.tuning().running);
    EXPECT_THAT(rig.outcome().text.toStdString(), HasSubstr("A fault ended the run"));
    EXPECT_EQ(rig.status().state, StationState::Fault);
    EXPECT_THAT(rig.start(TuningRun::Step), testing::Not(""));
}

// REQ-TUNING-17: The rules of every motion apply to a run: it is refused while STOP is latched, without control, and
// without room.
TEST(TuningDesk, ARunPassesTheGates)
{
    TuningRig low(sim::commissionedPair(), {.azimuth = 30_deg, .elevation = 0.2_deg});
    EXPECT_THAT(low.start(TuningRun::Sweep, Axis::Elevation), HasSubstr("needs 0.75° of free travel on both sides"));
    EXPECT_THAT(low.tuning().plans[1][static_cast<std::size_t>(TuningRun::Sweep)].obstacle.toStdString(),
                HasSubstr("needs 0.75°"));
    EXPECT_EQ(low.ask(request::GiveAuthority{}), "");
    EXPECT_THAT(low.start(TuningRun::Step), HasSubstr("The clients have control"));
    EXPECT_THAT(low.status().permissions.reason(Action::TuneAzimuth).toStdString(), HasSubstr("clients have"));
    ASSERT_EQ(low.ask(request::Stop{}), "");
    EXPECT_THAT(low.start(TuningRun::Step), HasSubstr("STOP"));
    EXPECT_THAT(low.ask(request::EndTuning{}), HasSubstr("No tuning run"));
}

// REQ-TUNING-18: A guided run measures the backlash of an axis, with its uncertainty.
TEST(TuningDesk, BacklashIsMeasured)
{
    sim::PairSettings pair = sim::commissionedPair();
    pair.azimuth.plant.backlash = 0.06 / 360.0;
    pair.azimuth.plant.loadShare = 0.6;
    TuningRig rig(pair);
    rig.watch();
    ASSERT_TRUE(rig.measures(TuningRun::Backlash));
    const response::BacklashFigures found = rig.result(TuningRun::Backlash).backlash.value();
    RecordProperty("gap", std::to_string(found.gap.degrees()));
    EXPECT_NEAR(found.gap.degrees(), 0.06, std::max(found.uncertainty.degrees(), 0.006));
    EXPECT_LT(found.uncertainty.degrees(), 0.02);
    EXPECT_LT(found.freeTorque, found.loadTorque);
    EXPECT_LT(rig.farthest, 0.5);
}

// REQ-TUNING-19: If the torque does not show the play, the run reports this and no number.
TEST(TuningDesk, BacklashThatTheMotorDoesNotFeelIsNotInvented)
{
    TuningRig rig;  // all friction in front of the gap
    ASSERT_EQ(rig.start(TuningRun::Backlash), "");
    ASSERT_TRUE(rig.ends());
    EXPECT_TRUE(rig.outcome().failed);
    EXPECT_THAT(rig.outcome().text.toStdString(), HasSubstr("so there is no result"));
}

}  // namespace
}  // namespace boresight::system_test
