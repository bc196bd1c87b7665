// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/moteus_mount/drive_watch.h"

#include "core/alarms/catalogue.h"
#include "core/base/text.h"
#include "core/moteus/faults.h"
#include "core/moteus_mount/fault_class.h"

#include <algorithm>
#include <utility>

namespace boresight {
namespace {

using supervision::LossClass;
using supervision::Symptom;
using supervision::Weight;

constexpr std::chrono::seconds kLimitLinger{2};
// A lost drive carries out our last command until its watchdog expires.
constexpr std::chrono::milliseconds kLastOrderFades{500};
// A drive that boots, or a bus that comes up, is no reason for an alarm yet.
constexpr Seconds kPatienceAtStart{1.0};
// The alarm of a drive that is back waits this long to learn how far its axis moved. Later the number is added to it.
constexpr Seconds kPatienceForPlace{1.0};

LossClass classOf(DriveLoss loss, int faultCode)
{
    switch (loss) {
        case DriveLoss::Fault:
            return classOfFault(faultCode);
        case DriveLoss::Silent:
        case DriveLoss::TimedOut:
            return LossClass::Bus;
        case DriveLoss::Disobeys:
            return LossClass::Motion;
        case DriveLoss::Blind:
            return LossClass::Encoder;
        case DriveLoss::Released:
            break;
    }
    return LossClass::Released;
}

drive_alarms::Heat heatOf(const DriveReport& report)
{
    return {.board = report.boardTemperature, .motor = report.motorTemperature};
}

// Something pushes the axis or is in its way. If its set-point stayed elsewhere, the drive would go on pushing.
bool isGivingWay(Symptom symptom)
{
    return symptom == Symptom::FollowingError || symptom == Symptom::Stalled || symptom == Symptom::WrongWay ||
           symptom == Symptom::MovesUncommanded || symptom == Symptom::OutsideTravel || symptom == Symptom::TorqueGuard;
}

}  // namespace

DriveWatch::DriveWatch(Axis axis, const profile::InForce& profile, AlarmBoard& alarms, SilenceAlarms& silences)
    : m_which(axis), m_profile(profile), m_alarms(alarms), m_supervisor(axis, profile), m_silences(silences)
{}

std::optional<DriveWatch::Trouble> DriveWatch::watch(Drive& drive, const tracking::Setpoint& setpoint,
                                                     const Context& context)
{
    const auto lost = watchLoss(drive, context);
    if (!lost) {
        watchSilence(drive, context);
    }
    watchUnordered(drive, context);
    watchActiveLimit(drive, context.now);
    watchCooling(drive, context.now);
    auto seen = supervise(drive, setpoint, context);
    if (lost) {
        const bool doubtful = lost->turnDoubtful || (seen && seen->turnDoubtful);
        seen = lost;
        seen->turnDoubtful = doubtful;
    }
    return seen;
}

std::optional<DriveWatch::Trouble> DriveWatch::watchLoss(Drive& drive, const Context& context)
{
    const auto loss = drive.takeLoss();
    if (!loss) {
        return std::nullopt;
    }
    const int code = drive.report() ? drive.report()->fault : 0;
    m_supervisor.forgetMotion();
    if (*loss == DriveLoss::Silent) {
        beginSilence(drive, Silence::Kind::Lost, context);
        // This text stays as the reason of the latch after the silence has ended.
        return Trouble{.what = Text::tr("the %1 stopped replying").arg(drive.label()),
                       .loss = classOf(*loss, code),
                       .fellSilent = true};
    }
    const AlarmCase lost = *loss == DriveLoss::TimedOut && context.stalled
                               ? drive_alarms::timedOutByStall(drive.label(), *context.stalled)
                               : drive_alarms::lost(drive.label(), *loss, code);
    m_alarms.raise(lost.entry.of(m_which), lost.arguments);
    return Trouble{.what = whatOf(lost), .loss = classOf(*loss, code)};
}

void DriveWatch::beginSilence(const Drive& drive, Silence::Kind kind, const Context& context)
{
    const auto& place = drive.place();
    m_silent = {.since = drive.heard(),
                .place = place && context.turnKnown
                             ? std::optional(m_profile->axis(m_which).geometry.toAxis(place->position))
                             : std::nullopt};
    m_silences.tell(m_which, {.kind = kind, .since = m_silent->since, .needsRearm = context.faultLatched});
}

// A drive can go silent and return many times before a re-arm. The alarm always shows its present state.
void DriveWatch::watchSilence(const Drive& drive, const Context& context)
{
    if (drive.answering(context.now) || context.silenceExpected) {
        if (!context.faultLatched) {
            endSilence();
        } else if (!context.silenceExpected && m_silent) {
            watchReturn(drive, context);
        }
        return;
    }
    if (m_silent && !m_silent->backTold) {
        m_silent->back.reset();
    } else if (context.running > kPatienceAtStart) {
        beginSilence(drive, Silence::Kind::Unheard, context);
    }
}

// The first replies do not contain the position yet, and the wrap is confirmed some seconds later. A position that the
// operator enters is no evidence of how far the axis moved.
void DriveWatch::watchReturn(const Drive& drive, const Context& context)
{
    Silent& silent = *m_silent;
    silent.back = silent.back.value_or(context.now);
    if (context.turnAsked) {
        silent.place.reset();
    }
    const auto moved = movedSince(silent, drive, context);
    const bool waits = silent.backTold ? silent.place.has_value() : context.now - *silent.back < kPatienceForPlace;
    if (!moved && waits) {
        return;
    }
    if (moved || !silent.backTold) {
        m_silences.tell(m_which, {.kind = Silence::Kind::Back,
                                  .since = silent.since,
                                  .lasted = *silent.back - silent.since,
                                  .moved = moved});
    }
    silent.backTold = true;
    if (moved || !silent.place) {
        m_silent.reset();
    }
}

std::optional<Angle> DriveWatch::movedSince(const Silent& silent, const Drive& drive, const Context& context) const
{
    const auto& place = drive.place();
    if (!context.turnKnown || !silent.place || !place || place->received <= silent.since) {
        return std::nullopt;
    }
    return m_profile->axis(m_which).geometry.toAxis(place->position) - *silent.place;
}

void DriveWatch::endSilence()
{
    m_silent.reset();
    m_silences.end(m_which);
}

void DriveWatch::watchUnordered(const Drive& drive, const Context& context)
{
    if (!drive.activeUnordered() || !drive.answering(context.now) || context.ownOrders) {
        m_activeSince.reset();
    } else if (!m_activeSince) {
        m_activeSince = context.now;
    }
    if (m_activeSince && context.now - *m_activeSince >= kLastOrderFades) {
        const AlarmCase unordered = drive_alarms::unordered(drive.label(), drive.report()->mode);
        m_alarms.raise(unordered.entry.of(m_which), unordered.arguments);
    } else {
        m_alarms.clear(alarmEntry("drive.active-unordered").of(m_which));
    }
}

void DriveWatch::watchActiveLimit(const Drive& drive, SteadyTime now)
{
    const auto& report = drive.report();
    if (report && report->mode == moteus::Mode::Position && moteus::isLimit(report->fault)) {
        m_limitSeen = now;
        // A single reply without a temperature must not make another alarm.
        const drive_alarms::Heat heat = heatOf(*report);
        m_limitHeat = {.board = heat.board ? heat.board : m_limitHeat.board,
                       .motor = heat.motor ? heat.motor : m_limitHeat.motor};
        const AlarmCase limit = drive_alarms::activeLimit(drive.label(), report->fault, m_limitHeat);
        m_alarms.raise(limit.entry.of(m_which), limit.arguments);
    } else if (m_limitSeen && now - *m_limitSeen > kLimitLinger) {
        m_limitSeen.reset();
        m_limitHeat = {};
        m_alarms.clear(alarmEntry("drive.limit").of(m_which));
    }
}

// While a fault by heat waits for its re-arm, its alarm shows how the drive cools down. It stays the same alarm.
void DriveWatch::watchCooling(const Drive& drive, SteadyTime now)
{
    const auto& report = drive.report();
    const bool hot =
        report && report->mode == moteus::Mode::Fault && classOfFault(report->fault) == LossClass::OverTemperature;
    if (!hot) {
        m_faultHeat.reset();
        return;
    }
    if (!drive.answering(now) || !m_alarms.active(alarmEntry("drive.fault").of(m_which))) {
        return;
    }
    const drive_alarms::Heat heat = heatOf(*report);
    m_faultHeat = m_faultHeat.value_or(heat);
    const AlarmCase fault = drive_alarms::tooHot(drive.label(), report->fault, *m_faultHeat, heat);
    m_alarms.raise(fault.entry.of(m_which), fault.arguments);
}

supervision::AxisObservation DriveWatch::observation(Drive& drive, const tracking::Setpoint& setpoint,
                                                     const Context& context) const
{
    using Phase = Drive::Phase;
    const DriveReport& report = *drive.report();
    const auto& place = drive.place();
    const pointing::AxisGeometry& geometry = m_profile->axis(m_which).geometry;
    const auto leap = [&](const std::optional<supervision::PlaceBelief::Leap>& one) {
        return one ? std::optional(supervision::AngleLeap{.by = geometry.toAxis(one->to) - geometry.toAxis(one->from),
                                                          .to = geometry.toAxis(one->to),
                                                          .within = one->within})
                   : std::nullopt;
    };
    return {
        .now = context.now,
        .utc = context.utc,
        .received = drive.heard(),
        .fresh = report.received != m_observed,
        .placed = place && place->received != m_placed,
        .actual = place ? geometry.toAxis(place->position) : Angle{},
        .falsePlace = leap(drive.takeFalsePlace()),
        .jumped = leap(drive.takeJump()),
        .engaging = drive.phase() == Phase::Capturing || drive.phase() == Phase::Unseen || drive.phase() == Phase::Held,
        .engaged = drive.phase() == Phase::Engaged,
        .commanded = setpoint.position,
        .commandedRate = setpoint.rate,
        .torque = report.torque,
        .voltage = report.voltage,
        .boardTemperature = report.boardTemperature,
        .motorTemperature = report.motorTemperature,
        .limit = moteus::isLimit(report.fault) ? drive_alarms::limitClause(report.fault) : QString(),
        .turnKnown = context.turnKnown,
        .turnEntered = context.turnEntered};
}

std::optional<DriveWatch::Trouble> DriveWatch::supervise(Drive& drive, const tracking::Setpoint& setpoint,
                                                         const Context& context)
{
    const bool referencing = drive.phase() == Drive::Phase::Referencing;
    if (!drive.answering(context.now) || referencing) {
        m_supervisor.forgetReplies();  // a silence has its own alarm
        if (referencing) {
            m_supervisor.forgetMotion();  // the reported angle is being changed on purpose
        }
        endHints({});
        return std::nullopt;
    }
    const supervision::AxisObservation now = observation(drive, setpoint, context);
    const auto seen = m_supervisor.observe(now);
    m_observed = drive.report()->received;
    m_placed = drive.place() ? drive.place()->received : m_placed;
    // A danger is reported each time it begins, also while a fault waits for its re-arm. The axis must then be held
    // where it is now, not where it was at the first fault.
    std::optional<Trouble> trouble;
    std::set<Symptom> stops;
    for (const supervision::Observed& observed : seen) {
        tell(observed);
        const bool jump = observed.symptom == Symptom::EncoderJump && now.jumped;
        const bool stop = observed.weight == Weight::Stop;
        // Perhaps the axis is at the end of its cable, one wrap away from the entered position.
        const bool wrongWrap =
            stop && isGivingWay(observed.symptom) && observed.symptom != Symptom::OutsideTravel && context.turnEntered;
        const bool begins = stop && !m_stops.contains(observed.symptom);
        if (stop) {
            stops.insert(observed.symptom);
        }
        if (jump || (begins && !trouble)) {
            trouble = Trouble{.what = observed.what,
                              .stops = stop || (trouble && trouble->stops),
                              .turnDoubtful = jump || wrongWrap,
                              .gaveWay = stop && isGivingWay(observed.symptom)};
        } else if (begins && wrongWrap) {
            trouble->turnDoubtful = true;
        }
    }
    m_stops = std::move(stops);
    endHints(seen);
    return trouble;
}

// Raises an alarm once for a symptom, and again when a warning becomes a reason to stop.
void DriveWatch::tell(const supervision::Observed& observed)
{
    std::optional<Weight>& told = m_told[observed.symptom];
    if (!told || (told == Weight::Hint && observed.weight == Weight::Stop)) {
        told = observed.weight;
        const AlarmCase alarm = drive_alarms::supervised(observed);
        m_alarms.raise(alarm.entry.of(m_which), alarm.arguments);
    }
}

// An alarm that stopped the mount stays until the re-arm. A warning ends with its cause.
void DriveWatch::endHints(const std::vector<supervision::Observed>& seen)
{
    std::erase_if(m_told, [&](const auto& told) {
        const bool lasts = std::ranges::any_of(seen, [&](const auto& one) { return one.symptom == told.first; });
        if (lasts || told.second == Weight::Stop) {
            return false;
        }
        m_alarms.clear(drive_alarms::entryOf(told.first).of(m_which));
        return true;
    });
}

void DriveWatch::forgetMotion()
{
    m_supervisor.forgetMotion();
    m_supervisor.forgetReplies();
}

void DriveWatch::engaged()
{
    m_supervisor.forgetCommand();
}

// An alarm whose cause lasts is not cleared here. With the next reply it is raised again, or it ends.
void DriveWatch::rearmed()
{
    m_supervisor.rearmed();
    m_stops.clear();
    endSilence();
    for (auto& [symptom, told] : m_told) {
        told.reset();
    }
}

}  // namespace boresight
