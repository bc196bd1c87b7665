// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/moteus_mount/moteus_mount.h"

#include "core/alarms/catalogue.h"
#include "core/base/numbers.h"
#include "core/base/text.h"
#include "core/moteus_mount/drive_readings.h"

#include <algorithm>
#include <iterator>

namespace boresight {
namespace {

// Fast enough to differ from standing still, slow enough to do no harm.
constexpr AngularRate kSlowestProof = AngularRate::fromDegrees(0.5);
constexpr AngularRate kFastestProof = AngularRate::fromDegrees(5.0);

bool isSwitchedOn(const Drive& drive)
{
    return drive.phase() != Drive::Phase::Listening ||
           (drive.report() && drive.report()->mode != moteus::Mode::Stopped);
}

QString registersText(const Drive& drive)
{
    const auto& reply = drive.report();
    return Text::tr("moteus mode %1, fault %2")
        .arg(reply ? static_cast<int>(reply->mode) : 0)
        .arg(reply ? reply->fault : 0);
}

}  // namespace

MoteusMount::MoteusMount(const profile::InForce& profile, const Clock& clock, EventLog& log, AlarmBoard& alarms,
                         TurnKeeper::Start start, AxisSet axes)
    : m_profile(profile),
      m_clock(clock),
      m_log(log),
      m_alarms(alarms),
      m_drives(profile, axes),
      m_third(profile, alarms),
      m_names{toQString(m_drives.drive(Axis::Azimuth).name()), toQString(m_drives.drive(Axis::Elevation).name())},
      m_silences(profile, alarms, m_drives),
      m_watches{DriveWatch(Axis::Azimuth, profile, alarms, m_silences),
                DriveWatch(Axis::Elevation, profile, alarms, m_silences)},
      m_turns(profile, clock, log, std::move(start)),
      m_turnWatch(m_turns, m_drives, m_watches, alarms),
      m_stall(m_drives, m_watches, m_turns, alarms, log, clock),
      m_proof(m_drives, m_turns, m_turnWatch, log),
      m_interlock(failure(ErrorCode::Refused, Text::tr("the drives have not been checked yet"))),
      m_started(clock.now()),
      m_now(m_started)
{}

void MoteusMount::take(const CanFrame& frame)
{
    m_drives.take(frame);
    m_third.take(frame);
}

std::vector<CanFrame> MoteusMount::frames() const
{
    std::vector<CanFrame> frames = m_drives.frames();
    std::ranges::copy(m_third.frames(), std::back_inserter(frames));
    return frames;
}

void MoteusMount::framesSent()
{
    m_stall.framesSent(m_profile->control.watchdog, heldPlace(), m_clock.now());
}

void MoteusMount::lineOpened()
{
    for (const Axis axis : axes()) {
        m_drives.drive(axis).restartCount();
    }
}

void MoteusMount::framesTaken()
{
    for (const Axis axis : axes()) {
        m_drives.drive(axis).frameSent();
    }
    m_third.framesTaken();
}

void MoteusMount::driveRestarted(Axis axis)
{
    m_log.add(Severity::Warning, name(axis), Text::tr("was power-cycled, so its cable wrap is judged again"));
    m_turnWatch.forget(axis);
    m_restarted = true;
}

void MoteusMount::countsAnew(Axis axis)
{
    m_log.add(Severity::Warning, name(axis),
              Text::tr("counts from a new zero, so Boresight checks its cable wrap again"));
    m_turnWatch.forget(axis);
    m_restarted = true;
}

Capabilities MoteusMount::capabilities() const
{
    Capabilities can{.axes = {}};
    for (const Axis axis : axes()) {
        can.axes[index(axis)] = {.silence = Drive::kSilence, .watchdog = true};
    }
    return can;
}

std::optional<QString> MoteusMount::identity(Axis axis) const
{
    if (!has(axis)) {
        return QString();
    }
    const auto& facts = m_turnWatch.facts(axis);
    return facts ? std::optional(facts->uuid) : std::nullopt;
}

QString MoteusMount::lastIdentity(Axis axis) const
{
    const auto& turn = journal().turns[index(axis)];
    return has(axis) && turn ? turn->drive : QString();
}

AxisHand MoteusMount::handOf(const Drive& drive, Axis axis) const
{
    if (drive.phase() == Drive::Phase::Held) {
        return AxisHand::Held;
    }
    if (drive.phase() == Drive::Phase::Engaged) {
        return AxisHand::Follows;
    }
    switch (drive.report() ? drive.report()->mode : moteus::Mode::Stopped) {
        case moteus::Mode::Stopped:
        case moteus::Mode::Fault:
            return AxisHand::Off;
        case moteus::Mode::PositionTimeout: {
            const auto& facts = m_turnWatch.facts(axis);
            return facts && facts->holdsWhenNotFed ? AxisHand::HoldsItself : AxisHand::TimedOut;
        }
        default:
            return drive.activeUnordered() ? AxisHand::Unordered : AxisHand::On;
    }
}

AxisReport MoteusMount::report(Axis axis) const
{
    if (!has(axis)) {
        return reportOfMissingAxis(m_drives.engaged(), m_now);
    }
    const Drive& drive = m_drives.drive(axis);
    AxisReport report{.hand = handOf(drive, axis),
                      .answers = drive.answering(m_now),
                      .seen = !drive.unseen(),
                      .latched = drive.latched(),
                      .changesHands = DrivePair::changingHands(drive),
                      .underOrders = drive.phase() != Drive::Phase::Listening,
                      .wrapKnown = m_turns.known(axis),
                      .wrapAsked = m_turns.asked(axis),
                      .place = m_drives.measured(axis),
                      .placed = drive.place() ? drive.place()->received : SteadyTime{},
                      .rate = m_drives.measuredRate(axis)};
    if (const auto& reply = drive.report()) {
        report.heard = reply->received;
        report.voltage = reply->voltage;
        report.torque = reply->torque;
        report.current = reply->current;
        report.power = reply->power;
        report.boardTemperature = reply->boardTemperature;
        report.motorTemperature = reply->motorTemperature;
    }
    return report;
}

Result<> MoteusMount::available() const
{
    return m_busLeft
               ? failure(ErrorCode::NoAnswer, Text::tr("The bus is released to other tools. Take the bus back first."))
               : Result<>{};
}

// DriveCare adds the results of the drive check.
void MoteusMount::describe(DrivesStatus& status) const
{
    status.released = m_busLeft;
    status.switchedOn = std::ranges::any_of(axes(), [this](Axis axis) { return isSwitchedOn(m_drives.drive(axis)); });
    status.proofRunning = m_proof.running();
    status.proofText = m_proof.text();
    status.azimuth.present = has(Axis::Azimuth);
    status.elevation.present = has(Axis::Elevation);
    for (const Axis axis : axes()) {
        DriveStatus& drive = axis == Axis::Azimuth ? status.azimuth : status.elevation;
        drive.id = m_profile->axis(axis).id;
        drive.readings = readingsOf(m_drives.drive(axis), m_now);
        drive.registers = registersText(m_drives.drive(axis));
        drive.turnQuestion = readable() ? m_turns.question(axis, m_drives.drive(axis)) : std::nullopt;
        drive.crashStop = journal().crashStops[index(axis)];
    }
}

void MoteusMount::observe(SteadyTime now)
{
    if (m_observed) {
        m_stall.tickBegins(now - m_now, m_profile->control.watchdog, heldPlace(), now);
    } else {
        m_started = now;  // the drives have received no query yet
    }
    m_observed = true;
    m_now = now;
    m_drives.judge(now);
    m_third.observe(now);
}

MountFindings MoteusMount::supervise(const MountSituation& known)
{
    MountFindings found;
    keepTurns(known, found);
    resumeAfterStall(known, found);
    watchDrives(known, found);
    letBackInside();
    return found;
}

void MoteusMount::keepTurns(const MountSituation& known, MountFindings& found)
{
    const bool restarted = std::exchange(m_restarted, false);
    const bool lost = m_turnWatch.keep({.now = m_now, .released = m_busLeft, .atRest = known.settled});
    found.interrupted = lost || restarted;  // the target belongs to angles that are not valid any more
    if (found.interrupted) {
        interruptProof();
    }
    m_turnWatch.raiseAlarms(lost && known.wanted && !restarted, readable());
}

// If a drive does not come back, the motion ends with a fault.
void MoteusMount::resumeAfterStall(const MountSituation& known, MountFindings& found)
{
    const bool hindered = m_proof.running() || known.closing || m_busLeft || known.stopLatched || known.faultLatched ||
                          !m_interlock || !m_turnWatch.allKnown();
    m_stall.resume(m_profile->control.afterStall == profile::AfterStall::Resume && !hindered, m_now);
    if (const auto missing = m_stall.finish(known.faultLatched, m_now)) {
        stopFor(missing->first, missing->second, found);
    }
}

void MoteusMount::watchDrives(const MountSituation& known, MountFindings& found)
{
    std::vector<std::size_t> silent;  // indices of the troubles of silent drives
    for (const Axis axis : axes()) {
        const DriveWatch::Context context{.now = m_now,
                                          .utc = m_clock.utc(),
                                          .running = m_now - m_started,
                                          .turnKnown = m_turns.known(axis),
                                          .turnEntered = m_turns.entered(axis),
                                          .turnAsked = m_turns.asked(axis),
                                          .faultLatched = known.faultLatched || !found.troubles.empty(),
                                          .ownOrders = known.closing,
                                          .silenceExpected = m_busLeft,
                                          .stalled = m_stall.recent(m_now)};
        const auto trouble = m_watches[index(axis)].watch(m_drives.drive(axis), m_setpoints[index(axis)], context);
        if (trouble && trouble->stops) {
            stopFor(axis, *trouble, found);
        }
        if (trouble && trouble->turnDoubtful) {
            m_turns.forget(axis, trouble->what);
        }
        if (trouble && trouble->fellSilent) {
            silent.push_back(found.troubles.size() - 1);
        }
    }
    m_silences.show(m_now);
    for (const std::size_t one : silent) {
        found.troubles[one].what =
            m_silences.isOfBoth() ? Text::tr("both drives stopped replying") : found.troubles[one].what;
    }
}

// An axis that can not follow must stay where it is, so its set-point must not pull it any further, also if its wrap is
// in doubt. An axis whose angle has jumped gets no set-point, because nobody knows where its drive would move for that
// set-point.
void MoteusMount::stopFor(Axis axis, const DriveWatch::Trouble& trouble, MountFindings& found)
{
    found.troubles.push_back({.axis = axis, .loss = trouble.loss, .what = trouble.what});
    interruptProof();
    if (trouble.gaveWay) {
        m_drives.drive(axis).yield();  // its set-point is moved there when the drive is captured again
    } else if (trouble.turnDoubtful) {
        m_drives.drive(axis).hold();
    }
}

void MoteusMount::interruptProof()
{
    if (m_proof.running()) {
        m_proof.end(Text::tr("ended before it was done"));
    }
}

bool MoteusMount::isFarOutside(Axis axis) const
{
    const auto place = m_drives.measured(axis);
    const TravelRange& travel = m_profile->axis(axis).geometry.travel;
    const Angle margin = m_profile->control.driveLimitMargin;
    return m_turns.known(axis) && place && (*place > travel.max + margin || *place < travel.min - margin);
}

// An axis that was pushed out beyond the bounds of its drive could not even be moved back: fault 39.
void MoteusMount::letBackInside()
{
    for (const Axis axis : axes()) {
        const auto measured = m_drives.measured(axis);
        const bool outside =
            m_turns.known(axis) && measured && !m_profile->axis(axis).geometry.travel.contains(*measured);
        bool& ignoring = m_ignoringBounds[index(axis)];
        ignoring = isFarOutside(axis) || (ignoring && outside);
        m_drives.drive(axis).setIgnoreBounds(ignoring);
    }
}

// Where the drives were commanded to be. A drive that is still being taken over has no set-point.
AxisPosition MoteusMount::heldPlace() const
{
    const auto of = [this](Axis axis) {
        const Angle setpoint = m_setpoints[index(axis)].position;
        const bool engaged = m_drives.drive(axis).phase() == Drive::Phase::Engaged;
        return engaged ? setpoint : m_drives.measured(axis).value_or(setpoint);
    };
    return {.azimuth = of(Axis::Azimuth), .elevation = of(Axis::Elevation)};
}

std::optional<Angle> MoteusMount::takeFollowing(Axis axis)
{
    if (!m_drives.drive(axis).takeEngaged()) {
        return std::nullopt;
    }
    const auto place = m_drives.measured(axis);
    if (place) {
        m_watches[index(axis)].engaged();
    } else {
        m_drives.drive(axis).hold();  // its set-point is still at an old position
    }
    return place;
}

void MoteusMount::command(Axis axis, const tracking::Setpoint& setpoint)
{
    m_setpoints[index(axis)] = setpoint;
    m_drives.setSetpoint(axis, setpoint);
}

void MoteusMount::recover()
{
    for (const Axis axis : axes()) {
        if (m_drives.drive(axis).latched()) {
            m_drives.drive(axis).recover();
        }
    }
}

void MoteusMount::rearmed()
{
    for (const Axis axis : axes()) {
        m_alarms.clear(alarmEntry("drive.fault").of(axis));
        m_watches[index(axis)].rearmed();
    }
}

// Some settings cause fault 41 when they are written to an active drive, and the axis falls. Storing any setting holds
// the drive up.
Result<> MoteusMount::mayBeWritten() const
{
    for (const Axis axis : axes()) {
        if (isSwitchedOn(m_drives.drive(axis))) {
            return failure(ErrorCode::Refused,
                           Text::tr("The %1 is switched on. Support the elevation and switch the drives off first.")
                               .arg(label(axis)));
        }
    }
    return {};
}

Result<> MoteusMount::mayBeTuned(Axis axis) const
{
    return has(axis) ? available() : failure(ErrorCode::NotAvailable, Text::tr("No moteus turns this axis."));
}

Result<> MoteusMount::maySwitchOff(Axis axis) const
{
    if (!has(axis)) {
        return failure(ErrorCode::NotAvailable, Text::tr("No moteus turns this axis."));
    }
    return isSwitchedOn(m_drives.drive(axis))
               ? Result<>{}
               : failure(ErrorCode::Refused, Text::tr("The %1 is switched off already.").arg(label(axis)));
}

// Axes of another rotator stay as they are. If only one axis is switched off, the other stays as it is, too: its drive
// gets its last set-point in each tick.
QString MoteusMount::switchOff(std::optional<Axis> only)
{
    for (const Axis axis : axes()) {
        if (!only || axis == *only) {
            m_drives.drive(axis).release();
        }
    }
    if (!only) {
        m_third.leave(profile::OnExit::Off);
    }
    return !only && axes().size() == kAxes.size()
               ? Text::tr("switches the drives off, so nothing holds the mount")
               : Text::tr("switches the %1 off, so nothing holds its axis").arg(label(only.value_or(axes().front())));
}

QString MoteusMount::leaveBus()
{
    m_busLeft = true;
    m_third.setReleased(true);
    for (const Axis axis : axes()) {
        m_drives.drive(axis).listen();
        m_turns.forget(axis);
        learn(axis, std::nullopt);
    }
    return Text::tr("releases the bus to other tools. Drives that are on continue in their time-out mode");
}

Result<> MoteusMount::mayTakeBus() const
{
    return m_busLeft ? Result<>{} : failure(ErrorCode::Refused, Text::tr("the bus is not released to other tools"));
}

Result<> MoteusMount::takeBus()
{
    return mayTakeBus().map([this] {
        m_busLeft = false;
        m_third.setReleased(false);
        m_started = m_clock.now();  // the drives have received no query yet
    });
}

Result<> MoteusMount::mayChooseWrap(Axis axis) const
{
    if (!has(axis)) {
        return failure(ErrorCode::NotAvailable, Text::tr("No moteus turns this axis."));
    }
    return m_turns.mayChoose(axis, m_drives.drive(axis));
}

Result<> MoteusMount::chooseWrap(Axis axis, Angle angle, const QString& source)
{
    return mayChooseWrap(axis).and_then([&] { return m_turns.choose(axis, angle, m_drives.drive(axis), source); });
}

Result<> MoteusMount::mayProve(AngularRate rate, const TravelRange& azimuths, const TravelRange& elevations)
{
    if (rate < kSlowestProof || rate > kFastestProof) {
        return failure(ErrorCode::OutOfRange, Text::tr("the rate of a crash-stop test must be %1 to %2°/s")
                                                  .arg(toQString(formatFixed(kSlowestProof.degrees(), 1)),
                                                       toQString(formatFixed(kFastestProof.degrees(), 1))));
    }
    return CrashStopProof::prepare(rate, *measured(), azimuths, elevations, axes())
        .map([this](const CrashStopProof& proof) { m_nextProof = proof; });
}

void MoteusMount::beginProof()
{
    if (m_nextProof) {
        m_proof.begin(*std::exchange(m_nextProof, std::nullopt));
    }
}

}  // namespace boresight
