// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/base/result.h"
#include "core/calibration/sensor_offset.h"
#include "core/north/axis_trace.h"
#include "core/orientation/orientation.h"
#include "core/profile/profile.h"

#include <QString>

#include <vector>

// One measurement of north with the sensor while the mount stands still: collects readings for a while and averages
// them. Moves nothing. Pure; station thread.
namespace boresight {

class OffsetRun
{
public:
    // A sensor that reports once a second sends twice the readings that an average needs.
    static constexpr Seconds kDuration{20.0};

    explicit OffsetRun(SteadyTime now) : m_started(now) {}

    // `about`: the axes at the time of the heading. `declination`: from magnetic to true north.
    void take(const orientation::Orientation& value, const AxesThen& about, const profile::Profile& profile,
              Angle declination);

    [[nodiscard]] bool done(SteadyTime now) const { return passed(now) >= kDuration; }
    [[nodiscard]] double part(SteadyTime now) const;
    [[nodiscard]] Seconds left(SteadyTime now) const;
    [[nodiscard]] QString text() const;
    // Refused with the reason if the readings do not give a result.
    [[nodiscard]] Result<calibration::SensorOffset> outcome(const profile::SensorSettings& settings,
                                                            Angle declination) const;

private:
    [[nodiscard]] Seconds passed(SteadyTime now) const { return now - m_started; }

    SteadyTime m_started;
    std::vector<calibration::SensorReading> m_readings;
};

}  // namespace boresight
