// SPDX-License-Identifier: GPL-3.0-or-later
// boresightd as a systemd service: signals, limits, the watchdog of the service, the permissions of its files.
#include "core/base/file_descriptor.h"
#include "tests/fakes/program.h"
#include "tests/fakes/tcp_peer.h"
#include "tests/fakes/wait_until.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <gmock/gmock.h>
#include <sys/socket.h>
#include <sys/un.h>

#include <array>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstring>
#include <memory>
#include <mutex>
#include <thread>

namespace boresight {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::Not;
using namespace std::chrono_literals;

const QByteArray kProfile = "version = 1\n";

class ServiceTest : public testing::Test
{
protected:
    void SetUp() override { write(kProfile); }
    void TearDown() override
    {
        for (const char* const name : {"NOTIFY_SOCKET", "WATCHDOG_USEC", "WATCHDOG_PID"}) {
            qunsetenv(name);
        }
    }
    void write(const QByteArray& profile) const { write(path, profile); }
    static void write(const QString& where, const QByteArray& bytes)
    {
        QFile file(where);
        ASSERT_TRUE(file.open(QIODevice::WriteOnly));
        ASSERT_EQ(file.write(bytes), bytes.size());
    }
    // `before` is what the shell does first.
    void start(const QString& before = QStringLiteral(":"))
    {
        program = std::make_unique<fakes::Program>(
            QStringLiteral("/bin/sh"),
            QStringList{QStringLiteral("-c"), before + QStringLiteral("; echo $$; exec \"$0\" \"$@\""),
                        QStringLiteral(BORESIGHTD), QStringLiteral("--state-dir"), folder.path(),
                        QStringLiteral("--listen"), QStringLiteral("127.0.0.1:0")} +
                arguments);
        ASSERT_TRUE(program->waitForLine(QStringLiteral("rotctld listening on"))) << errors();
        process = program->lines().constFirst().toInt();
    }
    void send(int signal) const
    {
        ASSERT_GT(process, 0) << "0 is everybody here";
        ASSERT_EQ(::kill(process, signal), 0);
    }
    [[nodiscard]] std::unique_ptr<fakes::TcpPeer> connect() const
    {
        const int port = program->lines().constLast().section(QLatin1Char(':'), -1).toInt();
        return std::make_unique<fakes::TcpPeer>("127.0.0.1", std::uint16_t(port), [] { QTest::qWait(1); });
    }
    [[nodiscard]] bool says(const char* text) { return program->waitForError(QString::fromUtf8(text)); }
    [[nodiscard]] std::string errors() const { return program->errors().toStdString(); }
    // Friction may leave a drive a hundredth of a degree beside its target.
    [[nodiscard]] static bool isNear(const std::string& reply, double azimuth, double elevation)
    {
        constexpr double kNear = 0.05;
        const QStringList lines = QString::fromStdString(reply).split(QLatin1Char('\n'));
        return lines.size() >= 2 && std::abs(lines[0].toDouble() - azimuth) < kNear &&
               std::abs(lines[1].toDouble() - elevation) < kNear;
    }
    void expectOrderlyEnd()
    {
        program->terminate();
        EXPECT_EQ(program->waitForEnd(), 0) << errors();
    }

    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("profile.toml"));
    QStringList arguments = {QStringLiteral("--profile"), path};
    std::unique_ptr<fakes::Program> program;
    pid_t process = 0;
};

// Story: SIGHUP, which makes other services reload, ended this one at once during a motion.
// REQ-APP-43a: A profile that is read again (SIGHUP) is applied like the operator's own changes. Changes that need a
// restart are named. A profile that cannot be read, or belongs to another mount, changes nothing.
TEST_F(ServiceTest, HangUpReadsTheProfileAgain)
{
    start();
    write(kProfile + "[jog]\nfast_deg_s = 5\n");
    send(SIGHUP);
    EXPECT_TRUE(says("the profile was read again and is in force")) << errors();
    EXPECT_THAT(errors(), HasSubstr("changes jog.fast_deg_s"));
    write(kProfile + "[jog]\nfast_deg_s = 5\n[azimuth]\nid = 7\n");
    send(SIGHUP);
    EXPECT_TRUE(says("These settings wait for a restart: azimuth.id")) << errors();
    expectOrderlyEnd();
}

