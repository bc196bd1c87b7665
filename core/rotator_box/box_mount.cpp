// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/rotator_box/box_mount.h"

#include "core/alarms/catalogue.h"
#include "core/base/text.h"
#include "core/rotator_box/each_step.h"
#include "core/units/degrees_text.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace boresight {
namespace {

// After this time without an answer an alarm is raised.
constexpr std::chrono::seconds kPatience{3};

}  // namespace

BoxMount::BoxMount(const profile::InForce& profile, AlarmBoard& alarms, const AxisSet& axes,
                   const std::array<AxisCapabilities, 2>& each, Angle count)
    : m_profile(profile),
      m_alarms(alarms),
      m_capabilities{.axes = {capabilitiesOf(axes, Axis::Azimuth, each), capabilitiesOf(axes, Axis::Elevation, each)}},
      m_each(each),
      m_count(count),
      m_axes{
          AxisOfBox{.watch = ObedienceWatch(each[0].rareStarts ? 2.0 * count : Angle{}), .spared = SparedAlarm(alarms)},
          AxisOfBox{.watch = ObedienceWatch(each[0].rareStarts ? 2.0 * count : Angle{}),
                    .spared = SparedAlarm(alarms)}},
      m_motors(profile, m_capabilities, {each[0].step, each[1].step}, count),
      m_home(alarms)
{}

bool BoxMount::answers() const
{
    return m_lineOpen && m_heard && m_now - *m_heard <= silence();
}

AxisSet BoxMount::turned() const
{
    return axesIf(m_capabilities.has(Axis::Azimuth), m_capabilities.has(Axis::Elevation));
}

const QString& BoxMount::name(Axis axis) const
{
    static const std::array kNames{QStringLiteral("azimuth drive"), QStringLiteral("elevation drive")};
    return kNames.at(index(axis));
}

QString BoxMount::label(Axis axis) const
{
    return Text::of(name(axis).toStdString());
}

// Such a rotator has no identity that can be read.
std::optional<QString> BoxMount::identity(Axis /*axis*/) const
{
    return m_heard ? std::optional(QString()) : std::nullopt;
}

bool BoxMount::placed() const
{
    return std::ranges::all_of(turned(), [this](Axis axis) { return of(axis).filter.place().has_value(); });
}

bool BoxMount::moves() const
{
    return std::ranges::any_of(turned(), [this](Axis axis) { return of(axis).watch.moves(m_now); });
}

AxisReport BoxMount::report(Axis axis) const
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

void BoxMount::lineOpened()
{
    m_lineOpen = true;
    if (!talk().wantsAnotherLine()) {  // otherwise the time without an answer continues
        m_opened.reset();
    }
    talk().restart();
    forgetPlaces();
}

void BoxMount::forgetPlaces()
{
    for (AxisOfBox& axis : m_axes) {
        axis.filter.forget();
        axis.watch.release();
    }
    m_motors.forget();
}

void BoxMount::observe(SteadyTime now)
{
    // This computer slept or stalled, and nobody watched the rotator on its way. A reply may be from before the stall.
    m_broke = m_broke || (m_state.follows && now - m_now > silence());
    m_now = now;
    if (m_lineOpen && !m_opened) {
        m_opened = now;
    }
    if (const auto places = talk().takePlaces(); places && !m_broke) {
        takePlaces(*places);
    }
}

void BoxMount::takePlaces(const RotatorTalk::Places& places)
{
    m_heard = m_now;
    if (std::exchange(m_state.silent, false)) {
        stop();  // it may still be moving to a target from before the silence
    }
    for (const Axis axis : kAxes) {
        const std::optional<Angle>& angle = axis == Axis::Azimuth ? places.azimuth : places.elevation;
        if (!angle) {
            continue;
        }
        AxisOfBox& mine = of(axis);
        const auto jump = mine.filter.take(*angle, m_now);
        if (jump && m_capabilities.has(axis) && !m_home.isRunning()) {  // at its switch an axis gets another count
            mine.jump = jump;
        }
        if (mine.filter.place() && mine.filter.placed() == m_now) {
            mine.watch.place(inSteps(*mine.filter.place(), m_count), m_now);
            m_motors.see(axis, *mine.filter.place(), m_now);
        }
    }
    if (placed()) {
        m_opened = m_now;
        // After a lost motion the alarm may be that of a silence. It stays as the reason until Re-arm.
        if (!m_state.lost) {
            m_alarms.clear(alarmEntry("rotator.no-answer"));
        }
    }
}

