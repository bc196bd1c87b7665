// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/can/socketcan_frame.h"

#include <gtest/gtest.h>
#include <linux/can/error.h>

#include <algorithm>
#include <vector>

namespace boresight::socketcan {
namespace {

CanFrame frameOf(std::uint32_t id, std::size_t size)
{
    CanFrame frame;
    frame.id = id;
    frame.setPayload(std::vector<std::uint8_t>(size, 0x11));
    return frame;
}

// REQ-CAN-01 (SocketCanFrame.*): Frames reach the wire as CAN-FD with bit-rate switch, extended identifier above
// 0x7FF, padded with 0x50.
TEST(SocketCanFrame, RequestIsExtendedFdWithBitRateSwitchPaddedWithNop)
{
    const RawFrame raw = toRaw(frameOf(0x8001, 9)).value();
    EXPECT_EQ(raw.size, CANFD_MTU);
    EXPECT_EQ(raw.frame.can_id, 0x8001U | CAN_EFF_FLAG);
    EXPECT_EQ(raw.frame.len, 12);
    EXPECT_EQ(raw.frame.data[8], 0x11);
    EXPECT_EQ(raw.frame.data[9], 0x50);
    EXPECT_EQ(raw.frame.data[11], 0x50);
    EXPECT_EQ(raw.frame.data[12], 0x00);
    EXPECT_NE(raw.frame.flags & CANFD_BRS, 0);
}

TEST(SocketCanFrame, ShortIdentifiersAreStandardUnlessTheFrameSaysOtherwise)
{
    CanFrame frame = frameOf(0x7ff, 1);
    EXPECT_EQ(toRaw(frame)->frame.can_id, 0x7ffU);
    frame.extended = true;
    EXPECT_EQ(toRaw(frame)->frame.can_id, 0x7ffU | CAN_EFF_FLAG);
    EXPECT_EQ(toRaw(frameOf(0x800, 1))->frame.can_id, 0x800U | CAN_EFF_FLAG);
}

TEST(SocketCanFrame, ClassicFrameIsSixteenBytesWithoutFlags)
{
    CanFrame frame = frameOf(0x101, 3);
    frame.flexibleData = false;
    const RawFrame raw = toRaw(frame).value();
    EXPECT_EQ(raw.size, CAN_MTU);
    EXPECT_EQ(raw.frame.flags, 0);
    EXPECT_EQ(raw.frame.len, 3);
}

TEST(SocketCanFrame, RefusesWhatNoBusCanCarry)
{
    EXPECT_EQ(toRaw(frameOf(0x20000000, 1)).error().code, ErrorCode::InvalidInput);
    CanFrame classic = frameOf(0x101, 9);
    classic.flexibleData = false;
    EXPECT_EQ(toRaw(classic).error().code, ErrorCode::InvalidInput);
}

TEST(SocketCanFrame, EveryLegalFrameComesBackTheSame)
{
    for (const std::uint32_t id : {0x0U, 0x100U, 0x7ffU, 0x800U, 0x8001U, 0x1fffffffU}) {
        for (const std::size_t size : {0U, 1U, 8U, 12U, 20U, 64U}) {
            for (const bool bitRateSwitch : {false, true}) {
                CanFrame frame = frameOf(id, size);
                frame.extended = id > kMaxStandardId;
                frame.bitRateSwitch = bitRateSwitch;
                EXPECT_EQ(fromRaw(toRaw(frame).value()), frame) << toString(frame);
            }
        }
    }
}

TEST(SocketCanFrame, OddSizesRemoteAndErrorFramesAreNoFrames)
{
    RawFrame raw = toRaw(frameOf(0x100, 8)).value();
    raw.size = CANFD_MTU - 1;
    EXPECT_EQ(fromRaw(raw), std::nullopt);
    raw.size = 0;
    EXPECT_EQ(fromRaw(raw), std::nullopt);
    raw.size = CAN_MTU;
    EXPECT_NE(fromRaw(raw), std::nullopt);
    raw.frame.len = 9;
    EXPECT_EQ(fromRaw(raw), std::nullopt);
    raw.frame.len = 8;
    raw.frame.can_id |= CAN_RTR_FLAG;
    EXPECT_EQ(fromRaw(raw), std::nullopt);
    EXPECT_FALSE(isErrorFrame(raw));
    raw.frame.can_id = CAN_ERR_FLAG | CAN_ERR_BUSOFF;
    EXPECT_EQ(fromRaw(raw), std::nullopt);
    EXPECT_TRUE(isErrorFrame(raw));
}

ErrorReport reportOf(canid_t errorClass, std::uint8_t controller = 0)
{
    RawFrame raw;
    raw.size = CAN_MTU;
    raw.frame.can_id = CAN_ERR_FLAG | errorClass;
    raw.frame.len = CAN_ERR_DLC;
    raw.frame.data[1] = controller;
    return readErrorFrame(raw);
}

// REQ-CAN-11: Bus-off, error-passive, missing acknowledge and damaged frames are distinguished, each with its remedy. A
// bus-off from before the program started is detected, too.
TEST(SocketCanFrame, ErrorFramesAreToldApart)
{
    EXPECT_EQ(reportOf(CAN_ERR_BUSOFF), ErrorReport{.busOff = true});
    EXPECT_EQ(reportOf(CAN_ERR_RESTARTED), ErrorReport{.restarted = true});
    EXPECT_EQ(reportOf(CAN_ERR_ACK), ErrorReport{.noAcknowledge = true});
    EXPECT_EQ(reportOf(CAN_ERR_CRTL, CAN_ERR_CRTL_TX_PASSIVE), ErrorReport{.errorPassive = true});
    EXPECT_EQ(reportOf(CAN_ERR_CRTL, CAN_ERR_CRTL_TX_PASSIVE | CAN_ERR_CRTL_RX_WARNING),
              ErrorReport{.errorPassive = true});
    EXPECT_EQ(reportOf(CAN_ERR_CRTL, 0x40), ErrorReport{.errorActive = true});
    EXPECT_EQ(reportOf(CAN_ERR_CRTL, CAN_ERR_CRTL_TX_WARNING), ErrorReport{.errorActive = true});
    EXPECT_EQ(reportOf(CAN_ERR_CRTL, CAN_ERR_CRTL_RX_OVERFLOW), ErrorReport{.receiveOverflow = true});
    EXPECT_EQ(reportOf(CAN_ERR_PROT), ErrorReport{.busError = true});
    // data[1] counts only for the class CRTL
    EXPECT_EQ(reportOf(CAN_ERR_BUSERROR, 0xff), ErrorReport{.busError = true});
}

}  // namespace
}  // namespace boresight::socketcan
