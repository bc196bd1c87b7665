// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/profile/profile.h"

#include <QString>

#include <string>
#include <vector>

// What a profile asks of its mount that is permitted and still hardly meant: brakes that are none, an acceleration that
// no torque gives. It is reported with its numbers and never refused, because the mount alone knows. Pure.
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
