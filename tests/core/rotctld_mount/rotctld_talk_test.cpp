// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/rotctld_mount/rotctld_talk.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace boresight::rotctl {
namespace {

using std::chrono::milliseconds;
using Proof = RotatorTalk::Proof;

const AxisPosition kThere{.azimuth = 100_deg, .elevation = 10_deg};
const std::string kState =
    "dump_state:\nrotctld Protocol Ver: 1\nRotor Model: 1\nMinimum Azimuth: -180.000000\n"
    "Maximum Azimuth: 450.000000\nMinimum Elevation: 0.000000\nMaximum Elevation: 90.000000\nSouth Zero: 0\n"
    "rot_type=AzEl\ndone\nRPRT 0\n";
const std::string kPlainState = "1\n1\nmin_az=0.0\nmax_az=360.0\nmin_el=0.0\nmax_el=90.0\nrot_type=AzEl\ndone\n";

using Answers = std::map<std::string, std::string>;  // by the beginning of the query
const Answers kExtended{{"+\\dump_state", kState},
                        {"+\\get_pos", "get_pos:\nAzimuth: 180.00\nElevation: 45.00\nRPRT 0\n"},
                        {"+\\set_pos", "set_pos: 100.00 10.00\nRPRT 0\n"},
                        {"+\\stop", "stop:\nRPRT 0\n"}};
const Answers kPlain{{"\\dump_state", kPlainState}, {"p", "180.00\n45.00\n"}, {"P", "RPRT 0\n"}, {"S", "RPRT 0\n"}};
const Answers kPlainest{{"p", "180.00\n45.00\n"}, {"P", "RPRT 0\n"}, {"S", "RPRT 0\n"}};

// Records what is sent, with the time. The server answers after 40 ms, or after the time that a command takes. The line
// is opened again when this is requested.
class Talk
{
public:
    RotctldTalk& operator*() { return m_talk; }
    RotctldTalk* operator->() { return &m_talk; }
    void run(milliseconds time, const Answers& answers = {})
    {
        for (const SteadyTime end = m_now + time; m_now < end; m_now += milliseconds(20)) {
            while (!m_due.empty() && m_due.front().when <= m_now) {
                const std::string bytes = m_due.front().bytes;
                m_due.erase(m_due.begin());
                m_talk.take(bytes, m_now);
            }
            if (const std::string bytes = m_talk.send(m_now); !bytes.empty()) {
                sent.push_back({m_now, bytes});
                answer(bytes, answers);
            }
            if (m_talk.wantsAnotherLine()) {
                ++lines;
                m_due.clear();
                m_talk.restart();
            }
        }
    }
    void hear(std::string_view bytes) { m_talk.take(bytes, m_now); }
    [[nodiscard]] int count(const std::string& beginning) const
    {
        return static_cast<int>(
            std::ranges::count_if(sent, [&beginning](const Sent& one) { return one.bytes.starts_with(beginning); }));
    }
    // The number of lines that are no queries.
    [[nodiscard]] int orders() const { return count("+\\s") + count("P") + count("S"); }

    struct Sent
    {
        SteadyTime when;
        std::string bytes;
    };
    std::vector<Sent> sent;
    int lines = 1;
    milliseconds orderTakes{40};

private:
    void answer(const std::string& bytes, const Answers& answers)
    {
        for (const auto& [beginning, said] : answers) {
            if (bytes.starts_with(beginning)) {
                const bool orders = bytes.starts_with("+\\set_pos");
                m_due.push_back({m_now + (orders ? orderTakes : milliseconds(40)), said});
            }
        }
    }

