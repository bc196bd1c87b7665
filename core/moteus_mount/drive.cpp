// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/moteus_mount/drive.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

namespace boresight {
namespace {

// An axis slower than this stands still, apart from the noise of the measured velocity (0.01 rev/s at the rotor).
// Capturing waits for this no longer than kBrakingTime.
constexpr MotorRate kDriveStanding = MotorRate::fromTurns(0.001);
constexpr Seconds kBrakingTime{0.6};
// Stalls excused in one phase. Without this limit a computer that stalls all the time would hide a drive that does not
// obey.
constexpr int kMostStalls = 20;
// An axis stands still only if it has moved by less than this share of the allowance for a position since the last
// reply.
constexpr double kSteady = 0.2;

const moteus::Field kIgnoreBounds{1.0, moteus::Resolution::Int8};
const moteus::Field kNoIntegral{0.0, moteus::Resolution::Int8};

// Each frame carries the number of its tick, and the reply repeats the number. It is sent as a position in steps of 8
// bits. Each number takes two steps, because the drive may round down. A drive that has received no number answers 0,
// so 0 is not used.
constexpr int kEchoes = 31;
constexpr double kEchoStep = 0.01;  // turns

moteus::Field echoOf(int number)
{
    return {(2.0 * number + 1.5) * kEchoStep, moteus::Resolution::Int8};
}

int numberOf(double echo)
{
    return static_cast<int>(std::lround(echo / kEchoStep)) / 2;
}

// The position register wraps at this value. A larger number is no position.
constexpr double kPositionRange = 32768.0;  // turns

// A reply shows the state before the command of the same exchange. So the first reply of a phase is no evidence about
// that phase.
constexpr int kFirstTellingReply = 2;

// `home` is used for a reply that does not contain the home state.
DriveReport toReport(const moteus::Reply& reply, SteadyTime received, moteus::HomeState home)
{
    using moteus::Register;
    const auto number = [&](Register reg) {
        const auto value = reply.value(reg);
        return value && std::isfinite(*value) ? value : std::nullopt;
    };
    const auto turns = number(Register::Position);
    const bool possible = turns && std::abs(*turns) <= kPositionRange;
    const auto rate = number(Register::Velocity);
    const auto motorTemperature = number(Register::MotorTemperature);
    return {.received = received,
            .mode = *reply.mode(),
            .fault = reply.fault().value_or(0),
            .homeState = reply.homeState().value_or(home),
            .position = possible ? std::optional(MotorTurns::fromTurns(*turns)) : std::nullopt,
            .rate = rate ? std::optional(MotorRate::fromTurns(*rate)) : std::nullopt,
            .torque = number(Register::Torque),
            .current = number(Register::QCurrent),
            .dCurrent = number(Register::DCurrent),
            .power = number(Register::Power),
            .voltage = number(Register::Voltage),
            .boardTemperature = number(Register::Temperature),
            // The drive reports 0 without a sensor.
            .motorTemperature = motorTemperature == 0.0 ? std::nullopt : motorTemperature};
}

}  // namespace

Drive::Drive(const DriveSettings& settings, std::string name)
    : m_settings(settings), m_name(std::move(name)), m_belief(settings.places)
{}

void Drive::setSettings(const DriveSettings& settings)
{
    m_settings = settings;
    m_belief.setLimits(settings.places);
}

void Drive::enter(Phase phase)
{
    m_phase = phase;
    m_repliesInPhase = 0;
    m_phaseSince.reset();
    m_stallsInPhase = 0;
    m_follower.leave();
}

void Drive::engage()
{
    m_onlyHold = false;
    if (m_phase == Phase::Capturing || m_phase == Phase::Engaged || m_phase == Phase::Unseen) {
        return;
    }
    if (m_phase == Phase::Referencing) {
        m_heldWhenReferenced = true;  // the position is written first
        return;
    }
    m_captureAfterRecovery = true;
    m_yielding = false;
    if (m_phase != Phase::Recovering) {
        enter(latched() ? Phase::Recovering : Phase::Capturing);
    }
}

void Drive::hold()
{
    if (m_phase == Phase::Engaged || m_phase == Phase::Unseen) {
        enter(Phase::Held);
    }
    m_onlyHold = true;
}

void Drive::listen()
{
    enter(Phase::Listening);
}

void Drive::seize()
{
    if (activeUnordered()) {
        engage();
    }
}

void Drive::recover()
{
    if (m_report && m_report->mode == moteus::Mode::Fault && !m_faultTold) {
        return;  // the fault came with the last reply and must be reported first
    }
    m_captureAfterRecovery = m_report && m_report->mode == moteus::Mode::PositionTimeout;
    enter(Phase::Recovering);
}

void Drive::reference(MotorTurns place, MotorTurns tolerance)
{
    m_justReferenced = false;
    m_reference = place;
    m_referenceTolerance = tolerance;
    m_heldWhenReferenced = m_phase == Phase::Engaged || m_phase == Phase::Capturing || m_phase == Phase::Held;
    m_belief.expectAnother();
    enter(Phase::Referencing);
}

bool Drive::canBeReferenced() const
{
    return m_report && (m_phase == Phase::Listening || m_phase == Phase::Engaged || m_phase == Phase::Held);
}

void Drive::yield()
{
    if (m_phase == Phase::Engaged) {
        m_yielding = true;
        enter(Phase::Capturing);
    }
}

void Drive::starve()
{
    enter(Phase::Starving);
}

void Drive::brake()
{
    enter(Phase::Braking);
}

void Drive::release()
{
    enter(Phase::Releasing);
}

void Drive::setSetpoint(const MotorSetpoint& setpoint)
{
    m_setpoint = setpoint;
    m_yielding = m_yielding && (m_phase != Phase::Engaged || setpoint.rate == MotorRate{});
    if (m_phase == Phase::Engaged) {
        m_order = m_follower.follow(setpoint, {.speed = m_settings.speed,
                                               .acceleration = hardest(),
                                               .tick = m_settings.tick,
                                               .bounded = !m_ignoreBounds});
    }
}

bool Drive::answering(SteadyTime now) const
{
    return m_report && now - m_heard < kSilence;
}

// The stall does not count as silence of the drive. Replies that arrived during the stall are read after it and have
// that later time. So no time may be moved beyond `now`.
void Drive::excuse(Seconds stall, SteadyTime now)
{
    const auto excused = std::chrono::duration_cast<SteadyTime::duration>(stall);
    m_heard = std::min(m_heard + excused, now);
    m_placed = std::min(m_placed + excused, now);
    if (m_phaseSince && m_stallsInPhase < kMostStalls) {
        ++m_stallsInPhase;
        m_phaseSince = std::min(*m_phaseSince + excused, now);
    }
}

bool Drive::activeUnordered() const
{
    using moteus::Mode;
    if (m_phase != Phase::Listening || !m_report) {
        return false;
    }
    const Mode mode = m_report->mode;
    return (mode >= Mode::Pwm && mode <= Mode::Position) || mode == Mode::ZeroVelocity || mode == Mode::StayWithin;
}

bool Drive::latched() const
{
    return m_report && (m_report->mode == moteus::Mode::Fault || m_report->mode == moteus::Mode::PositionTimeout);
}

bool Drive::take(const CanFrame& frame)
{
    const auto reply = moteus::decodeReply(frame);
    if (!reply || reply->prefix != 0 || reply->source != m_settings.id || reply->destination != moteus::kHostId) {
        return false;
    }
    if (reply->mode()) {
        m_report = toReport(*reply, frame.received, m_report ? m_report->homeState : moteus::HomeState::Relative);
        m_heard = frame.received;
        m_replied = true;
        ++m_repliesInPhase;
        takeControl(*reply);
        takePlace();
    }
    return true;
}

void Drive::takePlace()
{
    m_belief.take(
        {.asked = m_asked.value_or(m_report->received), .received = m_report->received, .place = m_report->position});
    if (m_phase == Phase::Referencing) {
        static_cast<void>(takeFalsePlace());  // the position is set on purpose
        static_cast<void>(takeJump());
    }
    if (m_belief.believedLast()) {
        m_saidPlace = true;
        m_placed = m_report->received;
    }
}

void Drive::takeControl(const moteus::Reply& reply)
{
    const auto position = reply.value(moteus::Register::ControlPosition);
    const auto rate = reply.value(moteus::Register::ControlVelocity);
    const auto asked = ticksAgo(reply);
    if (position && rate && asked) {
        m_follower.heard(MotorTurns::fromTurns(*position), MotorRate::fromTurns(*rate), *asked);
    }
}

// How many ticks ago the frame was sent that this reply answers. A reply without an echo that comes later than half a
// tick may answer an earlier frame, so it is not used.
std::optional<int> Drive::ticksAgo(const moteus::Reply& reply) const
{
    const auto echo = reply.value(moteus::Register::StayWithinLower);
    if (const int number = echo ? numberOf(*echo) : 0; number > 0 && number <= kEchoes) {
        return (m_tickNumber - (number - 1) + kEchoes) % kEchoes;
    }
    return m_report->received - m_tick < m_settings.tick / 2.0 ? std::optional(0) : std::nullopt;
}

void Drive::lose(DriveLoss loss)
{
    m_loss = loss;
    if (loss == DriveLoss::Silent) {
        m_belief.expectAnother();  // the last position may be out of date
    } else if (loss == DriveLoss::Released || loss == DriveLoss::Disobeys) {
        m_belief.forget();  // the drive may have lost its power, or may not know its position yet
    }
    enter(Phase::Listening);
}

void Drive::countReply()
{
    if (std::exchange(m_replyDue, false)) {
        ++m_replyCount.sent;
        m_replyCount.answered += m_replied ? 1 : 0;
    }
}

void Drive::judge(SteadyTime now)
{
    countReply();
    if (std::exchange(m_replied, false) || !m_asked) {
        m_asked = now;
    }
    m_tick = now;
    m_tickNumber = (m_tickNumber + 1) % kEchoes;
    m_order.reset();
    m_follower.begin(now);
    m_unanswered = std::exchange(m_saidPlace, false) ? 0 : m_unanswered + 1;
    judgeFault();
    if (m_phase == Phase::Listening || m_phase == Phase::Braking) {
        return;
    }
    if (m_phase == Phase::Engaged && unseen()) {
        enter(Phase::Unseen);
    }
    m_holdNext = !m_holdNext;
    if (!m_phaseSince) {
        m_phaseSince = now;
    }
    if (!answering(now)) {
        lose(DriveLoss::Silent);
    } else if (m_phase == Phase::Unseen && now - m_placed >= kSilence) {
        lose(DriveLoss::Blind);
    } else if (mustObey() && now - *m_phaseSince > kObedience) {
        lose(DriveLoss::Disobeys);
    } else if (m_repliesInPhase >= (m_phase == Phase::Unseen ? 1 : kFirstTellingReply)) {
        judgePhase(m_report->mode, now - *m_phaseSince);
    }
}

// Phases that end as soon as the drive has carried out its command.
bool Drive::mustObey() const
{
    return m_phase == Phase::Capturing || m_phase == Phase::Recovering || m_phase == Phase::Referencing ||
           m_phase == Phase::Releasing;
}

// A fault is reported once, in any phase but Recovering, which is clearing the fault.
void Drive::judgeFault()
{
    const bool inFault = m_report && m_report->mode == moteus::Mode::Fault;
    if (inFault && !m_faultTold && m_phase != Phase::Recovering) {
        lose(DriveLoss::Fault);
    }
    m_faultTold = inFault;
}

void Drive::judgePhase(moteus::Mode mode, Seconds inPhase)
{
    if (m_phase == Phase::Starving) {
        return;
    }
    if (m_phase == Phase::Releasing || m_phase == Phase::Recovering) {
        if (mode == moteus::Mode::Stopped) {
            const bool capture = m_phase == Phase::Recovering && m_captureAfterRecovery;
            enter(capture ? Phase::Capturing : Phase::Listening);
        }
    } else if (m_phase == Phase::Referencing) {
        judgeReference();
    } else if (mode == moteus::Mode::PositionTimeout) {
        lose(DriveLoss::TimedOut);
    } else if (m_phase == Phase::Capturing) {
        if (mode == moteus::Mode::Position && m_belief.believedLast()) {
            judgeCapture(inPhase);
        }
    } else if (mode != moteus::Mode::Position) {
        lose(DriveLoss::Released);
    } else if (m_phase == Phase::Unseen && !unseen()) {
        enter(Phase::Capturing);
    }
}

// An axis that is captured in motion brakes first. A set-point at its present position would pull it back.
void Drive::judgeCapture(Seconds inPhase)
{
    const bool slow = m_report->rate && abs(*m_report->rate) < kDriveStanding;
    const bool stands = slow && abs(place()->moved) < m_settings.places.allowance * kSteady;
    if (stands || inPhase > kBrakingTime) {
        m_justEngaged = !m_onlyHold;
        enter(m_onlyHold ? Phase::Held : Phase::Engaged);
    }
}

void Drive::judgeReference()
{
    const bool taken = m_report->homeState == moteus::HomeState::Output && m_belief.believedLast() &&
                       abs(place()->position - m_reference) < m_referenceTolerance;
    if (taken) {
        enter(m_heldWhenReferenced ? Phase::Capturing : Phase::Listening);
        m_justReferenced = true;
    }
}

moteus::PositionCommand Drive::positionCommand(const MotionOrder& order) const
{
    return {.position = order.place ? order.place->turns() : moteus::kKeepControlPosition,
            .velocity = order.rate.turns(),
            .maximumTorque = m_settings.maxTorque,
            .watchdogTimeout = m_settings.watchdog.count(),
            .velocityLimit = m_settings.velocityLimit.turns(),
            .accelerationLimit = order.acceleration.turns(),
            .integralLimitScale = m_yielding ? std::optional(kNoIntegral) : std::nullopt,
            .ignorePositionBounds = m_ignoreBounds ? std::optional(kIgnoreBounds) : std::nullopt,
            .echo = echoOf(m_tickNumber + 1)};
}

// Brakes a moving axis with the emergency braking of the drive. For an axis that nobody sees or that is not captured
// yet.
moteus::PositionCommand Drive::holdCommand() const
{
    moteus::PositionCommand command = positionCommand({.acceleration = m_settings.emergencyBraking});
    command.recapture = m_yielding && m_phase == Phase::Capturing && m_repliesInPhase < kFirstTellingReply;
    return command;
}

// Setting the position does not feed the watchdog, so a drive that was held gets "brake and hold" in every second tick.
moteus::Command Drive::referenceCommand() const
{
    if (m_heldWhenReferenced && m_holdNext) {
        return holdCommand();
    }
    if (m_report && m_report->homeState == moteus::HomeState::Relative) {
        return moteus::SetOutputExact{m_reference.turns()};
    }
    return moteus::SetOutputNearest{m_reference.turns()};
}

std::optional<moteus::Command> Drive::command() const
{
    switch (m_phase) {
        case Phase::Listening:
        case Phase::Starving:
            return std::nullopt;
        case Phase::Referencing:
            return referenceCommand();
        case Phase::Capturing:
        case Phase::Unseen:
        case Phase::Held:
            return holdCommand();
        case Phase::Engaged:
            // Not the velocity of the set-point: repeated in each tick, it would move the axis on without end.
            return positionCommand(
                m_order.value_or(MotionOrder{.place = m_setpoint.position, .acceleration = hardest()}));
        case Phase::Recovering:
        case Phase::Releasing:
            return moteus::Stop{};
        case Phase::Braking:
            return moteus::Brake{};
    }
    return std::nullopt;
}

CanFrame Drive::frame() const
{
    const moteus::Request request{
        .destination = static_cast<std::uint8_t>(m_settings.id), .command = command(), .query = moteus::rotatorQuery()};
    const auto frame = moteus::encode(request);
    assert(frame);  // a fixed set of fields and a fixed query: tests prove that it fits
    return *frame;
}

}  // namespace boresight
