// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/moteus_mount/third_drive.h"

#include "core/moteus/subframes.h"
#include "tests/fakes/ideal_drive.h"
#include "tests/fakes/manual_clock.h"

#include <gtest/gtest.h>

namespace boresight {
namespace {

constexpr std::uint8_t kThirdId = 3;

profile::Profile withThirdAxis()
{
    profile::Profile profile;
    profile.thirdAxis.axis.id = kThirdId;
    profile.thirdAxis.axis.maxTorque = 0.5;
    return profile;
}

std::string hex(const CanFrame& frame)
{
    QByteArray bytes;
    for (std::size_t i = 0; i < frame.size; ++i) {
        bytes += static_cast<char>(frame.data[i]);
    }
    return bytes.toHex().toStdString();
}

struct ThirdDriveTest : ::testing::Test
{
    void tick()
    {
        clock.advance(Seconds(0.02));
        drive.observe(clock.now());
        frames = drive.frames();
        drive.framesTaken();
        answer();
    }
    void answer()
    {
        for (const CanFrame& frame : frames) {
            const auto to = moteus::fromCanId(frame.id);
            const auto reply = to.source == kVersionHost ? std::optional(version()) : board.answer(frame, clock.now());
            if (reply) {
                drive.take(*reply);
            }
        }
    }
    [[nodiscard]] CanFrame version() const
    {
        moteus::SubframeWriter writer;
        writer.appendReplies(std::vector<moteus::RegisterValue>{
            {moteus::Register::RegisterMapVersion, moteus::Resolution::Int32, moteus::kRegisterMapVersion}});
        CanFrame reply =
            moteus::makeFrame({.replyWanted = false, .source = kThirdId, .destination = kVersionHost}, writer.bytes());
        reply.received = clock.now();
        return reply;
    }

    static constexpr std::uint8_t kVersionHost = 0x12;
    fakes::ManualClock clock;
    EventLog log{clock};
    AlarmBoard alarms{log, clock};
    profile::InForce inForce{withThirdAxis()};
    ThirdDrive drive{inForce, alarms};
    fakes::IdealDrive board{kThirdId, 0.0};
    std::vector<CanFrame> frames;
};

// REQ-THIRD-01: Until the operator jogs it, the board of the third axis gets only queries.
TEST_F(ThirdDriveTest, ListensFirst)
{
    tick();
    ASSERT_EQ(frames.size(), 1U);
    EXPECT_EQ(frames[0].id, 0x8003U) << "from 0 to 3, reply wanted";
    EXPECT_EQ(
        hex(frames[0]),
        "11001f01160415071e38114014060a50");  // reads: mode, position…torque, currents, power, control, echo, rest
    tick();
    ASSERT_EQ(frames.size(), 2U);
    EXPECT_EQ(frames[1].id, 0x9203U) << "from 0x12 to 3: a reply that is not taken for one to a command";
    EXPECT_EQ(hex(frames[1]), "1b8002");  // reads three i32 from 0x100: model, firmware, register map
    EXPECT_TRUE(board.seen.empty());
}

// REQ-THIRD-02: Each frame that holds or moves the third axis has the watchdog time, the torque and the limits of the
// profile.
TEST_F(ThirdDriveTest, EachCommandHasTheWatchdogTime)
{
    for (int i = 0; i < 10; ++i) {
        tick();
    }
    const Result<> fit = drive.fit();
    ASSERT_TRUE(fit) << fit.error().text.toStdString();
    drive.engage();
    std::optional<Angle> place;
    for (int i = 0; i < 20 && !place; ++i) {
        tick();
        place = drive.takeFollowing();
    }
    ASSERT_TRUE(place);
    for (int i = 0; i < 20; ++i) {
        clock.advance(Seconds(0.02));
        drive.observe(clock.now());
        drive.command({.position = *place + Angle::fromDegrees(0.1 * i), .rate = 5_deg_s});
        frames = drive.frames();
        answer();
    }
    EXPECT_EQ(hex(frames.front()),
              "01000a"                          // mode: position
              "0e2035f1ac3b398e633c"            // position 1.9°, velocity 5°/s
              "0d250000003f"                    // maximum torque 0.5 Nm
              "0f27cdcccc3dabaaaa3cabaa2a3d"    // watchdog 0.1 s, limits 7.5°/s and 15°/s²
              "014007"                          // the number of the tick
              "11001f01160415071e38114014060a"  // the query
              "50505050505050505050505050");    // padding
    ASSERT_FALSE(board.seen.empty());
    for (const fakes::IdealDrive::Seen& one : board.seen) {
        ASSERT_EQ(one.mode, moteus::Mode::Position);
        EXPECT_NEAR(one.fields.at(moteus::Register::CommandWatchdogTimeout), 0.1, 1e-6);
        EXPECT_NEAR(one.fields.at(moteus::Register::CommandMaximumTorque), 0.5, 1e-6);
    }
    EXPECT_NEAR(board.position, place->turns() + 1.9 / 360.0, 0.5 / 360.0);
}

}  // namespace
}  // namespace boresight
