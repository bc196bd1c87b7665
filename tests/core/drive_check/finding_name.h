// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/drive_check/findings.h"

#include <array>
#include <cstddef>
#include <string>

// The name of a finding in tests, for example "drives.missing.elevation".
namespace boresight::drive_check {

[[nodiscard]] inline std::string nameOf(const Finding& finding)
{
    constexpr std::array kNames{"none", "missing", "shared-id", "foreign-board", "swapped", "other",
                                "map",  "unread",  "unstored",  "dangerous",     "advised"};
    const std::string name = std::string("drives.") + kNames.at(static_cast<std::size_t>(finding.kind));
    return finding.about.isEmpty() ? name : name + "." + finding.about.toStdString();
}

}  // namespace boresight::drive_check
