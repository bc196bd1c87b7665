// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/profile/in_force.h"

#include "core/profile/profile_diff.h"

#include <utility>

namespace boresight::profile {

InForce::InForce(const Profile& profile) : m_value(std::make_shared<const Profile>(profile)), m_wanted(m_value) {}

void InForce::apply(const Profile& wanted)
{
    Application application = applied(*m_value, wanted);
    m_value = std::make_shared<const Profile>(std::move(application.inForce));
    m_waitingKeys = std::move(application.waitingKeys);
    m_wanted = std::make_shared<const Profile>(wanted);
}

}  // namespace boresight::profile
