// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cross_check/sensor_watch.h"

#include "core/alarms/catalogue.h"
#include "core/base/numbers.h"
#include "core/base/text.h"
#include "core/units/degrees_text.h"

namespace boresight {
namespace {

const QString kWatchSource = QStringLiteral("sensor");  // in the log
// After its start the sensor waits for WiFi and for the time of day. Only then it sends data.
constexpr Seconds kFirstPatience{10.0};
constexpr Seconds kFrozen{5.0};
constexpr Angle kToldAnew = Angle::fromDegrees(1.0);

// Nearer to the zenith the heading may jump to the opposite side.
constexpr Angle kHighestCourse = Angle::fromDegrees(75.0);

orientation::JudgeSettings judgeSettings(const profile::Profile& profile)
{
    return {.lost = profile.sensor.lost,
            .azimuthSpeed = profile.azimuth.limits.speed,
            .elevationSpeed = profile.elevation.limits.speed,
            .declinationInSensor = profile.sensor.declinationInSensor};
}

// Whether anything in the profile shows where north is. If the zero of an axis itself was set to north, the profile
// does not show that.
bool holdsNorth(const profile::Profile& profile)
{
    return profile.pointing.azimuthOffset != Angle{} || profile.sensor.mounting.azimuthOffset != Angle{} ||
           wasSwung(profile.sensor);
}

QString doubtOfCalibration(const orientation::Orientation& value)
{
    if (!value.calibration) {
        return Text::tr("the sensor does not report the calibration of its compass");
    }
    return isTiedToNorth(*value.calibration)
               ? QString()
               : Text::tr("its compass is not calibrated (magnetometer %1, system %2 of 3)")
                     .arg(value.calibration->magnetometer)
                     .arg(value.calibration->system);
}

}  // namespace

SensorWatch::SensorWatch(const profile::InForce& profile, const Clock& clock, EventLog& log, AlarmBoard& alarms)
    : m_profile(profile),
      m_clock(clock),
      m_log(log),
      m_alarms(alarms),
      m_judge(judgeSettings(*profile)),
      m_inForce(profile->sensor),
      m_afterApply(profile->sensor)
{
    correct();
}

void SensorWatch::leaveOut(Axis axis)
{
    m_inForce.leaveOut(axis);
    m_afterApply.leaveOut(axis);
}

void SensorWatch::profileChanged(const profile::Profile& before, const profile::Profile& after)
{
    m_judge.setSettings(judgeSettings(after));
    m_inForce.judgeBy(after.sensor);
    m_afterApply.judgeBy(after.sensor);
    // A lasting disagreement survives a change of settings that affects neither readings nor directions of the axes.
    if (!readAlike(after.sensor, before.sensor) || after.pointing != before.pointing) {
        correct();
    }
}

void SensorWatch::setSiteDeclination(const std::optional<Result<Angle>>& declination, const QString& model,
                                     const QString& expiry)
{
    m_site = {.byModel = declination, .model = model, .expiry = expiry};
    correct();
}

// Starts the comparison again, because a wrong setting may have caused the old difference.
void SensorWatch::correct()
{
    m_inForce.convertBy(SensorToSky(settings(), m_site.of(settings())));
    correctProposed();
    m_currentLink.forget();
    ++m_breaks;
}

void SensorWatch::setProposed(const std::optional<calibration::SensorMounting>& mounting)
{
    if (mounting != m_proposed) {
        m_proposed = mounting;
        correctProposed();
    }
}

void SensorWatch::correctProposed()
{
    profile::SensorSettings proposed = settings();
    if (m_proposed) {
        setMounting(proposed, *m_proposed);
    }
    m_afterApply.convertBy(SensorToSky(proposed, m_site.of(settings())));
}

void SensorWatch::begin(const QString& source)
{
    m_source = {.name = source, .begun = m_clock.now()};
    m_judge.forget();
    m_inForce.forget();
    m_currentLink.forget();
    m_alarms.clear(alarmEntry("sensor.silent"));
    tellDisagreement();
}

void SensorWatch::take(const orientation::Orientation& value)
{
    const orientation::ValueFate fate = m_judge.take(value);
    if (fate == orientation::ValueFate::Dead) {
        return;
    }
    compare(value);
    if (fate == orientation::ValueFate::Used) {
        const bool followed =
            doubtOfCalibration(value).isEmpty() && m_inForce.directionOf(value).elevation < kHighestCourse;
        m_breaks += followed ? 0 : 1;
        note(value);
    }
}

void SensorWatch::compare(const orientation::Orientation& value)
{
    // Outliers are included: a sensor that was knocked over differs at once, and a single outlier never counts.
    m_inForce.take(value);
    m_afterApply.take(value);
    if (const auto difference = m_inForce.difference(Axis::Azimuth).now) {
        const bool agrees = abs(*difference) <= settings().disagreement && !m_inForce.difference(Axis::Azimuth).lasts;
        m_source.agreed = m_source.agreed || agrees;
        const auto latency = std::chrono::duration_cast<SteadyTime::duration>(settings().latency);
        m_currentLink.take(value.arrival - latency, settings().averaging, *difference);
    }
}

QString SensorWatch::doubtOf(const orientation::Orientation& value) const
{
    return m_inForce.isReliable(value) ? doubtOfCalibration(value)
                                       : Text::tr("steel disturbs its compass near %1 (result of the swing)")
                                             .arg(azimuthText(m_inForce.azimuthOf(value)));
}

void SensorWatch::note(const orientation::Orientation& value)
{
    if (!std::exchange(m_source.heard, true)) {
        m_log.add(Severity::Advisory, kWatchSource,
                  Text::tr("the orientation sensor sends data: %1").arg(m_source.name));
    }
    if (m_judge.restarts() > m_source.restartsTold) {
        m_source.restartsTold = m_judge.restarts();
        m_log.add(Severity::Warning, kWatchSource,
                  Text::tr("the orientation sensor restarted, so its calibration begins again"));
    }
    if (!value.unknown.empty() && !std::exchange(m_source.unknownTold, true)) {
        m_log.add(Severity::Advisory, kWatchSource,
                  Text::tr("its messages contain unknown fields: %1").arg(toQString(value.unknown)));
    }
}

void SensorWatch::tick(const std::optional<SkyPointing>& axes, double amperes,
                       const std::optional<SkyPointing>& proposed)
{
    if (m_source.name.isEmpty()) {
        return;
    }
    const SteadyTime now = m_clock.now();
    m_inForce.note(now, axes);
    m_afterApply.note(now, proposed);
    m_currentLink.note(now, amperes);
    if (m_judge.dead() || m_judge.presence(now) == orientation::Presence::Lost) {
        m_inForce.forget();
        m_afterApply.forget();
    }
    m_inForce.tick(now);
    m_afterApply.tick(now);
    tellPresence();
    tellDisagreement();
}

void SensorWatch::tellPresence()
{
    const SteadyTime now = m_clock.now();
    const orientation::Presence presence = m_judge.presence(now);
    const bool overdue =
        presence == orientation::Presence::Awaited && now - m_source.begun >= std::max(kFirstPatience, settings().lost);
    const bool absent = presence == orientation::Presence::Lost || overdue;
    if (absent || m_judge.dead()) {
        raiseAbsence();
        m_source.heard = false;
    } else if (m_source.heard) {
        m_alarms.clear(alarmEntry("sensor.silent"));
    }
}

void SensorWatch::raiseAbsence()
{
    if (m_judge.dead()) {
        m_alarms.raise(alarmEntry("sensor.dead"));
        return;
    }
    m_alarms.raise(
        alarmEntry("sensor.silent"),
        {m_source.name, m_source.status.problem.isEmpty() ? Text::tr("Check the power, WiFi and cable of the sensor")
                                                          : m_source.status.problem});
}

bool SensorWatch::isNorthUnknown() const
{
    return !holdsNorth(*m_profile) && !m_source.agreed;
}

bool SensorWatch::disagrees(Axis axis) const
{
    const bool expected = axis == Axis::Azimuth && isNorthUnknown();
    // An active alarm ends only after a value has agreed with the proposal.
    const SensorCheck::Difference& proposed = m_afterApply.difference(axis);
    const bool agrees = proposed.now && !proposed.beyond;
    const bool explained = m_proposed && !proposed.lasts && (agrees || !m_told.stands);
    return m_inForce.difference(axis).lasts && !expected && !explained;
}

// Only an advisory, which makes no sound: it shows a new user what to do.
void SensorWatch::tellNorth()
{
    const SensorCheck::Difference& azimuth = m_inForce.difference(Axis::Azimuth);
    if (!azimuth.lasts || !isNorthUnknown()) {
        m_alarms.clear(alarmEntry("north.not-set"));
    } else if (const Angle apart = abs(azimuth.now.value_or(m_northTold.value_or(Angle{})));
               !m_alarms.active(alarmEntry("north.not-set")) || abs(apart - m_northTold.value_or(apart)) > kToldAnew) {
        m_northTold = apart;
        m_alarms.raise(alarmEntry("north.not-set"), {degreesText(apart)});
    }
}

void SensorWatch::tellDisagreement()
{
    tellNorth();
    const bool disagrees = this->disagrees();
    // Only after some motions it becomes visible that the difference follows the current. Then the alarm is raised
    // again and names the current as its cause.
    const bool byCurrent = this->disagrees(Axis::Azimuth) && m_currentLink.correlation();
    if (disagrees && (!m_told.stands || (byCurrent && !m_told.currentNamed) || hasChanged())) {
        raiseDisagreement();
    } else if (!disagrees && m_told.stands) {
        m_alarms.clear(alarmEntry("sensor.disagrees-azimuth"));
    }
    m_told.stands = disagrees;
    m_told.currentNamed = disagrees && (m_told.currentNamed || byCurrent);
}

Axis SensorWatch::axisInDoubt() const
{
    return disagrees(Axis::Azimuth) ? Axis::Azimuth : Axis::Elevation;
}

// The sentence follows the present difference, but not its small changes.
bool SensorWatch::hasChanged() const
{
    const Axis axis = axisInDoubt();
    const std::optional<Angle>& now = m_inForce.difference(axis).now;
    return m_told.axis != axis || (now && abs(abs(*now) - m_told.apart) > kToldAnew);
}

void SensorWatch::raiseDisagreement()
{
    const Axis axis = axisInDoubt();
    const Angle apart = abs(m_inForce.difference(axis).now.value_or(Angle{}));
    m_told.axis = axis;
    m_told.apart = apart;
    m_alarms.raise(
        axis == Axis::Azimuth ? alarmEntry("sensor.disagrees-azimuth") : alarmEntry("sensor.disagrees-elevation"),
        {degreesText(apart), causes(axis)});
}

QString SensorWatch::causes(Axis axis) const
{
    const auto frozen = m_judge.frozenSince();
    if (frozen && m_inForce.difference(axis).beganMoving && m_clock.now() - *frozen >= kFrozen) {
        return Text::tr("The sensor repeats one value to the last digit. Switch it off and on");
    }
    if (axis == Axis::Elevation) {
        return Text::tr(
            "Check the elevation offset and the mounting of the sensor. Check the elevation zero and the coupling");
    }
    if (const auto link = m_currentLink.correlation()) {
        return Text::tr(
                   "The difference follows the motor current, %1 per ampere (correlation %2). Move the sensor away "
                   "from motors and their cables, or twist the cables")
            .arg(degreesText(link->perAmpere))
            .arg(link->coefficient, 0, 'f', 2);
    }
    return m_inForce.difference(axis).beganMoving
               ? Text::tr(
                     "The difference began while the mount moved. Check the motor current, iron near the compass, the "
                     "azimuth direction of the sensor and the coupling")
               : Text::tr(
                     "Check the azimuth offset and the mounting of the sensor. Look for iron or a motor current near "
                     "the compass. Check the azimuth zero");
}

bool SensorWatch::isYoung() const
{
    const orientation::Presence presence = m_judge.presence(m_clock.now());
    return !m_judge.dead() && (presence == orientation::Presence::Present || presence == orientation::Presence::Late);
}

SensorStatus SensorWatch::status() const
{
    if (m_source.name.isEmpty()) {
        return {};
    }
    const SteadyTime now = m_clock.now();
    SensorStatus status{
        .source = m_source.name,
        .open = m_source.status.open,
        .problem = m_source.status.problem,
        .presence = m_judge.presence(now),
        .dead = m_judge.dead(),
        .last = m_judge.last(),
        .declination = m_inForce.toSky().correction.declination(),
        .declinationText = geomagnetism::describe(m_site.of(settings())),
        .declinationModel = m_site.model,
        .declinationDoubt = m_site.doubt(settings()),
        .azimuthDifference = m_inForce.difference(Axis::Azimuth).now,
        .elevationDifference = m_inForce.difference(Axis::Elevation).now,
        .disagrees = disagrees(),
        .turns = settings().mounting.sense == orientation::Sense::Clockwise ? m_judge.turns() : -m_judge.turns(),
        .outliers = m_judge.outliers(),
        .restarts = m_judge.restarts(),
        .counts = m_source.status.counts};
    if (status.last) {
        status.age = std::chrono::duration_cast<std::chrono::milliseconds>(now - status.last->arrival);
        status.doubt = doubtOf(*status.last);
        status.direction = isYoung() ? std::optional(m_inForce.directionOf(*status.last)) : std::nullopt;
        if (status.direction && m_inForce.toSky().deviation && m_inForce.isReliable(*status.last)) {
            status.azimuthSigma = azimuthSigma(*m_inForce.toSky().deviation, *status.direction);
        }
    }
    return status;
}

SensorEvidence SensorWatch::evidence() const
{
    const auto last = m_judge.last();
    if (!last || !isYoung()) {
        return {};
    }
    const SkyPointing direction = m_inForce.directionOf(*last);
    return {.azimuth = doubtOf(*last).isEmpty() ? std::optional(direction.azimuth) : std::nullopt,
            .elevation = isLevel(*last) ? std::optional(direction.elevation) : std::nullopt,
            .course = course(*last)};
}

// The true azimuth, on the turn given by the count of the headings.
std::optional<SensorCourse> SensorWatch::course(const orientation::Orientation& last) const
{
    const SkyPointing direction = m_inForce.directionOf(last);
    if (!doubtOfCalibration(last).isEmpty() || direction.elevation >= kHighestCourse) {
        return std::nullopt;
    }
    orientation::Orientation zero = last;
    zero.heading = {};
    const bool clockwise = settings().mounting.sense == orientation::Sense::Clockwise;
    const Angle about = m_inForce.directionOf(zero).azimuth + (clockwise ? m_judge.course() : -m_judge.course());
    return SensorCourse{.unbroken = m_judge.breaks() + m_breaks, .azimuth = direction.azimuth.nearestTo(about)};
}

}  // namespace boresight
