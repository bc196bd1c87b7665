// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/sim_bus/pty_server.h"

#include "tests/fakes/text_of.h"
#include "tests/fakes/wait_until.h"

#include <QFile>
#include <QFileInfo>
#include <QTemporaryDir>

#include <fcntl.h>
#include <gtest/gtest.h>

#include <array>

namespace boresight::sim {
namespace {

// A client of the terminal: opens the link, writes, and collects the output without blocking.
class Client
{
public:
    explicit Client(const QString& path)
        : m_file(::open(path.toLocal8Bit().constData(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC)),
          m_readable(m_file.number(), QSocketNotifier::Read)
    {
        EXPECT_TRUE(m_file.isOpen());
        QObject::connect(&m_readable, &QSocketNotifier::activated, &m_readable, [this] {
            std::array<char, 4096> buffer{};
            const ssize_t size = ::read(m_file.number(), buffer.data(), buffer.size());
            received.append(buffer.data(), static_cast<std::size_t>(std::max<ssize_t>(size, 0)));
        });
    }
    void write(const std::string& text)
    {
        EXPECT_EQ(::write(m_file.number(), text.data(), text.size()), static_cast<ssize_t>(text.size()));
    }
    [[nodiscard]] bool waitFor(const std::string& text)
    {
        return fakes::waitUntil([&] { return received.find(text) != std::string::npos; });
    }

    std::string received;

private:
    FileDescriptor m_file;
    QSocketNotifier m_readable;
};

class PtyServerTest : public testing::Test
{
protected:
    void SetUp() override
    {
        auto created = PtyServer::create(link, pair, clock);
        ASSERT_TRUE(created) << textOf(created.error());
        server = std::move(*created);
    }

    QTemporaryDir folder;
    QString link = folder.filePath(QStringLiteral("mount"));
    SystemClock clock;
    SimulatedPair pair{commissionedPair()};
    std::unique_ptr<PtyServer> server;
};

// REQ-SIM-12 (PtyServerTest.*): A client may close the terminal and come back. The symbolic link disappears with the
// server.
TEST_F(PtyServerTest, AnswersRealBytes)
{
    Client client(link);
    client.write("can send 8001 11001f01 BF\ncan send 8002 1100 BF\n");
    ASSERT_TRUE(client.waitFor("rcv 0200 210000 e B F r x-1\r\n")) << client.received;
    EXPECT_TRUE(client.received.starts_with("OK\r\nrcv 0100 210000")) << "nothing echoed: " << client.received;
}

TEST_F(PtyServerTest, ClientMayCloseAndComeBack)
{
    for (int i = 0; i < 3; ++i) {
        auto client = std::make_unique<Client>(link);
        client->write("can send 8001 1100 BF\n");
        ASSERT_TRUE(client->waitFor("rcv 0100 210000 e B F r x-1\r\n")) << "visit " << i << ": " << client->received;
        client->write("can send 80");  // leaves half a line behind
        client.reset();
        ASSERT_TRUE(fakes::waitUntil([&] { return !server->hasClient(); }));
    }
}

TEST_F(PtyServerTest, TimeGoesOnByItself)
{
    Client client(link);
    client.write("can send 0001 01000f BF\n");  // brake
    ASSERT_TRUE(client.waitFor("OK\r\n"));
    EXPECT_TRUE(fakes::waitUntil([&] { return pair.truth(Axis::Azimuth).mode == moteus::Mode::Brake; }));
}

TEST_F(PtyServerTest, LateReplyArrives)
{
    pair.faults().add({.kind = FaultKind::LateReply, .value = 0.05});
    Client client(link);
    client.write("can send 8001 1100 BF\n");
    ASSERT_TRUE(client.waitFor("OK\r\n"));
    EXPECT_EQ(client.received, "OK\r\n");
    EXPECT_TRUE(client.waitFor("rcv 0100"));
}

TEST_F(PtyServerTest, LinkGoesWithTheServer)
{
    EXPECT_TRUE(QFileInfo(link).isSymLink());
    server.reset();
    EXPECT_FALSE(QFileInfo(link).isSymLink());
}

TEST_F(PtyServerTest, TakesOverALinkLeftBehindButNoFile)
{
    auto second = PtyServer::create(link, pair, clock);
    ASSERT_TRUE(second);
    server.reset();
    EXPECT_EQ(QFile::symLinkTarget(link), (*second)->terminal()) << "not the old server's to remove";

    const QString file = folder.filePath(QStringLiteral("file"));
    ASSERT_TRUE(QFile(file).open(QIODevice::WriteOnly));
    const auto refused = PtyServer::create(file, pair, clock);
    ASSERT_FALSE(refused);
    EXPECT_NE(textOf(refused.error()).find("file"), std::string::npos);
    EXPECT_TRUE(QFileInfo(file).isFile());
}

}  // namespace
}  // namespace boresight::sim
