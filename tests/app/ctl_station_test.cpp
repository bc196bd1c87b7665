// SPDX-License-Identifier: GPL-3.0-or-later
// boresightctl beside a running station: boresightd with its simulated mount.
#include "tests/app/ctl_outcome.h"
#include "tests/fakes/wait_until.h"

#include <QRegularExpression>
#include <QTcpServer>
#include <QTcpSocket>
#include <QTemporaryDir>

#include <gmock/gmock.h>

namespace boresight {
namespace {

using testing::HasSubstr;

class CtlStation : public testing::Test
{
protected:
    void SetUp() override
    {
        ASSERT_TRUE(daemon.waitForLine(QStringLiteral("rotctld listening on ")));
        address = daemon.lines().constLast().section(QLatin1Char(' '), -1);
    }
    [[nodiscard]] Outcome ask(const char* line) const
    {
        return ctl(words(line) + QStringList{QStringLiteral("--station"), address});
    }

    QTemporaryDir folder;
    fakes::Program daemon{QStringLiteral(BORESIGHTD),
                          {QStringLiteral("--simulate"), QStringLiteral("--state-dir"), folder.path(),
                           QStringLiteral("--listen"), QStringLiteral("127.0.0.1:0")}};
    QString address;
};

// REQ-CTL-300: goto, stop, park and status ask a running station over rotctld. stop says that it does not latch.
TEST_F(CtlStation, IsSentStoppedAndParked)
{
    EXPECT_TRUE(fakes::waitUntil([this] { return ask("goto 113 40").status == 0; }));
    EXPECT_TRUE(
        fakes::waitUntil([this] { return ask("status").output.find("state:    MOVING\n") != std::string::npos; }));
    const Outcome status = ask("status --format json");
    EXPECT_EQ(status.status, 0);
    EXPECT_THAT(status.output, HasSubstr("\"azimuth\""));
    EXPECT_THAT(ask("status").output, HasSubstr("actual:   azimuth "));
    const Outcome stop = ask("stop");
    EXPECT_EQ(stop.status, 0) << stop.errors;
    EXPECT_THAT(stop.output, HasSubstr("STOP is not latched"));
    EXPECT_EQ(ask("park").status, 0);
}

// REQ-CTL-301: Exit status 1 with the reason when the station refuses, 2 for a line without sense, 3 when nobody
// answers.
TEST(CtlStationOutcome, SaysWhyNothingWasDone)
{
    QTcpServer station;
    ASSERT_TRUE(station.listen(QHostAddress::LocalHost));
    QObject::connect(&station, &QTcpServer::newConnection, &station,
                     [&station] { station.nextPendingConnection()->write("set_pos: 1 2\nRPRT -9\n"); });
    const QString address = QStringLiteral("127.0.0.1:%1").arg(station.serverPort());
    const QStringList point = words("goto 1 2 --station") + QStringList{address};
    const Outcome refused = ctl(point);
    EXPECT_EQ(refused.status, 1);
    EXPECT_THAT(refused.errors, HasSubstr("refused: STOP is latched"));
    station.close();
    EXPECT_EQ(ctl(point).status, 3);
    for (const char* line :
         {"goto", "goto 1", "goto north 2", "goto 1 200", "stop now", "park --station mast", "status --format xml"}) {
        EXPECT_EQ(ctl(words(line)).status, 2) << line;
    }
}

}  // namespace
}  // namespace boresight
