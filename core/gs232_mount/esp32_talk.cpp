// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/gs232_mount/esp32_talk.h"

#include "core/gs232/esp32_command.h"
#include "core/gs232_mount/strange_text.h"
#include "core/gs232_mount/typed_motion.h"

#include <algorithm>
#include <utility>
#include <variant>

namespace boresight::gs232 {

void Esp32Talk::restart()
{
    const bool stop = m_stop;
    *this = Esp32Talk(m_middle);
    m_stop = stop;
}

void Esp32Talk::take(std::string_view bytes, SteadyTime now)
{
    if (m_proof != Proof::Foreign) {
        m_splitter.add(bytes, [this, now](std::string_view line) { takeLine(line, now); });
    }
}

void Esp32Talk::takeLine(std::string_view line, SteadyTime now)
{
    const esp32::Reply reply = esp32::parseLine(line);
    if (const auto* const place = std::get_if<esp32::Place>(&reply); place != nullptr && m_proof == Proof::Box) {
        answered();
        takePlace(*place);
    } else if (std::holds_alternative<esp32::Version>(reply)) {
        answered();
        m_proof = Proof::Box;
        m_strange = {};
    } else if (const auto* const digits = std::get_if<esp32::Digits>(&reply)) {
        m_digits = {.value = *digits, .when = now};
        m_offsets.take(*digits);
    } else if (std::holds_alternative<esp32::Started>(reply)) {
        m_readings = 0;
        m_offsets.askAgain();
    } else if (std::holds_alternative<esp32::Debugs>(reply)) {
        answered();
    } else if (std::holds_alternative<esp32::Code>(reply) && m_proof == Proof::Box) {
        answered();
    } else if (m_proof != Proof::Box || !m_offsets.take(line, now)) {
        ++m_counts.unknown;
        takeStrange(line);
    }
}

void Esp32Talk::takePlace(const esp32::Place& place)
{
    m_readings = std::min(m_readings + 1, kReadings);
    if (m_readings < kReadings) {
        return;
    }
    m_known = place;
    m_places = Places{.azimuth = place.azimuth.nearestTo(m_middle), .elevation = place.elevation};
    if (m_untilPin > 0 && --m_untilPin == 0) {
        m_targets[index(Axis::Azimuth)] = {.next = place.azimuth, .sent = {}};
        m_targets[index(Axis::Elevation)] = {.next = place.elevation, .sent = {}};
    }
}

// Only a device that has not proved itself can be foreign.
void Esp32Talk::takeStrange(std::string_view line)
{
    m_strange.text = shownOfStrange(line);
    m_strange.questions += std::exchange(m_strange.sinceAsked, true) ? 0 : 1;
    if (m_proof == Proof::Unknown && m_strange.questions >= kProbeQuestions) {
        m_proof = Proof::Foreign;
        m_stop = false;
    }
}

void Esp32Talk::answered()
{
    ++m_counts.received;
    m_times.open = std::max(m_times.open - 1, 0);
}

std::optional<RotatorTalk::Places> Esp32Talk::takePlaces()
{
    return std::exchange(m_places, std::nullopt);
}

void Esp32Talk::go(Axis axis, Angle angle)
{
    m_untilPin = 0;
    m_targets[index(axis)].next = angle;
}

void Esp32Talk::stop()
{
    m_targets = {};
    m_stop = true;
}

std::optional<esp32::Digits> Esp32Talk::digits(SteadyTime now) const
{
    const bool isFresh = m_digits.when && now - *m_digits.when < kReportsStay;
    return isFresh ? std::optional(m_digits.value) : std::nullopt;
}

std::string Esp32Talk::say(std::string bytes, SteadyTime now, int answers)
{
    m_times.open = answers;
    m_times.said = now;
    m_counts.sent += static_cast<std::uint64_t>(answers);
    return bytes;
}

Result<> Esp32Talk::mayType(std::string_view line) const
{
    return esp32::movesWhenTyped(line) ? refusalOfMotion() : RotatorTalk::mayType(line);
}

// The line may change what the box measures. So the known position is no place to stay any more.
std::string Esp32Talk::type(std::string_view line, SteadyTime::duration pause, SteadyTime now)
{
    if (m_stop || mustWait(now)) {
        return {};
    }
    m_targets = {};
    m_untilPin = 0;
    m_known.reset();
    m_places.reset();
    m_times.free = now + pause;
    m_offsets.askAgain();
    return say(std::string(line) + '\r', now, 0);
}

// An answer is awaited, or the pause after a typed line has not ended.
bool Esp32Talk::mustWait(SteadyTime now) const
{
    return now < m_times.free || (m_times.open > 0 && now - m_times.said < kAnswerTime);
}

// One piece, because it may be the last one before the line is closed.
std::string Esp32Talk::stopAt(SteadyTime now)
{
    m_untilPin = kReadings;
    m_times.free = now;
    std::string bytes(esp32::kRelaysOff);
    if (!m_known) {
        return say(std::move(bytes), now, 2);
    }
    bytes += esp32::goTo(Axis::Azimuth, m_known->azimuth) + esp32::goTo(Axis::Elevation, m_known->elevation);
    return say(std::move(bytes), now, 4);
}

std::string Esp32Talk::nextTarget(SteadyTime now)
{
    for (const Axis axis : kAxes) {
        Target& target = m_targets[index(axis)];
        if (target.next && (!target.sent || now - *target.sent >= kBetweenGoes)) {
            target.sent = now;
            return say(esp32::goTo(axis, *std::exchange(target.next, std::nullopt)), now);
        }
    }
    return {};
}

std::string Esp32Talk::ask(std::string_view question, std::chrono::milliseconds pause, SteadyTime now)
{
    if (m_times.asked && now - *m_times.asked < pause) {
        return {};
    }
    m_times.asked = now;
    m_strange.sinceAsked = false;
    return say(std::string(question), now);
}

// The command for the reports switches them off if they are on.
bool Esp32Talk::wantsReports(SteadyTime now)
{
    const bool isTried = m_times.switched && now - *m_times.switched < kReportsStay;
    if (isTried || digits(now)) {
        return false;
    }
    m_times.switched = now;
    return true;
}

std::string Esp32Talk::send(SteadyTime now)
{
    if (m_proof == Proof::Foreign) {
        return {};
    }
    if (m_proof == Proof::Box && std::exchange(m_stop, false)) {  // otherwise it waits for the proof
        return stopAt(now);
    }
    if (mustWait(now)) {
        return {};
    }
    if (m_proof != Proof::Box) {
        m_targets = {};
        return ask(esp32::kAskVersion, kBetweenTries, now);
    }
    if (std::string target = nextTarget(now); !target.empty()) {
        return target;
    }
    const bool hurries = m_untilPin > 0 || m_readings < kReadings;
    if (!hurries && wantsReports(now)) {
        return say(std::string(esp32::kSwitchReports), now);
    }
    if (!hurries && m_offsets.wants(digits(now), now)) {
        m_offsets.asked(now);
        return say(std::string(esp32::kAskOffsets), now);
    }
    return ask(esp32::kAskPlace, hurries ? std::chrono::milliseconds(0) : kBetweenAsks, now);
}

}  // namespace boresight::gs232
