// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/base/result.h"
#include "core/rotctl/reply_reader.h"
#include "core/serial/line_splitter.h"

#include <optional>
#include <string>
#include <string_view>

// Asks a rotctld for the position of its rotator, again and again, and nothing else. Uses the plain form, which all
// imitations know. Only one question at a time, so a late answer is never taken for the answer to a later question.
// Pure.
namespace boresight::rotctl {

class PositionPoll
{
public:
    static constexpr std::chrono::milliseconds kPeriod{250};
    // After this time without an answer the caller must connect again.
    static constexpr std::chrono::seconds kPatience{3};

    // Call it for a new connection.
    void restart();
    // The bytes to write now; often empty.
    [[nodiscard]] std::string ask(SteadyTime now);
    void take(std::string_view bytes);
    // The newest answer, once. Error NoAnswer: the rotctld reports an error. Error Refused: the server is not a
    // rotctld.
    [[nodiscard]] std::optional<Result<AxisPosition>> takeAnswer();
    [[nodiscard]] bool hangs(SteadyTime now) const { return m_reader && now - m_asked > kPatience; }

private:
    void takeLine(std::string_view line);

    LineSplitter m_splitter;
    std::optional<ReplyReader> m_reader;  // reads the answer to the open question
    std::optional<Result<AxisPosition>> m_answer;
    SteadyTime m_asked{};
    bool m_started = false;  // a question was sent on this connection
};

}  // namespace boresight::rotctl
