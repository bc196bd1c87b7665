// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/gs232_mount/gs232_mount.h"

#include "core/alarms/catalogue.h"
#include "core/base/text.h"
#include "core/gs232/box_command.h"
#include "core/units/degrees_text.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace boresight::gs232 {
namespace {

// The common ones turn by 6 °/s. Set-points that are slower let it run into each target, stop and start again.
constexpr AngularRate kFastest = AngularRate::fromDegrees(6.0);
// The target is this far ahead of the set-point. The box then runs on until the next target, half a second later.
constexpr Seconds kAhead{0.6};
// Of a rotator that is slower than its profile says: it must not run far when the line fails.
constexpr Angle kFarthest = 12_deg;
// Until an alarm reports that nothing answers.
constexpr std::chrono::seconds kPatience{3};

Angle wholeDegrees(Angle angle)
{
    return Angle::fromDegrees(std::round(angle.degrees()));
}

// The whole degrees inside the travel; min > max if there is none.
TravelRange countsIn(const TravelRange& travel)
{
    constexpr double kRounding = 1e-6;  // degrees
    return {.min = Angle::fromDegrees(std::ceil(travel.min.degrees() - kRounding)),
            .max = Angle::fromDegrees(std::floor(travel.max.degrees() + kRounding))};
}

// The nearest place that the box can be sent to. From inside the travel it is inside.
Angle onCount(const TravelRange& travel, Angle angle)
{
    const TravelRange counts = countsIn(travel);
    const bool isInside = angle >= travel.min && angle <= travel.max;
    return isInside ? std::clamp(wholeDegrees(angle), counts.min, counts.max) : wholeDegrees(angle);
}

std::optional<AxisCapabilities> capabilitiesOf(const AxisSet& axes, Axis axis)
{
    constexpr AxisCapabilities kAxis{
        .step = 1_deg, .miss = ObedienceWatch::kMet, .fastest = kFastest, .silence = Gs232Mount::kSilence};
    return std::ranges::find(axes, axis) != axes.end() ? std::optional(kAxis) : std::nullopt;
}

// The box counts by itself, and its count is the angle of the axis. A new profile has the sign and the offset of
// another mount.
Result<> countsAsTheBox(const profile::Profile& profile, Axis axis, const QString& table)
{
    const pointing::AxisGeometry& geometry = profile.axis(axis).geometry;
    const pointing::AxisGeometry usual = profile::Profile().axis(axis).geometry;
    const bool plain = geometry.sign == 1 && geometry.offset == Angle{};
    if (plain || (geometry.sign == usual.sign && geometry.offset == usual.offset)) {
        return {};
    }
    return failure(ErrorCode::Refused,
                   Text::tr("This rotator counts its angles itself: %1.sign and %1.offset_deg have no "
                            "effect on it. Set them to 1 and 0, and calibrate the count at its box.")
                       .arg(table));
}

Result<> fits(const profile::Profile& profile, const Capabilities& capabilities, Axis axis)
{
    if (!capabilities.has(axis)) {
        return {};
    }
    const QString table = axis == Axis::Azimuth ? QStringLiteral("azimuth") : QStringLiteral("elevation");
    const TravelRange& reach = axis == Axis::Azimuth ? kAzimuthReach : kElevationReach;
    const TravelRange& travel = profile.axis(axis).geometry.travel;
    const TravelRange counts = countsIn(travel);
    if (travel.min >= reach.min && travel.max <= reach.max && counts.min <= counts.max) {
        return countsAsTheBox(profile, axis, table);
    }
    return failure(ErrorCode::Refused,
                   Text::tr("The travel %1…%2 does not fit this rotator, which counts whole degrees of %3…%4. Change "
                            "%5.travel_min_deg and %5.travel_max_deg in the profile.")
                       .arg(degreesText(travel.min, 1), degreesText(travel.max, 1), degreesText(reach.min, 0),
                            degreesText(reach.max, 0), table));
}

}  // namespace

