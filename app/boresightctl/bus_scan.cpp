// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/boresightctl/bus_scan.h"

#include <algorithm>
#include <array>
#include <chrono>

namespace boresight::ctl {
namespace {

using namespace std::chrono_literals;
using moteus::Register;

// Not the source number of a station: on a shared bus its drives' answers are not for us, nor ours for it.
constexpr std::uint8_t kSource = 0x70;
constexpr int kLastId = 126;
constexpr int kSweeps = 2;
constexpr auto kDiscoveryTime = 300ms;  // the maker's tools wait 0.2 s
constexpr auto kSweepStep = 3ms;        // question and answer take 0.3 ms of the bus
constexpr auto kSweepRest = 200ms;      // for late answers
constexpr auto kAnswerTime = 100ms;
constexpr int kMaxTries = 3;
constexpr std::array<const moteus::Query& (*)(), 3> kQuestions{moteus::discoveryQuery, moteus::versionQuery,
                                                               moteus::rotatorQuery};

// A lone NOP that wants a reply; every board answers it with the same empty frame.
CanFrame isAnybodyThere(std::uint8_t id)
{
    const std::array<std::uint8_t, 1> nop{0x50};
    return moteus::makeFrame({.replyWanted = true, .source = kSource, .destination = id}, nop);
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

}  // namespace

BusScan::BusScan(CanLink& link, QObject* parent) : QObject(parent), m_link(link)
{
    m_timer.setSingleShot(true);
    m_timer.setTimerType(Qt::PreciseTimer);
    connect(&m_timer, &QTimer::timeout, this, &BusScan::next);
    connect(&m_link, &CanLink::frameReceived, this, &BusScan::take);
}

void BusScan::start()
{
    m_timer.start(kDiscoveryTime);
    ask({.destination = moteus::kBroadcastId, .source = kSource, .query = moteus::discoveryQuery()});
}

void BusScan::next()
{
    switch (m_phase) {
        case Phase::Discover:
            m_phase = Phase::Sweep;
            [[fallthrough]];
        case Phase::Sweep:
            return m_sweeps < kSweeps ? sweep() : beginIdentify();
        case Phase::Identify:
            return identify();
        case Phase::Done:
            return;
    }
}

void BusScan::sweep()
{
    m_sweptId = m_sweptId % kLastId + 1;
    m_sweeps += m_sweptId == kLastId ? 1 : 0;
    m_timer.start(m_sweeps < kSweeps ? std::chrono::milliseconds(kSweepStep) : kSweepRest);
    if (!isKnown(m_sweptId)) {
        send(isAnybodyThere(static_cast<std::uint8_t>(m_sweptId)));
    }
}

void BusScan::beginIdentify()
{
    m_phase = Phase::Identify;
    std::ranges::stable_sort(m_controllers, {}, &FoundController::id);
    identify();
}

void BusScan::identify()
{
    if (m_controller == m_controllers.size()) {
        return end({});
    }
    const bool known = m_question == 0 && m_controllers[m_controller].known.uuid();
    if (known || m_tries == kMaxTries) {
        m_tries = 0;
        if (++m_question == kQuestions.size()) {
            m_question = 0;
            ++m_controller;
        }
        return identify();
    }
    ++m_tries;
    m_timer.start(kAnswerTime);
    ask(question());
}

// By its UUID where it can be: the only way to speak to one of two boards with the same id.
moteus::Request BusScan::question() const
{
    const FoundController& controller = m_controllers[m_controller];
    moteus::Request request{
        .destination = static_cast<std::uint8_t>(controller.id), .source = kSource, .query = kQuestions[m_question]()};
    const std::optional<moteus::Uuid> uuid = controller.known.uuid();
    if (uuid && controller.known.value(Register::UuidMaskCapable).value_or(0.0) != 0.0) {
        request.uuid = moteus::UuidMask{.uuid = *uuid};
    }
    return request;
}

void BusScan::ask(const moteus::Request& request)
{
    const Result<CanFrame> frame = moteus::encode(request);
    if (frame) {
        send(*frame);
    } else {
        end(QString::fromStdString(frame.error().text));
    }
}

void BusScan::send(const CanFrame& frame)
{
    if (const Result<> sent = m_link.send(std::span(&frame, 1)); !sent) {
        end(QString::fromStdString(sent.error().text));
    }
}

void BusScan::end(const QString& problem)
{
    if (m_phase != Phase::Done) {
        m_phase = Phase::Done;
        m_timer.stop();
        Q_EMIT finished(problem);
    }
}

void BusScan::take(const CanFrame& frame)
{
    const Result<moteus::Reply> reply = moteus::decodeReply(frame);
    if (!reply || reply->destination != kSource) {
        return;
    }
    if (m_phase == Phase::Identify) {
        takeAnswer(*reply);
    } else if (m_phase != Phase::Done) {
        takeDiscovered(*reply);
    }
}

void BusScan::takeDiscovered(const moteus::Reply& reply)
{
    const auto known = std::ranges::find_if(m_controllers, [&](const FoundController& one) {
        return one.id == reply.source && (!reply.uuid() || one.known.uuid() == reply.uuid());
    });
    if (known == m_controllers.end()) {
        m_controllers.push_back({.id = reply.source, .known = reply});
    }
}

void BusScan::takeAnswer(const moteus::Reply& reply)
{
    FoundController& controller = m_controllers[m_controller];
    if (reply.source == controller.id && isAnswerTo(kQuestions[m_question](), reply)) {
        append(controller.known, reply);
        m_tries = kMaxTries;
        m_timer.start(0);
    }
}

bool BusScan::isKnown(int id) const
{
    return std::ranges::count(m_controllers, id, &FoundController::id) > 0;
}

}  // namespace boresight::ctl
