// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/north/proposals.h"
#include "tests/core/control/station_rig.h"

// The parts of the calibration that hold data, without runs and requests: mount, model, points and proposals. The
// history is kept in memory only.
namespace boresight {

struct NorthRig : public StationRig
{
    NorthRig()
    {
        profile.sensor.source = profile::SensorSource::Simulated;
        inForce.apply(profile);
        [[maybe_unused]] const bool isNew = mount.update();
    }

    // Does what Apply does.
    void apply(calibration::CalibrationRecord record)
    {
        record.when = std::chrono::floor<std::chrono::milliseconds>(clock.utc());
        record.mount = mount.today();
        record.terms.before = profile.pointing;
        profile.pointing = record.terms.after;
        inForce.apply(profile);
        file.add(std::move(record));
    }

    CalibrationFile file{QString()};
    MountIdentity mount{control, inForce};
    ModelInForce model{file, inForce, mount, clock};
    KeptPoints points{control, file, mount, model, clock, log};
    LiveSensor sensor{inForce, clock};
    Proposals proposals{inForce, sensor, model, points, log};
};

}  // namespace boresight