Gs232Mount::Gs232Mount(const profile::InForce& profile, AlarmBoard& alarms, const AxisSet& axes)
    : m_profile(profile),
      m_alarms(alarms),
      m_capabilities{.axes = {capabilitiesOf(axes, Axis::Azimuth), capabilitiesOf(axes, Axis::Elevation)}},
      m_names{QStringLiteral("azimuth drive"), QStringLiteral("elevation drive")},
      m_fitness(fits(*profile, m_capabilities, Axis::Azimuth).and_then([&] {
          return fits(*profile, m_capabilities, Axis::Elevation);
      })),
      m_talk(m_capabilities.has(Axis::Elevation) ? Question::Both : Question::Azimuth, profile->baud)
{}

QString Gs232Mount::label(Axis axis) const
{
    return Text::of(name(axis).toStdString());
}

// Such a box does not report who it is.
std::optional<QString> Gs232Mount::identity(Axis /*axis*/) const
{
    return m_heard ? std::optional(QString()) : std::nullopt;
}

bool Gs232Mount::placed() const
{
    return std::ranges::all_of(kAxes,
                               [this](Axis axis) { return !m_capabilities.has(axis) || of(axis).filter.place(); });
}

bool Gs232Mount::moves() const
{
    return std::ranges::any_of(kAxes,
                               [this](Axis axis) { return m_capabilities.has(axis) && of(axis).watch.moves(m_now); });
}

AxisReport Gs232Mount::report(Axis axis) const
{
    if (!m_capabilities.has(axis)) {
        return reportOfMissingAxis(m_state.follows, m_now);
    }
    const AxisOfBox& mine = of(axis);
    const AxisHand idle = mine.watch.moves(m_now) ? AxisHand::Unordered : AxisHand::HoldsItself;
    AxisReport report{.hand = m_state.follows ? AxisHand::Follows : idle,
                      .answers = answers(),
                      .seen = answers(),
                      .latched = m_state.lost,
                      .changesHands = m_state.wanted && !m_state.follows,
                      .underOrders = m_state.follows || m_state.wanted,
                      .wrapKnown = mine.filter.place().has_value()};
    report.heard = m_heard;
    if (mine.filter.place()) {
        report.place = mine.filter.place();
        report.placed = mine.filter.placed();
    }
    return report;
}

void Gs232Mount::lineOpened()
{
    m_lineOpen = true;
    m_opened.reset();
    m_talk.restart();
    for (AxisOfBox& axis : m_axes) {
        axis.filter.forget();
        axis.watch.release();
    }
}

void Gs232Mount::observe(SteadyTime now)
{
    m_now = now;
    if (m_lineOpen && !m_opened) {
        m_opened = now;
    }
    if (const auto position = m_talk.takePosition()) {
        takePlaces(*position);
    }
}

void Gs232Mount::takePlaces(const Position& position)
{
    m_heard = m_now;
    if (!m_state.lost) {
        m_alarms.clear(alarmEntry("rotator.no-answer"));  // or of a silence, which is the reason until Re-arm
    }
    if (std::exchange(m_state.silent, false)) {
        stop();  // it may still be on its way to where it was sent before the silence
    }
    for (const Axis axis : kAxes) {
        const std::optional<Angle>& angle = axis == Axis::Azimuth ? position.azimuth : position.elevation;
        if (!angle) {
            continue;
        }
        AxisOfBox& mine = of(axis);
        if (const auto jump = mine.filter.take(*angle, m_now); jump && m_capabilities.has(axis)) {
            mine.jump = jump;
        }
        if (mine.filter.place() && mine.filter.placed() == m_now) {
            mine.watch.place(*mine.filter.place(), m_now);
        }
    }
}

