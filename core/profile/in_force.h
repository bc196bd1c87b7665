// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/profile/profile.h"

#include <memory>
#include <string>
#include <vector>

// The profile in force, for everybody who obeys it. The value itself never changes: apply() puts another one in its
// place. The station owns the only InForce, and nobody else calls apply(). All others are given a const reference and
// read a setting where they use it, so that it counts from the next use on. Whoever must react to a change has
// profileChanged(before, after), which the station calls after apply(). Also has what is wanted: the profile as it was
// applied, with all that waits for a new connection. Station thread only; it is made before its readers and outlives
// them. Another thread gets shared(), with the status.
namespace boresight::profile {

class InForce
{
public:
    explicit InForce(const Profile& profile);
    InForce(const InForce&) = delete;
    InForce& operator=(const InForce&) = delete;

    // What applies now is in force from here on.
    void apply(const Profile& wanted);

    // A reference into it is good until the next apply().
    [[nodiscard]] const Profile& operator*() const { return *m_value; }
    [[nodiscard]] const Profile* operator->() const { return m_value.get(); }
    [[nodiscard]] const std::shared_ptr<const Profile>& shared() const { return m_value; }

    [[nodiscard]] const Profile& wanted() const { return *m_wanted; }
    [[nodiscard]] const std::vector<std::string>& waitingKeys() const { return m_waitingKeys; }

private:
    std::shared_ptr<const Profile> m_value;
    std::shared_ptr<const Profile> m_wanted;
    std::vector<std::string> m_waitingKeys;
};

}  // namespace boresight::profile
