// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/can/socketcan_frame.h"

#include "core/can/bus_frame.h"

#include <linux/can/error.h>

#include <algorithm>

namespace boresight::socketcan {
namespace {

// CANFD_FDF of Linux 5.14; older kernels ignore it.
constexpr std::uint8_t kFlexibleDataFlag = 0x04;
// CAN_ERR_CRTL_ACTIVE, and the two warning levels. They are cleared when the controller gets worse.
constexpr std::uint8_t kControllerWell = 0x40 | CAN_ERR_CRTL_RX_WARNING | CAN_ERR_CRTL_TX_WARNING;
constexpr std::uint8_t kControllerPassive = CAN_ERR_CRTL_RX_PASSIVE | CAN_ERR_CRTL_TX_PASSIVE;

}  // namespace

Result<RawFrame> toRaw(const CanFrame& frame)
{
    const Result<CanFrame> ready = readyForBus(frame);
    if (!ready) {
        return tl::unexpected(ready.error());
    }
    RawFrame raw;
    raw.size = ready->flexibleData ? CANFD_MTU : CAN_MTU;
    raw.frame.can_id = ready->id | (ready->extended ? CAN_EFF_FLAG : 0U);
    raw.frame.len = ready->size;
    if (ready->flexibleData) {
        raw.frame.flags = static_cast<std::uint8_t>(kFlexibleDataFlag | (ready->bitRateSwitch ? CANFD_BRS : 0));
    }
    std::ranges::copy(ready->payload(), raw.frame.data);
    return raw;
}

std::optional<CanFrame> fromRaw(const RawFrame& raw)
{
    const bool flexibleData = raw.size == CANFD_MTU;
    const std::size_t maxPayload = flexibleData ? kMaxCanPayload : kMaxClassicPayload;
    const bool wholeFrame = flexibleData || raw.size == CAN_MTU;
    if (!wholeFrame || (raw.frame.can_id & (CAN_ERR_FLAG | CAN_RTR_FLAG)) != 0 || raw.frame.len > maxPayload) {
        return std::nullopt;
    }
    CanFrame frame;
    frame.extended = (raw.frame.can_id & CAN_EFF_FLAG) != 0;
    frame.id = raw.frame.can_id & (frame.extended ? CAN_EFF_MASK : CAN_SFF_MASK);
    frame.flexibleData = flexibleData;
    frame.bitRateSwitch = flexibleData && (raw.frame.flags & CANFD_BRS) != 0;
    frame.setPayload({raw.frame.data, raw.frame.len});
    return frame;
}

bool isErrorFrame(const RawFrame& raw)
{
    return (raw.frame.can_id & CAN_ERR_FLAG) != 0;
}

ErrorReport readErrorFrame(const RawFrame& raw)
{
    const auto has = [&raw](canid_t errorClass) { return (raw.frame.can_id & errorClass) != 0; };
    const std::uint8_t controller = has(CAN_ERR_CRTL) ? raw.frame.data[1] : std::uint8_t{0};
    const bool passive = (controller & kControllerPassive) != 0;
    return {
        .busOff = has(CAN_ERR_BUSOFF),
        .restarted = has(CAN_ERR_RESTARTED),
        .errorPassive = passive,
        .errorActive = !passive && (controller & kControllerWell) != 0,
        .noAcknowledge = has(CAN_ERR_ACK) || (has(CAN_ERR_PROT) && raw.frame.data[3] == CAN_ERR_PROT_LOC_ACK),
        .busError = has(CAN_ERR_PROT) || has(CAN_ERR_BUSERROR),
        .receiveOverflow = (controller & CAN_ERR_CRTL_RX_OVERFLOW) != 0,
    };
}

}  // namespace boresight::socketcan
