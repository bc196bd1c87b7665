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

// Which antenna of the mount is in use: all directions are those of its beam. The operator chooses one. While a
// satellite is tracked that has an antenna of its own, that one is in use. Whatever ends the tracking may itself have
// sent the beam somewhere, so it stays in use until the mount rests. After a start it is the main one: what is chosen
// is not kept, so that the mount points as its profile says. Moves nothing. Station thread only.
namespace boresight {

class AntennaChoice
{
public:
    // What the station tracks by itself.
    struct Tracked
    {
        std::optional<std::int64_t> satellite;  // whose own antenna counts
        bool isOver = false;
    };

    // `changed` is called when another antenna is in use, or the same one with another beam. All outlive this.
    AntennaChoice(const profile::InForce& profile, EventLog& log, std::function<void()> changed);

    [[nodiscard]] const pointing::Antenna& inUse() const { return m_inUse; }
    [[nodiscard]] pointing::Antenna chosen() const { return m_profile->antenna(m_chosen); }
    // By which its beam points.
    [[nodiscard]] pointing::PointingTerms terms() const { return m_profile->termsOf(m_inUse); }
    // The same once another profile is in force: another antenna may then be in use.
    [[nodiscard]] pointing::PointingTerms termsBy(const profile::Profile& after) const
    {
        return after.termsOf(after.antenna(wanted(after)));
    }
    // As far as the beam of another antenna of the mount can be from it.
    [[nodiscard]] Angle spread() const;
    [[nodiscard]] const std::optional<Tracked>& tracked() const { return m_tracked; }
    [[nodiscard]] bool tracks() const { return m_tracked && !m_tracked->isOver; }

    // By hand, and for the satellite that is tracked now as well. Refused with the names of the profile: it has no such
    // antenna.
    Result<> choose(const std::string& name);
    void track(const std::optional<Tracked>& tracked);
    void endTracking();
    // The mount rests: what is not tracked any more chooses no antenna.
    void release();
    // The antenna may have another name, another beam, or be gone: then it is the main one.
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
