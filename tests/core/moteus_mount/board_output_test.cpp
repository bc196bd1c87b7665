// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/moteus_mount/board_output.h"

#include "core/moteus/pin_query.h"
#include "core/moteus_mount/drive.h"
#include "core/sim/simulated_pair.h"
#include "tests/fakes/manual_clock.h"

#include <gmock/gmock.h>

#include <string>
#include <vector>

namespace boresight {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

using Bytes = std::vector<std::uint8_t>;

Bytes bytesOf(const CanFrame& frame)
{
    return {frame.data.begin(), frame.data.begin() + frame.size};
}

// Pin 2 of port 1 of the azimuth board, which is an output. Pin 4 of the same port is another output, and is on.
struct BoardOutputTest : testing::Test
{
    BoardOutputTest()
    {
        azimuth().makeOutput(1, 2);
        azimuth().makeOutput(1, 4);
        (void)pair.exchange(*moteus::encode({.destination = 1,
                                             .command = moteus::SetOutputs{.port = 1, .bits = 0b10000},
                                             .query = moteus::outputQuery()}),
                            elapsed);
        QObject::connect(&output, &outputs::Output::reached,
                         [this](bool on) { answers.emplace_back(on ? "on" : "off"); });
        QObject::connect(&output, &outputs::Output::failed,
                         [this](const QString& reason) { answers.push_back(reason.toStdString()); });
    }
    sim::SimulatedMoteus& azimuth() { return pair.drive(Axis::Azimuth); }
    void exchange(const CanFrame& frame)
    {
        sent.push_back(bytesOf(frame));
        if (silent) {
            return;
        }
        for (const sim::PairReply& reply : pair.exchange(frame, elapsed)) {
            CanFrame back = reply.frame;
            back.received = clock.now();
            isOfADrive = isOfADrive || drive.take(back);
            output.take(back);
        }
    }
    void run(int ticks)
    {
        for (int i = 0; i < ticks; ++i) {
            clock.advance(Seconds(0.02));
            elapsed += Seconds(0.02);
            if (const auto frame = output.frame(clock.now())) {
                exchange(*frame);
            }
        }
    }
    void order(bool on)
    {
        output.set(on);
        run(5);
    }

    fakes::ManualClock clock;
    Seconds elapsed{0.0};
    sim::SimulatedPair pair{sim::commissionedPair()};
    BoardOutput output{{.board = 1, .port = 1, .number = 2}, [this](const CanFrame& frame) { exchange(frame); }};
    Drive drive{DriveSettings{.id = 1}, "azimuth drive"};
    std::vector<std::string> answers;
    std::vector<Bytes> sent;
    bool silent = false;
    bool isOfADrive = false;
};

// REQ-BRAKE-40: A pin of a moteus is switched by the register of all outputs of its port (0x05c, 0x05d). The other
// outputs are read first and stay as they are. The order is reached when the board reports it. The frames command no
// motor, and their replies are not taken for those of a command.
TEST_F(BoardOutputTest, APinIsSwitchedAndItsNeighboursStay)
{
    order(true);
    EXPECT_TRUE(azimuth().isDrivenHigh(1, 2));
    EXPECT_TRUE(azimuth().isDrivenHigh(1, 4));
    EXPECT_THAT(answers, ElementsAre("on"));
    ASSERT_EQ(sent.size(), 2U);
    EXPECT_EQ(sent[0], (Bytes{0x12, 0x5c}))  // read two i8 from 0x05c
        << "what the port has";
    // 0x01 write one i8, 0x5c: outputs of port 1, 0x14: pins 2 and 4. Then the same question.
    EXPECT_EQ(sent[1], (Bytes{0x01, 0x5c, 0x14, 0x12, 0x5c}));
    EXPECT_TRUE(moteus::checkAnswerable(moteus::outputQuery()));
    order(false);
    EXPECT_FALSE(azimuth().isDrivenHigh(1, 2));
    EXPECT_TRUE(azimuth().isDrivenHigh(1, 4));
    EXPECT_THAT(answers, ElementsAre("on", "off"));
    EXPECT_FALSE(isOfADrive);
    EXPECT_EQ(azimuth().servo().mode(), moteus::Mode::Stopped);
}

// REQ-BRAKE-41: Off is sent at once, because the program may end next. It is also the last frame before the bus is
// closed.
TEST_F(BoardOutputTest, OffIsSentAtOnce)
{
    order(true);
    sent.clear();
    EXPECT_TRUE(output.lastFrame());
    output.set(false);
    EXPECT_EQ(sent.size(), 1U);
    EXPECT_FALSE(azimuth().isDrivenHigh(1, 2));
    run(5);
    EXPECT_FALSE(output.lastFrame());
}

// REQ-BRAKE-42: A pin that is off although it was on, because its board was without power, is a failure. It is not
// switched on again by itself. A board that does not reply within 0.5 s is a failure, too.
TEST_F(BoardOutputTest, ALostPinIsAFailure)
{
    order(true);
    azimuth().setPowered(false);
    azimuth().setPowered(true);
    EXPECT_FALSE(azimuth().isDrivenHigh(1, 2));
    answers.clear();
    order(true);
    ASSERT_EQ(answers.size(), 1U);
    EXPECT_THAT(answers[0], HasSubstr("Was board 1 without power?"));
    EXPECT_FALSE(azimuth().isDrivenHigh(1, 2));

    silent = true;
    answers.clear();
    output.set(false);
    run(20);
    EXPECT_THAT(answers, IsEmpty());
    run(10);
    EXPECT_THAT(answers, ElementsAre("board 1 does not reply"));
}

// REQ-BRAKE-43: While the bus is released to other tools, a pin that is off counts as off, and one that is on is a
// failure.
TEST_F(BoardOutputTest, WithoutTheLineAPinThatIsOffStaysOff)
{
    order(false);
    output.set(false);
    output.restWithoutLine();
    output.set(true);
    output.restWithoutLine();
    EXPECT_THAT(answers, ElementsAre("off", "off", "the line to board 1 is closed"));
}

TEST_F(BoardOutputTest, APinThatIsNoOutputShowsNothing)
{
    BoardOutput other({.board = 1, .port = 2, .number = 0}, [](const CanFrame&) {});
    other.set(true);
    for (int i = 0; i < 3; ++i) {
        clock.advance(Seconds(0.02));
        for (const sim::PairReply& reply : pair.exchange(*other.frame(clock.now()), elapsed)) {
            CanFrame back = reply.frame;
            back.received = clock.now();
            if (i < 2) {
                other.take(back);
            }
        }
    }
    EXPECT_FALSE(azimuth().isDrivenHigh(2, 0));
}

}  // namespace
}  // namespace boresight
