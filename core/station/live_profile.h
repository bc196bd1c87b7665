// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/profile/profile_diff.h"

#include <memory>
#include <string>
#include <vector>

// The profile in force, what was applied and waits for a new connection, and the one that has both. Everybody who shows
// the profile is given the very object that is obeyed. Station thread only; the object itself never changes.
namespace boresight {

class LiveProfile
{
public:
    explicit LiveProfile(const profile::Profile& profile)
        : m_inForce(std::make_shared<const profile::Profile>(profile)), m_wanted(profile)
    {}

    // What changed, by key; what applies now is in force from here on.
    std::vector<profile::Change> apply(const profile::Profile& wanted)
    {
        auto changes = profile::changesBetween(m_wanted, wanted);
        profile::Application application = profile::applied(*m_inForce, wanted);
        m_inForce = std::make_shared<const profile::Profile>(std::move(application.inForce));
        m_waitingKeys = std::move(application.waitingKeys);
        m_wanted = wanted;
        return changes;
    }

    [[nodiscard]] const std::shared_ptr<const profile::Profile>& inForce() const { return m_inForce; }
    [[nodiscard]] const profile::Profile& wanted() const { return m_wanted; }
    [[nodiscard]] const std::vector<std::string>& waitingKeys() const { return m_waitingKeys; }

private:
    std::shared_ptr<const profile::Profile> m_inForce;
    profile::Profile m_wanted;
    std::vector<std::string> m_waitingKeys;
};

}  // namespace boresight
