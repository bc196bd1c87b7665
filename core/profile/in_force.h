// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/profile/profile.h"

#include <memory>
#include <string>
#include <vector>

// The profile in force, for all code that reads settings. The value itself never changes: apply() replaces it by a new
// one. The station owns the only InForce, and only the station calls apply(). All other code has a const reference and
// reads a setting where it is used, so a change counts from the next use on. An object that must react to a change has
// a function profileChanged(before, after), which the station calls after apply(). InForce also keeps the wanted
// profile: the profile as it was applied, with the settings that wait for Reconnect. Station thread only. It is created
// before its readers and outlives them. Another thread gets shared() with the status.
namespace boresight::profile {

class InForce
{
public:
    explicit InForce(const Profile& profile);
    InForce(const InForce&) = delete;
    InForce& operator=(const InForce&) = delete;

    // Puts the settings that apply at once into force. The others wait for Reconnect (waitingKeys()).
    void apply(const Profile& wanted);

    // The reference is valid until the next apply().
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
