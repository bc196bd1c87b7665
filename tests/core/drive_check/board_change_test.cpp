// SPDX-License-Identifier: GPL-3.0-or-later
// One setting of one board, on the simulated pair with factory settings: both boards have the same id.
#include "core/drive_check/board_change.h"

#include "core/sim/drive_config.h"
#include "core/sim/simulated_pair.h"
#include "tests/fakes/text_of.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>

namespace boresight::drive_check {
namespace {

using testing::HasSubstr;

constexpr Seconds kChangeTick{0.02};

// Changes the id of the elevation board to 2.
class BoardChangeTest : public testing::Test
{
protected:
    BoardChangeTest() { pair.setFitted(Axis::Azimuth, false); }

    static moteus::Uuid uuidOf(Axis axis)
    {
        const auto bytes = sim::factoryPair().azimuth.config.uuid;
        moteus::Uuid uuid{};
        for (std::size_t i = 0; i < bytes.size(); ++i) {
            const std::uint8_t byte = i + 1 == bytes.size() && axis == Axis::Elevation ? 0x32 : bytes[i];
            uuid[i / 4] |= static_cast<std::uint32_t>(byte) << (8 * (i % 4));
        }
        return uuid;
    }
    [[nodiscard]] SteadyTime now() const
    {
        return SteadyTime(std::chrono::hours(1)) + std::chrono::duration_cast<SteadyTime::duration>(elapsed);
    }
    // Runs until the change has ended. `meanwhile` is called before each tick.
    std::string change(
        const BoardOrder& order, const std::function<void()>& meanwhile = [] {})
    {
        work.begin(order, now());
        for (int i = 0; i < 1500 && work.isRunning(); ++i) {
            meanwhile();
            for (const CanFrame& frame : work.frames(now())) {
                sent.push_back(frame);
                for (const sim::PairReply& reply : pair.exchange(frame, elapsed)) {
                    if (const auto decoded = moteus::decodeReply(reply.frame)) {
                        work.take(*decoded);
                    }
                }
            }
            elapsed += kChangeTick;
            pair.advanceTo(elapsed);
        }
        EXPECT_FALSE(work.isRunning());
        const Result<> outcome = work.outcome().value_or(failure(ErrorCode::NoAnswer, QStringLiteral("never ended")));
        return outcome ? std::string() : textOf(outcome.error());
    }
    [[nodiscard]] int idOf(Axis axis) { return pair.drive(axis).driveConfig().id; }
    void losePower(Axis axis)
    {
        pair.drive(axis).setPowered(false);
        pair.drive(axis).setPowered(true);
    }

