// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

// The errors of Hamlib in plain words. Pure.
namespace boresight::rotctl {

// `code` as rotctld reports it: negative. A clause without a full stop, with the number of Hamlib behind it.
[[nodiscard]] QString errorInWords(int code);
// The rotator cannot do this at all, so asking again is of no use.
[[nodiscard]] bool isUnavailable(int code);

}  // namespace boresight::rotctl
