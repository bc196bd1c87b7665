// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/profile/profile.h"

#include <QString>

#include <string>
#include <vector>

// Finds settings that are permitted but probably wrong, such as a brake that is too weak or an acceleration that needs
// too much torque. They are reported with their numbers and never refused, because they may be right for a mount. Pure.
namespace boresight::profile {

struct Advice
{
    std::string key;  // "azimuth.max_acceleration_deg_s2"
    QString what;     // with the numbers, one sentence
    QString remedy;   // what to do, one sentence

    bool operator==(const Advice&) const = default;
};

[[nodiscard]] std::vector<Advice> adviceOn(const Profile& profile);

}  // namespace boresight::profile