MountFindings Gs232Mount::supervise(const MountSituation& /*known*/)
{
    MountFindings found;
    if (const bool broke = std::exchange(m_broke, false); m_heard && !m_state.silent && (broke || !answers())) {
        beginSilence(found);
    }
    showNoAnswer();
    for (const Axis axis : kAxes) {
        if (m_capabilities.has(axis)) {
            superviseAxis(axis, found);
        }
    }
    if (m_state.wanted && !m_state.follows && answers() && placed()) {
        begin();
    }
    return found;
}

void Gs232Mount::beginSilence(MountFindings& found)
{
    m_state.silent = true;
    const bool followed = m_state.follows;
    if (followed) {
        stop();  // it may still read what we write
        letGo();
    }
    for (const Axis axis : kAxes) {
        of(axis).filter.forget();
        of(axis).watch.release();
        if (followed && m_capabilities.has(axis)) {
            m_state.lost = true;
            found.troubles.push_back({.axis = axis,
                                      .loss = supervision::LossClass::Bus,
                                      .what = Text::tr("the %1 fell silent").arg(label(axis))});
        }
    }
    if (followed) {
        m_alarms.raise(alarmEntry("rotator.silent"));
    }
}

// At the start, and after a silence that ended no motion. What comes in place of an answer says what is wrong.
void Gs232Mount::showNoAnswer()
{
    const bool patient = !m_opened || m_now - *m_opened < kPatience;
    if (!m_lineOpen || patient || answers() || m_state.lost || m_talk.proof() == Proof::Foreign) {
        return;
    }
    const QString remedy =
        m_talk.echoes() ? Text::tr(
                              "The line returns what Boresight sends. Connect the rotator to it. If a modem is "
                              "connected, switch the modem off")
        : m_talk.refuses()
            ? Text::tr(
                  "The rotator refuses the question for both axes. If it has no elevation, set elevation.driver to "
                  "\"none\"")
            : Text::tr("Check its power, the cable, and its speed (bus.baud, %1)").arg(m_profile->baud);
    m_alarms.raise(alarmEntry("rotator.no-answer"), {remedy});
}

void Gs232Mount::superviseAxis(Axis axis, MountFindings& found)
{
    if (const auto jump = std::exchange(of(axis).jump, std::nullopt)) {
        lose(found, axis,
             {alarmEntry("rotator.jumped"), {label(axis), degreesText(jump->from, 0), degreesText(jump->to, 0)}});
    }
    if (!answers()) {
        return;
    }
    switch (of(axis).watch.judge(m_now)) {
        case ObedienceWatch::Verdict::Obeys:
            break;
        case ObedienceWatch::Verdict::SendAgain:
            sendOrdered();
            break;
        case ObedienceWatch::Verdict::Stuck:
            lose(found, axis,
                 {alarmEntry("rotator.stuck"),
                  {label(axis), degreesText(*of(axis).filter.place(), 0), degreesText(*of(axis).ordered, 0)}});
            break;
        case ObedienceWatch::Verdict::StopAgain:
            m_talk.stop();
            break;
        case ObedienceWatch::Verdict::RunsOn:
            lose(found, axis, {alarmEntry("rotator.runs-on"), {label(axis)}});
            break;
    }
}

void Gs232Mount::lose(MountFindings& found, Axis axis, const AlarmCase& alarm)
{
    stop();
    letGo();
    m_state.lost = true;
    m_alarms.raise(alarm.entry.of(axis), alarm.arguments);
    found.troubles.push_back({.axis = axis, .loss = supervision::LossClass::Motion, .what = whatOf(alarm)});
}

void Gs232Mount::begin()
{
    m_state.follows = true;
    for (const Axis axis : kAxes) {
        AxisOfBox& mine = of(axis);
        mine.begins = true;
        mine.watch.release();
        mine.ordered = m_capabilities.has(axis) ? std::optional(wholeDegrees(*mine.filter.place())) : std::nullopt;
    }
}

