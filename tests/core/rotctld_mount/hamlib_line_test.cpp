// SPDX-License-Identifier: GPL-3.0-or-later
// The mount with a rotctld that Boresight starts itself. It is Hamlib's own program, with its dummy, and with its
// driver of a GS-232B on a pseudo-terminal.
#include "core/rotctld_mount/hamlib_line.h"

#include "core/base/file_descriptor.h"
#include "core/gs232_mount/gs232_box.h"
#include "tests/core/rotctld_mount/rotctld_rig.h"
#include "tests/fakes/pseudo_terminal.h"

#include <QDir>
#include <QFile>
#include <QStandardPaths>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <functional>
#include <memory>
#include <vector>

namespace boresight::rotctl {
namespace {

// The processes named rotctld that this process has started.
std::vector<pid_t> ownPrograms()
{
    std::vector<pid_t> found;
    for (const QString& name : QDir(QStringLiteral("/proc")).entryList(QDir::Dirs)) {
        QFile stat(QStringLiteral("/proc/%1/stat").arg(name));
        if (name.toInt() > 0 && stat.open(QIODevice::ReadOnly)) {
            const QString text = QString::fromLatin1(stat.readAll());
            if (text.contains(QStringLiteral("(rotctld) ")) && !text.contains(QStringLiteral(") Z ")) &&
                text.section(QStringLiteral(") "), -1).section(QLatin1Char(' '), 1, 1).toInt() == ::getpid()) {
                found.push_back(name.toInt());
            }
        }
    }
    return found;
}

std::unique_ptr<BoxLine> lineOf(const std::string& bus, const std::vector<std::string>& settings = {})
{
    constexpr int kBaud = 9600;
    return std::make_unique<HamlibLine>(
        HamlibRotator{.bus = parseBusName(bus).value(), .baud = kBaud, .settings = settings});
}

class HamlibProgram : public testing::Test
{
protected:
    void SetUp() override
    {
        if (QStandardPaths::findExecutable(QStringLiteral("rotctld")).isEmpty()) {
            GTEST_SKIP() << "rotctld is not installed (Debian package libhamlib-utils)";
        }
    }
    void TearDown() override { EXPECT_TRUE(ownPrograms().empty()) << "it ends with its line"; }

