// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/alarms/alarm_board.h"
#include "core/alarms/event_log.h"
#include "core/base/clock.h"
#include "core/control/helm.h"
#include "core/guards/sun_alarms.h"
#include "core/guards/sun_watch.h"
#include "core/motion/motion.h"
#include "core/pointing/mount_model.h"
#include "core/pointing/permitted_region.h"
#include "core/profile/in_force.h"

#include <optional>

// Keeps the permitted region of the beam up to date: the limits of the profile, and a keep-out around the Sun. The
// keep-out is renewed as the Sun moves. Whatever obeys the region obeys the keep-out as well. While the clock is
// doubted, the keep-out is a band across the sky, of all places that the Sun can have. A motion that is no longer
// permitted ends. A mount that stands where the region forbids it, for example because the Sun moved there, stays and
// raises an alarm. Station thread only.
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

    // At the start of the program: the region of the profile, and the present position of the Sun.
    void begin();
    void profileChanged(const profile::Profile& before, const profile::Profile& after);
    // Another antenna is in use, or the beam of the antenna changed.
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
    std::optional<pointing::PermittedRegion> m_limits;  // of the profile, without the Sun
    pointing::PointingTerms m_terms;                    // with which m_limits was made
    SunWatch m_sun;
    SunAlarms m_sunAlarms;
};

}  // namespace boresight
