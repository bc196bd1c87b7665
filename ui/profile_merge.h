// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/profile/profile.h"

#include <span>
#include <string>
#include <vector>

// Two profiles compared and joined setting by setting. A list (horizon, keep-outs, presets) counts as one setting: its
// entries mean something only together. Pure.
namespace boresight::ui {

// The keys that differ, as setting.h names them, and of the lists "limits.horizon", "limits.keep_out", "presets".
[[nodiscard]] std::vector<std::string> changedKeys(const profile::Profile& from, const profile::Profile& to);

// `into` takes these settings over from `from`.
void takeOver(profile::Profile& into, const profile::Profile& from, std::span<const std::string> keys);

}  // namespace boresight::ui