// REQ-APP-43a
TEST_F(ServiceTest, HangUpDoesNotEndTheMotion)
{
    start();
    const auto client = connect();
    ASSERT_TRUE(fakes::waitUntil([&client] { return client->ask("P 15 15\n") == "RPRT 0\n"; }));
    write(kProfile + "[jog]\nfast_deg_s = 5\n");
    send(SIGHUP);
    EXPECT_TRUE(says("the profile was read again and is in force")) << errors();
    EXPECT_TRUE(fakes::waitUntil([&client] { return isNear(client->ask("p\n", 2), 15.0, 15.0); })) << errors();
    EXPECT_EQ(errors().find("ends the motion"), std::string::npos) << errors();
    expectOrderlyEnd();
}

// REQ-APP-43a
TEST_F(ServiceTest, AProfileThatCannotBeReadLeavesTheOldOneInForce)
{
    start();
    write("version = 1\n[jog]\nfast_deg_s = \"quick\"\n");
    send(SIGHUP);
    EXPECT_TRUE(says("the profile was not applied, so the previous profile stays in force")) << errors();
    EXPECT_THAT(errors(), HasSubstr("profile.toml:3: jog.fast_deg_s"));
    QFile::remove(path);
    send(SIGHUP);
    EXPECT_TRUE(says("No such file")) << errors();
    expectOrderlyEnd();
}

// REQ-APP-43a
TEST_F(ServiceTest, HangUpOfASimulationReadsTheProfileOfTheMountAndWritesNothing)
{
    const QByteArray real = kProfile + "[bus]\nname = \"fdcanusb:/dev/nothing\"\n";
    write(real);
    arguments << QStringLiteral("--simulate");
    start();
    const QByteArray changed = real + "[jog]\nfast_deg_s = 5\n";
    write(changed);
    send(SIGHUP);
    EXPECT_TRUE(says("the profile was read again and is in force")) << errors();
    expectOrderlyEnd();
    QFile file(path);
    ASSERT_TRUE(file.open(QIODevice::ReadOnly));
    EXPECT_EQ(file.readAll(), changed);
    EXPECT_FALSE(QFile::exists(folder.filePath(QStringLiteral("simulated"))));
}

// Story: the window had made another mount the current one, and SIGHUP gave the limits of that mount to the mount of
// the service.
// REQ-APP-43a
TEST_F(ServiceTest, HangUpDoesNotTakeTheProfileOfAnotherMount)
{
    const QString profiles = folder.filePath(QStringLiteral("boresight/profiles"));
    ASSERT_TRUE(QDir().mkpath(profiles));
    write(profiles + QStringLiteral("/roof.toml"), kProfile + "[mount]\nname = \"roof\"\n");
    write(profiles + QStringLiteral("/field.toml"), kProfile + "[mount]\nname = \"field\"\n[jog]\nfast_deg_s = 5\n");
    write(profiles + QStringLiteral("/current"), "roof.toml\n");
    arguments.clear();
    start(QStringLiteral("export XDG_CONFIG_HOME=") + folder.path());
    write(profiles + QStringLiteral("/current"), "field.toml\n");
    send(SIGHUP);
    EXPECT_TRUE(says("the profile was not applied, so the previous profile stays in force")) << errors();
    EXPECT_THAT(errors(), HasSubstr("roof.toml. The current mount is another one: restart boresightd"));
    expectOrderlyEnd();
}

// A log or journal that has reached the limit of its size is an alarm, and does not end the program.
TEST_F(ServiceTest, AFileAtItsLimitDoesNotEndIt)
{
#ifdef BORESIGHT_THREAD_SANITIZED
    GTEST_SKIP() << "ThreadSanitizer writes files of its own, and ends at their limit";
#endif
    start(QStringLiteral("ulimit -f 0"));
    EXPECT_TRUE(says("events.log")) << errors();
    expectOrderlyEnd();
}

