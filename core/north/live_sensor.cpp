// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/north/live_sensor.h"

#include "core/base/text.h"
#include "core/calibration/sensor_offset.h"

namespace boresight {
namespace {

// A sensor reports levels from 0 to 3.
constexpr int kCalibratedMagnetometer = 2;

}  // namespace

const orientation::Orientation* LiveSensor::take(const SensorStatus& sensor)
{
    m_declination = sensor.declination;
    m_restarts = sensor.restarts;
    m_problem = sensor.problem;
    if (!sensor.last || (m_last && sensor.last->arrival == m_last->arrival)) {
        return nullptr;
    }
    m_last = sensor.last;
    return &*m_last;
}

Result<> LiveSensor::isHeard() const
{
    const Seconds age = m_last ? Seconds(m_clock.now() - m_last->arrival) : Seconds(0.0);
    if (m_last && age <= m_profile->sensor.lost) {
        return {};
    }
    const QString silence =
        m_last ? Text::tr("The orientation sensor has sent nothing for %1 s.").arg(age.count(), 0, 'f', 0)
               : Text::tr("The orientation sensor has sent nothing yet.");
    return failure(ErrorCode::NoAnswer,
                   m_problem.isEmpty() ? silence : QStringLiteral("%1 (%2)").arg(silence, m_problem));
}

Result<> LiveSensor::isUsable() const
{
    if (m_profile->sensor.source == profile::SensorSource::None) {
        return failure(ErrorCode::NotAvailable, Text::tr("The profile has no orientation sensor."));
    }
    return isHeard().and_then([this]() -> Result<> {
        if (m_last->calibration && m_last->calibration->magnetometer < kCalibratedMagnetometer) {
            return failure(
                ErrorCode::Refused,
                Text::tr(
                    "Magnetometer calibration is only %1 of 3, but %2 is needed. Move the sensor in figures of eight.")
                    .arg(m_last->calibration->magnetometer)
                    .arg(kCalibratedMagnetometer));
        }
        return {};
    });
}

Result<> LiveSensor::isTiedToNorth() const
{
    return isUsable().and_then([this]() -> Result<> {
        return m_last->calibration ? calibration::isCalibrated(std::nullopt, m_last->calibration->system,
                                                               calibration::SensorOffsetLimits{}.calibration)
                                   : Result<>{};
    });
}

}  // namespace boresight
