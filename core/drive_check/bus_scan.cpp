// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/drive_check/bus_scan.h"

#include <algorithm>
#include <array>
#include <utility>

namespace boresight::drive_check {
namespace {

using namespace std::chrono_literals;
using moteus::Register;

constexpr int kLastId = 126;
constexpr int kSweeps = 2;
constexpr int kBroadcasts = 2;          // of the first query, because the answer of a drive may be lost
constexpr auto kDiscoveryTime = 150ms;  // for each broadcast; the maker's tools wait 0.2 s
constexpr auto kSweepStep = 3ms;        // query and answer take 0.3 ms of the bus
constexpr int kMostAtOnce = 8;
constexpr auto kSettleTime = 200ms;
constexpr auto kAnswerTime = 100ms;
constexpr int kMaxTries = 5;  // if a tenth of all replies is lost, one board in 10⁵ is reported as two with one id

// A single NOP that wants a reply. Every board answers it with the same empty frame.
CanFrame isAnybodyThere(std::uint8_t source, int id)
{
    const std::array<std::uint8_t, 1> nop{0x50};
    return moteus::makeFrame({.replyWanted = true, .source = source, .destination = static_cast<std::uint8_t>(id)},
                             nop);
}

bool isAnswerTo(const moteus::Query& query, const moteus::Reply& reply)
{
    const Register first = query.front().reg;
    return std::ranges::count(reply.values, first, &moteus::RegisterValue::reg) > 0 ||
           std::ranges::count(reply.errors, first, &moteus::RegisterError::reg) > 0;
}

void append(moteus::Reply& known, const moteus::Reply& reply)
{
    known.values.insert(known.values.end(), reply.values.begin(), reply.values.end());
    known.errors.insert(known.errors.end(), reply.errors.begin(), reply.errors.end());
}

std::vector<CanFrame> asFrames(const moteus::Request& request)
{
    const Result<CanFrame> frame = moteus::encode(request);
    return frame ? std::vector{*frame} : std::vector<CanFrame>{};
}

}  // namespace

bool FoundController::isUnreadable() const
{
    const bool refused = std::ranges::any_of(
        known.errors, [](const moteus::RegisterError& error) { return error.reg == Register::Uuid; });
    return !known.uuid() && !refused;
}

BusScan::BusScan(std::uint8_t source, std::vector<moteus::Query> questions)
    : m_source(source), m_questions(std::move(questions))
{
    m_questions.insert(m_questions.begin(), moteus::discoveryQuery());
}

void BusScan::begin(SteadyTime now)
{
    m_controllers.clear();
    enter(Phase::Discover, now);
}

void BusScan::enter(Phase phase, SteadyTime now)
{
    m_phase = phase;
    m_entered = now;
    m_asked = 0;
    m_controller = 0;
    m_question = 0;
    m_tries = 0;
    m_answered = false;
}

std::vector<CanFrame> BusScan::frames(SteadyTime now)
{
    if (m_phase == Phase::Discover) {
        return discover(now);
    }
    if (m_phase == Phase::Sweep) {
        return sweep(now);
    }
    if (m_phase == Phase::Settle && now - m_entered >= kSettleTime) {
        std::ranges::stable_sort(m_controllers, {}, &FoundController::id);
        enter(Phase::Identify, now);
    }
    return m_phase == Phase::Identify ? identify(now) : std::vector<CanFrame>{};
}

std::vector<CanFrame> BusScan::discover(SteadyTime now)
{
    if (now - m_entered < m_asked * kDiscoveryTime) {
        return {};
    }
    if (m_asked == kBroadcasts) {
        enter(Phase::Sweep, now);
        return {};
    }
    ++m_asked;
    return asFrames({.destination = moteus::kBroadcastId, .source = m_source, .query = moteus::discoveryQuery()});
}

// Sends as many queries as the time since the last call allows, so that a slow caller does not slow the scan down.
std::vector<CanFrame> BusScan::sweep(SteadyTime now)
{
    std::vector<CanFrame> frames;
    for (int sent = 0; sent < kMostAtOnce && now - m_entered >= m_asked * kSweepStep; ++sent) {
        if (m_asked == kSweeps * kLastId) {
            enter(Phase::Settle, now);
            break;
        }
        const int id = m_asked++ % kLastId + 1;
        if (!isKnown(id)) {
            frames.push_back(isAnybodyThere(m_source, id));
        }
    }
    return frames;
}

std::vector<CanFrame> BusScan::identify(SteadyTime now)
{
    if (m_tries > 0 && !m_answered && now - m_questionSent < kAnswerTime) {
        return {};
    }
    if (!passToUnanswered()) {
        m_phase = Phase::Idle;
        return {};
    }
    ++m_tries;
    m_questionSent = now;
    return asFrames(question());
}

// False if no query is left.
bool BusScan::passToUnanswered()
{
    while (m_controller < m_controllers.size()) {
        const bool known = m_question == 0 && m_controllers[m_controller].known.uuid();
        if (!known && !m_answered && m_tries < kMaxTries) {
            return true;
        }
        m_tries = 0;
        m_answered = false;
        if (++m_question == m_questions.size()) {
            m_question = 0;
            ++m_controller;
        }
    }
    return false;
}

// Addresses the board by its UUID if possible. This is the only way to reach one of two boards with the same id.
moteus::Request BusScan::question() const
{
    const FoundController& controller = m_controllers[m_controller];
    moteus::Request request{
        .destination = static_cast<std::uint8_t>(controller.id), .source = m_source, .query = m_questions[m_question]};
    const std::optional<moteus::Uuid> uuid = controller.known.uuid();
    if (uuid && controller.known.value(Register::UuidMaskCapable).value_or(0.0) != 0.0) {
        request.uuid = moteus::UuidMask{.uuid = *uuid};
    }
    return request;
}

void BusScan::take(const moteus::Reply& reply)
{
    if (reply.destination != m_source || reply.prefix != 0) {
        return;
    }
    if (m_phase == Phase::Identify) {
        takeAnswer(reply);
    } else if (m_phase != Phase::Idle) {
        takeDiscovered(reply);
    }
}

void BusScan::takeDiscovered(const moteus::Reply& reply)
{
    const auto uuid = reply.uuid();
    const auto known = std::ranges::find_if(m_controllers, [&](const FoundController& one) {
        return one.id == reply.source && (!uuid || !one.known.uuid() || one.known.uuid() == uuid);
    });
    if (known == m_controllers.end()) {
        m_controllers.push_back({.id = reply.source, .known = reply});
    } else if (uuid && !known->known.uuid()) {
        append(known->known, reply);
    }
}

void BusScan::takeAnswer(const moteus::Reply& reply)
{
    if (m_controller >= m_controllers.size() || m_tries == 0 || m_answered) {
        return;
    }
    FoundController& controller = m_controllers[m_controller];
    if (reply.source == controller.id && isAnswerTo(m_questions[m_question], reply)) {
        append(controller.known, reply);
        m_answered = true;
    }
}

bool BusScan::isKnown(int id) const
{
    return std::ranges::count(m_controllers, id, &FoundController::id) > 0;
}

}  // namespace boresight::drive_check
