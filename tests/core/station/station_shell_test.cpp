// SPDX-License-Identifier: GPL-3.0-or-later
// The local socket of a whole station, with a real socket.
#include "tests/core/station/linked_station.h"
#include "tests/fakes/wait_until.h"

#include <QLocalSocket>
#include <QTcpServer>

#include <gmock/gmock.h>

#include <algorithm>

namespace boresight {
namespace {

using testing::HasSubstr;

// The socket is named by the port of the rotctld server.
QString socketOf(const StationStatus& status, const QTemporaryDir& runtime)
{
    return local::socketPath(runtime.path(), status.listening.section(QLatin1Char(':'), -1).toUShort());
}

std::string ask(const QString& path, const QByteArray& line)
{
    QLocalSocket socket;
    socket.connectToServer(path);
    socket.write(line);
    EXPECT_TRUE(fakes::waitUntil([&socket] { return socket.state() == QLocalSocket::UnconnectedState; }));
    return socket.readAll().toStdString();
}

std::string logOf(LinkedStation& rig)
{
    rig.station->updateTaken();
    rig.station->publish();
    QStringList lines;
    for (const StationUpdate& update : rig.updates) {
        for (const LogEntry& entry : update.log) {
            lines.append(entry.source + QStringLiteral(": ") + entry.text);
        }
    }
    return lines.join(u'\n').toStdString();
}

// REQ-STATION-200: A command of the local socket is a request of the operator, named "shell" in the log: take and
// release change who has the control, stop latches at once, reset-stop ends the latch. A refusal is answered and
// logged.
TEST(StationShell, AsksAsTheOperator)
{
    const QTemporaryDir runtime;
    LinkedStation rig;
    rig.station->serveShell(runtime.path());
    rig.station->openAll();
    rig.run(5);
    const QString path = socketOf(rig.station->status(), runtime);
    EXPECT_EQ(rig.station->status().authority, Authority::Clients);
    EXPECT_EQ(ask(path, "take\n"), "ok\n");
    EXPECT_EQ(rig.station->status().authority, Authority::Operator);
    EXPECT_EQ(ask(path, "release\n"), "ok\n");
    EXPECT_EQ(rig.station->status().authority, Authority::Clients);
    const std::uint64_t tick = rig.station->status().tick;
    EXPECT_EQ(ask(path, "stop\n"), "ok\n");
    EXPECT_TRUE(rig.station->status().stopLatched);
    EXPECT_EQ(rig.station->status().tick, tick + 1) << "STOP does not wait for the next tick";
    EXPECT_EQ(ask(path, "release\n"), "error: STOP is latched. Reset STOP first.\n");
    EXPECT_EQ(rig.station->status().authority, Authority::Operator);
    EXPECT_EQ(ask(path, "reset-stop\n"), "ok\n");
    EXPECT_FALSE(rig.station->status().stopLatched);
    EXPECT_EQ(rig.station->status().authority, Authority::Operator);
    const std::string log = logOf(rig);
    EXPECT_THAT(log, HasSubstr("shell: listening on " + path.toStdString()));
    EXPECT_THAT(log, HasSubstr("shell: STOP is latched"));
    EXPECT_THAT(log, HasSubstr("shell: release refused: STOP is latched"));
}

// REQ-STATION-201: A station without a local socket works, and its log says why it has none. Where the rotctld server
// does not listen there is none either.
TEST(StationShell, TheStationWorksWithoutIt)
{
    LinkedStation rig;
    rig.station->serveShell({});
    rig.station->openAll();
    rig.run(5);
    EXPECT_FALSE(rig.station->status().listening.isEmpty());
    EXPECT_THAT(logOf(rig), HasSubstr("shell: The local socket did not open: XDG_RUNTIME_DIR is not set. Commands of"));

    QTcpServer taken;
    ASSERT_TRUE(taken.listen(QHostAddress::LocalHost));
    const QTemporaryDir runtime;
    profile::Profile profile = anyPort();
    profile.rotctld.listen.port = taken.serverPort();
    LinkedStation deaf(profile);
    deaf.station->serveShell(runtime.path());
    deaf.station->openAll();
    EXPECT_TRUE(deaf.station->status().listening.isEmpty());
    EXPECT_FALSE(QFile::exists(runtime.filePath(QStringLiteral("boresight"))));
}

}  // namespace
}  // namespace boresight
