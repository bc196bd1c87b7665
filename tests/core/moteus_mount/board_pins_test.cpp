// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/moteus_mount/board_pins.h"

#include "core/moteus/pin_query.h"
#include "core/moteus_mount/drive.h"
#include "core/sim/simulated_pair.h"
#include "tests/fakes/manual_clock.h"

#include <gtest/gtest.h>

namespace boresight {
namespace {

constexpr contacts::BoardPin kPin{.board = 1, .port = 1, .number = 2};

// The boards of the simulated mount. A switch at pin 2 of the azimuth board is high while it is not pressed.
struct BoardPinsTest : testing::Test
{
    BoardPinsTest()
    {
        profile::Profile profile;
        profile.endSwitches.inputs = {"moteus:1:aux1.2", "moteus:1:aux2.0", "mqtt:roof/end", ""};
        inForce.apply(profile);
        pair.wire({.port = 1, .pin = 2, .at = pair.drive(Axis::Azimuth).plant().loadPosition() + 0.01});
    }
    void exchange(bool areConsolesFree = false)
    {
        for (const CanFrame& frame : pins.frames(clock.now(), areConsolesFree)) {
            for (const sim::PairReply& reply : pair.exchange(frame, elapsed)) {
                CanFrame back = reply.frame;
                back.received = clock.now();
                isOfADrive = isOfADrive || drive.take(back);
                pins.take(back);
            }
        }
    }
    [[nodiscard]] std::optional<bool> isOn(const contacts::BoardPin& pin) const
    {
        return pins.read(pin, clock.now()).isOn;
    }

    fakes::ManualClock clock;
    Seconds elapsed{0.0};
    profile::InForce inForce{profile::Profile{}};
    sim::SimulatedPair pair{sim::commissionedPair()};
    BoardPins pins{inForce};
    Drive drive{DriveSettings{.id = 1}, "azimuth drive"};
    bool isOfADrive = false;
};

// REQ-ENDSWITCH-50: Each board with a pin of the profile is asked once per tick for the states of its aux pins
// (registers 0x05e and 0x05f), in a frame that commands nothing and whose reply is not taken for one to a command.
TEST_F(BoardPinsTest, EachBoardIsAskedOnce)
{
    const std::vector<CanFrame> frames = pins.frames(clock.now(), false);
    ASSERT_EQ(frames.size(), 1U);
    EXPECT_EQ(frames[0].id, 0x9101U) << "from 0x11 to 1, reply wanted";
    // 0x12: read two i8, 0x5e: from the state of aux port 1
    EXPECT_EQ(std::vector<std::uint8_t>(frames[0].data.begin(), frames[0].data.begin() + 2),
              (std::vector<std::uint8_t>{0x12, 0x5e}));
    EXPECT_TRUE(moteus::checkAnswerable(moteus::pinQuery()));
    exchange();
    EXPECT_FALSE(isOfADrive);
}

// REQ-ENDSWITCH-51: Bit 0 of the register is pin 0. A reading that is older than 0.2 s does not count.
TEST_F(BoardPinsTest, ReadsThePinsOfASimulatedBoard)
{
    EXPECT_EQ(pins.read(kPin, clock.now()).problem, QStringLiteral("board 1 has not replied yet"));
    exchange();
    EXPECT_EQ(isOn(kPin), true);
    sim::SimulatedMoteus& board = pair.drive(Axis::Azimuth);
    board.place(board.plant().loadPosition() + 0.02);
    elapsed = Seconds(0.1);
    exchange();
    EXPECT_EQ(isOn(kPin), false) << "the axis has pressed it";
    EXPECT_EQ(isOn({.board = 1, .port = 1, .number = 1}), true);
    EXPECT_EQ(isOn({.board = 1, .port = 2, .number = 0}), true);
    board.setPin(2, 0, false);
    exchange();
    EXPECT_EQ(isOn({.board = 1, .port = 2, .number = 0}), false);
    EXPECT_EQ(isOn({.board = 1, .port = 2, .number = 1}), true);
    clock.advance(Seconds(0.25));
    EXPECT_EQ(pins.read(kPin, clock.now()).problem, QStringLiteral("board 1 does not reply"));
    EXPECT_FALSE(isOn({.board = 2, .port = 1, .number = 2}));
}

// REQ-ENDSWITCH-52: After a connection the console of each board is asked for the modes of its pins. A pin that is no
// digital input cannot be read, whatever it reads, and the reason names the setting. The modes are asked again when the
// board was away.
TEST_F(BoardPinsTest, APinThatIsNoInputIsNotRead)
{
    const auto connect = [&] {
        for (int tick = 0; tick < 100; ++tick) {
            exchange(true);
            clock.advance(Seconds(0.02));
            elapsed += Seconds(0.02);
        }
        exchange(true);
    };
    const auto configure = [&](const std::string& value) {
        const std::string text = "conf set aux1.pins.2.mode " + value + "\n";
        sim::SimulatedMoteus& board = pair.drive(Axis::Azimuth);
        board.receiveText(1, {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
        board.dropText(1, board.pendingText(1).size());
    };
    configure("15");
    exchange();
    EXPECT_EQ(isOn(kPin), false) << "the modes are not known yet";
    connect();
    EXPECT_FALSE(isOn(kPin).has_value());
    EXPECT_EQ(
        pins.read(kPin, clock.now()).problem,
        QStringLiteral("The pin is no input: aux1.pins.2.mode of board 1 is 15. Set it to 14 with moteus tview and "
                       "store it"));
    EXPECT_EQ(isOn({.board = 1, .port = 2, .number = 0}), true);
    configure("14");
    connect();
    EXPECT_FALSE(isOn(kPin).has_value()) << "the modes are asked once";
    clock.advance(Seconds(1.0));
    connect();
    EXPECT_EQ(isOn(kPin), true);
}

}  // namespace
}  // namespace boresight
