// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/orientation/sentence_stream.h"

#include "core/orientation/sentence.h"

#include <algorithm>
#include <utility>

namespace boresight::orientation {
namespace {

constexpr std::size_t kShownChatter = 60;

// True if all characters are printable ASCII, unlike the noise at a wrong baud rate.
bool isReadable(std::string_view text)
{
    return std::ranges::all_of(text, [](char character) { return character >= ' ' && character < '\x7f'; });
}

}  // namespace

void SentenceStream::add(std::string_view bytes, SteadyTime arrival, const OnValue& onValue, const OnRefused& onRefused)
{
    for (const char character : bytes) {
        if (character == '$' || character == '\r' || character == '\n') {
            endPiece(arrival, onValue, onRefused);
            m_place = character == '$' ? Place::Sentence : Place::Outside;
        } else if (m_place == Place::Outside) {
            m_place = Place::Chatter;
        }
        if (m_place != Place::Outside && m_piece.size() <= kLongestSentence) {
            m_piece += character;
        }
    }
}

void SentenceStream::clear()
{
    m_place = Place::Outside;
    m_piece.clear();
}

void SentenceStream::endPiece(SteadyTime arrival, const OnValue& onValue, const OnRefused& onRefused)
{
    // Taken out first, because the receiver may close the port and clear() this stream.
    const std::string piece = std::exchange(m_piece, {});
    if (m_place == Place::Chatter) {
        ++m_counts.chatter;
        m_lastChatter = isReadable(piece) ? piece.substr(0, kShownChatter) : std::string();
    } else if (m_place == Place::Sentence) {
        judge(piece, arrival, onValue, onRefused);
    }
}

void SentenceStream::judge(const std::string& sentence, SteadyTime arrival, const OnValue& onValue,
                           const OnRefused& onRefused)
{
    if (!isOurs(sentence)) {
        ++m_counts.foreign;
        return;
    }
    const auto value =
        sentence.size() > kLongestSentence ? refused(Refusal::TooLong) : parseSentence(sentence, arrival);
    if (value) {
        ++m_counts.accepted;
        m_counts.lowerCaseChecksum += hasLowerCaseChecksum(sentence) ? 1 : 0;
        onValue(*value);
        return;
    }
    m_counts.count(value.error().reason);
    if (onRefused) {
        onRefused(value.error(), sentence);
    }
}

}  // namespace boresight::orientation