    sim::SimulatedPair pair{sim::factoryPair()};
    BoardChange work;
    BoardOrder newId{.board = uuidOf(Axis::Elevation),
                     .id = 1,
                     .newId = 2,
                     .key = "id.id",
                     .value = 2.0,
                     .alone = true,
                     .what = QStringLiteral("the id 2")};
    Seconds elapsed{0.0};
    std::vector<CanFrame> sent;
};

// REQ-SURVEY-950: The only board on the bus receives another id. It is set, the board is found again by its UUID under
// the new id, and the id is read back and stored. Nothing that is sent moves an axis.
TEST_F(BoardChangeTest, TheOnlyBoardGetsAnotherIdThatIsStored)
{
    EXPECT_EQ(change(newId), "");
    EXPECT_EQ(idOf(Axis::Elevation), 2);
    EXPECT_EQ(idOf(Axis::Azimuth), 1);
    losePower(Axis::Elevation);
    EXPECT_EQ(idOf(Axis::Elevation), 2) << "it is stored";
    for (const CanFrame& frame : sent) {
        moteus::SubframeReader reader(frame.payload());
        while (const auto subframe = reader.next()) {
            const auto* write = std::get_if<moteus::WriteBlock>(&*subframe);
            EXPECT_TRUE(write == nullptr || write->first >= moteus::Register::UuidMask) << toString(frame);
        }
    }
}

// REQ-SURVEY-950
TEST_F(BoardChangeTest, LostFramesAreRepeated)
{
    (void)pair.faults().add({.kind = sim::FaultKind::LostReply, .axis = Axis::Elevation, .value = 0.1});
    EXPECT_EQ(change(newId), "");
    losePower(Axis::Elevation);
    EXPECT_EQ(idOf(Axis::Elevation), 2);
}

// REQ-SURVEY-951: Nothing is changed while two boards with the same id are connected, or a board other than the
// confirmed one, or none.
TEST_F(BoardChangeTest, TwoBoardsWithOneIdAreLeftAsTheyAre)
{
    pair.setFitted(Axis::Azimuth, true);
    EXPECT_THAT(change(newId), HasSubstr("Two boards with the id 1 are still connected"));
    EXPECT_EQ(idOf(Axis::Azimuth), 1);
    EXPECT_EQ(idOf(Axis::Elevation), 1);
}

// REQ-SURVEY-951
TEST_F(BoardChangeTest, TheWrongBoardIsLeftAsItIs)
{
    pair.setFitted(Axis::Azimuth, true);
    pair.setFitted(Axis::Elevation, false);
    EXPECT_THAT(change(newId), HasSubstr("is not the board that you confirmed"));
    EXPECT_EQ(idOf(Axis::Azimuth), 1);
}

// REQ-SURVEY-951
TEST_F(BoardChangeTest, WithoutABoardNothingIsSentToAny)
{
    pair.setFitted(Axis::Elevation, false);
    EXPECT_THAT(change(newId), HasSubstr("No board with the id 1 answers"));
}

// REQ-SURVEY-952: Nothing is stored unless the same board alone answers under the new id and reads back the value that
// was set.
TEST_F(BoardChangeTest, AnotherBoardThatComesMeanwhileEndsItUnstored)
{
    const auto plugIn = [this] { pair.setFitted(Axis::Azimuth, idOf(Axis::Elevation) == 2); };
    EXPECT_THAT(change(newId, plugIn), HasSubstr("Nothing was stored"));
    losePower(Axis::Elevation);
    EXPECT_EQ(idOf(Axis::Elevation), 1) << "it has its old id again";
}

// REQ-SURVEY-952
TEST_F(BoardChangeTest, ABoardThatLosesItsPowerMeanwhileKeepsItsOldId)
{
    bool lost = false;
    const auto lose = [&] {
        if (!lost && work.progress().startsWith(QStringLiteral("Checking that"))) {
            lost = true;
            losePower(Axis::Elevation);
        }
    };
    EXPECT_THAT(change(newId, lose), HasSubstr("does not answer with the id 2"));
    EXPECT_EQ(idOf(Axis::Elevation), 1);
}

// Story: text that is not a number counts as 0, without an error. A command may be garbled on its way to the console.
// REQ-SURVEY-952
TEST_F(BoardChangeTest, WhatReadsBackOtherwiseIsNotStored)
{
    BoardOrder ratio{.board = uuidOf(Axis::Elevation),
                     .id = 1,
                     .newId = 1,
                     .key = "motor_position.rotor_to_output_ratio",
                     .value = 0.01,
                     .what = QStringLiteral("the gear ratio")};
    bool spoiled = false;
    const auto spoil = [&] {  // another tool writes at the same time
        const std::string text = "conf set motor_position.rotor_to_output_ratio 0.5\n";
        if (!spoiled && pair.drive(Axis::Elevation).driveConfig().motorPosition.rotorToOutputRatio == 0.01) {
            pair.drive(Axis::Elevation)
                .receiveText(1, {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
            spoiled = true;
        }
    };
    EXPECT_THAT(change(ratio, spoil), HasSubstr("reads back 0.5"));
    EXPECT_TRUE(spoiled);
    losePower(Axis::Elevation);
    EXPECT_EQ(pair.drive(Axis::Elevation).driveConfig().motorPosition.rotorToOutputRatio, 1.0);
}

// REQ-SURVEY-953: The gear ratio of a board is set, read back and stored, also beside another board.
TEST_F(BoardChangeTest, AGearRatioIsStored)
{
    ASSERT_EQ(change(newId), "");
    pair.setFitted(Axis::Azimuth, true);
    const BoardOrder ratio{.board = uuidOf(Axis::Elevation),
                           .id = 2,
                           .newId = 2,
                           .key = "motor_position.rotor_to_output_ratio",
                           .value = 1.0 / 150.0,
                           .what = QStringLiteral("the gear ratio")};
    EXPECT_EQ(change(ratio), "");
    losePower(Axis::Elevation);
    EXPECT_NEAR(pair.drive(Axis::Elevation).driveConfig().motorPosition.rotorToOutputRatio, 1.0 / 150.0, 1e-8);
    EXPECT_EQ(pair.drive(Axis::Azimuth).driveConfig().motorPosition.rotorToOutputRatio, 1.0);
}

// REQ-SURVEY-957: When the gear ratio changes, the gains that depend on output turns are converted: read, set, read
// back and stored with it. Gains that older firmware does not have are left out.
TEST_F(BoardChangeTest, GainsFollowTheGear)
{
    const double before = pair.drive(Axis::Elevation).driveConfig().servo.gains.kp;
    const BoardOrder ratio{.board = uuidOf(Axis::Elevation),
                           .id = 1,
                           .newId = 1,
                           .key = "motor_position.rotor_to_output_ratio",
                           .value = 0.01,
                           .scaled = {{"servo.pid_position.kp", 10000.0}, {"servo.not_there", 2.0, true}},
                           .what = QStringLiteral("the gear ratio")};
    EXPECT_EQ(change(ratio), "");
    losePower(Axis::Elevation);
    EXPECT_NEAR(pair.drive(Axis::Elevation).driveConfig().servo.gains.kp, 10000.0 * before, 1.0);

    BoardOrder unreadable = ratio;
    unreadable.scaled.back().optional = false;
    unreadable.value = 0.02;
    EXPECT_EQ(change(unreadable), "servo.not_there cannot be read. Nothing was changed.");
    EXPECT_NEAR(pair.drive(Axis::Elevation).driveConfig().motorPosition.rotorToOutputRatio, 0.01, 1e-8);
}

// Story: the answer to `conf write` was lost, and the operator read that nothing was stored.
// REQ-SURVEY-952
TEST_F(BoardChangeTest, WhatWasPerhapsStoredIsCalledUnknown)
{
    const auto fallSilent = [&] {
        if (work.progress().startsWith(QStringLiteral("Storing"))) {
            (void)pair.faults().add({.kind = sim::FaultKind::LostReply, .axis = Axis::Elevation, .value = 1.0});
        }
    };
    EXPECT_THAT(change(newId, fallSilent), HasSubstr("It is unknown whether the board stored them"));
}

// REQ-SIM-950: Two different replies under the same id destroy each other or arrive one after the other, with the
// frequency that the settings give. Destroyed replies count as bus errors.
// REQ-SURVEY-954: Two boards with the same id are detected in both cases.
TEST_F(BoardChangeTest, APairWhoseAnswersBothArriveIsNoticedToo)
{
    sim::PairSettings lucky = sim::factoryPair();
    lucky.collisions = 0.0;
    sim::SimulatedPair both(lucky);
    const auto query = moteus::encode({.destination = 1, .query = moteus::basicQuery()});
    ASSERT_TRUE(query);
    EXPECT_EQ(both.exchange(*query, Seconds(0.0)).size(), 2u);
    EXPECT_EQ(both.replyCounts().collided, 0u);
    pair.setFitted(Axis::Azimuth, true);
    EXPECT_TRUE(pair.exchange(*query, elapsed).empty());
    EXPECT_EQ(pair.replyCounts().collided, 2u);

    BusScan scan(moteus::kDiagnosticHostId, {moteus::versionQuery()});
    scan.begin(now());
    while (scan.isRunning()) {
        for (const CanFrame& frame : scan.frames(now())) {
            for (const sim::PairReply& reply : both.exchange(frame, elapsed)) {
                scan.take(*moteus::decodeReply(reply.frame));
            }
        }
        elapsed += kChangeTick;
    }
    EXPECT_EQ(scan.controllers().size(), 2u);
}

}  // namespace
}  // namespace boresight::drive_check
