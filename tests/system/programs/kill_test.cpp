// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/sim_bus/pty_server.h"
#include "core/station/real_time.h"
#include "tests/fakes/real_mount.h"
#include "tests/fakes/text_of.h"
#include "tests/fakes/wait_until.h"
#include "tests/system/programs/boresightd_process.h"
#include "tests/system/standing.h"

#include <QTest>

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

// The program dies while the mount moves: the drives stop the mount by their own watchdog. boresightd runs as a
// separate process in real time. The simulated drives are in this process behind a pseudo-terminal, so their true
// motion is known.
namespace boresight::system_test {
namespace {

// Backlash, and the overshoot of 0.03° that the drive corrects after standing still.
constexpr Angle kKillStill = Angle::fromDegrees(0.05);

// The program needs less to get replies from both drives.
constexpr Seconds kLongRefusal{10.0};

class KillTest : public ::testing::Test
{
protected:
    void SetUp() override
    {
        realTime.ask();  // the drives keep their timing whatever other load the computer has
        auto created = sim::PtyServer::create(terminal, pair, clock);
        ASSERT_TRUE(created) << textOf(created.error());
        server = std::move(*created);
        startWhereItStands();
    }

    [[nodiscard]] std::unique_ptr<BoresightdProcess> start(const QStringList& more = {}) const
    {
        return std::make_unique<BoresightdProcess>(
            fakes::confirmedMount(folder.path(), QStringLiteral("fdcanusb:") + terminal) +
            QStringList{QStringLiteral("--state-dir"), folder.path()} + more);
    }
    // The operator enters where the mount stands.
    void startWhereItStands()
    {
        boresightd.reset();
        const double azimuth = truth(Axis::Azimuth).angle.degrees();
        const double elevation = truth(Axis::Elevation).angle.degrees();
        boresightd =
            start(fakes::standingAt(QStringLiteral("%1,%2").arg(azimuth, 0, 'f', 2).arg(elevation, 0, 'f', 2)));
        ASSERT_TRUE(boresightd->listens()) << boresightd->complaints();
        client = boresightd->connect();
    }
    sim::AxisTruth truth(Axis axis)
    {
        pair.advanceTo(clock.now() - epoch);
        return pair.truth(axis);
    }
    // The program answers RPRT -6 until it has replies from both drives. If the computer ran nothing for longer than
    // their watchdog time, the drives have stopped: they are re-armed and commanded again. After a longer time the
    // program does not know the cable wrap any more, and no client can enter it. Then the program starts anew.
    void setsOff(const std::string& command, const std::function<bool()>& reached)
    {
        SteadyTime refusedFrom = clock.now();
        EXPECT_TRUE(fakes::waitUntil([&] {
            if (reached()) {
                return true;
            }
            if (abs(truth(Axis::Azimuth).rate) > kStandingStill || client->ask(command) == "RPRT 0\n" ||
                client->ask("R 1\n") == "RPRT 0\n") {
                refusedFrom = clock.now();
            } else if (clock.now() - refusedFrom > kLongRefusal) {
                startWhereItStands();
                refusedFrom = clock.now();
            }
            return false;
        })) << boresightd->complaints();
    }
    void setsOff(const std::string& command, AngularRate rate)
    {
        setsOff(command, [this, rate] { return abs(truth(Axis::Azimuth).rate) > rate; });
    }

