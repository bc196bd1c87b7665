// SPDX-License-Identifier: GPL-3.0-or-later
// The complete chain on real CAN interfaces. It needs vcan0, up and with CAN-FD, and the right to change it (User-Mode
// Linux gives both). can-utils serve as an independent check, as the cable, and as a program that floods the bus.
#include "core/moteus/diagnostic.h"
#include "core/tracking/emergency_braking.h"
#include "tests/system/programs/socketcan_mount.h"

#include <QCoreApplication>
#include <QFile>
#include <QRegularExpression>
#include <QSet>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

namespace boresight::system_test {
namespace {

struct Witnessed
{
    QSet<QString> ids;
    QSet<qsizetype> sizes;
    int frames = 0;
    int padded = 0;  // frames that end in 0x50, the sub-frame without effect
    int others = 0;  // lines that are no CAN-FD frame with bit-rate switch
};

// candump -L: "(1700000000.000000) vcan0 00008001##511001F..." "##" means CAN-FD. The digit has its flags: 1 is the
// bit-rate switch, 4 (newer kernels) says CAN-FD again.
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

unsigned long long framesOnTheBus()
{
    QFile count(QStringLiteral("/sys/class/net/vcan0/statistics/rx_packets"));
    return count.open(QIODevice::ReadOnly) ? count.readAll().trimmed().toULongLong() : 0;
}

// Whether it is a moteus identifier: a request to one drive or to all (destination), or a reply of a drive to host 0.
bool isMoteusId(const QString& text)
{
    const std::uint32_t id = text.toUInt(nullptr, 16);
    const std::uint32_t source = (id >> 8U) & 0x7fU;
    const std::uint32_t destination = id & 0x7fU;
    const auto isOurs = [](std::uint32_t number) {
        return number == moteus::kHostId || number == moteus::kDiagnosticHostId;
    };
    // the drive check also queries id 16 with its own source number
    return (id & ~0xff7fU) == 0 && (isOurs(source) || isOurs(destination));
}

TEST(SocketCanSystem, PointsTheMountWithFramesOfCanFd)
{
    fakes::Program candump(QStringLiteral("candump"), {QStringLiteral("-L"), QStringLiteral("vcan0")});
    MountOnCan mount(QStringLiteral("vcan0"), QStringLiteral("vcan0"));
    ASSERT_TRUE(mount.starts());
    EXPECT_TRUE(mount.comesTo(20.0, 15.0)) << mount.log();
    EXPECT_TRUE(mount.endsWell());
    candump.terminate();
    static_cast<void>(candump.waitForEnd());

    const Witnessed seen = read(candump.output());
    std::printf("candump saw %d CAN-FD frames with bit-rate switch, %d of them padded with 50, %d others\n",
                seen.frames, seen.padded, seen.others);
    EXPECT_GT(seen.frames, 400);
    EXPECT_GT(seen.padded, 100);
    EXPECT_EQ(seen.others, 0) << candump.output().left(300).toStdString();
    // To drives 1 and 2 with the request for a reply (0x8000: an extended id), and their replies to host 0. The drive
    // check has its own source number.
    for (const char* id : {"00008001", "00008002", "100", "200"}) {
        EXPECT_TRUE(seen.ids.contains(QLatin1String(id))) << id;
    }
    for (const QString& id : seen.ids) {
        EXPECT_TRUE(isMoteusId(id)) << id.toStdString();
        EXPECT_EQ(id.size() == 8, id.toUInt(nullptr, 16) > 0x7ff) << id.toStdString();  // extended only if necessary
    }
    for (const qsizetype size : seen.sizes) {
        EXPECT_TRUE(size <= 8 || QSet<qsizetype>({12, 16, 20, 24, 32, 48, 64}).contains(size)) << size;
    }
}

// The drives stay powered on vcan1. vcan0 is the adapter, and its cable is the kernel's gateway between the two.
constexpr const char* kPlugIn = "cangw -A -s vcan0 -d vcan1 -X -e && cangw -A -s vcan1 -d vcan0 -X -e";

class SocketCanOutage : public testing::Test
{
protected:
    void SetUp() override
    {
        if (!run("modprobe -d /run/uml can-gw 2>/dev/null") || !run(kPlugIn)) {
            GTEST_SKIP() << "no CAN gateway here (kernel module can-gw, program cangw of can-utils)";
        }
        ASSERT_TRUE(mount.starts());
        ASSERT_TRUE(mount.notesProof()) << mount.log();
        ASSERT_TRUE(mount.slews("P 400 40")) << mount.log();
    }
    void TearDown() override { static_cast<void>(run("cangw -F 2>/dev/null")); }

