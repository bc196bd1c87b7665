// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/supervision/axis_supervisor.h"

#include "core/base/text.h"
#include "core/base/time_of_day.h"
#include "core/supervision/finding_words.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace boresight::supervision {
namespace {

// How late a healthy axis follows. The set-point is sent one tick after the reply that it is compared with, and a drive
// follows with a bandwidth of about 6 Hz.
constexpr Seconds kLag{0.05};

// More motion against the command than a control loop makes by itself.
constexpr Angle kAgainst = Angle::fromDegrees(0.5);

// A value that could cause a stop must last this long, so that one bad sample stops nothing.
constexpr Seconds kConfirm{0.1};

// How long a limit reported by the drive counts as the cause of what the axis does.
constexpr Seconds kLimitExplains{0.5};

// A high torque must last this long: longer than in a gust or during an acceleration.
constexpr Seconds kTorqueLasts{2.0};
// An axis that stands farther than this from its set-point, while its drive gives all the permitted torque, is blocked.
// The distance is ten steps of the position that the drive reports.
constexpr Angle kNotThere = Angle::fromDegrees(0.05);
constexpr double kAllTorque = 0.9;

constexpr double kSupplyReturns = 0.5;  // V: hysteresis of the alarms about the supply
constexpr double kCoolsBy = 3.0;        // °C: hysteresis of the alarms about heat
constexpr double kTrendNear = 30.0;     // °C below a limit: a cold board that warms up after switching on is farther

}  // namespace

AxisSupervisor::AxisSupervisor(Axis axis, const profile::InForce& profile)
    : m_axis(axis), m_names(namesOf(axis)), m_profile(profile)
{}

AxisSupervisor::Names AxisSupervisor::namesOf(Axis axis)
{
    const QString name = axis == Axis::Azimuth ? Text::tr("the azimuth") : Text::tr("the elevation");
    return {.axis = name,
            .supply = Text::tr("the supply of %1").arg(name),
            .board = Text::tr("the drive board of %1").arg(name),
            .motor = Text::tr("the motor of %1").arg(name)};
}

std::vector<Observed> AxisSupervisor::observe(const AxisObservation& seen)
{
    if (seen.turnKnown != m_knewTurn) {
        forgetMotion();
    } else if (seen.engaged && !m_wasEngaged) {
        forgetCommand();
    }
    m_wasEngaged = seen.engaged;
    m_knewTurn = seen.turnKnown;
    if (seen.fresh) {
        noteLimit(seen);
        judgeReplies(seen);
        judgeJump(seen);
        if (seen.placed) {
            judgeMotion(seen);
        }
        judgeTorque(seen);
        judgeSupply(seen);
        judgeBoard(seen);
        judgeMotor(seen);
    }

    std::vector<Observed> found;
    for (const Watch* const watch : {&m_following, &m_stalled, &m_pushes, &m_wrongWay, &m_uncommanded, &m_jump,
                                     &m_travel, &m_torqueGuard, &m_torqueHigh, &m_replies, &m_supplyLow, &m_supplyFalls,
                                     &m_supplyHigh, &m_boardHot, &m_boardWarms, &m_motorHot, &m_motorWarms}) {
        const auto& one = watch->observed();
        if (one && std::ranges::find(found, one->symptom, &Observed::symptom) == found.end()) {
            found.push_back(*one);
        }
    }
    std::ranges::stable_partition(found, [](const Observed& one) { return one.weight == Weight::Stop; });
    return found;
}

void AxisSupervisor::forgetMotion()
{
    forgetCommand();
    m_jump.forget();
}

void AxisSupervisor::rearmed()
{
    forgetMotion();
    m_supplyLow.forget();
}

void AxisSupervisor::forgetCommand()
{
    m_progress.forget();
    m_standing.forget();
    m_outside.forget();
    for (Watch* const watch :
         {&m_following, &m_stalled, &m_pushes, &m_wrongWay, &m_uncommanded, &m_travel, &m_torqueGuard}) {
        watch->forget();
    }
}

void AxisSupervisor::forgetReplies()
{
    m_lastReply.reset();
    m_replies.forget();
}

void AxisSupervisor::judgeMotion(const AxisObservation& seen)
{
    m_progress.look(seen);
    m_standing.look(seen);
    judgeFollowing(seen);
    judgeProgress(seen);
    judgeStanding(seen);
    judgeTravel(seen);
}

