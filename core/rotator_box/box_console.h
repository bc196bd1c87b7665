// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/base/result.h"
#include "core/rotator_box/rotator_talk.h"

#include <QStringList>

#include <optional>
#include <string>
#include <string_view>

// A line that the operator types to the control box, and what the box answers. One line at a time: it waits until it
// can be sent. Then all bytes count as its answer for a while. Pure: time and bytes are passed in.
namespace boresight {

class BoxConsole
{
public:
    // Shorter than the silence of every such driver, because nothing is asked meanwhile.
    static constexpr std::chrono::milliseconds kListens{800};
    static constexpr std::size_t kLongestAnswer = 2000;  // bytes; the help of a box is shorter
    static constexpr int kKept = 100;                    // lines

    // Whether another line may be typed to this device now, otherwise the reason.
    [[nodiscard]] Result<> admits(const RotatorTalk& talk, bool answers) const;
    void type(std::string line) { m_waiting = std::move(line); }
    // The bytes of a line that can be sent now. Usually empty.
    [[nodiscard]] std::string send(RotatorTalk& talk, SteadyTime now);
    void take(std::string_view bytes);
    // True once, when the time for the answer is over.
    [[nodiscard]] bool ends(SteadyTime now);
    // The connection was closed. An answer does not come any more.
    void drop();

    // A line waits, or its answer is awaited.
    [[nodiscard]] bool isBusy() const { return !m_waiting.empty() || m_until.has_value(); }
    // Each typed line after "> ", followed by its answer. The oldest first.
    [[nodiscard]] const QStringList& lines() const { return m_lines; }
    // The last answer in one line, once.
    [[nodiscard]] std::optional<QString> takeAnswer();

private:
    void show(const QString& line);

    std::string m_waiting;
    std::string m_heard;
    std::optional<SteadyTime> m_until;
    std::optional<QString> m_answer;
    QStringList m_lines;
};

}  // namespace boresight