    // The words are in the log at once, and the mount stands still.
    void expectStop(const char* how, const std::string& command, const std::string& words)
    {
        const std::size_t logBefore = mount.log().size();
        // The command takes about 0.1 s, or a second on a busy computer, and the mount slews meanwhile. The lines of
        // that time are read afterwards.
        ASSERT_TRUE(run(command));
        QCoreApplication::processEvents();
        const std::size_t before = mount.truths().size();
        const auto starvedBefore = mount.starved();
        const auto told = mount.waitForWords(words, logBefore);
        ASSERT_TRUE(told.has_value()) << mount.log();
        const auto stop = mount.standstillAfter(before);
        ASSERT_TRUE(stop.has_value());
        // time in which no program could report or stop anything
        const Seconds starved = mount.starved() - starvedBefore;
        std::printf("%s in a slew: said after %lld ms, at rest within %.2f s and %.2f degrees; starved for %.2f s\n",
                    how, *told, stop->time, stop->excursion, starved.count());
        EXPECT_LT(Seconds(std::chrono::milliseconds(*told)), Seconds(0.3) + starved) << "after the command was done";
        // 0.2 s for the watchdog and the braking from 10°/s, measured with lines a tenth of a second apart, on a busy
        // computer.
        EXPECT_LT(Seconds(stop->time), Seconds(1.0) + starved);
        EXPECT_LT(stop->excursion, 6.0 + 10.0 * starved.count());
        // "No reply" or "timed out", depending on the time that the guest had to detect it.
        EXPECT_TRUE(mount.waitForWords("Boresight ended the motion", logBefore).has_value()) << mount.log();
        EXPECT_TRUE(mount.waitForWords("press Re-arm", logBefore).has_value()) << mount.log();
    }

    // Three seconds after the bus is back nothing has moved, and a client is refused. Then the mount is re-armed and
    // obeys.
    void expectRestUntilReArmed(const std::string& command)
    {
        const std::size_t before = mount.truths().size();
        const std::size_t logBefore = mount.log().size();
        ASSERT_TRUE(run(command));
        ASSERT_TRUE(mount.waitForWords("bus [bus.down]: Cleared: ", logBefore).has_value()) << mount.log();
        ASSERT_TRUE(mount.waitForTruths(30));
        EXPECT_NE(mount.ask("P 50 20"), "RPRT 0\n") << mount.log();
        ASSERT_TRUE(mount.waitForTruths(10));
        std::printf("4 s after its return the mount has moved %.3f degrees\n", mount.largestMotion(before));
        EXPECT_LT(mount.largestMotion(before), 0.05);
        ASSERT_TRUE(mount.reArms()) << mount.log();
        EXPECT_TRUE(mount.comesTo(50.0, 20.0)) << mount.log();
    }

