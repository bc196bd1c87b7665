// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/clients/station_listeners.h"

#include "core/clients/station_rotator.h"
#include "tests/core/control/station_rig.h"
#include "tests/fakes/tcp_peer.h"
#include "tests/fakes/text_of.h"
#include "tests/fakes/wait_until.h"

#include <QCoreApplication>
#include <QLocalSocket>
#include <QTemporaryDir>
#include <QUdpSocket>

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace boresight {
namespace {

profile::Profile withListeners(std::vector<std::string> lines)
{
    profile::Profile profile;
    profile.listeners = std::move(lines);
    return profile;
}

struct ListenersRig : StationRig
{
    explicit ListenersRig(std::vector<std::string> lines) : StationRig(withListeners(std::move(lines)))
    {
        run(Seconds(0.2));
        further.open();
    }
    // With the ticks of the listeners.
    void pass(int seconds)
    {
        for (int i = 0; i < seconds; ++i) {
            run(Seconds(1.0));
            further.tick();
        }
    }
    [[nodiscard]] std::unique_ptr<fakes::TcpPeer> connect(std::size_t index) const
    {
        const std::string address = further.addresses().at(index);
        const std::string port = address.substr(address.rfind(':') + 1);
        return std::make_unique<fakes::TcpPeer>("127.0.0.1", static_cast<std::uint16_t>(std::stoi(port)),
                                                [] { QCoreApplication::processEvents(QEventLoop::AllEvents); });
    }
    // The alarm with this text, or an empty text if there is none.
    [[nodiscard]] QString alarm(const char* text) const
    {
        const auto alarms = control.status().alarms;
        const auto found =
            std::ranges::find_if(alarms, [&](const Alarm& one) { return one.what.contains(QLatin1String(text)); });
        return found == alarms.end() ? QString() : found->what;
    }

    StationRotator rotator{control, inForce, log, clock};
    StationListeners further{control, inForce, log, rotator, clock, std::make_shared<std::uint64_t>(70), nullptr};
};

// REQ-LISTENERS-04 (StationListeners.*): Several listeners serve at the same time. Each client has its own number and
// is in the list with its protocol. These clients move the mount by the same rule as rotctld clients.
TEST(StationListeners, SeveralServeAtOnce)
{
    ListenersRig rig({"gs232a drive tcp:127.0.0.1:0", "gs232b drive tcp:127.0.0.1:0"});
    const auto first = rig.connect(0);
    const auto second = rig.connect(1);
    EXPECT_TRUE(first->ask("C\r").starts_with("+0"));
    EXPECT_TRUE(second->ask("C\r").starts_with("AZ="));
    const auto clients = rig.further.clients();
    ASSERT_EQ(clients.size(), 2U);
    EXPECT_EQ(clients[0].program, "GS-232A");
    EXPECT_EQ(clients[1].program, "GS-232B");
    EXPECT_GT(clients[0].id, 70U) << "no number of a rotctld client";
    EXPECT_GT(clients[1].id, clients[0].id) << "who comes later has the higher number, at whatever listener";

    static_cast<void>(first->send("W040 030\rC\r"));
    EXPECT_TRUE(first->receiveLines(1).starts_with("\r+0"));
    EXPECT_EQ(second->ask("W300 010\r"), "?>\r\n") << "another client has control";
    EXPECT_EQ(rig.control.status().commander.clientId, clients[0].id);
    EXPECT_TRUE(rig.control.status().commander.name.startsWith(QLatin1String("client GS-232A 127.0.0.1:")));
    static_cast<void>(second->send("S\rC\r"));
    EXPECT_TRUE(second->receiveLines(1).starts_with("\rAZ=")) << "everybody may stop";
    EXPECT_TRUE(rig.further.disconnect(clients[1].id, QStringLiteral("by the operator")));
    EXPECT_FALSE(rig.further.disconnect(1, QStringLiteral("by the operator")));
}

// Story: the profile showed another number of clients as in force, but each listener kept the number of its start.
// REQ-CONTROL-500
TEST(StationListeners, TheNumberOfClientsChangesWhileRunning)
{
    ListenersRig rig({"gs232b drive tcp:127.0.0.1:0", "pst drive udp:127.0.0.1:0"});
    const auto one = rig.connect(0);
    const auto other = rig.connect(0);
    ASSERT_NE(one->ask("C2\r"), "");
    ASSERT_NE(other->ask("C2\r"), "");
    const auto permit = [&rig](int clients) {
        profile::Profile profile = *rig.inForce;
        profile.rotctld.maxClients = clients;
        rig.inForce.apply(profile);
        rig.further.profileChanged();
    };
    permit(2);
    const auto third = rig.connect(0);
    EXPECT_EQ(third->receiveUntilClosed(), "");
    EXPECT_EQ(rig.further.clients().size(), 2U);
    EXPECT_NE(one->ask("C2\r"), "") << "who is connected stays";
    permit(3);
    EXPECT_NE(rig.connect(0)->ask("C2\r"), "");
}

// REQ-LISTENERS-05: A listener with the right "read" reports positions and stops the mount. It refuses every motion,
// and the operator cannot give control to its clients.
TEST(StationListeners, OneThatReadsMovesNothing)
{
    ListenersRig rig({"gs232b read tcp:127.0.0.1:0"});
    const auto peer = rig.connect(0);
    EXPECT_TRUE(peer->ask("C2\r").starts_with("AZ="));
    for (const char* const motion : {"W040 030\r", "M040\r", "R\r", "U\r", "X4\r"}) {
        EXPECT_EQ(peer->ask(motion), "?>\r\n") << motion;
    }
    const std::uint64_t id = rig.further.clients().front().id;
    const std::string why = "The listener of this client has the right \"read\" (listeners.list in the profile).";
    const auto given = rig.ask(request::GiveControl{.clientId = id});
    ASSERT_FALSE(given);
    EXPECT_EQ(textOf(given.error()), why);
    const auto lifted = rig.ask(request::SetReadOnly{.clientId = id, .readOnly = false});
    ASSERT_FALSE(lifted);
    EXPECT_EQ(textOf(lifted.error()), why);
    EXPECT_EQ(peer->ask("R\r"), "?>\r\n");
    ASSERT_TRUE(rig.point(40.0, 30.0));
    static_cast<void>(peer->send("S\rC\r"));
    EXPECT_TRUE(peer->receiveLines(1).starts_with("\rAZ="));
    EXPECT_FALSE(rig.control.followsClient()) << "it has stopped the mount";
}

// An EasyComm client passes the tests that all clients pass.
TEST(StationListeners, EasycommIsOneOfThem)
{
    ListenersRig rig(
        {"easycomm3 drive tcp:127.0.0.1:0", "easycomm2 read tcp:127.0.0.1:0", "gs232b drive tcp:127.0.0.1:0"});
    const auto first = rig.connect(0);
    const auto reading = rig.connect(1);
    const auto other = rig.connect(2);
    static_cast<void>(first->send("AZ40.0 EL30.0\nAZ EL\n"));
    EXPECT_TRUE(first->receiveLines(1).starts_with("AZ"));
    EXPECT_EQ(rig.control.status().commander.name.left(24), QStringLiteral("client EasyComm III 127."));
    EXPECT_EQ(other->ask("W300 010\r"), "?>\r\n") << "another client has control";
    EXPECT_TRUE(reading->ask("AZ EL\n").starts_with("AZ"));
    EXPECT_EQ(reading->ask("AZ10.0 EL10.0\n"), "ALrefused\n");
    static_cast<void>(first->send("VR0500\nGS\n"));
    EXPECT_TRUE(first->receiveLines(1).starts_with("GS"));
    rig.run(Seconds(3.0));
    EXPECT_NEAR(rig.control.status().azimuth.commandedRate->degrees(), 0.5, 1e-6);
    static_cast<void>(reading->send("SA\nVE\n"));
    EXPECT_TRUE(reading->receiveLines(1).starts_with("VEBoresight-")) << "everybody may stop";
    rig.run(Seconds(3.0));
    EXPECT_FALSE(rig.rotator.motion().movingRight);
    rig.azimuth.silent = true;
    rig.run(Seconds(3.0));
    EXPECT_EQ(first->ask("AZ EL\n"), "ALno-position\n");
    EXPECT_EQ(first->ask("GS\n"), "GS8\n");
}

// The listener has a path as its place, and computes the bearing from the site of the profile.
TEST(StationListeners, PairsComeByASocketInTheFileSystem)
{
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("pairs"));
    ListenersRig rig({"pairs drive unix:" + path.toStdString()});
    ASSERT_EQ(rig.further.addresses(), std::vector<std::string>{path.toStdString()});
    QLocalSocket program;
    const auto ask = [&](const char* line) {
        program.write(line);
        program.flush();
        EXPECT_TRUE(fakes::waitUntil([&] { return program.canReadLine(); }));
        return program.readLine().toStdString();
    };
    program.connectToServer(path);
    EXPECT_EQ(ask("?\n"), "0.0 0.0\n");
    EXPECT_EQ(ask("40 30\n"), "OK\n");
    EXPECT_TRUE(rig.control.followsClient());
    EXPECT_TRUE(rig.control.status().commander.name.startsWith(QStringLiteral("client Pairs ") + path));
    EXPECT_TRUE(ask("bearing JN58td\n").starts_with("error: The site of the mount is unknown."));
    profile::Profile withSite = rig.inForce.wanted();
    withSite.site = {.known = true, .latitude = 38.72_deg, .longitude = -9.14_deg};
    rig.inForce.apply(withSite);
    EXPECT_EQ(ask("bearing JN58td\n"), "OK\n");
    ASSERT_TRUE(rig.ask(request::TakeAuthority{}));
    EXPECT_TRUE(ask("60\n").starts_with("error: "));
}

// REQ-LISTENERS-10 (StationListeners.ADatagram*): A datagram moves the mount within its limits and by the rule that
// holds for rotctld clients. STOP holds it, and nothing but the next command after it moves the mount.
TEST(StationListeners, ADatagramMovesTheMountWithinItsLimits)
{
    ListenersRig rig(
        {"pst drive udp:127.0.0.1:0", "n1mm drive udp:127.0.0.1:0 rotor=Yagi 20", "gs232b drive tcp:127.0.0.1:0"});
    const auto send = [&](std::size_t listener, const QByteArray& bytes) {
        const std::string address = rig.further.addresses().at(listener);
        QUdpSocket().writeDatagram(bytes, QHostAddress::LocalHost,
                                   static_cast<quint16>(std::stoi(address.substr(address.rfind(':') + 1))));
        const std::string program = listener == 0 ? "PstRotator" : "N1MM";
        EXPECT_TRUE(fakes::waitUntil([&] {
            return std::ranges::any_of(rig.further.clients(), [&](const rotctld::ClientInfo& client) {
                return client.program == program && client.lastMotion == rig.clock.now();
            });
        })) << bytes.toStdString();
    };
    send(0, "<PST><AZIMUTH>40</AZIMUTH><ELEVATION>30</ELEVATION></PST>");
    EXPECT_TRUE(rig.control.followsClient());
    EXPECT_TRUE(rig.control.status().commander.name.startsWith(QStringLiteral("client PstRotator 127.0.0.1:")));
    rig.pass(60);
    EXPECT_NEAR(rig.control.measured()->azimuth.degrees(), 40.0, 0.1);
    EXPECT_NEAR(rig.control.measured()->elevation.degrees(), 30.0, 0.1);

    send(0, "<PST><ELEVATION>170</ELEVATION></PST>");
    rig.pass(120);
    EXPECT_NEAR(rig.control.measured()->azimuth.degrees(), 220.0, 0.1) << "the same direction, over the zenith";
    EXPECT_NEAR(rig.control.measured()->elevation.degrees(), 10.0, 0.1);
    send(0, "<PST><ELEVATION>-20</ELEVATION></PST>");
    const QString became = rig.further.clients().front().lastCommand;
    EXPECT_TRUE(became.endsWith(QStringLiteral("elevation -20.0° below limit 0.0°"))) << became.toStdString();
    rig.pass(60);
    EXPECT_NEAR(rig.control.measured()->azimuth.degrees(), 40.0, 0.1) << "the azimuth that the program asked for";
    EXPECT_NEAR(rig.control.measured()->elevation.degrees(), rig.inForce->elevation.geometry.travel.min.degrees(),
                0.05);

    send(0, "<PST><AZIMUTH>100</AZIMUTH></PST>");
    send(1, "<N1MMRotor><rotor>Yagi 20</rotor><goazi>90.0</goazi><offset>0.0</offset></N1MMRotor>");
    EXPECT_TRUE(rig.further.clients().back().lastCommand.contains(QStringLiteral("has control")))
        << "another client has control";
    EXPECT_EQ(rig.connect(2)->ask("W300 010\r"), "?>\r\n");

    rig.pass(1);
    ASSERT_TRUE(rig.ask(request::Stop{}));
    rig.pass(5);
    const auto stopped = rig.control.measured()->azimuth;
    send(0, "<PST><AZIMUTH>200</AZIMUTH></PST>");
    send(1, "<N1MMRotor><rotor>Yagi 20</rotor><goazi>90.0</goazi><offset>0.0</offset></N1MMRotor>");
    rig.pass(20);
    EXPECT_NEAR(rig.control.measured()->azimuth.degrees(), stopped.degrees(), 0.01);
    ASSERT_TRUE(rig.ask(request::ResetStop{}));
    rig.pass(20);
    ASSERT_TRUE(rig.ask(request::GiveAuthority{}));
    rig.pass(20);
    EXPECT_NEAR(rig.control.measured()->azimuth.degrees(), stopped.degrees(), 0.01) << "nothing moves by itself";
    send(0, "<PST><AZIMUTH>60</AZIMUTH></PST>");
    rig.pass(60);
    EXPECT_NEAR(rig.control.measured()->azimuth.degrees(), 60.0, 0.1);
}

struct PstRig : ListenersRig
{
    PstRig() : ListenersRig({"pst drive udp:127.0.0.1:0"}) {}

    void send(const QByteArray& bytes, const QHostAddress& from = QHostAddress::LocalHost) const
    {
        const std::string address = further.addresses().front();
        QUdpSocket socket;
        socket.bind(from);
        socket.writeDatagram(bytes, QHostAddress::LocalHost,
                             static_cast<quint16>(std::stoi(address.substr(address.rfind(':') + 1))));
    }
    // Sends a command for a motion, and waits until it is judged. Returns whether it is accepted.
    [[nodiscard]] bool points(const QByteArray& fields, const QHostAddress& from = QHostAddress::LocalHost)
    {
        send("<PST>" + fields + "</PST>", from);
        const std::string sender = from.toString().toStdString();
        QString answer;
        EXPECT_TRUE(fakes::waitUntil([&] {
            return std::ranges::any_of(further.clients(), [&](const rotctld::ClientInfo& client) {
                answer = client.lastCommand;
                return client.address.starts_with(sender) && client.lastMotion == clock.now();
            });
        })) << fields.toStdString();
        return !answer.contains(QStringLiteral("refused"));
    }
    [[nodiscard]] bool stops()
    {
        send("<PST><STOP>1</STOP></PST>");
        return fakes::waitUntil([&] { return !control.followsClient(); });
    }
};

// REQ-LISTENERS-12 (StationListeners.AnAzimuthAlone*): An azimuth alone leaves the elevation at its target. If the
// mount goes to no target, the set-point of the elevation stays. So repeated azimuths move the elevation neither by the
// trim nor by an error of the axis.
TEST(StationListeners, AnAzimuthAloneKeepsTheElevationOfATrimmedMount)
{
    PstRig rig;
    ASSERT_TRUE(rig.points("<AZIMUTH>10</AZIMUTH><ELEVATION>30</ELEVATION>"));
    rig.pass(30);
    ASSERT_TRUE(rig.ask(request::Nudge{.elevation = 2_deg}));
    rig.pass(10);
    ASSERT_NEAR(rig.elevationDegrees(), 32.0, 0.01);
    for (const char* const azimuth : {"20", "30", "40"}) {
        ASSERT_TRUE(rig.stops());
        rig.pass(1);
        ASSERT_TRUE(rig.points("<AZIMUTH>" + QByteArray(azimuth) + "</AZIMUTH>"));
        rig.pass(20);
        EXPECT_NEAR(rig.azimuthDegrees(), QByteArray(azimuth).toDouble(), 0.01);
        EXPECT_NEAR(rig.elevationDegrees(), 32.0, 0.01) << "after a stop, azimuth " << azimuth;
    }
    for (const char* const azimuth : {"50", "60"}) {
        rig.pass(62);
        ASSERT_TRUE(rig.further.clients().empty());
        ASSERT_TRUE(rig.points("<AZIMUTH>" + QByteArray(azimuth) + "</AZIMUTH>"));
        rig.pass(20);
        EXPECT_NEAR(rig.elevationDegrees(), 32.0, 0.01) << "after a silence, azimuth " << azimuth;
    }
}

TEST(StationListeners, AnAzimuthAloneKeepsTheElevationWhereAStopLeftIt)
{
    PstRig rig;
    ASSERT_TRUE(rig.points("<AZIMUTH>10</AZIMUTH><ELEVATION>80</ELEVATION>"));
    rig.pass(2);
    ASSERT_TRUE(rig.stops());
    ASSERT_TRUE(rig.points("<AZIMUTH>20</AZIMUTH>"));
    const double braked = rig.control.status().elevation.commanded->degrees();
    rig.pass(20);
    EXPECT_GE(rig.elevationDegrees(), braked) << "it does not go back while it brakes";
    const double stopped = rig.elevationDegrees();
    ASSERT_TRUE(rig.points("<AZIMUTH>30</AZIMUTH>"));
    rig.pass(20);
    EXPECT_NEAR(rig.elevationDegrees(), stopped, 1e-3);
}

TEST(StationListeners, AnAzimuthAloneKeepsTheTargetOfAHostThatLeft)
{
    PstRig rig;
    profile::Profile slow = rig.inForce.wanted();
    slow.elevation.limits.speed = 0.5_deg_s;
    rig.setProfile(slow);
    ASSERT_TRUE(rig.points("<AZIMUTH>10</AZIMUTH><ELEVATION>60</ELEVATION>"));
    rig.pass(70);
    ASSERT_TRUE(rig.further.clients().empty());
    ASSERT_LT(rig.elevationDegrees(), 40.0);
    ASSERT_TRUE(rig.points("<AZIMUTH>20</AZIMUTH>"));
    rig.pass(100);
    EXPECT_NEAR(rig.elevationDegrees(), 60.0, 0.01);
}

TEST(StationListeners, AnAzimuthAloneKeepsTheTargetAfterTheRefusalOfAnotherHost)
{
    PstRig rig;
    ASSERT_TRUE(rig.points("<AZIMUTH>10</AZIMUTH><ELEVATION>60</ELEVATION>"));
    rig.pass(2);
    const QHostAddress other(QStringLiteral("127.0.0.2"));
    EXPECT_FALSE(rig.points("<AZIMUTH>100</AZIMUTH>", other));
    rig.tick();
    EXPECT_FALSE(rig.points("<PARK>1</PARK>", other));
    ASSERT_TRUE(rig.points("<AZIMUTH>20</AZIMUTH>"));
    rig.pass(60);
    EXPECT_NEAR(rig.azimuthDegrees(), 20.0, 0.01);
    EXPECT_NEAR(rig.elevationDegrees(), 60.0, 0.01);
}

TEST(StationListeners, ADatagramForReadersMovesNothing)
{
    ListenersRig rig({"pst read udp:127.0.0.1:0"});
    const std::string address = rig.further.addresses().front();
    const auto port = static_cast<quint16>(std::stoi(address.substr(address.rfind(':') + 1)));
    QUdpSocket().writeDatagram("<PST><AZIMUTH>40</AZIMUTH></PST>", QHostAddress::LocalHost, port);
    ASSERT_TRUE(fakes::waitUntil([&] { return !rig.further.clients().empty(); }));
    EXPECT_FALSE(rig.control.followsClient());
    EXPECT_TRUE(rig.further.clients().front().lastCommand.contains(QStringLiteral("refused")));
    ASSERT_TRUE(rig.point(40.0, 30.0));
    EXPECT_TRUE(rig.control.followsClient());
    QUdpSocket().writeDatagram("<PST><STOP>1</STOP></PST>", QHostAddress::LocalHost, port);
    EXPECT_TRUE(fakes::waitUntil([&] { return !rig.control.followsClient(); })) << "every client may stop";
}

// REQ-LISTENERS-14: A client of datagrams that the operator made read-only stays so, however long it is silent, and
// after Disconnect. The operator can let it move the mount again.
TEST(StationListeners, ASilenceEndsNoMarkOfTheOperator)
{
    ListenersRig rig({"pst drive udp:127.0.0.1:0"});
    const std::string address = rig.further.addresses().front();
    const auto port = static_cast<quint16>(std::stoi(address.substr(address.rfind(':') + 1)));
    const auto point = [&](int azimuth) {
        const QByteArray datagram = "<PST><AZIMUTH>" + QByteArray::number(azimuth) + "</AZIMUTH></PST>";
        QUdpSocket().writeDatagram(datagram, QHostAddress::LocalHost, port);
        EXPECT_TRUE(fakes::waitUntil([&] {
            const auto clients = rig.further.clients();
            return !clients.empty() && clients.front().lastCommand.startsWith(QString::fromLatin1(datagram));
        }));
    };
    point(40);
    ASSERT_TRUE(rig.control.followsClient());
    const std::uint64_t id = rig.further.clients().front().id;
    ASSERT_TRUE(rig.ask(request::SetReadOnly{.clientId = id, .readOnly = true}));
    rig.pass(120);
    point(50);
    EXPECT_FALSE(rig.control.followsClient()) << "after two minutes of silence";
    EXPECT_TRUE(rig.further.disconnect(id, QStringLiteral("by the operator")));
    point(60);
    EXPECT_FALSE(rig.control.followsClient()) << "after Disconnect";
    EXPECT_EQ(rig.further.clients().front().id, id);
    ASSERT_TRUE(rig.ask(request::SetReadOnly{.clientId = id, .readOnly = false}));
    point(70);
    EXPECT_TRUE(rig.control.followsClient());
    rig.pass(120);
    EXPECT_TRUE(rig.further.clients().empty()) << "a client without the mark leaves";
}

// REQ-LISTENERS-06: A listener that cannot be opened raises an alarm with the place and the reason. The other listeners
// serve. A listener that other computers can reach without a list of addresses raises an advisory.
TEST(StationListeners, APlaceThatIsTakenIsAnAlarm)
{
    const ListenersRig first({"gs232a drive tcp:127.0.0.1:0"});
    const std::string place = first.further.addresses().front();
    const ListenersRig second({"gs232a drive tcp:" + place, "gs232b drive tcp:127.0.0.1:0"});
    EXPECT_TRUE(second.alarm("Further clients cannot connect").contains(QString::fromStdString(place)));
    EXPECT_EQ(second.further.addresses().size(), 1U);
    EXPECT_TRUE(first.alarm("Further clients cannot connect").isEmpty());
    const ListenersRig open({"gs232a drive tcp:0.0.0.0:0"});
    EXPECT_FALSE(open.alarm("can move the mount").isEmpty());
    EXPECT_TRUE(open.alarm("forged sender").isEmpty());
}

// REQ-LISTENERS-11: A listener for datagrams that other computers can reach raises an advisory, because a datagram can
// name any sender.
TEST(StationListeners, DatagramsFromTheNetworkAreAnAdvisory)
{
    const ListenersRig open({"pst drive udp:0.0.0.0:0 10.0.0.7"});
    EXPECT_TRUE(open.alarm("forged sender").contains(QStringLiteral("UDP 0.0.0.0:")));
    const ListenersRig closed({"pst drive udp:127.0.0.1:0", "n1mm read udp:0.0.0.0:0"});
    EXPECT_TRUE(closed.alarm("forged sender").isEmpty());
}

// REQ-LISTENERS-07: While the drives are silent a client receives no position.
TEST(StationListeners, ASilentDriveIsNoPosition)
{
    ListenersRig rig({"gs232b drive tcp:127.0.0.1:0"});
    const auto peer = rig.connect(0);
    EXPECT_TRUE(peer->ask("C2\r").starts_with("AZ="));
    rig.azimuth.silent = true;
    rig.run(Seconds(3.0));
    EXPECT_EQ(peer->ask("C2\r"), "?>\r\n");
    EXPECT_EQ(peer->ask("M040\r"), "?>\r\n");
}

}  // namespace
}  // namespace boresight