MountFindings BoxMount::supervise(const MountSituation& /*known*/)
{
    MountFindings found;
    if (const bool broke = std::exchange(m_broke, false); m_heard && !m_state.silent && (broke || !answers())) {
        beginSilence(found);
    }
    showNoAnswer();
    if (m_console.ends(m_now)) {
        stop();  // the line may have started a motor
    }
    if (const auto run = m_home.step(talk(), moves() || !placed(), m_now); run != HomeRun::Outcome::None) {
        found.homed = run == HomeRun::Outcome::Ended;
        found.homed ? forgetPlaces() : stop();
    }
    for (const Axis axis : turned()) {
        superviseAxis(axis, found);
    }
    // A rotator that still moves after a stop is not taken over: its stop would not be watched any more.
    const auto isStopping = [this](Axis axis) { return of(axis).watch.stopping(); };
    const bool isFree = std::ranges::none_of(kAxes, isStopping) && !m_console.isBusy() && !m_home.isRunning();
    if (m_state.wanted && !m_state.follows && isFree && answers() && placed()) {
        begin();
    }
    return found;
}

// The axes stand, so they are let go without a stop, which would end the run.
void BoxMount::home()
{
    letGo();
    forgetPlaces();
    m_home.begin(talk(), m_now);
}

void BoxMount::beginSilence(MountFindings& found)
{
    m_state.silent = true;
    m_motors.forget();
    const bool followed = m_state.follows || m_state.wanted;
    if (followed) {
        stop();  // it may still receive what we write
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

// For the start, and for a silence that ended no motion. The received bytes may show what is wrong.
void BoxMount::showNoAnswer()
{
    const bool patient = !m_opened || m_now - *m_opened < kPatience;
    if (!m_lineOpen || patient || (answers() && placed()) || m_state.lost ||
        talk().proof() == RotatorTalk::Proof::Foreign) {
        return;
    }
    m_alarms.raise(alarmEntry("rotator.no-answer"), {remedyOfNoAnswer()});
}

void BoxMount::superviseAxis(Axis axis, MountFindings& found)
{
    AxisOfBox& mine = of(axis);
    if (const auto jump = std::exchange(mine.jump, std::nullopt)) {
        lose(found, axis,
             {alarmEntry("rotator.jumped"), {label(axis), degreesText(jump->from, 0), degreesText(jump->to, 0)}});
    }
    const Angle away = abs(mine.setpoint.position - mine.filter.place().value_or(mine.setpoint.position));
    mine.spared.look({.axis = axis, .label = label(axis), .away = away, .follows = m_state.follows}, m_motors,
                     m_profile->rotator, m_now);
    if (!answers()) {
        return;
    }
    switch (mine.watch.judge(m_now)) {
        case ObedienceWatch::Verdict::Obeys:
            break;
        case ObedienceWatch::Verdict::SendAgain:
            sendAgain(axis);
            break;
        case ObedienceWatch::Verdict::Stuck:
            lose(found, axis,
                 {alarmEntry("rotator.stuck"),
                  {label(axis), degreesText(*mine.filter.place(), 0), degreesText(*targetOf(axis), 0)}});
            break;
        case ObedienceWatch::Verdict::StopAgain:
            talk().stop();
            break;
        case ObedienceWatch::Verdict::RunsOn:
            lose(found, axis, {alarmEntry("rotator.runs-on"), {label(axis)}});
            break;
    }
}

void BoxMount::lose(MountFindings& found, AxisSet axes, const AlarmKey& key, const AlarmCase& alarm)
{
    stop();
    letGo();
    m_state.lost = true;
    m_alarms.raise(key, alarm.arguments);
    for (const Axis axis : axes) {
        found.troubles.push_back({.axis = axis, .loss = supervision::LossClass::Motion, .what = whatOf(alarm)});
    }
}

void BoxMount::lose(MountFindings& found, Axis axis, const AlarmCase& alarm)
{
    lose(found, axesIf(axis == Axis::Azimuth, axis == Axis::Elevation), alarm.entry.of(axis), alarm);
}

void BoxMount::loseAll(MountFindings& found, const AlarmCase& alarm)
{
    lose(found, turned(), alarm.entry, alarm);
}

void BoxMount::begin()
{
    m_state.follows = true;
    m_motors.begin();
    for (const Axis axis : kAxes) {
        AxisOfBox& mine = of(axis);
        mine.begins = true;
        mine.watch.release();
        if (m_capabilities.has(axis)) {
            mine.each.begin(*mine.filter.place(), m_each[index(axis)].step);
        }
    }
}

std::optional<Angle> BoxMount::takeFollowing(Axis axis)
{
    const auto place =
        m_capabilities.startsSeldom(axis) ? std::optional(m_motors.axis(axis).place()) : report(axis).place;
    return std::exchange(of(axis).begins, false) ? place : std::nullopt;
}

void BoxMount::stop()
{
    m_home.end();
    talk().stop();
    m_motors.stopped(m_now);
    for (const Axis axis : turned()) {
        of(axis).watch.stopped(m_now);
    }
}

void BoxMount::letGo()
{
    m_state.follows = m_state.wanted = false;
    for (AxisOfBox& axis : m_axes) {
        axis.begins = false;
    }
}

// Motors that are known to stand need no time for that, so a jog key has its effect at once.
void BoxMount::retake()
{
    const bool isStanding = rareStarts() && m_motors.stand() && !moves();
    stop();
    for (AxisOfBox& axis : m_axes) {
        if (isStanding) {
            axis.watch.release();
        }
    }
    m_state.follows = false;
}

void BoxMount::brakeHard(bool hard)
{
    const bool was = std::exchange(m_state.hard, hard);
    if (hard && !was) {
        stop();
    }
    if (was && !hard) {
        // The set-points braked over a longer way than the rotator, so it is taken over again where it is.
        m_state.follows = false;
    }
}

// The rotator moves although it does not follow: it carries out an old command, or somebody uses its keys.
void BoxMount::seize()
{
    const auto isStopping = [this](Axis axis) { return of(axis).watch.stopping(); };
    if ((!m_state.follows || m_state.hard) && answers() && moves() && std::ranges::none_of(kAxes, isStopping)) {
        stop();
    }
}

void BoxMount::rearmed()
{
    m_alarms.clear(alarmEntry("rotator.silent"));
    m_alarms.clear(alarmEntry("rotator.refused"));
    m_home.forgetFailure();
    for (const Axis axis : kAxes) {
        m_alarms.clear(alarmEntry("rotator.stuck").of(axis));
    }
}

void BoxMount::leave(profile::OnExit /*how*/)
{
    if (m_state.follows || moves()) {
        stop();
        letGo();
    }
}

std::optional<MotorStarts> BoxMount::starts(Axis axis) const
{
    return m_capabilities.startsSeldom(axis) ? std::optional(m_motors.axis(axis).starts(m_now)) : std::nullopt;
}

std::optional<Angle> BoxMount::targetOf(Axis axis) const
{
    return rareStarts() ? m_motors.axis(axis).target() : of(axis).each.target();
}

void BoxMount::order()
{
    if (m_state.hard) {
        return;
    }
    rareStarts() ? sendTo(m_motors.next(m_now)) : orderEachStep();
}

void BoxMount::orderEachStep()
{
    bool changed = false;
    for (const Axis axis : turned()) {
        AxisOfBox& mine = of(axis);
        const bool isOther = mine.each.aim(mine.setpoint, m_profile->axis(axis), mine.filter.place(),
                                           m_each[index(axis)].step, m_motors.leeway(axis).within);
        changed = isOther || changed;
    }
    if (changed) {
        sendOrdered();
    }
}

void BoxMount::sendOrdered()
{
    const auto target = [this](Axis axis) {
        return of(axis).each.target() ? of(axis).each.target() : of(axis).filter.place();
    };
    if (!goTo({.azimuth = target(Axis::Azimuth), .elevation = target(Axis::Elevation)})) {
        return;
    }
    for (const Axis axis : kAxes) {
        if (const auto& ordered = of(axis).each.target()) {
            of(axis).watch.sent(*ordered, m_now);
        }
    }
}

void BoxMount::sendAgain(Axis axis)
{
    rareStarts() ? sendTo(m_motors.again(axis)) : sendOrdered();
}

void BoxMount::sendTo(const SwitchedMotors::Targets& targets)
{
    const bool isAny = targets[0] || targets[1];
    if (!isAny || !goTo(m_motors.command(targets))) {
        return;
    }
    m_motors.sent(targets, m_now);
    for (const Axis axis : kAxes) {
        if (targets[index(axis)]) {
            of(axis).watch.sent(m_motors.axis(axis).aim(), m_now);
        }
    }
}

// A typed line may change what the box counts.
std::string BoxMount::send()
{
    if (m_state.follows) {
        order();
    }
    if (!m_lineOpen) {
        return {};
    }
    std::string typed = m_console.send(talk(), m_now);
    if (typed.empty()) {
        return talk().send(m_now);
    }
    forgetPlaces();
    return typed;
}

}  // namespace boresight
