// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace boresight {

// The mount's name as a file name: letters, digits, '-' and '_' stay. A name with any other character also gets a few
// digits of its hash, so that two mounts never share a file.
[[nodiscard]] QString safeFileName(const QString& mountName);

}  // namespace boresight
