// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/targets/target_path.h"

#include <optional>

// A target over the site as a screen shows it: where it stands, when it is up, and whether the station waits for its
// rise. A rise is looked for seldom, because that takes some milliseconds. It belongs to one thread.
namespace boresight::targets {

class TargetPlace
{
public:
    TargetPlace(const Target& target, const Site& site, ephemeris::RefractionRule rule);

    void setRule(ephemeris::RefractionRule rule);  // rises and sets are looked for again
    void look(UtcTime now);

    [[nodiscard]] const TargetPath& path() const { return m_path; }
    [[nodiscard]] const std::optional<SkyPointing>& direction() const { return m_direction; }
    [[nodiscard]] const std::optional<UpTime>& up() const { return m_up; }  // empty: not within a day
    // Whether the station would track it now, as far as its rise decides.
    [[nodiscard]] Result<> isSoon(UtcTime now) const;

private:
    QString m_name;
    TargetPath m_path;
    std::optional<SkyPointing> m_direction;
    std::optional<UpTime> m_up;
    Result<> m_isFound;  // the rise; else why there is none
    UtcTime m_lookedForAt{};
};

}  // namespace boresight::targets