void AxisSupervisor::judgeFollowing(const AxisObservation& seen)
{
    const Angle apart = abs(seen.commanded - seen.actual);
    const Angle error = seen.engaged ? apart - abs(seen.commandedRate) * kLag : Angle{};
    const WatchLimits limits{.hint = m_profile->supervision.followingHint.degrees(),
                             .stop = m_profile->supervision.followingStop.degrees(),
                             .release = 0.5 * m_profile->supervision.followingHint.degrees(),
                             .after = m_profile->supervision.followingTime};
    m_following.update(seen.now, error.degrees(), limits, [&] {
        return Text::tr("%1 was %2 away from its set-point for %3 (set-point %4, axis %5)")
                   .arg(m_names.axis, words(apart), words(m_profile->supervision.followingTime), words(seen.commanded),
                        words(seen.actual)) +
               limit(seen.now);
    });
}

void AxisSupervisor::judgeProgress(const AxisObservation& seen)
{
    const auto motion = [&](const QString& sentence) {
        return sentence.arg(m_names.axis, words(m_progress.asked()), words(seen.commandedRate),
                            words(m_progress.underCommand()), words(m_progress.moved()));
    };
    // After the command reverses, the axis runs on until the drive, which is at a limit, has stopped it.
    const bool runsOn = !limit(seen.now).isEmpty() && m_progress.slowsDown();
    const double against = runsOn ? 0.0 : m_progress.against().degrees();
    m_wrongWay.update(seen.now, against, {.stop = kAgainst.degrees(), .release = kAgainst.degrees()}, [&] {
        return motion(Text::tr("%1 moves the wrong way: it moved %5 in %4 instead of %2 (at %3)"));
    });
    const double missing = m_progress.missing() ? m_progress.underCommand().count() : 0.0;
    const double longest = m_profile->supervision.stallTime.count();
    m_stalled.update(seen.now, missing, {.stop = longest, .release = longest}, [&] {
        return Text::tr("%1 does not move: it moved %2 in %3 instead of %4")
                   .arg(m_names.axis, words(m_progress.moved()), words(m_progress.underCommand()),
                        words(m_progress.asked())) +
               limit(seen.now);
    });
}

void AxisSupervisor::noteLimit(const AxisObservation& seen)
{
    if (!seen.limit.isEmpty()) {
        m_limit = seen.limit;
        m_limitSeen = seen.now;
    }
}

QString AxisSupervisor::limit(SteadyTime now) const
{
    return now - m_limitSeen <= kLimitExplains ? m_limit : QString();
}

void AxisSupervisor::judgeStanding(const AxisObservation& seen)
{
    const Angle moved = m_standing.moved().value_or(Angle{});
    WatchLimits limits{.hint = m_profile->supervision.uncommanded.degrees(),
                       .release = 0.5 * m_profile->supervision.uncommanded.degrees(),
                       .after = kConfirm};
    if (seen.engaged) {
        limits.stop = limits.hint;
    }
    m_uncommanded.update(seen.now, abs(moved).degrees(), limits, [&] {
        return (seen.engaged
                    ? Text::tr("%1 moved by %2 to %3 although it has to hold its position")
                    : Text::tr("%1 moved by %2 to %3 without a command (weight, wind, a hand or another program)"))
            .arg(m_names.axis, words(moved), words(seen.actual));
    });
}

void AxisSupervisor::judgeJump(const AxisObservation& seen)
{
    if (seen.jumped) {
        m_progress.forget();
        m_standing.forget();
        m_outside.forget();
    }
    constexpr double kFalse = 1.0;
    constexpr double kJump = 2.0;
    const auto& leap = seen.jumped ? seen.jumped : seen.falsePlace;
    WatchLimits limits{.hint = kFalse, .release = kFalse, .quietFor = Seconds(3.0)};
    if (seen.engaged || seen.engaging) {
        limits.stop = kJump;
    }
    m_jump.update(
        seen.now,
        seen.jumped ? kJump
        : leap      ? kFalse
                    : 0.0,
        limits, [&] {
            return (seen.jumped
                        ? Text::tr("the reported angle of %1 jumped by %2 in %3 to %4, faster than the axis can move")
                        : Text::tr("a false reply reports that %1 jumped by %2 in %3 to %4"))
                .arg(m_names.axis, words(leap->by), words(leap->within), words(leap->to));
        });
}

