// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/gs232_mount/box_talk.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace boresight::gs232 {
namespace {

using std::chrono::milliseconds;

// Records what is sent, with the time. `answer` arrives 60 ms after each query.
class Talk
{
public:
    explicit Talk(int baud = 9600, Question question = Question::Both) : m_talk(question, baud) {}

    BoxTalk& operator*() { return m_talk; }
    BoxTalk* operator->() { return &m_talk; }
    void run(milliseconds time, const std::string& answer = {})
    {
        for (const SteadyTime end = m_now + time; m_now < end; m_now += milliseconds(20)) {
            if (m_due && m_now >= *m_due) {
                m_due.reset();
                m_talk.take(answer, m_now);
            }
            if (const std::string bytes = m_talk.send(m_now); !bytes.empty()) {
                sent.push_back({m_now, bytes});
                m_due = answer.empty() || bytes.front() != 'C' ? m_due : std::optional(m_now + milliseconds(60));
            }
        }
    }
    void hear(std::string_view bytes) { m_talk.take(bytes, m_now); }
    [[nodiscard]] int count(const std::string& command) const
    {
        return static_cast<int>(std::ranges::count(sent, command, &Sent::bytes));
    }

    struct Sent
    {
        SteadyTime when;
        std::string bytes;
    };
    std::vector<Sent> sent;

private:
    BoxTalk m_talk;
    SteadyTime m_now = SteadyTime{} + std::chrono::hours(1);
    std::optional<SteadyTime> m_due;
};

const std::string kAnswerB = "AZ=180  EL=090\r\n";

// REQ-GS232-05: The dialect is found by a query. Before the first answer nothing but the query is sent.
TEST(BoxTalk, TheDialectIsFoundByAsking)
{
    for (const auto& [answer, dialect] : {std::pair{kAnswerB, Dialect::B}, {"+0180+0090\r\n", Dialect::A}}) {
        Talk talk;
        talk->go("W001 002\r");
        talk->stop();
        talk.run(milliseconds(500));
        EXPECT_EQ(talk.count("C2\r"), static_cast<int>(talk.sent.size()));
        talk.hear(answer);
        EXPECT_EQ(talk->proof(), Proof::Box);
        EXPECT_EQ(talk->dialect(), dialect);
        const auto position = talk->takePlaces();
        ASSERT_TRUE(position);
        EXPECT_EQ(position->azimuth, 180_deg);
        EXPECT_FALSE(talk->takePlaces()) << "once";
    }
}

// REQ-GS232-06: The box receives at most four queries and two new targets in a second. There are 50 ms between two
// commands. Only a stop does not wait.
TEST(BoxTalk, CommandsArePaced)
{
    Talk talk;
    talk.run(milliseconds(1000), kAnswerB);
    talk.sent.clear();
    for (int i = 0; i < 500; ++i) {
        talk->go("W" + std::to_string(100 + i % 100) + " 010\r");
        talk.run(milliseconds(20), kAnswerB);
    }
    int asked = 0;
    for (std::size_t i = 0; i < talk.sent.size(); ++i) {
        asked += talk.sent[i].bytes == "C2\r" ? 1 : 0;
        EXPECT_TRUE(i == 0 || talk.sent[i].when - talk.sent[i - 1].when >= BoxTalk::kPause);
    }
    EXPECT_LE(asked, 41);
    EXPECT_GE(asked, 25);
    EXPECT_LE(static_cast<int>(talk.sent.size()) - asked, 21);
    EXPECT_GE(static_cast<int>(talk.sent.size()) - asked, 18);

    talk->stop();
    talk.run(milliseconds(20), kAnswerB);
    EXPECT_EQ(talk.sent.back().bytes, "S\r");
}

TEST(BoxTalk, AStopTakesTheTargetThatWaits)
{
    Talk talk;
    talk.run(milliseconds(1000), kAnswerB);
    talk.sent.clear();
    talk->go("W100 010\r");
    talk->stop();
    talk.run(milliseconds(2000), kAnswerB);
    EXPECT_EQ(talk.count("S\r"), 1);
    EXPECT_EQ(talk.count("W100 010\r"), 0);
}

// Story: a STOP before the first answer was dropped, and the box went on to a target from before the start.
TEST(BoxTalk, AStopBeforeTheFirstAnswerWaitsForIt)
{
    Talk talk;
    talk->stop();
    talk.run(milliseconds(500));
    EXPECT_EQ(talk.count("S\r"), 0);
    talk->restart();
    talk.run(milliseconds(2500), kAnswerB);
    EXPECT_EQ(talk.count("S\r"), 1);
}

// REQ-GS232-07: A device gets no more queries if, to three queries within three seconds, it sends only text that no
// such box sends. This also holds for a device that answered correctly before its line was opened again.
TEST(BoxTalk, AForeignDeviceIsLeftAlone)
{
    const std::vector<std::string> devices = {
        std::string("\xfe\xfe\xe0\x94\x00\x00\x25\x14\x00\xfd", 10),  // CI-V of an Icom
        "?;",                                                         // CAT of a Kenwood
        "IF00014250000     +00000000002000000 ;",
        "ERR unknown command\r\n",  // a CAN adapter
        "AZ 123.4\r",               // an ESP32 box
        "$GPGGA,123519,4807.038,N\r\n",
    };
    for (const std::string& said : devices) {
        Talk talk;
        talk.run(milliseconds(1000), kAnswerB);
        talk->restart();
        talk.sent.clear();
        talk.run(milliseconds(4500), said);
        EXPECT_EQ(talk->proof(), Proof::Foreign) << said;
        EXPECT_EQ(talk.count("C2\r"), static_cast<int>(talk.sent.size())) << said;
        EXPECT_FALSE(talk->strange().empty());
        talk.sent.clear();
        talk->go("W100 010\r");
        talk->stop();
        talk.run(milliseconds(5000), kAnswerB);
        EXPECT_TRUE(talk.sent.empty()) << "not even asked again";
    }
}

// Story: a byte of noise before the box was switched on closed its line until somebody pressed Reconnect.
// REQ-GS232-08: Noise does not make a box a foreign device: a byte when a plug is touched, the greeting of a box that
// starts, or single bytes while the box is off.
TEST(BoxTalk, NoiseMakesNoStrangerOfABox)
{
    for (const std::string& noise : {std::string("\xff"), std::string("\0~", 2), std::string("~\r"),
                                     std::string("*** BOOT 1.3 ***\r\nready\r\n")}) {
        Talk talk;
        talk.run(milliseconds(100));
        talk.hear(noise);
        talk.run(milliseconds(30000));
        EXPECT_EQ(talk->proof(), Proof::Unknown);
        EXPECT_GE(talk.count("C2\r"), 30) << "it is asked on";
        for (int i = 0; i < 10; ++i) {
            talk.hear(noise);
            talk.run(milliseconds(11000));
        }
        EXPECT_EQ(talk->proof(), Proof::Unknown);
        talk.run(milliseconds(1500), kAnswerB);
        EXPECT_EQ(talk->proof(), Proof::Box);
    }
}

// A greeting after the power-up, damaged lines and an echo do not make a box a foreign device.
TEST(BoxTalk, ABoxMayStammer)
{
    Talk talk;
    talk.hear("GS-232B V2.0\r\nC2\r");
    talk.run(milliseconds(1000));
    EXPECT_TRUE(talk->echoes());
    EXPECT_EQ(talk->proof(), Proof::Unknown);
    talk.hear("\r\n>AZ=18");
    talk.hear(std::string("\0", 1));
    talk.hear("0  EL=090\r\n");
    EXPECT_EQ(talk->proof(), Proof::Box);
    talk.run(milliseconds(10000));
    EXPECT_EQ(talk->proof(), Proof::Box) << "silence is no proof against it";
}

// Story: at 1200 baud a box without elevation counted as a foreign device after three seconds, and its line was closed.
// REQ-GS232-09: A refusal that arrives in pieces does not make a box a foreign device. It is reported as a refusal.
TEST(BoxTalk, ARefusalMayComeInPieces)
{
    Talk talk(1200);
    for (int question = 0; question < 10; ++question) {
        talk.run(milliseconds(1000));
        for (const char* const piece : {"?", ">", "\r", "\n"}) {
            talk.hear(piece);
            talk.run(milliseconds(20));
        }
    }
    EXPECT_EQ(talk->proof(), RotatorTalk::Proof::Unknown);
    EXPECT_TRUE(talk->refuses());
    talk.run(milliseconds(1500), kAnswerB);
    EXPECT_EQ(talk->proof(), RotatorTalk::Proof::Box);
}

// The rest of a late line does not count as the answer to the present query.
TEST(BoxTalk, HalfOfWhatWasAskedForIsNoAnswer)
{
    Talk both;
    both.run(milliseconds(100));
    both.hear("EL=090\r\nAZ=180\r\n");
    EXPECT_EQ(both->proof(), Proof::Unknown);
    Talk azimuth(1200, Question::Azimuth);
    azimuth.run(milliseconds(100));
    EXPECT_EQ(azimuth.sent.back().bytes, "C\r");
    azimuth.hear("AZ=180\r\n");
    EXPECT_EQ(azimuth->proof(), Proof::Box);
}

}  // namespace
}  // namespace boresight::gs232
