// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/gs232_mount/box_talk.h"

#include "core/base/text.h"
#include "core/gs232/box_command.h"
#include "core/gs232/esp32_reply.h"
#include "core/gs232_mount/strange_text.h"
#include "core/gs232_mount/typed_motion.h"

#include <algorithm>
#include <utility>
#include <variant>

namespace boresight::gs232 {
namespace {

constexpr std::size_t kBitsOfAByte = 10;    // 8N1
constexpr std::size_t kLongestAnswer = 20;  // bytes, with those before the answer

// A break of the line is received as NUL.
std::string withoutNulls(std::string_view bytes)
{
    std::string text(bytes);
    std::erase(text, '\0');
    return text;
}

}  // namespace

void BoxTalk::restart()
{
    const bool stop = m_stop;
    *this = BoxTalk(m_question, m_baud);
    m_stop = stop;
}

void BoxTalk::take(std::string_view bytes, SteadyTime now)
{
    if (m_proof == Proof::Foreign) {
        return;
    }
    const std::string text = withoutNulls(bytes);
    // A radio may never send a line end.
    const bool ends = text.find_first_of("\r\n") != std::string::npos;
    if (m_proof == Proof::Unknown && !ends && !text.empty()) {
        takePiece(text, now);
    }
    m_splitter.add(text, [this, now](std::string_view line) { takeLine(line, now); });
}

// A part of a refusal is no strange data.
void BoxTalk::takePiece(std::string_view text, SteadyTime now)
{
    const Reply piece = parseReply(text);
    m_refuses = m_refuses || std::holds_alternative<Refused>(piece);
    if (!std::holds_alternative<Refused>(piece) && !std::holds_alternative<Nothing>(piece)) {
        takeStrange(text, now);
    }
}

void BoxTalk::takeLine(std::string_view line, SteadyTime now)
{
    if (m_proof == Proof::Unknown && esp32::isLineOfEsp32(line)) {
        m_speaksWords = true;
        return;
    }
    const Reply reply = parseReply(line);
    const auto* const position = std::get_if<Position>(&reply);
    if (position != nullptr && isWhole(*position)) {
        m_proof = Proof::Box;
        m_dialect = position->dialect;
        m_places = Places{.azimuth = position->azimuth, .elevation = position->elevation};
        m_echoes = m_refuses = false;
        m_strange = {};
        m_times.asked.reset();
        ++m_counts.received;
        return;
    }
    m_echoes = m_echoes || std::holds_alternative<Echo>(reply);
    if (std::holds_alternative<Refused>(reply)) {
        m_refuses = true;
        m_times.asked.reset();
    } else if (position != nullptr || std::holds_alternative<Unknown>(reply)) {
        ++m_counts.unknown;
        takeStrange(line, now);
    }
}

void BoxTalk::takeStrange(std::string_view bytes, SteadyTime now)
{
    if (m_strange.first && now - m_strange.last > kNoise) {
        m_strange = {};
    }
    m_strange.text = shownOfStrange(bytes);
    m_strange.first = m_strange.first.value_or(now);
    m_strange.last = now;
    m_strange.questions += std::exchange(m_strange.sinceAsked, true) ? 0 : 1;
}

// Declares the port foreign if enough questions had strange answers for long enough. By then all pieces have become
// lines.
void BoxTalk::judge(SteadyTime now)
{
    const bool often = m_strange.first && m_strange.questions >= kProbeQuestions;
    if (m_proof == Proof::Unknown && often && now - *m_strange.first >= kProbeTime) {
        m_proof = Proof::Foreign;
        m_go.clear();
        m_stop = false;
    }
}

bool BoxTalk::isWhole(const Position& position) const
{
    return position.azimuth && (m_question == Question::Azimuth || position.elevation);
}

std::optional<RotatorTalk::Places> BoxTalk::takePlaces()
{
    return std::exchange(m_places, std::nullopt);
}

void BoxTalk::stop()
{
    m_go.clear();
    m_stop = true;
}

SteadyTime::duration BoxTalk::timeOf(std::size_t bytes) const
{
    return std::chrono::round<SteadyTime::duration>(
        Seconds(static_cast<double>(bytes * kBitsOfAByte) / static_cast<double>(m_baud)));
}

std::string BoxTalk::say(std::string command, SteadyTime now)
{
    m_times.free = now + kPause + timeOf(command.size());
    ++m_counts.sent;
    return command;
}

Result<> BoxTalk::mayType(std::string_view line) const
{
    switch (effectOfTyped(line)) {
        case TypedEffect::Moves:
            return refusalOfMotion();
        case TypedEffect::AsksBack:
            return failure(ErrorCode::Refused,
                           Text::tr("After this line the box waits for an answer, and takes the questions of Boresight "
                                    "for it. Close Boresight, and send this line with a terminal program."));
        case TypedEffect::None:
            break;
    }
    return RotatorTalk::mayType(line);
}

std::string BoxTalk::type(std::string_view line, SteadyTime::duration pause, SteadyTime now)
{
    if (m_stop || mustWait(now)) {
        return {};
    }
    m_go.clear();
    m_places.reset();
    m_splitter.clear();
    std::string bytes = say(std::string(line) + '\r', now);
    m_times.free = now + pause;
    return bytes;
}

// An answer is awaited, or the pause after the last command has not ended.
bool BoxTalk::mustWait(SteadyTime now) const
{
    const bool isAsked = m_times.asked && now - *m_times.asked < kAnswerTime + timeOf(kAskBoth.size() + kLongestAnswer);
    return now < m_times.free || isAsked;
}

std::string BoxTalk::send(SteadyTime now)
{
    judge(now);
    if (m_proof != Proof::Box) {
        m_go.clear();
    }
    if (m_proof == Proof::Foreign) {
        return {};
    }
    if (m_proof == Proof::Box && std::exchange(m_stop, false)) {  // otherwise it waits for the proof
        return say(std::string(kStopAll), now);
    }
    if (mustWait(now)) {
        return {};
    }
    if (!m_go.empty() && (!m_times.lastGo || now - *m_times.lastGo >= kBetweenGoes)) {
        m_times.lastGo = now;
        return say(std::exchange(m_go, {}), now);
    }
    const auto pause = m_proof == Proof::Box ? kBetweenAsks : kBetweenTries;
    if (m_times.lastAsk && now - *m_times.lastAsk < pause) {
        return {};
    }
    m_times.lastAsk = m_times.asked = now;
    m_strange.sinceAsked = false;
    m_splitter.clear();  // half a line would damage the answer
    return say(std::string(m_question == Question::Both ? kAskBoth : kAskAzimuth), now);
}

}  // namespace boresight::gs232