void AxisSupervisor::judgeTravel(const AxisObservation& seen)
{
    const TravelRange& travel = m_profile->axis(m_axis).geometry.travel;
    m_outside.look(seen, travel);
    const Angle beyond = seen.turnKnown ? m_outside.beyond() : Angle{};
    WatchLimits limits{.hint = m_profile->supervision.outsideHint.degrees(),
                       .release = 0.5 * m_profile->supervision.outsideHint.degrees()};
    if (seen.engaged && m_outside.outwards()) {
        limits.stop = m_profile->supervision.outsideStop.degrees();
    }
    m_travel.update(seen.now, beyond.degrees(), limits, [&] {
        return (m_outside.outwards() ? Text::tr("%1 is at %2, %3 beyond its travel %4…%5, and moves farther out")
                                     : Text::tr("%1 is at %2, %3 beyond its travel %4…%5"))
            .arg(m_names.axis, words(seen.actual), words(beyond), words(travel.min), words(travel.max));
    });
}

void AxisSupervisor::judgeTorque(const AxisObservation& seen)
{
    if (!seen.torque) {
        return;
    }
    const double torque = std::abs(*seen.torque);
    const double share = seen.engaged ? torque / m_profile->axis(m_axis).maxTorque : 0.0;
    const auto needs = [&](const QString& sentence) {
        return sentence.arg(m_names.axis, words(torque, 1), words(100.0 * share, 0),
                            words(m_profile->axis(m_axis).maxTorque, 1));
    };
    const bool stands = m_standing.moved().has_value();
    const double most = stands ? std::min(m_profile->supervision.torqueAtRest, m_profile->supervision.torqueHint)
                               : m_profile->supervision.torqueHint;
    m_torqueHigh.update(seen.now, share, {.hint = most, .release = 0.85 * most, .after = kTorqueLasts}, [&] {
        return stands ? needs(Text::tr("%1 stands still and needs %2 Nm, %3 % of the %4 Nm allowed: more than the %5 "
                                       "Nm of weight and friction"))
                            .arg(words(most * m_profile->axis(m_axis).maxTorque, 1))
                      : needs(Text::tr("%1 needs %2 Nm, %3 % of the %4 Nm allowed"));
    });
    judgePush(seen, stands ? share : 0.0);
    m_torqueGuard.update(
        seen.now, seen.turnKnown && !seen.turnEntered ? 0.0 : share,
        {.stop = m_profile->supervision.torqueUnwind,
         .release = 0.85 * m_profile->supervision.torqueUnwind,
         .after = kConfirm},
        [&] {
            return needs(
                seen.turnKnown
                    ? Text::tr("%1 needs %2 Nm, %3 % of the %4 Nm allowed. Its entered cable wrap may be wrong")
                    : Text::tr("%1 needs %2 Nm, %3 % of the %4 Nm allowed. Its position is unknown"));
        });
}

// Finds an axis that is blocked just before its target. The rest of the way is too short for judgeProgress().
void AxisSupervisor::judgePush(const AxisObservation& seen, double share)
{
    const Angle apart = abs(seen.commanded - seen.actual);
    const bool pushes = share >= kAllTorque && apart > kNotThere;
    m_pushes.update(seen.now, pushes ? 1.0 : 0.0, {.stop = 1.0, .release = 1.0, .after = kTorqueLasts}, [&] {
        return Text::tr("%1 does not move: it was %2 away from its set-point for %5, with %3 Nm of the %4 Nm allowed")
                   .arg(m_names.axis, words(apart), words(std::abs(seen.torque.value_or(0.0)), 1),
                        words(m_profile->axis(m_axis).maxTorque, 1), words(kTorqueLasts)) +
               limit(seen.now);
    });
}

void AxisSupervisor::judgeReplies(const AxisObservation& seen)
{
    const Seconds gap = seen.received - std::exchange(m_lastReply, seen.received).value_or(seen.received);
    const Seconds limit = m_profile->supervision.replyAge;
    m_replies.update(seen.now, gap.count(), {.hint = limit.count(), .release = 0.75 * limit.count()}, [&] {
        return Text::tr("the drive of %1 was late: no reply for %2 (limit %3)")
            .arg(m_names.axis, words(gap), words(limit));
    });
}