    // rotctld answers, and the rotator turns.
    static void startTurning(Rig& rig)
    {
        ASSERT_TRUE(rig.comesTrue([&] { return rig.place().has_value() && rig.connection->driver().answers(); }));
        ASSERT_EQ(ownPrograms().size(), 1U);
        ASSERT_TRUE(rig.control.request(request::PointAxes{{100_deg, 60_deg}}, kOperator));
        ASSERT_TRUE(rig.comesTrue([&] { return rig.place()->azimuth > 5_deg; }));
    }
    // Another rotctld answers, and nothing has moved by itself.
    static void expectRestarted(Rig& rig, pid_t before)
    {
        ASSERT_TRUE(rig.comesTrue([&] { return rig.connection->driver().answers() && !ownPrograms().empty(); }));
        ASSERT_EQ(ownPrograms().size(), 1U);
        EXPECT_NE(ownPrograms().front(), before);
        const auto received = rig.line().received;
        ASSERT_TRUE(rig.comesTrue([&] { return rig.line().received > received + 5; }));
        EXPECT_EQ(rig.place(), (AxisPosition{0_deg, 0_deg})) << "the dummy begins there";
    }
};

// REQ-ROTCTLDMOUNT-61: For a model of Hamlib Boresight starts rotctld on a free port that only this computer can reach.
// It uses this rotctld like any other, and ends it with the mount.
TEST_F(HamlibProgram, IsStartedAndDriven)
{
    Rig rig(lineOf("hamlib:1"));
    ASSERT_TRUE(rig.comesTrue([&] { return rig.place().has_value(); }));
    EXPECT_EQ(rig.line().name, QStringLiteral("hamlib:1"));
    EXPECT_EQ(rig.line().kind, QStringLiteral("rotctld"));
    EXPECT_TRUE(rig.connection->driver().interlock());
    ASSERT_TRUE(rig.control.request(request::PointAxes{{12_deg, 8_deg}}, kOperator));
    EXPECT_TRUE(rig.comesTrue([&] { return abs(rig.place()->azimuth - 12_deg) < 0.1_deg; }));
    EXPECT_TRUE(rig.comesTrue([&] { return abs(rig.place()->elevation - 8_deg) < 0.1_deg; }));
    const pid_t program = ownPrograms().front();
    EXPECT_EQ(::getpgid(program), program) << "Ctrl+C in the terminal is for Boresight";
    rig.connection->close();
    EXPECT_TRUE(fakes::waitUntil([] { return ownPrograms().empty(); }));
}

// REQ-ROTCTLDMOUNT-62: If the rotctld that Boresight has started ends or hangs, the rotator counts as silent and the
// motion ends. A rotctld that hangs is killed. Another one is started, and nothing moves by itself.
TEST_F(HamlibProgram, ThatIsKilledIsReportedAndStartedAgain)
{
    Rig rig(lineOf("hamlib:1"));
    ASSERT_NO_FATAL_FAILURE(startTurning(rig));
    const pid_t program = ownPrograms().front();
    ::kill(program, SIGKILL);
    ASSERT_TRUE(rig.comesTrue([&] { return rig.warns("rotator.line-down"); }));
    EXPECT_TRUE(rig.line().problem.contains(QStringLiteral("rotctld was killed or crashed")))
        << rig.line().problem.toStdString();
    expectRestarted(rig, program);
}

// REQ-ROTCTLDMOUNT-62
TEST_F(HamlibProgram, ThatHangsIsKilledAndStartedAgain)
{
    Rig rig(lineOf("hamlib:1"));
    ASSERT_NO_FATAL_FAILURE(startTurning(rig));
    const pid_t program = ownPrograms().front();
    ::kill(program, SIGSTOP);
    ASSERT_TRUE(rig.comesTrue([&] { return !rig.connection->driver().answers(); }));
    ASSERT_TRUE(rig.comesTrue([&] { return ::kill(program, 0) != 0; })) << "it is still there";
    expectRestarted(rig, program);
}

// REQ-ROTCTLDMOUNT-63: If the rotctld that Boresight has started ends at once, for example because of a wrong port or
// model, its last output is reported. If Hamlib is not installed, the alarm says what to install.
TEST_F(HamlibProgram, WithoutItsPortSaysWhy)
{
    Rig rig(lineOf("hamlib:603:/dev/no-such-port"));
    ASSERT_TRUE(rig.comesTrue([&] { return rig.warns("rotator.line-down"); }));
    const QString problem = rig.line().problem;
    EXPECT_TRUE(problem.startsWith(QStringLiteral("hamlib:603:/dev/no-such-port: rotctld ended with status 2: ")))
        << problem.toStdString();
    EXPECT_TRUE(problem.contains(QStringLiteral("Unable to open /dev/no-such-port"))) << problem.toStdString();
    EXPECT_EQ(rig.line().sent, 0U);
}

// REQ-ROTCTLDMOUNT-63
TEST_F(HamlibProgram, OfAModelThatDoesNotExistSaysWhy)
{
    Rig rig(lineOf("hamlib:99999"));
    ASSERT_TRUE(rig.comesTrue([&] { return rig.warns("rotator.line-down"); }));
    EXPECT_TRUE(rig.line().problem.contains(QStringLiteral("Unknown rot num 99999")))
        << rig.line().problem.toStdString();
}

// REQ-ROTCTLDMOUNT-67: The rotctld that Boresight starts gets the settings of Hamlib in the profile. Its limits are
// then those of the settings. If Hamlib refuses a setting, the alarm says where the settings are, and how to list their
// names.
TEST_F(HamlibProgram, HasTheSettingsOfTheProfile)
{
    Rig rig(lineOf("hamlib:1", {"min_az=-20.5", "max_az=300.5"}));
    ASSERT_TRUE(rig.comesTrue([&] { return rig.place().has_value(); }));
    const Result<>& fit = rig.connection->driver().interlock();
    ASSERT_FALSE(fit);
    for (const char* const limit : {"-20.5", "300.5"}) {
        EXPECT_TRUE(fit.error().text.contains(QLatin1String(limit))) << fit.error().text.toStdString();
    }
}

// REQ-ROTCTLDMOUNT-67
TEST_F(HamlibProgram, WithASettingThatHamlibRefusesSaysWhere)
{
    Rig rig(lineOf("hamlib:1", {"min_az=-90", "no_such_name=1"}));
    ASSERT_TRUE(rig.comesTrue([&] { return rig.warns("rotator.line-down"); }));
    EXPECT_TRUE(rig.line().problem.contains(QStringLiteral("bus.hamlib_settings"))) << rig.line().problem.toStdString();
    EXPECT_TRUE(rig.line().problem.contains(QStringLiteral("rotctl -m 1 -L")));
}

// REQ-ROTCTLDMOUNT-63
TEST_F(HamlibProgram, ThatIsNotInstalledIsToldWithItsPackage)
{
    const QByteArray path = qgetenv("PATH");
    qputenv("PATH", "/nonexistent");
    Rig rig(lineOf("hamlib:1"));
    rig.tick();
    qputenv("PATH", path);
    EXPECT_TRUE(rig.warns("rotator.line-down"));
    EXPECT_TRUE(rig.line().problem.contains(QStringLiteral("libhamlib-utils"))) << rig.line().problem.toStdString();
}

// A GS-232B on a pseudo-terminal, for Hamlib's driver 603.
struct SerialRotator
{
    void work(SteadyTime now)
    {
        box.take(terminal.takeWritten().toStdString(), now);
        if (const std::string bytes = box.answers(now); !bytes.empty()) {
            terminal.write(QByteArray::fromStdString(bytes));
        }
    }

