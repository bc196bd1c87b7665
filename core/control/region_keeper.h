// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/alarms/alarm_board.h"
#include "core/alarms/event_log.h"
#include "core/base/clock.h"
#include "core/control/helm.h"
#include "core/control/sun_alarms.h"
#include "core/control/sun_watch.h"
#include "core/motion/motion.h"
#include "core/pointing/mount_model.h"
#include "core/pointing/permitted_region.h"
#include "core/profile/in_force.h"

#include <optional>

// Keeps in force where the beam may be: the limits of the profile, and a keep-out around the Sun that is renewed as the
// Sun moves. So everything that obeys the region obeys the keep-out. While the clock is doubted the keep-out is a band
// across the sky, the places that the Sun can have. A motion that is not permitted any more ends. A mount that stands
// while the Sun comes over it stays, and raises an alarm. So does one that stands where the limits forbid it. Station
// thread only.
namespace boresight {

class RegionKeeper
{
public:
    struct Parts
    {
        const profile::InForce& profile;
        const AntennaChoice& antenna;
        const Clock& clock;
        pointing::MountModel& model;
        Motion& motion;
        Helm& helm;
        AlarmBoard& alarms;
        EventLog& log;
    };

    explicit RegionKeeper(const Parts& parts);

    // The program begins with the region of the profile and the Sun of now.
    void begin();
    void profileChanged(const profile::Profile& before, const profile::Profile& after);
    // Another antenna is in use, or its beam is another one.
    void antennaChanged();
    // Once in a tick.
    void step();

    [[nodiscard]] const SunWatch& sun() const { return m_sun; }

private:
    void renew(bool redrawn);
    void enforce();
    void layOutLimits();
    [[nodiscard]] std::optional<Angle> distanceToSun(const AxisPosition& measured) const;
    void watchPlace(const std::optional<AxisPosition>& measured);
    void end(const QString& why);

    Parts m_of;
    std::optional<pointing::PermittedRegion> m_limits;  // of the profile alone, without the Sun
    pointing::PointingTerms m_terms;                    // of which it is laid out
    SunWatch m_sun;
    SunAlarms m_sunAlarms;
};

}  // namespace boresight
