// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"

#include <QString>

#include <string>

// Checks of what follows the prefix in the name of an output or of an input. Pure, any thread.
namespace boresight::contacts {

// One line of at most 1000 bytes, without control characters.
[[nodiscard]] Result<> checkLine(const std::string& text);
// A path from / on, which names no folder.
[[nodiscard]] Result<QString> checkedPath(const QString& path);
// A topic of an MQTT broker. MQTT reserves topics that begin with '$' for the broker. '+' and '#' stand for several
// topics.
[[nodiscard]] Result<QString> checkedTopic(const QString& topic);

}  // namespace boresight::contacts
