// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/orientation/orientation.h"
#include "core/orientation/refusal.h"

#include <functional>
#include <string>
#include <string_view>

// Extracts the sensor's sentences from the bytes of its serial port, however the bytes are split or joined. A '$'
// always begins a sentence, because the firmware may lose the end of the previous one. CR, LF or the next '$' ends a
// sentence. Start-up text, line noise and sentences of other devices are counted and skipped. Holds at most one
// sentence; pure.
namespace boresight::orientation {

// The firmware's own buffer has 88 characters. The rest is for future fields.
inline constexpr std::size_t kLongestSentence = 128;

class SentenceStream
{
public:
    // Calls `onValue` for each completed sentence, and `onRefused` with its text for each sentence that is not used.
    using OnValue = std::function<void(const Orientation&)>;
    using OnRefused = std::function<void(const Refused&, std::string_view sentence)>;
    void add(std::string_view bytes, SteadyTime arrival, const OnValue& onValue, const OnRefused& onRefused = {});

    // Drops an incomplete sentence, because after the port was opened again its end never comes. The counts stay.
    void clear();

    [[nodiscard]] const Counts& counts() const { return m_counts; }
    // The beginning of the last line that was not a sentence, if it is readable. It may show what is wrong with the
    // sensor.
    [[nodiscard]] const std::string& lastChatter() const { return m_lastChatter; }

private:
    enum class Place
    {
        Outside,  // nothing or white space since the last line end
        Chatter,  // inside a line that is not a sentence
        Sentence
    };
    void endPiece(SteadyTime arrival, const OnValue& onValue, const OnRefused& onRefused);
    void judge(const std::string& sentence, SteadyTime arrival, const OnValue& onValue, const OnRefused& onRefused);

    Place m_place = Place::Outside;
    // From its '$' or first character on. If it is too long, it is kept to one character above the limit.
    std::string m_piece;
    std::string m_lastChatter;
    Counts m_counts;
};

}  // namespace boresight::orientation