    struct Sample
    {
        Seconds time;
        AxisPosition place;
        AngularRate fastest;  // of both axes
    };
    std::vector<Sample> watch(Seconds duration)
    {
        std::vector<Sample> samples;
        const SteadyTime begin = clock.now();
        for (SteadyTime now = begin; now - begin < duration; now = clock.now()) {
            const sim::AxisTruth azimuth = truth(Axis::Azimuth);
            const sim::AxisTruth elevation = truth(Axis::Elevation);
            samples.push_back(
                {now - begin, {azimuth.angle, elevation.angle}, std::max(abs(azimuth.rate), abs(elevation.rate))});
            QTest::qWait(1);
        }
        return samples;
    }
    static Angle apart(const AxisPosition& one, const AxisPosition& other)
    {
        return std::max(abs(one.azimuth - other.azimuth), abs(one.elevation - other.elevation));
    }
    // The time when it finally stood still.
    static Seconds restTime(const std::vector<Sample>& samples)
    {
        const auto moving = std::find_if(samples.rbegin(), samples.rend(),
                                         [](const Sample& sample) { return sample.fastest > kStandingStill; });
        return moving == samples.rend() ? Seconds(0.0) : moving->time;
    }
    // The longest time in which this program, and with it the drives, did not run. Earlier frames are answered after
    // it.
    static Seconds longestPause(const std::vector<Sample>& samples)
    {
        Seconds longest(0.0);
        for (std::size_t i = 1; i < samples.size(); ++i) {
            longest = std::max(longest, samples[i].time - samples[i - 1].time);
        }
        return longest;
    }
    // The watchdog time of the drives is 0.1 s, and then they brake.
    static void expectRestAtOnce(const std::vector<Sample>& samples)
    {
        EXPECT_LT(restTime(samples), Seconds(0.2) + longestPause(samples));
        RecordProperty("rest_after_kill_s", QString::number(restTime(samples).count(), 'f', 3).toStdString());
    }
    void expectNothingMovesFor(Seconds duration)
    {
        const auto samples = watch(duration);
        for (const Sample& sample : samples) {
            ASSERT_LT(apart(sample.place, samples.front().place), kKillStill) << sample.time.count() << " s";
        }
    }

    QTemporaryDir folder;
    const QString terminal = folder.filePath(QStringLiteral("mount"));
    RealTime realTime;
    SystemClock clock;
    sim::SimulatedPair pair{sim::commissionedPair()};
    const SteadyTime epoch = clock.now();
    std::unique_ptr<sim::PtyServer> server;
    std::unique_ptr<BoresightdProcess> boresightd;
    std::unique_ptr<fakes::TcpPeer> client;
};

TEST_F(KillTest, TheDrivesStopTheMountAndNothingMovesAfterwards)
{
    setsOff("M 16 100\n", 5.9_deg_s);  // 6 °/s clockwise
    boresightd->kill();
    const auto samples = watch(Seconds(1.5));
    EXPECT_GT(apart(samples.front().place, samples.back().place), 0.3_deg) << "it was moving";
    expectRestAtOnce(samples);
    EXPECT_EQ(truth(Axis::Azimuth).mode, moteus::Mode::PositionTimeout);

    boresightd = start();  // the journal proves that the drives never lost power, so nobody is asked for the wrap
    ASSERT_TRUE(boresightd->listens()) << boresightd->complaints();
    expectNothingMovesFor(Seconds(1.5));
    client = boresightd->connect();
    // RPRT -6 is the reply while a drive's last position is too old, for example after this computer ran nothing for a
    // moment.
    EXPECT_TRUE(fakes::waitUntil([&] { return client->ask("|p\n").ends_with("RPRT 0\n"); }));
    expectNothingMovesFor(Seconds(0.5));
    setsOff("P 0 10\n", [this] { return abs(truth(Axis::Azimuth).angle) < 0.1_deg; });
}

TEST_F(KillTest, TheDrivesStopTheFastestMoveToo)
{
    setsOff("P 200 60\n", 9.9_deg_s);
    boresightd->kill();
    expectRestAtOnce(watch(Seconds(1.0)));
}

TEST_F(KillTest, AnOrderlyEndDeceleratesAndLeavesTheDrivesHolding)
{
    setsOff("P 200 60\n", 9.0_deg_s);
    const std::optional<int> code = boresightd->terminate();
    EXPECT_EQ(code, 0);
    EXPECT_LT(abs(truth(Axis::Azimuth).rate), 0.1_deg_s) << "it ends after the mount has come to rest";
    expectNothingMovesFor(Seconds(1.0));
    for (const Axis axis : {Axis::Azimuth, Axis::Elevation}) {
        EXPECT_EQ(truth(axis).mode, moteus::Mode::PositionTimeout) << "on_exit = hold: the drive's own time-out mode";
    }
}

}  // namespace
}  // namespace boresight::system_test