    MountOnCan mount{QStringLiteral("vcan1"), QStringLiteral("vcan0")};
};

// REQ-CAN-20 (SocketCanOutage.*): On a real interface a slewing mount stops when the interface goes down or is removed,
// reports this within 300 ms, and moves again only after a re-arm. With a bus flooded by another program the mount
// stays under control or stops, with a report.
TEST_F(SocketCanOutage, InterfaceDownInMotionStopsTheMountUntilReArmed)
{
    expectStop("interface down", "ip link set vcan0 down",
               "socketcan:vcan0: the interface is down. Bring it up with `ip link set vcan0 mtu 72 up`");
    expectRestUntilReArmed("ip link set vcan0 up");
}

TEST_F(SocketCanOutage, InterfaceRemovedInMotionStopsTheMountUntilItIsBackAndReArmed)
{
    expectStop("interface removed", "ip link del vcan0",
               "socketcan:vcan0: the interface was removed. Plug the adapter in again");
    expectRestUntilReArmed(std::string("ip link add vcan0 type vcan && ip link set vcan0 mtu 72 up && ") + kPlugIn);
}

struct Flood
{
    const char* name;
    QStringList identifier;
};

// Frames to drive 5, which does not exist: a frame to 1 or 2 would be a command. On a real bus smaller identifiers have
// priority. A virtual bus has no arbitration, but the flood takes computing time and room in the sockets.
class SocketCanFlood : public testing::TestWithParam<Flood>
{};

// REQ-CAN-20 (SocketCanFlood.*)
TEST_P(SocketCanFlood, MountStaysUnderControlOrStopsAndSaysSo)
{
    MountOnCan mount(QStringLiteral("vcan0"), QStringLiteral("vcan0"));
    ASSERT_TRUE(mount.starts());
    ASSERT_TRUE(mount.notesProof()) << mount.log();
    ASSERT_TRUE(mount.slews("P 400 30")) << mount.log();

    const std::size_t logBefore = mount.log().size();
    const std::size_t before = mount.truths().size();
    const double timeBefore = mount.truth().time;
    fakes::Program cangen(QStringLiteral("cangen"),
                          QStringList{QStringLiteral("vcan0"), QStringLiteral("-g"), QStringLiteral("0"),
                                      QStringLiteral("-i"), QStringLiteral("-L"), QStringLiteral("8")} +
                              GetParam().identifier);
    const unsigned long long framesBefore = framesOnTheBus();
    ASSERT_TRUE(mount.waitForTruths(40));
    const double seconds = mount.truth().time - timeBefore;
    const unsigned long long flood = framesOnTheBus() - framesBefore;
    cangen.terminate();
    static_cast<void>(cangen.waitForEnd());
    ASSERT_TRUE(mount.waitForTruths(10));

    const bool stopped = mount.log().find("press Re-arm", logBefore) != std::string::npos;
    std::printf("%s, %.0f frames a second for %.1f s: %s at azimuth %.2f\n%s", GetParam().name,
                static_cast<double>(flood) / seconds, seconds,
                stopped ? "the mount stopped and said so" : "the mount stayed under control", mount.truth().azimuth,
                mount.log().substr(logBefore).c_str());
    constexpr double kSurelyAFlood = 3000.0;  // frames a second; a busy computer may send fewer
    if (static_cast<double>(flood) / seconds > kSurelyAFlood) {
        EXPECT_NE(mount.log().find("Another program floods the bus", logBefore), std::string::npos);
    }
    // An axis catches up after frames that come late or in pairs, at most at the drives' own limit, which is 1.5 times
    // that of the profile. A drive that catches up while the set-point brakes overshoots at most by its lag: 0.25 s at
    // 10°/s. After that the replies count as missing.
    for (const Truth& truth : mount.truths()) {
        EXPECT_LT(std::abs(truth.azimuthRate), 1.05 * tracking::kLimitGuard * 10.0);
        EXPECT_LT(truth.elevation, 30.0 + 2.5);
    }
    if (stopped) {
        ASSERT_TRUE(mount.standstillAfter(before).has_value());
        const std::size_t atRest = mount.truths().size() - 1;
        ASSERT_TRUE(mount.waitForTruths(20));
        EXPECT_LT(mount.largestMotion(atRest), 0.05);
        EXPECT_TRUE(mount.reArms()) << mount.log();
    }
    EXPECT_TRUE(mount.comesTo(20.0, 30.0)) << mount.log();
}

INSTANTIATE_TEST_SUITE_P(
    Priorities, SocketCanFlood,
    testing::Values(Flood{"Higher", {QStringLiteral("-I"), QStringLiteral("005")}},
                    Flood{"Lower", {QStringLiteral("-e"), QStringLiteral("-I"), QStringLiteral("1FFF0505")}}),
    [](const auto& flood) { return flood.param.name; });

TEST(SocketCanSystem, CanUpRecognisesAVirtualInterface)
{
    ASSERT_TRUE(run("ip link set vcan0 down && ip link set vcan0 mtu 16"));
    fakes::Program canUp(QStringLiteral(CAN_UP), {QStringLiteral("vcan0")});
    EXPECT_EQ(canUp.waitForEnd(), 0);
    EXPECT_TRUE(canUp.errors().contains(QStringLiteral("vcan0 is a virtual CAN interface, without bit timing")))
        << canUp.errors().toStdString();
    EXPECT_TRUE(canUp.errors().contains(QStringLiteral("right: mtu 72 (wanted 72)"))) << canUp.errors().toStdString();
    EXPECT_TRUE(run("ip link show vcan0 | grep -q '<.*UP.*> mtu 72'"));
}

}  // namespace
}  // namespace boresight::system_test
