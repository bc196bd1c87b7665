// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/gs232_mount/gs232_mount.h"

#include "core/base/text.h"
#include "core/gs232/box_command.h"
#include "core/rotator_box/box_interlock.h"
#include "core/units/degrees_text.h"

namespace boresight::gs232 {
namespace {

// Common rotators turn at 6 °/s. With slower set-points the rotator would reach each target, stop and start again.
constexpr AngularRate kFastest = AngularRate::fromDegrees(6.0);

constexpr AxisCapabilities kAxis{
    .step = 1_deg, .miss = ObedienceWatch::kMet, .fastest = kFastest, .silence = Gs232Mount::kSilence};

Result<> fits(const profile::Profile& profile, const Capabilities& capabilities, Axis axis)
{
    if (!capabilities.has(axis)) {
        return {};
    }
    const TravelRange& reach = axis == Axis::Azimuth ? kAzimuthReach : kElevationReach;
    const TravelRange& travel = profile.axis(axis).geometry.travel;
    const TravelRange counts = stepsIn(travel, capabilities.axes[index(axis)]->step);
    if (travel.min >= reach.min && travel.max <= reach.max && counts.min <= counts.max) {
        return countsAsTheRotator(profile, axis);
    }
    return failure(ErrorCode::Refused,
                   Text::tr("The travel %1…%2 does not fit this rotator. It counts whole degrees of %3…%4. Change "
                            "%5.travel_min_deg and %5.travel_max_deg in the profile.")
                       .arg(degreesText(travel.min, 1), degreesText(travel.max, 1), degreesText(reach.min, 0),
                            degreesText(reach.max, 0), tableOf(axis)));
}

// The box reports a heading, so it does not know on which cable wrap it is. An axis that misses an end of a full turn
// would be reported at the other end.
Result<> fitsEsp32(const profile::Profile& profile, const Capabilities& capabilities)
{
    constexpr Angle kWidest = Angle::fromDegrees(350.0);
    const TravelRange& travel = profile.azimuth.geometry.travel;
    if (capabilities.has(Axis::Azimuth) && travel.max - travel.min > kWidest) {
        return failure(
            ErrorCode::Refused,
            Text::tr("The travel %1…%2 does not fit this rotator. This rotator reports a heading and no cable "
                     "wrap. So its travel may be at most %3 wide. Change azimuth.travel_min_deg and "
                     "azimuth.travel_max_deg in the profile.")
                .arg(degreesText(travel.min, 1), degreesText(travel.max, 1), degreesText(kWidest, 0)));
    }
    const Result<> counts = capabilities.has(Axis::Azimuth) ? countsAsTheRotator(profile, Axis::Azimuth) : Result<>{};
    return counts.and_then([&] { return fits(profile, capabilities, Axis::Elevation); });
}

QString digitsText(const esp32::Digits& digits)
{
    return Text::tr("system %1, gyroscope %2, accelerometer %3, magnetometer %4")
        .arg(digits.system)
        .arg(digits.gyroscope)
        .arg(digits.accelerometer)
        .arg(digits.magnetometer);
}

Angle middleOf(const TravelRange& travel)
{
    return travel.min + 0.5 * (travel.max - travel.min);
}

}  // namespace

Gs232Mount::Gs232Mount(const profile::InForce& profile, AlarmBoard& alarms, const AxisSet& axes)
    : BoxMount(profile, alarms, axes, asInProfile(kAxis, *profile), kAxis.step),
      m_interlock(fits(*profile, capabilities(), Axis::Azimuth).and_then([&] {
          return fits(*profile, capabilities(), Axis::Elevation);
      })),
      m_box(capabilities().has(Axis::Elevation) ? Question::Both : Question::Azimuth, profile->baud),
      m_esp32(middleOf(profile->azimuth.geometry.travel)),
      m_offsets(profile, alarms)
{}

void Gs232Mount::observe(SteadyTime now)
{
    m_now = now;
    if (!m_isEsp32 && m_box.speaksWords()) {
        m_isEsp32 = true;
        m_interlock = fitsEsp32(*profile(), capabilities());
    }
    if (m_isEsp32) {
        m_offsets.compare(m_esp32.offsets());
    }
    BoxMount::observe(now);
}

QString Gs232Mount::kind() const
{
    if (talk().proof() != RotatorTalk::Proof::Box) {
        return QStringLiteral("GS-232");
    }
    if (m_isEsp32) {
        return QStringLiteral("ESP32");
    }
    return m_box.dialect() == Dialect::A ? QStringLiteral("GS-232A") : QStringLiteral("GS-232B");
}

QString Gs232Mount::kindInWords() const
{
    return Text::tr("a GS-232 rotator");
}

QString Gs232Mount::condition() const
{
    const auto digits = m_esp32.digits(m_now);
    return digits ? Text::tr("Calibration of its sensor, 3 is best: %1").arg(digitsText(*digits)) : QString();
}

std::string Gs232Mount::sensorOffsets() const
{
    return m_esp32.offsets() ? esp32::offsetsText(*m_esp32.offsets()) : std::string();
}

bool Gs232Mount::goTo(const RotatorTalk::Places& target)
{
    if (!m_isEsp32) {
        return goToBox(target);
    }
    goToEsp32(target);
    return true;
}

void Gs232Mount::goToEsp32(const RotatorTalk::Places& target)
{
    if (target.azimuth && capabilities().has(Axis::Azimuth)) {
        m_esp32.go(Axis::Azimuth, *target.azimuth);
    }
    if (target.elevation && capabilities().has(Axis::Elevation)) {
        m_esp32.go(Axis::Elevation, *target.elevation);
    }
}

// There is no command for the elevation alone.
bool Gs232Mount::goToBox(const RotatorTalk::Places& target)
{
    if (!target.azimuth) {
        return false;  // the command needs an azimuth, and it is unknown
    }
    const auto command =
        capabilities().has(Axis::Elevation)
            ? gs232::goTo({.azimuth = *target.azimuth, .elevation = target.elevation.value_or(Angle{})})
            : goToAzimuth(*target.azimuth);
    if (!command) {
        return false;  // outside the count of the box, which interlock() reports
    }
    m_box.go(*command);
    return true;
}

// The received bytes show what is wrong.
QString Gs232Mount::remedyOfNoAnswer() const
{
    if (const auto digits = m_esp32.digits(m_now); digits && digits->blocks) {
        return Text::tr(
                   "The box calibrates its sensor and answers nothing else. Move the antenna until all digits of "
                   "the box are 3. They are %1")
            .arg(digitsText(*digits));
    }
    if (m_box.echoes()) {
        return Text::tr(
            "The line returns what Boresight sends. Connect the rotator to it. If a modem is "
            "connected, switch the modem off");
    }
    if (m_box.refuses()) {
        return Text::tr(
            "The rotator refuses the question for both axes. If it has no elevation, set "
            "elevation.driver to \"none\"");
    }
    return Text::tr("Check the power of the rotator, the cable, and the speed (bus.baud, %1)").arg(profile()->baud);
}

}  // namespace boresight::gs232
