// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/calibration_record.h"
#include "core/control/station_control.h"

#include <array>
#include <optional>

// Which mount this is: the identity of its two drives, as far as it is known, and the site of the profile. A
// calibration and its points are valid for one mount only. Station thread only.
namespace boresight {

class MountIdentity
{
public:
    // Control and profile must outlive it.
    MountIdentity(const StationControl& control, const profile::InForce& profile)
        : m_control(control), m_profile(profile)
    {}

    // Reads what the drives report. True: at least one drive has a new identity.
    [[nodiscard]] bool update();
    // Both drives were read. This includes a drive that reports no identity.
    [[nodiscard]] bool bothRead() const;
    [[nodiscard]] calibration::RecordMount today() const;

private:
    const StationControl& m_control;
    const profile::InForce& m_profile;
    std::array<std::optional<QString>, 2>
        m_drives;  // the UUIDs of the drives: an empty text if a drive reports none, no value if it was not read yet
};

}  // namespace boresight