    RotctldTalk m_talk;
    SteadyTime m_now = SteadyTime{} + std::chrono::hours(1);
    std::vector<Sent> m_due;
};

// REQ-ROTCTLDMOUNT-01: The first query to a rotctld is about its limits. Until the answer arrives only queries are
// sent.
TEST(RotctldTalk, IsAskedForItsLimitsFirst)
{
    Talk talk;
    (void)talk->go(kThere);
    talk->stop();
    talk.run(milliseconds(500));
    EXPECT_EQ(talk.count("+\\dump_state\n"), 1);
    EXPECT_EQ(talk.sent.size(), 1U);
    talk.hear(kState);
    EXPECT_EQ(talk->proof(), Proof::Box);
    ASSERT_TRUE(talk->state());
    EXPECT_EQ(talk->state()->azimuth.min, -180_deg);
    talk.run(milliseconds(500), kExtended);
    const auto places = talk->takePlaces();
    ASSERT_TRUE(places);
    EXPECT_EQ(places->azimuth, 180_deg);
    EXPECT_EQ(places->elevation, 45_deg);
    EXPECT_FALSE(talk->takePlaces()) << "once";
}

// REQ-ROTCTLDMOUNT-02: A server that does not know the extended form is used in the plain form. If it reports no limits
// either, it is recognised by its position. Each attempt uses a new connection, and only queries are sent.
TEST(RotctldTalk, ImitationsAreUsedInThePlainForm)
{
    for (const auto& [answers, limits] : {std::pair{kPlain, true}, {kPlainest, false}}) {
        Talk talk;
        talk.run(milliseconds(13000), answers);
        EXPECT_EQ(talk->proof(), Proof::Box);
        EXPECT_EQ(talk->state().has_value(), limits);
        EXPECT_EQ(talk.orders(), 0);
        EXPECT_EQ(talk.lines, limits ? 2 : 3);
        EXPECT_TRUE(talk->takePlaces());
        ASSERT_TRUE(talk->go(kThere));
        talk.run(milliseconds(500), answers);
        EXPECT_EQ(talk.count("P 100.00 10.00\n"), 1);
        talk->stop();
        talk.run(milliseconds(500), answers);
        EXPECT_EQ(talk.count("S\n"), 1);
    }
    // After a server has refused an unknown query, the next query follows at once.
    Answers refusing = kPlainest;
    refusing["+\\dump_state"] = "RPRT -11\n";
    refusing["\\dump_state"] = "RPRT -11\n";
    Talk talk;
    talk.run(milliseconds(4000), refusing);
    EXPECT_EQ(talk->proof(), Proof::Box);
    EXPECT_EQ(talk.lines, 1);
}

// REQ-ROTCTLDMOUNT-03: The rotator receives at most four queries and two new targets in a second. A command waits for
// the answer to the previous one. Only a stop waits for nothing.
TEST(RotctldTalk, CommandsArePaced)
{
    Talk talk;
    talk.run(milliseconds(1000), kExtended);
    talk.sent.clear();
    for (int i = 0; i < 500; ++i) {
        (void)talk->go({.azimuth = Angle::fromDegrees(100.0 + i % 100), .elevation = 10_deg});
        talk.run(milliseconds(20), kExtended);
    }
    EXPECT_LE(talk.count("+\\get_pos"), 41);
    EXPECT_GE(talk.count("+\\get_pos"), 25);
    EXPECT_LE(talk.count("+\\set_pos"), 21);
    EXPECT_GE(talk.count("+\\set_pos"), 18);
    for (std::size_t i = 1; i < talk.sent.size(); ++i) {
        EXPECT_GE(talk.sent[i].when - talk.sent[i - 1].when, milliseconds(40));
    }
    talk.run(milliseconds(300));  // a query without an answer
    talk->stop();
    talk.run(milliseconds(20));
    EXPECT_EQ(talk.sent.back().bytes, "+\\stop\n");
}

// Story: a SPID at 600 Bd needs 0.8 s for a target. It never received a query during a motion, and counted as silent.
// REQ-ROTCTLDMOUNT-66: If a rotator needs more time for a target than there is between two targets, its position is
// still queried between them.
TEST(RotctldTalk, ASlowRotatorIsAskedBetweenTargets)
{
    Talk talk;
    talk.orderTakes = milliseconds(770);
    talk.run(milliseconds(1000), kExtended);
    talk.sent.clear();
    for (int i = 0; i < 500; ++i) {
        (void)talk->go({.azimuth = Angle::fromDegrees(100.0 + i % 100), .elevation = 10_deg});
        talk.run(milliseconds(20), kExtended);
    }
    EXPECT_GE(talk.count("+\\set_pos"), 10);
    for (std::size_t i = 1; i < talk.sent.size(); ++i) {
        EXPECT_FALSE(talk.sent[i].bytes.starts_with("+\\set_pos") && talk.sent[i - 1].bytes.starts_with("+\\set_pos"));
    }
}

TEST(RotctldTalk, AStopTakesTheTargetThatWaits)
{
    Talk talk;
    talk.run(milliseconds(1000), kExtended);
    talk.sent.clear();
    (void)talk->go(kThere);
    talk->stop();
    talk.run(milliseconds(2000), kExtended);
    EXPECT_EQ(talk.count("+\\stop"), 1);
    EXPECT_EQ(talk.count("+\\set_pos"), 0);
}

// REQ-ROTCTLDMOUNT-04: A server that sends something else gets no more queries: a rigctld, whose usual port is the next
// number, a web server, a shell, a GS-232 box behind a serial server, and a server with a binary protocol.
TEST(RotctldTalk, AForeignServerIsLeftAlone)
{
    const std::vector<std::string> servers = {
        "dump_state:\n1\n1\n0\n150000.000000 1500000000.000000 0x1ff -1 -1 0x77e00007 0xf\n0 0\nRPRT 0\n",
        "HTTP/1.1 400 Bad Request\r\nServer: nginx\r\n\r\n",
        "SSH-2.0-OpenSSH_9.2p1\r\n",
        "?>\r\n",
        "AZ=180  EL=090\r\n",
        std::string("\x15\x03\x01\x00\x02\x02\x46", 7),  // a TLS alert
        "220 mail.example.org ESMTP\r\n",
    };
    for (const std::string& said : servers) {
        Talk talk;
        talk.run(milliseconds(1000), kExtended);
        talk->restart();
        talk.sent.clear();
        talk.run(milliseconds(6000), {{"+\\dump_state", said}});
        EXPECT_EQ(talk->proof(), Proof::Foreign) << said;
        EXPECT_FALSE(talk->strange().empty());
        EXPECT_EQ(talk.sent.size(), 1U) << said;
        (void)talk->go(kThere);
        talk->stop();
        talk.run(milliseconds(5000), kExtended);
        EXPECT_EQ(talk.sent.size(), 1U) << "not even asked again";
    }
    Talk banner;
    banner.hear("Welcome\r\n");
    banner.run(milliseconds(1000), kExtended);
    EXPECT_EQ(banner->proof(), Proof::Foreign) << "before it was asked";
    EXPECT_TRUE(banner.sent.empty());
}

// REQ-ROTCTLDMOUNT-05: A refused target is sent again. The refusals are counted until a target is accepted. A refused
// stop is repeated twice a second until it is accepted.
TEST(RotctldTalk, WhatIsRefusedIsSentAgain)
{
    Answers refusing = kExtended;
    refusing["+\\set_pos"] = "set_pos: 100.00 10.00\nRPRT -5\n";
    refusing["+\\stop"] = "stop:\nRPRT -6\n";
    Talk talk;
    talk.run(milliseconds(1000), kExtended);
    (void)talk->go(kThere);
    talk.run(milliseconds(1400), refusing);
    EXPECT_EQ(talk->refusals(), 3);
    EXPECT_EQ(talk->refusal(), -5);
    talk.run(milliseconds(1000), kExtended);
    EXPECT_EQ(talk->refusals(), 0);
    EXPECT_EQ(talk.count("+\\set_pos"), 4);
    talk->stop();
    talk.run(milliseconds(3000), refusing);
    EXPECT_NEAR(talk.count("+\\stop"), 6, 1);
    const int stops = talk.count("+\\stop");
    talk.run(milliseconds(3000), kExtended);
    EXPECT_EQ(talk.count("+\\stop"), stops + 1);
}

// REQ-ROTCTLDMOUNT-06: A rotator that cannot stop is sent to its present position at once.
TEST(RotctldTalk, WhoCannotStopIsSentToWhereItStands)
{
    Answers unable = kExtended;
    unable["+\\stop"] = "stop:\nRPRT -11\n";
    Talk talk;
    talk.run(milliseconds(1000), unable);
    talk->stop();
    talk.run(milliseconds(200), unable);
    EXPECT_EQ(talk.orders(), 2) << "nobody knows yet where it stands";
    talk->standsAt(AxisPosition{.azimuth = 180_deg, .elevation = 45_deg});
    talk.sent.clear();
    talk.run(milliseconds(1000), unable);
    EXPECT_EQ(talk.count("+\\stop"), 0);
    EXPECT_EQ(talk.count("+\\set_pos 180.00 45.00\n"), 1);
    talk->stop();
    talk.run(milliseconds(20), unable);
    EXPECT_EQ(talk.count("+\\stop"), 0) << "it is known now";
    EXPECT_EQ(talk.count("+\\set_pos 180.00 45.00\n"), 2);
}

// REQ-ROTCTLDMOUNT-07: While an answer is missing nothing is sent except one stop, because more would wait in the queue
// of the server. If the answer is missing for five seconds, the connection is opened again and continues in the known
// form. A stop without an answer is sent again.
TEST(RotctldTalk, AServerThatHangsIsConnectedToAnew)
{
    for (const Answers& answers : {kExtended, kPlain}) {
        Talk talk;
        talk.run(milliseconds(6000), answers);
        ASSERT_EQ(talk->proof(), Proof::Box);
        const int lines = talk.lines;
        talk.run(milliseconds(300));
        talk.sent.clear();
        ASSERT_TRUE(talk->go(kThere));
        for (int i = 0; i < 4; ++i) {
            talk->stop();
            talk.run(milliseconds(1000));
        }
        ASSERT_EQ(talk.sent.size(), 1U) << "one stop";
        EXPECT_EQ(talk.count("+\\stop") + talk.count("S"), 1);
        EXPECT_EQ(talk.lines, lines);
        talk.run(milliseconds(1500));
        EXPECT_EQ(talk.lines, lines + 1);
        talk.sent.clear();
        talk.run(milliseconds(12000));
        EXPECT_EQ(talk.count("+\\dump_state"), &answers == &kExtended ? 3 : talk.count("+\\dump_state"));
        EXPECT_EQ(talk.orders(), 0);
        talk.sent.clear();
        talk.run(milliseconds(5000), answers);
        EXPECT_EQ(talk.count("+\\stop") + talk.count("S"), 1);
        EXPECT_TRUE(talk->state());
    }
}

// REQ-ROTCTLDMOUNT-08: A damaged answer is ignored, and gives no position.
TEST(RotctldTalk, ADamagedAnswerIsLeftOut)
{
    Talk talk;
    talk.run(milliseconds(1000), kExtended);
    (void)talk->takePlaces();
    for (const char* const damaged :
         {"get_pos:\nAzimuth: 18get_pos:\nAzimuth: 180.00\nElevation: 45.00\nRPRT 0\n",
          "get_pos:\nAzimuth: 180.00\nRPRT 0\n", "get_pos:\nAzimuth: 180.00\nElevation: 4#.00\nRPRT 0\n",
          "stop:\nRPRT 0\n", "RPRT 0\n", "RPRT 1\nRPRT -1\n"}) {
        Answers answers = kExtended;
        answers["+\\get_pos"] = damaged;
        talk.run(milliseconds(1000), answers);
        EXPECT_FALSE(talk->takePlaces()) << damaged;
        talk.run(milliseconds(2000), kExtended);
        EXPECT_TRUE(talk->takePlaces()) << damaged;
    }
    EXPECT_EQ(talk->proof(), Proof::Box);
}

// REQ-ROTCTLDMOUNT-09: An additional line after an answer is ignored, and so is the second of two refusals.
TEST(RotctldTalk, AReportTooManyIsPassedOver)
{
    Answers ending = kPlainest;
    ending["+\\dump_state"] = "RPRT -11\nRPRT -11\n";
    ending["\\dump_state"] = "RPRT -11\n";
    ending["p"] = "180.00\n45.00\nRPRT 0\n";
    Talk talk;
    talk.run(milliseconds(8000), ending);
    EXPECT_EQ(talk->proof(), Proof::Box);
    EXPECT_EQ(talk.lines, 1);
    EXPECT_GE(talk.count("p"), 15);
}

// After a refused stop no target is sent before the stop is accepted.
TEST(RotctldTalk, ATargetWaitsForTheStop)
{
    Answers refusing = kExtended;
    refusing["+\\stop"] = "stop:\nRPRT -6\n";
    Talk talk;
    talk.run(milliseconds(1000), kExtended);
    talk->stop();
    talk.run(milliseconds(200), refusing);
    (void)talk->go(kThere);
    talk.run(milliseconds(2000), refusing);
    EXPECT_EQ(talk.count("+\\set_pos"), 0);
    talk.run(milliseconds(2000), kExtended);
    EXPECT_EQ(talk.count("+\\set_pos"), 1);
    EXPECT_TRUE(talk.sent.back().bytes.starts_with("+\\get_pos"));
}

TEST(RotctldTalk, AnErrorOfTheRotatorIsNoPosition)
{
    Answers failing = kExtended;
    failing["+\\get_pos"] = "get_pos:\nRPRT -5\n";
    Talk talk;
    talk.run(milliseconds(2000), failing);
    EXPECT_EQ(talk->proof(), Proof::Box);
    EXPECT_FALSE(talk->takePlaces());
    EXPECT_EQ(talk->positionError(), -5);
    talk.run(milliseconds(500), kExtended);
    EXPECT_EQ(talk->positionError(), 0);
}

}  // namespace
}  // namespace boresight::rotctl
