// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/witness/sensor_watch.h"

#include "core/alarms/catalogue.h"
#include "core/base/numbers.h"
#include "core/base/text.h"
#include "core/units/degrees_text.h"

namespace boresight {
namespace {

const QString kWatchSource = QStringLiteral("sensor");  // of its lines in the log
// The sensor waits for its WiFi and the time before it says anything.
constexpr Seconds kFirstPatience{10.0};
// A compass below this is not tied to magnetic north, or about to lose it.
constexpr int kFewestMagnetometer = 2;
constexpr int kFewestSystem = 1;
constexpr int kFewestAccelerometer = 1;
constexpr Seconds kFrozen{5.0};

// Nearer to the zenith a heading jumps to the other side of the circle.
constexpr Angle kHighestCourse = Angle::fromDegrees(75.0);

orientation::JudgeSettings judgeSettings(const profile::Profile& profile)
{
    return {.lost = profile.sensor.lost,
            .azimuthSpeed = profile.azimuth.limits.speed,
            .elevationSpeed = profile.elevation.limits.speed,
            .declinationInSensor = profile.sensor.declinationInSensor};
}

SensorCheckSettings checkSettings(const profile::SensorSettings& sensor)
{
    return {.threshold = sensor.disagreement,
            .time = sensor.disagreementTime,
            .latency = sensor.latency,
            .averaging = sensor.averaging};
}

// Whatever tells where north is. An axis whose own zero was set to north tells nothing in the profile.
bool holdsNorth(const profile::Profile& profile)
{
    return profile.pointing.azimuthOffset != Angle{} || profile.sensor.mounting.azimuthOffset != Angle{} ||
           wasSwung(profile.sensor);
}

bool isTiedToNorth(const orientation::Calibration& calibration)
{
    return calibration.magnetometer >= kFewestMagnetometer && calibration.system >= kFewestSystem;
}

QString doubtOfCalibration(const orientation::Orientation& value)
{
    if (!value.calibration) {
        return Text::tr("the sensor does not tell how well its compass is calibrated");
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
      m_check(checkSettings(profile->sensor)),
      m_proposedCheck(checkSettings(profile->sensor))
{
    correct();
}

void SensorWatch::profileChanged(const profile::Profile& before, const profile::Profile& after)
{
    m_judge.setSettings(judgeSettings(after));
    m_check.setSettings(checkSettings(after.sensor));
    m_proposedCheck.setSettings(checkSettings(after.sensor));
    // A disagreement that lasts outlives settings that change no reading and no direction of the axes.
    if (!readAlike(after.sensor, before.sensor) || after.pointing != before.pointing) {
        correct();
    }
}

void SensorWatch::setSiteDeclination(const std::optional<Result<Angle>>& declination, const QString& model,
                                     const QString& expiry)
{
    m_siteDeclination = declination;
    m_model = model;
    m_modelExpiry = expiry;
    correct();
}

geomagnetism::Declination SensorWatch::declination() const
{
    geomagnetism::Declination declination{
        .by = settings().declinationBy, .inSensor = settings().declinationInSensor, .here = settings().declination};
    if (!settings().declinationFile.empty()) {
        declination.origin = geomagnetism::DeclinationOrigin::Model;
        const bool known = m_siteDeclination && *m_siteDeclination;
        declination.here = known ? std::optional(**m_siteDeclination) : std::nullopt;
    }
    return declination;
}

// A declination of exactly 0° was mostly not typed at all: it accuses nobody.
QString SensorWatch::doubtOfDeclination() const
{
    const bool byModel = !settings().declinationFile.empty();
    if (byModel && m_siteDeclination && !*m_siteDeclination) {
        return toQString(m_siteDeclination->error().text);
    }
    if (byModel && !m_modelExpiry.isEmpty()) {
        return m_modelExpiry;
    }
    return byModel || settings().declination != Angle{} ? geomagnetism::doubt(declination()) : QString();
}

// What was compared before is compared anew: the difference was perhaps that of a wrong setting.
void SensorWatch::correct()
{
    m_truth = SensorTruth(settings(), declination());
    correctProposed();
    m_check.forget();
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
    m_proposedTruth = SensorTruth(proposed, declination());
    m_proposedCheck.forget();
}

void SensorWatch::begin(const QString& source)
{
    m_name = source;
    m_source = {};
    m_begun = m_clock.now();
    m_judge.forget();
    m_check.forget();
    m_currentLink.forget();
    m_heard = false;
    m_agreed = false;
    m_unknownTold = false;
    m_restartsTold = 0;
    m_alarms.clear(alarmEntry("sensor.silent"));
    tellDisagreement();
}

void SensorWatch::take(const orientation::Orientation& value)
{
    const orientation::Verdict verdict = m_judge.take(value);
    if (verdict == orientation::Verdict::Dead) {
        return;
    }
    compare(value);
    if (verdict == orientation::Verdict::Used) {
        const bool followed =
            doubtOfCalibration(value).isEmpty() && m_truth.directionOf(value).elevation < kHighestCourse;
        m_breaks += followed ? 0 : 1;
        note(value);
    }
}

void SensorWatch::compare(const orientation::Orientation& value)
{
    // Outliers too: a sensor that was knocked over differs at once, and one outlier alone never counts.
    m_check.take(readingOf(value, m_truth));
    m_proposedCheck.take(readingOf(value, m_proposedTruth));
    if (const auto difference = m_check.difference(Axis::Azimuth).now) {
        const bool agrees = abs(*difference) <= settings().disagreement && !m_check.difference(Axis::Azimuth).lasts;
        m_agreed = m_agreed || agrees;
        const auto latency = std::chrono::duration_cast<SteadyTime::duration>(settings().latency);
        m_currentLink.take(value.arrival - latency, settings().averaging, *difference);
    }
}

SensorReading SensorWatch::readingOf(const orientation::Orientation& value, const SensorTruth& truth)
{
    const SkyPointing direction = truth.directionOf(value);
    const bool tied = !value.calibration || isTiedToNorth(*value.calibration);
    const bool level = !value.calibration || value.calibration->accelerometer >= kFewestAccelerometer;
    return {.direction = direction,
            .arrival = value.arrival,
            .azimuthCounts = tied && truth.isReliable(direction),
            .elevationCounts = level};
}

QString SensorWatch::doubtOf(const orientation::Orientation& value) const
{
    const SkyPointing direction = m_truth.directionOf(value);
    return m_truth.isReliable(direction)
               ? doubtOfCalibration(value)
               : Text::tr("steel steers its compass around %1: the swing found it unreliable there")
                     .arg(degreesText(direction.azimuth));
}

void SensorWatch::note(const orientation::Orientation& value)
{
    if (!std::exchange(m_heard, true)) {
        m_log.add(Severity::Advisory, kWatchSource, Text::tr("the orientation sensor is heard: %1").arg(m_name));
    }
    if (m_judge.restarts() > m_restartsTold) {
        m_restartsTold = m_judge.restarts();
        m_log.add(Severity::Warning, kWatchSource,
                  Text::tr("the orientation sensor has been restarted: its calibration begins anew"));
    }
    if (!value.unknown.empty() && !std::exchange(m_unknownTold, true)) {
        m_log.add(Severity::Advisory, kWatchSource,
                  Text::tr("its messages hold more than is known here: %1").arg(toQString(value.unknown)));
    }
}

void SensorWatch::tick(const std::optional<SkyPointing>& axes, double amperes,
                       const std::optional<SkyPointing>& proposed)
{
    if (m_name.isEmpty()) {
        return;
    }
    const SteadyTime now = m_clock.now();
    m_check.note(now, axes);
    m_proposedCheck.note(now, proposed);
    m_currentLink.note(now, amperes);
    if (m_judge.dead() || m_judge.presence(now) == orientation::Presence::Lost) {
        m_check.forget();
        m_proposedCheck.forget();
    }
    m_check.tick(now);
    m_proposedCheck.tick(now);
    tellPresence();
    tellDisagreement();
}

void SensorWatch::tellPresence()
{
    const SteadyTime now = m_clock.now();
    const orientation::Presence presence = m_judge.presence(now);
    const bool overdue =
        presence == orientation::Presence::Awaited && now - m_begun >= std::max(kFirstPatience, settings().lost);
    const bool absent = presence == orientation::Presence::Lost || overdue;
    if (absent || m_judge.dead()) {
        raiseAbsence();
        m_heard = false;
    } else if (m_heard) {
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
        {m_name, m_source.problem.isEmpty() ? Text::tr("Check its power, WiFi and cable") : m_source.problem});
}

bool SensorWatch::isNorthUnknown() const
{
    return !holdsNorth(*m_profile) && !m_agreed;
}

bool SensorWatch::disagrees(Axis axis) const
{
    const bool expected = axis == Axis::Azimuth && isNorthUnknown();
    // An alarm that stands goes only when a value has agreed with what is proposed.
    const SensorCheck::Difference& proposed = m_proposedCheck.difference(axis);
    const bool agrees = proposed.now && !proposed.beyond;
    const bool explained = m_proposed && !proposed.lasts && (agrees || !m_disagreed);
    return m_check.difference(axis).lasts && !expected && !explained;
}

// No beep, nothing amber: a newcomer is shown the way.
void SensorWatch::tellNorth()
{
    const SensorCheck::Difference& azimuth = m_check.difference(Axis::Azimuth);
    if (!azimuth.lasts || !isNorthUnknown()) {
        m_alarms.clear(alarmEntry("north.not-set"));
    } else if (!m_alarms.active(alarmEntry("north.not-set"))) {
        m_alarms.raise(alarmEntry("north.not-set"), {degreesText(abs(azimuth.now.value_or(Angle{})))});
    }
}

void SensorWatch::tellDisagreement()
{
    tellNorth();
    const bool disagrees = this->disagrees();
    // That it goes with the current shows after some motions only: then it is told again, with its cause.
    const bool byCurrent = this->disagrees(Axis::Azimuth) && m_currentLink.correlation();
    if (disagrees && (!m_disagreed || (byCurrent && !m_currentTold))) {
        raiseDisagreement();
    } else if (!disagrees && m_disagreed) {
        m_alarms.clear(alarmEntry("sensor.disagrees-azimuth"));
    }
    m_disagreed = disagrees;
    m_currentTold = disagrees && (m_currentTold || byCurrent);
}

void SensorWatch::raiseDisagreement()
{
    const Axis axis = disagrees(Axis::Azimuth) ? Axis::Azimuth : Axis::Elevation;
    const Angle apart = abs(m_check.difference(axis).now.value_or(Angle{}));
    m_alarms.raise(
        axis == Axis::Azimuth ? alarmEntry("sensor.disagrees-azimuth") : alarmEntry("sensor.disagrees-elevation"),
        {degreesText(apart), causes(axis)});
}

QString SensorWatch::causes(Axis axis) const
{
    const auto frozen = m_judge.frozenSince();
    if (frozen && m_check.difference(axis).beganMoving && m_clock.now() - *frozen >= kFrozen) {
        return Text::tr("The sensor repeats one value to the last digit. Switch it off and on");
    }
    if (axis == Axis::Elevation) {
        return Text::tr("Check the elevation offset and mounting of the sensor, the elevation zero and the coupling");
    }
    if (const auto link = m_currentLink.correlation()) {
        return Text::tr(
                   "It follows the motor current, %1 per ampere (correlation %2). Move the sensor away from motors and "
                   "their cables, or twist these")
            .arg(degreesText(link->perAmpere))
            .arg(link->coefficient, 0, 'f', 2);
    }
    return m_check.difference(axis).beganMoving
               ? Text::tr(
                     "It began while the mount moved. Check the motor current, iron near the compass, the azimuth "
                     "sense of the sensor and the coupling")
               : Text::tr(
                     "Check the azimuth offset and mounting of the sensor, iron near the compass and the azimuth zero");
}

bool SensorWatch::isYoung() const
{
    const orientation::Presence presence = m_judge.presence(m_clock.now());
    return !m_judge.dead() && (presence == orientation::Presence::Present || presence == orientation::Presence::Late);
}

SensorStatus SensorWatch::status() const
{
    if (m_name.isEmpty()) {
        return {};
    }
    const SteadyTime now = m_clock.now();
    SensorStatus status{
        .source = m_name,
        .open = m_source.open,
        .problem = m_source.problem,
        .presence = m_judge.presence(now),
        .dead = m_judge.dead(),
        .last = m_judge.last(),
        .declination = m_truth.correction.declination(),
        .declinationText = geomagnetism::describe(declination()),
        .declinationModel = m_model,
        .declinationDoubt = doubtOfDeclination(),
        .azimuthDifference = m_check.difference(Axis::Azimuth).now,
        .elevationDifference = m_check.difference(Axis::Elevation).now,
        .disagrees = disagrees(),
        .turns = settings().mounting.sense == orientation::Sense::Clockwise ? m_judge.turns() : -m_judge.turns(),
        .outliers = m_judge.outliers(),
        .restarts = m_judge.restarts(),
        .counts = m_source.counts};
    if (status.last) {
        status.age = std::chrono::duration_cast<std::chrono::milliseconds>(now - status.last->arrival);
        status.doubt = doubtOf(*status.last);
        status.direction = isYoung() ? std::optional(m_truth.directionOf(*status.last)) : std::nullopt;
        if (status.direction && m_truth.deviation && m_truth.isReliable(*status.direction)) {
            status.azimuthSigma = azimuthSigma(*m_truth.deviation, *status.direction);
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
    const SkyPointing direction = m_truth.directionOf(*last);
    const bool level = !last->calibration || last->calibration->accelerometer >= kFewestAccelerometer;
    return {.azimuth = doubtOf(*last).isEmpty() ? std::optional(direction.azimuth) : std::nullopt,
            .elevation = level ? std::optional(direction.elevation) : std::nullopt,
            .course = course(*last)};
}

// The true azimuth, on the turn that the count of the headings says.
std::optional<SensorCourse> SensorWatch::course(const orientation::Orientation& last) const
{
    const SkyPointing direction = m_truth.directionOf(last);
    if (!doubtOfCalibration(last).isEmpty() || direction.elevation >= kHighestCourse) {
        return std::nullopt;
    }
    orientation::Orientation zero = last;
    zero.heading = {};
    const bool clockwise = settings().mounting.sense == orientation::Sense::Clockwise;
    const Angle about = m_truth.directionOf(zero).azimuth + (clockwise ? m_judge.course() : -m_judge.course());
    return SensorCourse{.unbroken = m_judge.breaks() + m_breaks, .azimuth = direction.azimuth.nearestTo(about)};
}

}  // namespace boresight