std::optional<Angle> Gs232Mount::takeFollowing(Axis axis)
{
    return std::exchange(of(axis).begins, false) ? report(axis).place : std::nullopt;
}

void Gs232Mount::stop()
{
    m_talk.stop();
    for (const Axis axis : kAxes) {
        if (m_capabilities.has(axis)) {
            of(axis).watch.stopped(m_now);
        }
    }
}

void Gs232Mount::letGo()
{
    m_state.follows = m_state.wanted = false;
    for (AxisOfBox& axis : m_axes) {
        axis.begins = false;
    }
}

void Gs232Mount::brakeHard(bool hard)
{
    const bool was = std::exchange(m_state.hard, hard);
    if (hard && !was) {
        stop();
    }
    if (was && !hard) {
        m_state.follows = false;  // the set-points braked farther than the box: it is taken over again where it stands
    }
}

// It moves although it does not follow: what was ordered before goes on, or somebody stands at the box.
void Gs232Mount::seize()
{
    const auto isStopping = [this](Axis axis) { return of(axis).watch.stopping(); };
    if ((!m_state.follows || m_state.hard) && answers() && moves() && std::ranges::none_of(kAxes, isStopping)) {
        stop();
    }
}

void Gs232Mount::rearmed()
{
    m_alarms.clear(alarmEntry("rotator.silent"));
    for (const Axis axis : kAxes) {
        m_alarms.clear(alarmEntry("rotator.stuck").of(axis));
    }
}

void Gs232Mount::leave(profile::OnExit /*how*/)
{
    if (m_state.follows || moves()) {
        stop();
        letGo();
    }
}

// Not farther than the axis needs to stop from there: it is permitted up to that point.
Angle Gs232Mount::aimOf(Axis axis) const
{
    const tracking::Setpoint& setpoint = of(axis).setpoint;
    const double rate = setpoint.rate.degrees();
    const double stopping = rate * rate / (2.0 * m_profile->axis(axis).limits.acceleration.degrees());
    const double ahead = std::min(std::abs(rate) * kAhead.count(), stopping);
    const Angle aim = setpoint.position + Angle::fromDegrees(std::copysign(ahead, rate));
    const auto& place = of(axis).filter.place();
    return onCount(m_profile->axis(axis).geometry.travel,
                   place ? std::clamp(aim, *place - kFarthest, *place + kFarthest) : aim);
}

void Gs232Mount::order()
{
    bool changed = false;
    for (const Axis axis : kAxes) {
        AxisOfBox& mine = of(axis);
        if (const Angle aim = aimOf(axis); m_capabilities.has(axis) && aim != mine.ordered) {
            mine.ordered = aim;
            changed = true;
        }
    }
    if (changed && !m_state.hard) {
        sendOrdered();
    }
}

// An axis that this mount does not turn is sent to where it stands.
void Gs232Mount::sendOrdered()
{
    const auto target = [this](Axis axis) {
        return of(axis).ordered.value_or(of(axis).filter.place().value_or(Angle{}));
    };
    const std::optional<std::string> command =
        m_capabilities.has(Axis::Elevation)
            ? goTo({.azimuth = target(Axis::Azimuth), .elevation = target(Axis::Elevation)})
            : goToAzimuth(target(Axis::Azimuth));
    if (m_capabilities.has(Axis::Elevation) && !of(Axis::Azimuth).ordered && !of(Axis::Azimuth).filter.place()) {
        return;  // the command names the azimuth, too, and nobody knows it
    }
    if (!command) {
        return;  // outside of what the box counts: fitness() says so
    }
    m_talk.go(*command);
    for (const Axis axis : kAxes) {
        if (of(axis).ordered) {
            of(axis).watch.sent(*of(axis).ordered, m_now);
        }
    }
}

std::string Gs232Mount::send()
{
    if (m_state.follows) {
        order();
    }
    return m_lineOpen ? m_talk.send(m_now) : std::string();
}

}  // namespace boresight::gs232
