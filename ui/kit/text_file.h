// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"

#include <QString>

namespace boresight::ui {

// Writes the whole file, or leaves the old one unchanged.
[[nodiscard]] Result<> saveText(const QString& path, const QString& text);

}  // namespace boresight::ui
