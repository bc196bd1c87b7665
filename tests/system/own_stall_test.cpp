// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/system/simulated_station.h"

#include <gtest/gtest.h>

// This computer stalls more than once, or while drives are taken over. The drives have all their physics.
namespace boresight::system_test {
namespace {

// A mount on its way that must arrive whatever happens.
class Way
{
public:
    void setOff() { ASSERT_EQ(rig.ask(request::PointSky{{Angle::fromDegrees(60.0), Angle::fromDegrees(40.0)}}), ""); }
    void run(Seconds time) { rig.run(time); }
    void stall(Seconds time) { rig.clock.advance(time); }
    void expectResumption() { EXPECT_TRUE(rig.logSays(QStringLiteral("takes the drives over"))); }
    void expectArrival(const std::string& what)
    {
        EXPECT_TRUE(rig.settle()) << what;
        EXPECT_NE(rig.status().state, StationState::Fault) << what;
        EXPECT_NEAR(rig.truth(Axis::Azimuth), 60.0, 0.1) << what;
        EXPECT_NEAR(rig.truth(Axis::Elevation), 40.0, 0.1) << what;
    }

private:
    SimulatedStation rig;
};

// Story: this computer stalled for more than a second while a drive was taken over. The stall counted as a second in
// which the drive did not obey.
// REQ-CONTROL-06a (OwnStalls.*)
TEST(OwnStalls, WhileDrivesAreTakenOverTheyDoNotCountAsDisobedience)
{
    for (const double after : {0.0, 0.02, 0.04, 0.06, 0.1}) {
        for (const double seconds : {0.5, 1.2, 1.9}) {
            Way way;
            way.setOff();
            way.run(Seconds(after));
            way.stall(Seconds(seconds));
            way.expectArrival(std::to_string(after) + " " + std::to_string(seconds));
        }
    }
}

TEST(OwnStalls, ASecondOneMayMeetTheResumption)
{
    for (const double pause : {0.02, 0.04, 0.08, 0.2}) {
        Way way;
        way.setOff();
        way.run(Seconds(3.0));
        way.stall(Seconds(0.4));
        way.run(Seconds(pause));
        way.stall(Seconds(1.3));
        way.expectArrival(std::to_string(pause));
        way.expectResumption();
    }
}

// Story: a busy computer stalled six times in a row. After each stall the axes were compared with set-points that had
// gone on during the stall, and the sixth difference exceeded the limit.
TEST(OwnStalls, ARowOfThemDoesNotEndTheMotion)
{
    struct Row
    {
        int count;
        double stall;
        double pause;
    };
    for (const Row& row : {Row{6, 0.15, 0.04}, Row{6, 0.3, 0.02}, Row{20, 0.12, 0.06}, Row{15, 0.2, 0.1}}) {
        Way way;
        way.setOff();
        way.run(Seconds(3.0));
        for (int i = 0; i < row.count; ++i) {
            way.stall(Seconds(row.stall));
            way.run(Seconds(row.pause));
        }
        way.expectArrival(std::to_string(row.count) + " of " + std::to_string(row.stall));
        way.expectResumption();
    }
}

}  // namespace
}  // namespace boresight::system_test