    fakes::PseudoTerminal terminal;
    // Keeps the terminal open: it would hang up when the first rotctld ends.
    FileDescriptor keeper{::open(terminal.path().toLocal8Bit().constData(), O_RDWR | O_NOCTTY | O_CLOEXEC)};
    gs232::Gs232Box box{{},
                        {.acknowledge = gs232::Gs232Box::Acknowledge::None, .latency = std::chrono::milliseconds(5)}};
};

// REQ-ROTCTLDMOUNT-64: The control moves and stops a rotator on a serial port through a rotctld that Boresight has
// started. The last stop reaches the rotator before this rotctld ends.
TEST_F(HamlibProgram, TurnsARotatorOnASerialPort)
{
    SerialRotator rotator;
    Rig rig(lineOf("hamlib:603:" + rotator.terminal.path().toStdString()));
    const auto comesTrue = [&](const std::function<bool()>& condition) {
        return rig.comesTrue([&] {
            rotator.work(rig.clock.now());
            return condition();
        });
    };
    ASSERT_TRUE(comesTrue([&] { return rig.place().has_value() && rig.connection->driver().answers(); }));
    ASSERT_TRUE(rig.control.request(request::PointAxes{{20_deg, 15_deg}}, kOperator));
    EXPECT_TRUE(comesTrue([&] { return abs(rotator.box.truth().azimuth - 20_deg) < 2.5_deg; }));
    EXPECT_TRUE(comesTrue([&] { return abs(rotator.box.truth().elevation - 15_deg) < 2.5_deg; }));
    ASSERT_TRUE(rig.control.request(request::PointAxes{{150_deg, 70_deg}}, kOperator));
    ASSERT_TRUE(comesTrue([&] { return rotator.box.truth().azimuth > 30_deg; }));
    ASSERT_TRUE(rig.control.request(request::Stop{}, kOperator));
    rig.tick();
    const auto starts = rotator.box.heard().size();
    rig.connection->close();
    EXPECT_TRUE(fakes::waitUntil([&] {
        rig.clock.advance(Seconds(0.005));  // the box needs some time to answer
        rotator.work(rig.clock.now());
        return ownPrograms().empty();
    }));
    rotator.work(rig.clock.now());
    const auto& heard = rotator.box.heard();
    ASSERT_GT(heard.size(), starts);
    EXPECT_NE(std::find(heard.begin() + static_cast<std::ptrdiff_t>(starts), heard.end(), "S"), heard.end())
        << "the stop";
}

}  // namespace
}  // namespace boresight::rotctl
