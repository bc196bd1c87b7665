// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/can/bus_frame.h"

#include "core/base/text.h"

#include <algorithm>

namespace boresight {

Result<CanFrame> readyForBus(const CanFrame& frame)
{
    if (frame.id > kMaxExtendedId) {
        return failure(ErrorCode::InvalidInput,
                       QStringLiteral("CAN identifier of more than 29 bits: %1").arg(toQString(toString(frame))));
    }
    if (frame.size > kMaxCanPayload || (!frame.flexibleData && frame.size > kMaxClassicPayload)) {
        return failure(ErrorCode::InvalidInput,
                       QStringLiteral("too many bytes for this kind of CAN frame: %1").arg(toQString(toString(frame))));
    }
    CanFrame ready = frame;
    ready.extended = frame.extended || frame.id > kMaxStandardId;
    ready.bitRateSwitch = frame.bitRateSwitch && frame.flexibleData;
    ready.size = static_cast<std::uint8_t>(legalCanLength(frame.size));
    std::fill(ready.data.begin() + frame.size, ready.data.begin() + ready.size, kPaddingByte);
    return ready;
}

}  // namespace boresight
