// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/alarms/event_log.h"
#include "core/base/result.h"
#include "core/pointing/antenna.h"
#include "core/profile/in_force.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

// Which antenna of the mount is in use. Every direction that Boresight reads or shows is a direction of its beam. The
// operator chooses an antenna. A satellite can have an antenna of its own, which is in use while the satellite is
// tracked. The motion that ends the tracking may have been meant for that beam, so the antenna stays in use until the
// mount stands still. After a start the main antenna is in use: the choice is not stored, so the mount points as its
// profile says. Moves nothing. Station thread only.
namespace boresight {

class AntennaChoice
{
public:
    // A target that the station tracks by itself.
    struct Tracked
    {
        std::optional<std::int64_t> satellite;  // its own antenna is used; empty: the chosen one is
        bool isOver = false;
    };

    // `changed` is called when another antenna is in use, or when the beam of the same antenna differs. The arguments
    // outlive this.
    AntennaChoice(const profile::InForce& profile, EventLog& log, std::function<void()> changed);

    [[nodiscard]] const pointing::Antenna& inUse() const { return m_inUse; }
    [[nodiscard]] pointing::Antenna chosen() const { return m_profile->antenna(m_chosen); }
    // The pointing terms for the antenna in use.
    [[nodiscard]] pointing::PointingTerms terms() const { return m_profile->termsOf(m_inUse); }
    // The pointing terms that would apply with the profile `after`, in which another antenna may be in use.
    [[nodiscard]] pointing::PointingTerms termsBy(const profile::Profile& after) const
    {
        return after.termsOf(after.antenna(wanted(after)));
    }
    // The largest angle between the beam in use and the beam of any other antenna of the mount.
    [[nodiscard]] Angle spread() const;
    [[nodiscard]] const std::optional<Tracked>& tracked() const { return m_tracked; }
    [[nodiscard]] bool tracks() const { return m_tracked && !m_tracked->isOver; }

    // The operator's choice. It also replaces the antenna of the satellite that is tracked now. An unknown name is
    // refused, and the refusal lists the antennas of the profile.
    Result<> choose(const std::string& name);
    void track(const std::optional<Tracked>& tracked);
    void endTracking();
    // The mount stands still. If the tracking of a satellite has ended, its antenna is not used any more.
    void release();
    // The antenna may have another name or another beam in `after`. If it is gone, the main antenna is in use.
    void profileChanged(const profile::Profile& before, const profile::Profile& after);

private:
    [[nodiscard]] Result<> isKnown(const std::string& name) const;
    void renew();
    [[nodiscard]] std::string wanted(const profile::Profile& by) const;

    const profile::InForce& m_profile;
    EventLog& m_log;
    std::function<void()> m_changed;
    std::string m_chosen = pointing::kMainAntenna;
    std::optional<Tracked> m_tracked;
    pointing::Antenna m_inUse;
};

}  // namespace boresight
