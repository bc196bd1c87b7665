// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/rotctld_mount/rotctld_talk.h"

#include "core/base/control_characters.h"
#include "core/rotctl/rotctl_command.h"
#include "core/rotctl/rotctl_error.h"

#include <algorithm>
#include <utility>

namespace boresight::rotctl {
namespace {

constexpr std::size_t kShownOfStrange = 24;  // bytes

std::string shown(std::string_view bytes)
{
    std::string text = printable(std::string(bytes.substr(0, kShownOfStrange)));
    std::ranges::replace_if(
        text, [](char one) { return static_cast<unsigned char>(one) >= 0x80; }, '?');
    return text;
}

}  // namespace

void RotctldTalk::restart()
{
    const bool stops = m_stop.wanted || stopWaits();
    const Probe probe = m_probe;
    const bool answered = m_probeAnswered;
    *this = RotctldTalk();
    m_stop.wanted = stops;
    m_probe = probe;
    m_probeAnswered = answered;
}

Form RotctldTalk::form() const
{
    return m_probe == Probe::ExtendedState ? Form::Extended : Form::Plain;
}

void RotctldTalk::nextProbe()
{
    if (m_probeAnswered) {
        return;  // this server hangs, but its form is known
    }
    m_probe = m_probe == Probe::ExtendedState ? Probe::PlainState
              : m_probe == Probe::PlainState  ? Probe::PlainPosition
                                              : Probe::ExtendedState;
}

void RotctldTalk::take(std::string_view bytes, SteadyTime now)
{
    if (m_proof == Proof::Foreign || bytes.empty()) {
        return;
    }
    const std::size_t end = bytes.find_last_of("\r\n");
    m_line.rest = end == std::string_view::npos ? m_line.rest : std::string();
    m_line.rest += bytes.substr(end == std::string_view::npos ? 0 : end + 1, kShownOfStrange);
    m_line.rest.resize(std::min(m_line.rest.size(), kShownOfStrange));
    m_line.splitter.add(bytes, [this, now](std::string_view line) { takeLine(line, now); });
}

void RotctldTalk::takeLine(std::string_view line, SteadyTime now)
{
    if (m_proof == Proof::Foreign) {
        return;
    }
    if (m_waiting.empty()) {
        if (isReport(line)) {
            ++m_counts.unknown;  // some imitations end every answer with RPRT, or refuse each half of a command
        } else {
            takeStrange(line);
        }
        return;
    }
    if (m_waiting.front().spoiled) {
        if (isReport(line)) {
            leaveOut(now);
        }
        return;
    }
    switch (m_waiting.front().reader.take(line)) {
        case ReplyReader::Progress::More:
            break;
        case ReplyReader::Progress::Whole: {
            const Pending pending = m_waiting.front();
            m_waiting.pop_front();
            ++m_counts.received;
            finish(pending, pending.reader.reply(), now);
            break;
        }
        case ReplyReader::Progress::Strange:
            m_waiting.front().spoiled = true;
            takeStrange(line);
            if (isReport(line)) {
                leaveOut(now);
            }
            break;
    }
}

// Drops the oldest question: its answer is not known.
void RotctldTalk::leaveOut(SteadyTime now)
{
    const Pending pending = m_waiting.front();
    m_waiting.pop_front();
    if (pending.stops) {
        m_stop.wanted = true;
        m_stop.from = now + kBetweenStops;
    } else if (pending.question == Question::Order && !m_order.next) {
        m_order.next = m_order.last;
    } else if (pending.question == Question::Reset) {
        m_home.answer = Result<>{};  // it may have begun, so it is watched
    }
}

bool RotctldTalk::stopWaits() const
{
    return std::ranges::any_of(m_waiting, &Pending::stops);
}

// From a server that has not answered yet, a strange line is proof enough: a rotctld sends nothing without a question.
void RotctldTalk::takeStrange(std::string_view line)
{
    ++m_counts.unknown;
    m_strange = shown(line);
    if (m_proof == Proof::Unknown) {
        m_proof = Proof::Foreign;
        m_order = {};
        m_stop = {};
    } else if (form() == Form::Plain) {
        m_wantsLine = true;  // nothing shows which answer belongs to which question
    }
}

void RotctldTalk::finish(const Pending& pending, const Reply& reply, SteadyTime now)
{
    switch (pending.question) {
        case Question::State:
            m_state = reply.state;
            if (reply.state) {
                m_proof = Proof::Box;
                m_probeAnswered = true;
            } else {
                nextProbe();  // it can refuse, but does not know this question
            }
            break;
        case Question::Position:
            m_positionError = reply.code;
            if (reply.position) {
                m_proof = Proof::Box;
                m_probeAnswered = true;
                m_places = Places{.azimuth = reply.position->azimuth, .elevation = reply.position->elevation};
            }
            break;
        case Question::Order:
        case Question::Stop:
            finishOrder(pending.stops, reply.code, now);
            break;
        case Question::Reset:
            m_home.answer =
                reply.code < 0 ? Result<>(failure(ErrorCode::Refused, errorInWords(reply.code))) : Result<>{};
            break;
    }
}

void RotctldTalk::finishOrder(bool stops, int code, SteadyTime now)
{
    if (stops) {
        if (code < 0) {
            m_stop.wanted = true;
            m_stop.from = isUnavailable(code) && !m_stop.unavailable ? now : now + kBetweenStops;
            m_stop.unavailable = m_stop.unavailable || isUnavailable(code);
        }
        return;
    }
    m_order.error = code;
    m_order.refusals = code < 0 ? m_order.refusals + 1 : 0;
    if (code < 0 && !m_order.next) {
        m_order.next = m_order.last;
    }
}

std::optional<RotatorTalk::Places> RotctldTalk::takePlaces()
{
    return std::exchange(m_places, std::nullopt);
}

bool RotctldTalk::go(const AxisPosition& target)
{
    const bool possible = goTo(form(), target).has_value();
    m_order.next = possible ? std::optional(target) : std::nullopt;
    return possible;
}

void RotctldTalk::stop()
{
    m_order = {.next = {}, .last = {}, .sent = m_order.sent};
    m_stop.wanted = true;
    m_stop.from = {};
    m_home = {};
}

// An older target would turn the rotator back.
void RotctldTalk::home()
{
    m_order = {.next = {}, .last = {}, .sent = m_order.sent};
    m_home = {.wanted = true, .answer = {}};
}

std::string RotctldTalk::say(Question question, std::string command, SteadyTime now, bool stops)
{
    if (m_waiting.empty()) {
        m_line.splitter.clear();  // half a line would damage the answer
        m_line.rest.clear();
    }
    m_waiting.push_back({.question = question, .sent = now, .reader = ReplyReader(question, form()), .stops = stops});
    ++m_counts.sent;
    return command;
}

std::string RotctldTalk::probe(SteadyTime now)
{
    m_order = {};
    if (m_waiting.empty()) {
        if (m_asked && now - *m_asked < kBetweenTries) {
            return {};
        }
        m_asked = now;
        return m_probe == Probe::PlainPosition ? say(Question::Position, askPosition(form()), now)
                                               : say(Question::State, askState(form()), now);
    }
    if (now - m_waiting.front().sent >= kProbeTime && !m_wantsLine) {
        if (!m_line.rest.empty()) {
            takeStrange(m_line.rest);  // a binary protocol may never send a line end
            return {};
        }
        nextProbe();
        m_wantsLine = true;
    }
    return {};
}

std::string RotctldTalk::sendStop(SteadyTime now)
{
    m_stop.wanted = false;
    const auto overwritten = m_stop.unavailable && m_stop.place ? goTo(form(), *m_stop.place) : std::nullopt;
    return overwritten ? say(Question::Order, *overwritten, now, true)
                       : say(Question::Stop, stopAll(form()), now, true);
}

std::string RotctldTalk::send(SteadyTime now)
{
    if (m_proof == Proof::Foreign) {
        return {};
    }
    if (m_proof == Proof::Unknown) {
        return probe(now);
    }
    if (m_stop.wanted && !stopWaits() && now >= m_stop.from) {
        return sendStop(now);
    }
    if (!m_waiting.empty()) {
        m_wantsLine = m_wantsLine || now - m_waiting.front().sent >= kHangs;
        return {};
    }
    if (m_home.wanted && !m_stop.wanted) {
        m_home.wanted = false;
        return say(Question::Reset, resetAll(form()), now);
    }
    // Hamlib needs 0.8 s for a target of a slow box. A question between two targets keeps the position up to date.
    const bool mayGo = m_asked && (!m_order.sent || (now - *m_order.sent >= kBetweenGoes && *m_asked > *m_order.sent));
    if (m_order.next && !m_stop.wanted && mayGo) {
        m_order.sent = now;
        m_order.last = std::exchange(m_order.next, std::nullopt);
        return say(Question::Order, goTo(form(), *m_order.last).value_or(std::string()), now);
    }
    if (m_asked && now - *m_asked < kBetweenAsks) {
        return {};
    }
    m_asked = now;
    return say(Question::Position, askPosition(form()), now);
}

}  // namespace boresight::rotctl
