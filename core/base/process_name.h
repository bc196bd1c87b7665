// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <string>

// Names another program for the text of a refusal.
namespace boresight {

// For example "tview (process 1234)".
[[nodiscard]] QString processText(const QString& name, const QString& number);
// The name of the process with this number, from /proc. "another program" if `number` is empty.
[[nodiscard]] QString nameOfProcess(const std::string& number);

}  // namespace boresight
