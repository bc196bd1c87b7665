// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/units/quantity.h"
#include "tests/fakes/wait_until.h"
#include "tests/system/programs/boresightd_process.h"

#include <QDeadlineTimer>
#include <QStandardPaths>
#include <QTest>

#include <gtest/gtest.h>

#include <cmath>

// Hamlib's own client program from Debian drives boresightd through its network backend: `rotctl -m 2`.
namespace boresight::system_test {
namespace {

class HamlibClient : public ::testing::Test
{
protected:
    void SetUp() override
    {
        if (QStandardPaths::findExecutable(QStringLiteral("rotctl")).isEmpty()) {
            GTEST_SKIP() << "rotctl is not installed (Debian package libhamlib-utils)";
        }
        ASSERT_TRUE(boresightd.listens()) << boresightd.complaints();
        const auto client = boresightd.connect();
        ASSERT_TRUE(fakes::waitUntil([&] { return client->ask("p\n").find("RPRT") == std::string::npos; }))
            << "the drives do not answer";
    }

    struct Outcome
    {
        int exitCode = -1;
        QString said;
    };
    // One run of rotctl with these commands as its arguments.
    [[nodiscard]] Outcome rotctl(const QStringList& commands) const
    {
        QProcess process;
        process.setProcessChannelMode(QProcess::MergedChannels);
        process.start(QStringLiteral("rotctl"),
                      QStringList{QStringLiteral("-m"), QStringLiteral("2"), QStringLiteral("-r"),
                                  QString::fromStdString(boresightd.address())} +
                          commands);
        const bool ended = fakes::waitUntil([&] { return process.state() == QProcess::NotRunning; });
        return {.exitCode = ended ? process.exitCode() : -1,
                .said = QString::fromUtf8(process.readAllStandardOutput())};
    }
    void expectAccepted(const QStringList& commands) const
    {
        const Outcome outcome = rotctl(commands);
        EXPECT_EQ(outcome.exitCode, 0) << outcome.said.toStdString();
        EXPECT_FALSE(outcome.said.contains(QStringLiteral("error"))) << outcome.said.toStdString();
    }
    struct Place
    {
        double azimuth;
        double elevation;
    };
    [[nodiscard]] Place position() const
    {
        const QStringList lines = rotctl({QStringLiteral("p")}).said.split(QLatin1Char('\n'));
        return {.azimuth = lines.value(0).toDouble(), .elevation = lines.value(1).toDouble()};
    }
    [[nodiscard]] bool comesTo(Place place) const
    {
        for (QDeadlineTimer deadline(std::chrono::seconds(30)); !deadline.hasExpired();) {
            const Place now = position();
            // so that 359.99° is near 0°
            const Angle turn = Angle::fromDegrees(now.azimuth - place.azimuth).wrapped180();
            if (abs(turn) < 0.1_deg && std::abs(now.elevation - place.elevation) < 0.1) {
                return true;
            }
            QTest::qWait(100);  // each question starts a program, and all tests share the processor
        }
        return false;
    }

    BoresightdProcess boresightd{{QStringLiteral("--simulate")}};
};

TEST_F(HamlibClient, PointsReadsAndParks)
{
    expectAccepted({QStringLiteral("P"), QStringLiteral("20"), QStringLiteral("15")});
    EXPECT_TRUE(comesTo({20.0, 15.0}));
    expectAccepted({QStringLiteral("K")});
    EXPECT_TRUE(comesTo({0.0, 0.0}));
}

TEST_F(HamlibClient, IsRefusedWhatMakesNoSense)
{
    const Outcome outcome = rotctl({QStringLiteral("P"), QStringLiteral("20"), QStringLiteral("200")});
    EXPECT_TRUE(outcome.said.contains(QStringLiteral("error"))) << outcome.said.toStdString();
    EXPECT_TRUE(comesTo({0.0, 10.0})) << "nothing has moved";
}

TEST_F(HamlibClient, StopsMovesResetsAndAsksWhoWeAre)
{
    expectAccepted({QStringLiteral("P"), QStringLiteral("180"), QStringLiteral("60")});
    expectAccepted({QStringLiteral("S")});
    const Place first = position();
    expectAccepted({QStringLiteral("R"), QStringLiteral("1")});
    EXPECT_TRUE(comesTo(position()));
    // The mount may have stopped before it began to move, slightly below 0°.
    EXPECT_LT(std::abs(std::remainder(first.azimuth, 360.0)), 100.0) << "S ended the way to 180°";
    expectAccepted({QStringLiteral("M"), QStringLiteral("16"), QStringLiteral("50"), QStringLiteral("p")});
    const Outcome outcome = rotctl({QStringLiteral("_")});
    EXPECT_EQ(outcome.exitCode, 0);
    EXPECT_TRUE(outcome.said.contains(QStringLiteral("Boresight"))) << outcome.said.toStdString();
}

}  // namespace
}  // namespace boresight::system_test
