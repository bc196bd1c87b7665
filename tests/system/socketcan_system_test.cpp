// SPDX-License-Identifier: GPL-3.0-or-later
// The whole path on a real CAN interface: needs vcan0, CAN-FD, up, and candump as an independent witness.
#include "tests/fakes/program.h"
#include "tests/fakes/wait_until.h"
#include "tests/system/boresightd_process.h"

#include <QRegularExpression>
#include <QSet>
#include <QStandardPaths>
#include <QTest>

#include <gtest/gtest.h>

#include <cmath>

namespace boresight::system_test {
namespace {

struct Witnessed
{
    QSet<QString> ids;
    QSet<qsizetype> sizes;
    int frames = 0;
    int padded = 0;  // end in 0x50, the sub-frame that means nothing
    int others = 0;  // lines that are no CAN-FD frame with bit-rate switch
};

// candump -L: "(1700000000.000000) vcan0 00008001##511001F..."; ## is CAN-FD, the digit its flags: 1 bit-rate switch,
// 4 (newer kernels) CAN-FD once more.
Witnessed read(const QString& candump)
{
    static const QRegularExpression line(QStringLiteral("^\\([0-9.]+\\) vcan0 ([0-9A-F]+)##[15]([0-9A-F]*)$"));
    Witnessed seen;
    for (const QString& text : candump.split(QLatin1Char('\n'), Qt::SkipEmptyParts)) {
        const auto match = line.match(text.trimmed());
        seen.others += match.hasMatch() ? 0 : 1;
        if (match.hasMatch()) {
            ++seen.frames;
            seen.padded += match.captured(2).endsWith(QStringLiteral("5050")) ? 1 : 0;
            seen.ids.insert(match.captured(1));
            seen.sizes.insert(match.capturedLength(2) / 2);
        }
    }
    return seen;
}

bool comesTo(fakes::TcpPeer& client, double azimuth, double elevation)
{
    for (int i = 0; i < 1000; ++i) {
        const QStringList lines = QString::fromStdString(client.ask("p\n", 2)).split(QLatin1Char('\n'));
        if (std::abs(lines.value(0).toDouble() - azimuth) < 0.1 &&
            std::abs(lines.value(1).toDouble() - elevation) < 0.1) {
            return true;
        }
        QTest::qWait(20);
    }
    return false;
}

TEST(SocketCanSystem, PointsTheMountWithFramesOfCanFd)
{
    fakes::Program candump(QStringLiteral("candump"), {QStringLiteral("-L"), QStringLiteral("vcan0")});
    fakes::Program mount(QStringLiteral(BORESIGHTCTL),
                         {QStringLiteral("simulate"), QStringLiteral("--can"), QStringLiteral("vcan0")});
    ASSERT_TRUE(mount.waitForLine(QStringLiteral("ready"))) << mount.errors().toStdString();
    BoresightdProcess boresightd({QStringLiteral("--bus"), QStringLiteral("socketcan:vcan0")});
    ASSERT_TRUE(boresightd.listens()) << boresightd.complaints();
    const auto client = boresightd.connect();
    std::string answer;
    for (int i = 0; i < 100 && answer != "RPRT 0\n"; ++i) {
        answer = client->ask("P 20 15\n");
        QTest::qWait(20);  // until it sees both drives
    }
    EXPECT_EQ(answer, "RPRT 0\n");
    EXPECT_TRUE(comesTo(*client, 20.0, 15.0));
    EXPECT_EQ(boresightd.terminate(), 0);
    mount.terminate();
    EXPECT_EQ(mount.waitForEnd(), 0);
    candump.terminate();
    static_cast<void>(candump.waitForEnd());

    const Witnessed seen = read(candump.output());
    EXPECT_GT(seen.frames, 400);
    EXPECT_GT(seen.padded, 100);
    EXPECT_EQ(seen.others, 0) << candump.output().left(300).toStdString();
    // To drives 1 and 2 with the request for a reply (0x8000: an extended id), and their replies to host 0.
    const QSet<QString> ids{QStringLiteral("00008001"), QStringLiteral("00008002"), QStringLiteral("100"),
                            QStringLiteral("200")};
    EXPECT_EQ(seen.ids, ids);
    for (const qsizetype size : seen.sizes) {
        EXPECT_TRUE(size <= 8 || QSet<qsizetype>({12, 16, 20, 24, 32, 48, 64}).contains(size)) << size;
    }
}

}  // namespace
}  // namespace boresight::system_test