TEST_F(ServiceTest, APasswordForEverybodyIsTold)
{
    write(kProfile + "[mqtt]\nhost = \"broker\"\nuser = \"mast\"\npassword = \"secret\"\n");
    ASSERT_TRUE(QFile::setPermissions(path, QFile::ReadOwner | QFile::WriteOwner | QFile::ReadOther));
    start();
    EXPECT_THAT(errors(), HasSubstr("profile.toml holds a password, and every user of this computer can read"));
    EXPECT_THAT(errors(), Not(HasSubstr("secret")));
    fakes::Program check(QStringLiteral(BORESIGHTCTL), {QStringLiteral("check"), path});
    EXPECT_EQ(check.waitForEnd(), 0);
    EXPECT_THAT(check.errors().toStdString(), HasSubstr("chmod o-r"));
    ASSERT_TRUE(QFile::setPermissions(path, QFile::ReadOwner | QFile::WriteOwner));
    fakes::Program again(QStringLiteral(BORESIGHTCTL), {QStringLiteral("check"), path});
    EXPECT_EQ(again.waitForEnd(), 0);
    EXPECT_EQ(again.errors(), QString());
}

// The messages that systemd receives. It reads all the time, as systemd does, because the kernel holds ten messages and
// loses the next.
class NotifySocket
{
public:
    explicit NotifySocket(const QString& path) : m_socket(::socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0))
    {
        sockaddr_un address{};
        address.sun_family = AF_UNIX;
        std::strncpy(address.sun_path, path.toLocal8Bit().constData(), sizeof(address.sun_path) - 1);
        const void* const untyped = &address;
        EXPECT_EQ(::bind(m_socket.number(), static_cast<const sockaddr*>(untyped), sizeof address), 0);
        qputenv("NOTIFY_SOCKET", path.toLocal8Bit());
        m_listener = std::thread([this] { listen(); });
    }
    ~NotifySocket()
    {
        ::shutdown(m_socket.number(), SHUT_RDWR);
        m_listener.join();
    }

    [[nodiscard]] QStringList heard() const
    {
        const std::lock_guard lock(m_mutex);
        return m_heard;
    }

private:
    void listen()
    {
        std::array<char, 256> text{};
        for (ssize_t size = 0; (size = ::recv(m_socket.number(), text.data(), text.size(), 0)) > 0;) {
            const std::lock_guard lock(m_mutex);
            m_heard << QString::fromLatin1(text.data(), size);
        }
    }

    FileDescriptor m_socket;
    mutable std::mutex m_mutex;
    QStringList m_heard;
    std::thread m_listener;
};

// REQ-APP-43d: Every tick can notify the watchdog of the service.
TEST_F(ServiceTest, TheControlLoopFeedsTheWatchdogOfTheService)
{
    NotifySocket systemd(folder.filePath(QStringLiteral("notify")));
    qputenv("WATCHDOG_USEC", "200000");
    start();
    const QString fed = QStringLiteral("WATCHDOG=1");
    EXPECT_TRUE(fakes::waitUntil(
        [&] { return systemd.heard().count(fed) >= 5 && systemd.heard().contains(QStringLiteral("READY=1")); }));
    send(SIGHUP);
    EXPECT_TRUE(fakes::waitUntil([&] {
        const QStringList heard = systemd.heard();
        return heard.contains(QStringLiteral("RELOADING=1")) && heard.count(QStringLiteral("READY=1")) == 2;
    }));
    expectOrderlyEnd();
    EXPECT_THAT(systemd.heard(), Contains(QStringLiteral("STOPPING=1")));
}

TEST_F(ServiceTest, TheWatchdogOfAnotherProcessIsNotFed)
{
    NotifySocket systemd(folder.filePath(QStringLiteral("notify")));
    qputenv("WATCHDOG_USEC", "1000");
    qputenv("WATCHDOG_PID", "1");
    start();
    expectOrderlyEnd();
    EXPECT_THAT(systemd.heard(), Not(Contains(QStringLiteral("WATCHDOG=1"))));
}

}  // namespace
}  // namespace boresight
