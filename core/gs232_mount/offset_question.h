// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/gs232/esp32_offsets.h"
#include "core/gs232/esp32_reply.h"

#include <optional>
#include <string_view>

// When the ESP32 relay controller is asked for the offsets of its sensor, and which answer is believed. The box sends
// random numbers unless its sensor is fully calibrated. So an answer counts only between two reports whose digits are
// all 3. Pure: time and lines are passed in.
namespace boresight::gs232 {

class OffsetQuestion
{
public:
    static constexpr std::chrono::seconds kBetweenAsks{3};
    static constexpr std::chrono::milliseconds kAnswerTime{400};

    // The offsets may have changed: the box started, or the operator typed a line.
    void askAgain();
    // `digits`: of the last report, if it is not old.
    [[nodiscard]] bool wants(const std::optional<esp32::Digits>& digits, SteadyTime now) const;
    void asked(SteadyTime now);
    // False if the line is no part of such an answer.
    bool take(std::string_view line, SteadyTime now);
    void take(const esp32::Digits& digits);

    // The last offsets that are believed.
    [[nodiscard]] const std::optional<esp32::Offsets>& known() const { return m_known; }

private:
    bool m_wanted = true;
    std::optional<SteadyTime> m_asked;
    esp32::OffsetLines m_lines;
    std::optional<esp32::Offsets> m_doubtful;  // no report came since
    std::optional<esp32::Offsets> m_known;
};

}  // namespace boresight::gs232
