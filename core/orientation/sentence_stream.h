// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/orientation/orientation.h"
#include "core/orientation/refusal.h"

#include <functional>
#include <string>
#include <string_view>

// The sensor's sentences out of the bytes of its serial port, however these are split or joined on their way. A '$'
// begins a sentence, wherever it stands: the firmware may lose the end of one. CR, LF or the next '$' ends it. Start-up
// text, line noise and the sentences of others are counted and passed over. Holds at most one sentence; pure.
namespace boresight::orientation {

// The firmware's own buffer has 88; the rest is for fields to come.
inline constexpr std::size_t kLongestSentence = 128;

class SentenceStream
{
public:
    // Calls `onValue` for each sentence that is now complete; `onRefused` with its text for each that is not used.
    using OnValue = std::function<void(const Orientation&)>;
    using OnRefused = std::function<void(const Refused&, std::string_view sentence)>;
    void add(std::string_view bytes, SteadyTime arrival, const OnValue& onValue, const OnRefused& onRefused = {});

    // Forgets half a sentence: after a re-open it belongs to nothing. The counts stay.
    void clear();

    [[nodiscard]] const Counts& counts() const { return m_counts; }
    // The beginning of the last line that was no sentence, if it can be read: it may tell what ails the sensor.
    [[nodiscard]] const std::string& lastChatter() const { return m_lastChatter; }

private:
    enum class Place
    {
        Outside,  // nothing, or white space, since the last line's end
        Chatter,  // in a line that is no sentence
        Sentence
    };
    void endPiece(SteadyTime arrival, const OnValue& onValue, const OnRefused& onRefused);
    void judge(const std::string& sentence, SteadyTime arrival, const OnValue& onValue, const OnRefused& onRefused);

    Place m_place = Place::Outside;
    // From its '$' on, or its first character; one character longer than allowed if it is too long.
    std::string m_piece;
    std::string m_lastChatter;
    Counts m_counts;
};

}  // namespace boresight::orientation
