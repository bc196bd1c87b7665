// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/units/sky.h"

#include <QString>

#include <optional>
#include <string>
#include <string_view>

// A protocol of one command in each line of a connection. Station thread.
namespace boresight::rotctld {

// The effect of one line, or of one datagram. A result of InvalidInput: it is no command.
struct LineOutcome
{
    std::string reply;
    Result<> result;
    QString became = {};                    // the changed target, as text; empty if unchanged
    bool motion = false;                    // it requested a motion, accepted or not
    bool stop = false;                      // it requested a stop
    std::optional<SkyPointing> point = {};  // the target that it requested
};

// The line is an odd command: see ClientHabits::countOdd().
[[nodiscard]] inline bool isOdd(const LineOutcome& outcome)
{
    return !outcome.result && outcome.result.error().code == ErrorCode::InvalidInput;
}

class LineProtocol
{
public:
    virtual ~LineProtocol() = default;
    // Without its line end, never empty.
    [[nodiscard]] virtual LineOutcome obey(std::string_view line) = 0;
};

}  // namespace boresight::rotctld
