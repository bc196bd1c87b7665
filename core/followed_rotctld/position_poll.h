// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/base/result.h"
#include "core/rotctl/reply_reader.h"
#include "core/serial/line_splitter.h"

#include <optional>
#include <string>
#include <string_view>

// Asks a rotctld where its rotator is, again and again, and nothing else. In the plain form, which all imitations know.
// One question at a time: an answer that is late is never taken for the answer to a later question. Pure.
namespace boresight::rotctl {

class PositionPoll
{
public:
    static constexpr std::chrono::milliseconds kPeriod{250};
    // Then the connection has to be made anew.
    static constexpr std::chrono::seconds kPatience{3};

    // The connection is a new one.
    void restart();
    // What is to be written now; often nothing.
    [[nodiscard]] std::string ask(SteadyTime now);
    void take(std::string_view bytes);
    // The newest answer, once. NoAnswer: the rotctld reports an error. Refused: it is no rotctld.
    [[nodiscard]] std::optional<Result<AxisPosition>> takeAnswer();
    [[nodiscard]] bool hangs(SteadyTime now) const { return m_reader && now - m_asked > kPatience; }

private:
    void takeLine(std::string_view line);

    LineSplitter m_splitter;
    std::optional<ReplyReader> m_reader;  // of the question that waits
    std::optional<Result<AxisPosition>> m_answer;
    SteadyTime m_asked{};
    bool m_started = false;  // a question was asked on this connection
};

}  // namespace boresight::rotctl
