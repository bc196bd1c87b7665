// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"

#include <string>

namespace boresight {

// The text of an error, in the form that gtest compares and prints.
[[nodiscard]] inline std::string textOf(const Error& error)
{
    return error.text.toStdString();
}

}  // namespace boresight
