// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/units/quantity.h"
#include "tests/fakes/wait_until.h"
#include "tests/system/programs/boresightd_process.h"

#include <QRegularExpression>
#include <QTest>

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <string>
#include <vector>

// Browsers, port scanners, floods and clients that never read attack the running program at the same time, while a good
// client tracks. The good client gets its replies at once, its target is tracked, and only this client moves the mount.
// Times are reported, with bounds wide enough for a busy test computer.
namespace boresight::system_test {
namespace {

using SteadyClock = std::chrono::steady_clock;
using Peers = std::vector<std::unique_ptr<fakes::TcpPeer>>;

const std::vector<std::string>& unknownBoards()
{
    static const std::vector<std::string> list{
        "GET / HTTP/1.1\r\nHost: localhost:4533\r\nUser-Agent: Mozilla/5.0 (X11; Linux x86_64) AppleWebKit/537.36 "
        "(KHTML, like Gecko)\r\n\r\n",
        "OPTIONS / RTSP/1.0\r\n\r\n",
        "OPTIONS sip:nm SIP/2.0\r\nVia: SIP/2.0/TCP nm;branch=foo\r\n\r\n",
        "\x16\x03\x01\x02\x01\x01\xfc\x03\x03",
        "SSH-2.0-OpenSSH_9.2\r\n",
        "EHLO scanner\r\nQUIT\r\n",
        "AZ123.0 EL45.0 UP145000000 XXX DN435000000\n",
        "W120 045\r",
        "foo K S M 8 100 P 300 80\n",
        "\\nonsense P 300 80\n",
        "P nan 10\n",
        "P 300\n",
        std::string(100'000, 'x'),
    };
    return list;
}

// Connects, sends its data and closes.
void sendRubbish(const BoresightdProcess& boresightd, std::size_t number)
{
    const auto peer = boresightd.connect();
    peer->send(unknownBoards()[number % unknownBoards().size()], std::chrono::milliseconds(20));
    if (number % 2 == 0) {
        peer->reset();
    }
}

struct Answers
{
    void add(SteadyClock::duration time)
    {
        milliseconds.push_back(std::chrono::duration<double, std::milli>(time).count());
    }
    double percentile(double share)
    {
        std::ranges::sort(milliseconds);
        return milliseconds[static_cast<std::size_t>(share * static_cast<double>(milliseconds.size() - 1))];
    }

    std::vector<double> milliseconds;
};

class RubbishTest : public ::testing::Test
{
protected:
    void SetUp() override
    {
        ASSERT_TRUE(boresightd.listens()) << boresightd.complaints();
        good = boresightd.connect();
        const auto seesBothDrives = [this] { return good->ask("P 0 10\n") == "RPRT 0\n"; };
        ASSERT_TRUE(fakes::waitUntil(seesBothDrives)) << boresightd.complaints();
    }
    std::string ask(const std::string& command, int lines)
    {
        const auto begin = SteadyClock::now();
        std::string reply = good->ask(command, lines);
        answers.add(SteadyClock::now() - begin);
        return reply;
    }
    double azimuth() { return Angle::fromDegrees(std::stod(ask("p\n", 2))).wrapped180().degrees(); }
    void record()
    {
        RecordProperty("answer_p50_ms", QString::number(answers.percentile(0.5), 'f', 2).toStdString());
        RecordProperty("answer_p99_ms", QString::number(answers.percentile(0.99), 'f', 2).toStdString());
        EXPECT_EQ(boresightd.terminate(), 0) << boresightd.complaints();
        static const QRegularExpression ticks(QStringLiteral("ticks .*max [0-9.]+ ms"));
        RecordProperty("ticks", ticks.match(QString::fromStdString(boresightd.complaints())).captured().toStdString());
    }

    BoresightdProcess boresightd{{QStringLiteral("--simulate")}};
    std::unique_ptr<fakes::TcpPeer> good;
    Answers answers;
};

TEST_F(RubbishTest, MovesNothing)
{
    const double before = azimuth();
    for (std::size_t i = 0; i < 5 * unknownBoards().size(); ++i) {
        sendRubbish(boresightd, i);
        EXPECT_NEAR(azimuth(), before, 0.05) << unknownBoards()[i % unknownBoards().size()].substr(0, 40);
    }
    QTest::qWait(500);
    EXPECT_NEAR(azimuth(), before, 0.05);
    record();
}

TEST_F(RubbishTest, DoesNotDisturbAClientThatTracks)
{
    Peers floods;
    for (int i = 0; i < 20; ++i) {
        floods.push_back(boresightd.connect());  // never reads its replies
    }
    const auto begin = SteadyClock::now();
    const auto seconds = [&] { return std::chrono::duration<double>(SteadyClock::now() - begin).count(); };
    constexpr double kRate = 2.0;  // °/s
    std::size_t number = 0;
    double nextPoint = 0.0;
    double worst = 0.0;
    while (seconds() < 8.0) {
        if (seconds() >= nextPoint) {
            const std::string point = QString::number(kRate * seconds(), 'f', 2).toStdString();
            EXPECT_EQ(ask("P " + point + " 10\n", 1), "RPRT 0\n");
            nextPoint += 0.8;
        }
        for (const auto& flood : floods) {
            flood->send("p\np\np\np\np\np\np\np\n", std::chrono::milliseconds(0));
        }
        sendRubbish(boresightd, ++number);
        const double at = seconds();
        const double error = std::abs(azimuth() - kRate * at);
        if (at > 5.0) {  // by then the path is known, and the delay of the start is made up
            worst = std::max(worst, error);
        }
    }
    EXPECT_LT(worst, 1.0);
    EXPECT_LT(answers.percentile(0.5), 50.0);
    RecordProperty("strangers", static_cast<int>(number));
    RecordProperty("following_worst_deg", QString::number(worst, 'f', 3).toStdString());
    record();
}

}  // namespace
}  // namespace boresight::system_test