void AxisSupervisor::judgeSupply(const AxisObservation& seen)
{
    if (!seen.voltage) {
        return;
    }
    const double voltage = *seen.voltage;
    // A lower voltage is worse and Watch compares upwards, so value and limits are negative.
    WatchLimits low{.hint = -m_profile->supervision.supplyLow,
                    .release = -(m_profile->supervision.supplyLow + kSupplyReturns)};
    low.after = kConfirm;
    if (seen.engaged) {
        low.stop = -m_profile->supervision.supplyStop;
    }
    m_supplyLow.update(seen.now, -voltage, low, [&] {
        const bool stop = voltage <= m_profile->supervision.supplyStop;
        return Text::tr("the supply of %1 fell to %2 V, below %3 V")
            .arg(m_names.axis, words(voltage, 1),
                 words(stop ? m_profile->supervision.supplyStop : m_profile->supervision.supplyLow, 1));
    });
    m_supplyHigh.update(
        seen.now, voltage,
        {.hint = m_profile->supervision.supplyHigh, .release = m_profile->supervision.supplyHigh - kSupplyReturns},
        [&] {
            return Text::tr("the supply of %1 rose to %2 V, above %3 V")
                .arg(m_names.axis, words(voltage, 1), words(m_profile->supervision.supplyHigh, 1));
        });
    m_supplyTrend.add(seen.now, voltage);
    judgeTrend(m_supplyFalls, seen, m_supplyTrend,
               {.value = m_profile->supervision.supplyLow,
                .fromBelow = false,
                .near = std::numeric_limits<double>::infinity(),
                .unit = QStringLiteral("V"),
                .decimals = 1},
               m_names.supply);
}

void AxisSupervisor::judgeBoard(const AxisObservation& seen)
{
    if (!seen.boardTemperature) {
        return;
    }
    const double temperature = *seen.boardTemperature;
    m_boardHot.update(seen.now, temperature,
                      {.hint = m_profile->supervision.boardHot, .release = m_profile->supervision.boardHot - kCoolsBy},
                      [&] {
                          return Text::tr("%1 reached %2 °C and switches off at %3 °C")
                              .arg(m_names.board, words(temperature, 0), words(m_profile->supervision.boardLimit, 0));
                      });
    m_boardTrend.add(seen.now, temperature);
    judgeTrend(m_boardWarms, seen, m_boardTrend,
               {.value = m_profile->supervision.boardLimit, .near = kTrendNear, .unit = QStringLiteral("°C")},
               m_names.board);
}

void AxisSupervisor::judgeMotor(const AxisObservation& seen)
{
    if (!seen.motorTemperature) {
        return;
    }
    m_motorHot.update(
        seen.now, *seen.motorTemperature,
        {.hint = m_profile->supervision.motorHot, .release = m_profile->supervision.motorHot - kCoolsBy},
        [&] { return Text::tr("%1 reached %2 °C").arg(m_names.motor, words(*seen.motorTemperature, 0)); });
    m_motorTrend.add(seen.now, *seen.motorTemperature);
    judgeTrend(m_motorWarms, seen, m_motorTrend,
               {.value = m_profile->supervision.motorHot, .near = kTrendNear, .unit = QStringLiteral("°C")},
               m_names.motor);
}

void AxisSupervisor::judgeTrend(Watch& watch, const AxisObservation& seen, const Trend& trend, const TrendLimit& to,
                                const QString& what)
{
    const auto line = trend.line();
    const double distance = line ? (to.fromBelow ? to.value - line->now : line->now - to.value) : -1.0;
    const auto left = distance > 0.0 && distance < to.near ? line->timeTo(to.value) : std::nullopt;
    // A shorter time is worse and Watch compares upwards, so times are negative.
    const double soon = left ? -left->count() : -std::numeric_limits<double>::infinity();
    const double ahead = m_profile->supervision.trendAhead.count();
    watch.update(seen.now, soon, {.hint = -ahead, .release = -1.5 * ahead, .quietFor = Seconds(10.0)}, [&] {
        return (to.fromBelow ? Text::tr("%1 reached %2 %3. It rises by %4 %3/min and will reach %5 %3 at %6")
                             : Text::tr("%1 fell to %2 %3. It falls by %4 %3/min and will reach %5 %3 at %6"))
            .arg(what, words(line->now, to.decimals), to.unit, words(std::abs(line->perMinute), 1),
                 words(to.value, to.decimals), timeOfDayText(seen.utc + std::chrono::round<UtcTime::duration>(*left)));
    });
}

}  // namespace boresight::supervision
