// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/can_frame.h"

#include <algorithm>
#include <cassert>
#include <iomanip>
#include <sstream>

namespace boresight {

void CanFrame::setPayload(std::span<const std::uint8_t> bytes)
{
    assert(bytes.size() <= kMaxCanPayload);
    const std::size_t count = std::min(bytes.size(), kMaxCanPayload);
    std::copy_n(bytes.begin(), count, data.begin());
    size = static_cast<std::uint8_t>(count);
}

bool CanFrame::operator==(const CanFrame& other) const
{
    return id == other.id && extended == other.extended && flexibleData == other.flexibleData &&
           bitRateSwitch == other.bitRateSwitch && std::ranges::equal(payload(), other.payload());
}

std::size_t legalCanLength(std::size_t size)
{
    static constexpr std::array<std::size_t, 7> kLongLengths{12, 16, 20, 24, 32, 48, 64};
    assert(size <= kMaxCanPayload);
    if (size <= 8) {
        return size;
    }
    const auto* const fit = std::ranges::lower_bound(kLongLengths, size);
    return fit == kLongLengths.end() ? kMaxCanPayload : *fit;
}

std::string toString(const CanFrame& frame)
{
    std::ostringstream text;
    text << std::hex << frame.id << std::dec << " [" << static_cast<int>(frame.size) << ']' << std::hex
         << std::setfill('0');
    for (const std::uint8_t byte : frame.payload()) {
        text << ' ' << std::setw(2) << static_cast<int>(byte);
    }
    return text.str();
}

}  // namespace boresight
