// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/rotator_box/rotator_talk.h"

#include "core/base/control_characters.h"
#include "core/base/text.h"

namespace boresight {

Result<> RotatorTalk::mayType(std::string_view line) const
{
    constexpr std::size_t kLongest = 64;  // no command of such a box is longer
    const bool isAscii = std::ranges::all_of(line, [](char one) { return static_cast<unsigned char>(one) < 0x80; });
    if (!takesLines()) {
        return failure(ErrorCode::NotAvailable, Text::tr("this rotator does not have this function"));
    }
    if (line.find_first_not_of(' ') == std::string_view::npos || line.size() > kLongest || !isAscii ||
        hasControlCharacters(line)) {
        return failure(ErrorCode::InvalidInput,
                       Text::tr("A line has 1 to %1 letters without accents, digits and signs.").arg(kLongest));
    }
    return {};
}

}  // namespace boresight
