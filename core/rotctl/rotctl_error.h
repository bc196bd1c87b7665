// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

// The errors of Hamlib as texts. Pure.
namespace boresight::rotctl {

// `code`: as rotctld reports it, negative. The text is a clause without a full stop, with the number of Hamlib at its
// end.
[[nodiscard]] QString errorInWords(int code);
// The rotator does not have this function, so repeating the command is useless.
[[nodiscard]] bool isUnavailable(int code);

}  // namespace boresight::rotctl
