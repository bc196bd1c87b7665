// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace boresight {

// The mount's name as the name of a file: letters, digits, '-' and '_' stay; a name with anything else also gets a few
// digits of its hash, so that two mounts never share a file.
[[nodiscard]] QString safeFileName(const QString& mountName);

}  // namespace boresight
