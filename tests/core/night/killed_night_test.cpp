// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/night/night_desk_fixture.h"
#include "tests/fakes/wait_until.h"

#include <QTemporaryDir>

#include <gmock/gmock.h>

namespace boresight {
namespace {

using testing::SizeIs;

class KilledNight : public NightDeskTest
{
protected:
    // The report as a program finds it in the folder when it starts.
    [[nodiscard]] schedule::NightReport reportAfterAKill()
    {
        ReportFile found(path());
        NightDesk again(rig.control, rig.inForce, found, rig.clock, rig.log, [](const auto&, const auto&) {});
        return again.status()->report;
    }
    [[nodiscard]] Seconds stored() const
    {
        const auto lost = ReportFile(path()).lostPass();
        return lost ? lost->tracked : Seconds(0.0);
    }

private:
    [[nodiscard]] QString path() const { return folder.filePath(QStringLiteral("night.toml")); }

    QTemporaryDir folder;

protected:
    ReportFile onDisk{path()};
    NightDesk killed{rig.control,
                     rig.inForce,
                     onDisk,
                     rig.clock,
                     rig.log,
                     [](const std::vector<passes::SatelliteSearch>& searches, const NightDesk::Found& found) {
                         found(passes::findPasses(searches));
                     }};
};

// REQ-SCHEDULE-921: The record of the running pass is stored every 30 s. After kill -9 or a power failure the report
// shows this pass as interrupted, and the log has a line about it. After more than a day a new report begins.
TEST_F(KilledNight, TheRunningPassIsInterrupted)
{
    const auto runKilled = [&](UtcTime until) {
        while (now() < until) {
            killed.tick();
            rig.tick();
        }
    };
    killed.setSatellites(threeSatellites());
    killed.tick();
    ASSERT_TRUE(killed.carryOut(request::ArmSchedule{}, kOperator));
    skipToBefore(first());
    runKilled(first().begins() - std::chrono::seconds(1));
    EXPECT_EQ(stored(), Seconds(0.0)) << "nothing of it was tracked yet";
    runKilled(first().begins() + std::chrono::seconds(65));
    ASSERT_TRUE(fakes::waitUntil([&] { return stored() > Seconds(55.0); }));
    EXPECT_LT(stored(), Seconds(62.0)) << "30 s apart";
    EXPECT_TRUE(onDisk.report().passes.empty()) << "the report of 500 passes is not written for it";

    const schedule::NightReport report = reportAfterAKill();
    ASSERT_THAT(report.passes, SizeIs(1));
    EXPECT_EQ(report.passes[0].end, schedule::PassEnd::Interrupted);
    EXPECT_EQ(report.passes[0].number, first().number);
    EXPECT_EQ(report.done(), 0);
    EXPECT_TRUE(logged("before this start was a pass of"));
    EXPECT_EQ(reportAfterAKill(), report) << "once, however often it is started";
    rig.clock.stepUtc(ReportKeeper::kSameNight + Seconds(600.0));
    EXPECT_EQ(reportAfterAKill(), schedule::NightReport{});
}

}  // namespace
}  // namespace boresight
