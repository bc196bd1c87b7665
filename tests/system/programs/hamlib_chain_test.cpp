// SPDX-License-Identifier: GPL-3.0-or-later
// The bytes of Gpredict -> boresightd -> rotctld of Hamlib -> its dummy rotator: real programs from end to end.
#include "core/profile/profile.h"
#include "tests/fakes/program.h"
#include "tests/fakes/real_mount.h"
#include "tests/fakes/unused_port.h"
#include "tests/fakes/wait_until.h"
#include "tests/system/programs/boresightd_process.h"

#include <QDir>
#include <QFile>
#include <QStandardPaths>
#include <QTcpServer>
#include <QTemporaryDir>
#include <QTest>

#include <gtest/gtest.h>

#include <cmath>
#include <csignal>
#include <memory>
#include <sstream>
#include <string>

namespace boresight::system_test {
namespace {

struct Place
{
    double azimuth = -999.0;
    double elevation = -999.0;
};

profile::Profile hamlibMount()
{
    profile::Profile profile;
    for (profile::AxisSettings* const axis : {&profile.azimuth, &profile.elevation}) {
        axis->driver = profile::AxisDriver::Rotctld;
        axis->limits.speed = AngularRate::fromDegrees(6.0);
        axis->limits.acceleration = AngularAcceleration::fromDegrees(3.0);
        axis->limits.jerk = AngularJerk::fromDegrees(6.0);
    }
    return profile;
}

class HamlibChain : public testing::Test
{
protected:
    void SetUp() override
    {
        const QString path = QStandardPaths::findExecutable(QStringLiteral("rotctld"));
        if (path.isEmpty()) {
            GTEST_SKIP() << "rotctld is not installed (Debian package libhamlib-utils)";
        }
        const quint16 port = fakes::unusedPort();
        rotctld = std::make_unique<fakes::Program>(
            path, QStringList{QStringLiteral("-m"), QStringLiteral("1"), QStringLiteral("-T"),
                              QStringLiteral("127.0.0.1"), QStringLiteral("-t"), QString::number(port)});
        const QString bus = QStringLiteral("rotctld:127.0.0.1:%1").arg(port);
        boresightd = std::make_unique<BoresightdProcess>(fakes::confirmedMount(folder.path(), bus, hamlibMount()));
        ASSERT_TRUE(boresightd->listens()) << boresightd->complaints();
        gpredict = boresightd->connect();
        ASSERT_TRUE(fakes::waitUntil([&] { return gpredict->ask("p\n", 2).find("RPRT") == std::string::npos; }))
            << boresightd->complaints();
        dummy = std::make_unique<fakes::TcpPeer>("127.0.0.1", port, [] { QTest::qWait(1); });
    }
    static Place placeOf(fakes::TcpPeer& peer)
    {
        std::istringstream reply(peer.ask("p\n", 2));
        Place place;
        reply >> place.azimuth >> place.elevation;
        return place;
    }
    // As read by Gpredict, and as reported by the rotator itself.
    [[nodiscard]] bool comeTo(Place wanted)
    {
        return fakes::waitUntil([&] {
            for (fakes::TcpPeer* const peer : {gpredict.get(), dummy.get()}) {
                const Place now = placeOf(*peer);
                const double turn = std::remainder(now.azimuth - wanted.azimuth, 360.0);
                if (std::abs(turn) > 0.15 || std::abs(now.elevation - wanted.elevation) > 0.15) {
                    return false;
                }
            }
            return true;
        });
    }

    QTemporaryDir folder;
    std::unique_ptr<fakes::Program> rotctld;
    std::unique_ptr<BoresightdProcess> boresightd;
    std::unique_ptr<fakes::TcpPeer> gpredict;
    std::unique_ptr<fakes::TcpPeer> dummy;
};

// REQ-ROTCTLDMOUNT-50: The commands of Gpredict turn a rotator of Hamlib through Boresight. Its stop stops the rotator.
TEST_F(HamlibChain, GpredictTurnsTheDummyOfHamlib)
{
    ASSERT_EQ(gpredict->ask("P 20.00 15.00\n"), "RPRT 0\n");
    EXPECT_TRUE(comeTo({20.0, 15.0}));
    ASSERT_EQ(gpredict->ask("P 18,50 16,25\n"), "RPRT 0\n") << "in a locale with a comma";
    EXPECT_TRUE(comeTo({18.5, 16.25}));
    ASSERT_EQ(gpredict->ask("P 175.00 80.00\n"), "RPRT 0\n");
    ASSERT_TRUE(fakes::waitUntil([&] { return placeOf(*dummy).azimuth > 22.0; }));
    ASSERT_EQ(gpredict->ask("S\n"), "RPRT 0\n");
    Place stood;
    EXPECT_TRUE(fakes::waitUntil([&] {
        const Place now = placeOf(*dummy);
        const bool stands = now.azimuth == stood.azimuth && now.elevation == stood.elevation;
        stood = now;
        QTest::qWait(300);
        return stands;
    }));
    EXPECT_LT(stood.azimuth, 150.0);
    EXPECT_LT(stood.elevation, 79.0);
    gpredict->send("q\n");
    EXPECT_EQ(gpredict->receiveUntilClosed(), "");
    EXPECT_EQ(boresightd->terminate(), 0);
}

// The process named rotctld that has this process for its parent. 0: none.
pid_t childOf(qint64 parent)
{
    for (const QString& name : QDir(QStringLiteral("/proc")).entryList(QDir::Dirs)) {
        QFile stat(QStringLiteral("/proc/%1/stat").arg(name));
        if (name.toInt() > 0 && stat.open(QIODevice::ReadOnly)) {
            const QString text = QString::fromLatin1(stat.readAll());
            if (text.contains(QStringLiteral("(rotctld)")) &&
                text.section(QStringLiteral(") "), -1).section(QLatin1Char(' '), 1, 1).toLongLong() == parent) {
                return name.toInt();
            }
        }
    }
    return 0;
}

// True also for a process that has ended but was not waited for (a zombie).
bool hasEnded(pid_t process)
{
    QFile stat(QStringLiteral("/proc/%1/stat").arg(process));
    return !stat.open(QIODevice::ReadOnly) || stat.readAll().contains(") Z ");
}

// REQ-ROTCTLDMOUNT-65: A rotctld of our own ends with Boresight, also where Boresight is killed.
TEST(HamlibOwnRotctld, EndsWithBoresight)
{
    if (QStandardPaths::findExecutable(QStringLiteral("rotctld")).isEmpty()) {
        GTEST_SKIP() << "rotctld is not installed (Debian package libhamlib-utils)";
    }
    for (const bool killed : {true, false}) {
        const QTemporaryDir folder;
        BoresightdProcess boresightd(fakes::confirmedMount(folder.path(), QStringLiteral("hamlib:1"), hamlibMount()));
        ASSERT_TRUE(boresightd.listens()) << boresightd.complaints();
        const auto client = boresightd.connect();
        ASSERT_TRUE(fakes::waitUntil([&] { return client->ask("p\n", 2).find("RPRT") == std::string::npos; }))
            << boresightd.complaints();
        const pid_t rotctld = childOf(boresightd.process());
        ASSERT_GT(rotctld, 0);
        if (killed) {
            boresightd.kill();
        } else {
            EXPECT_EQ(boresightd.terminate(), 0);
        }
        EXPECT_TRUE(fakes::waitUntil([&] { return hasEnded(rotctld); })) << killed;
    }
}

}  // namespace
}  // namespace boresight::system_test
