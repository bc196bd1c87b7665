// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <string>

// Another program, in the words of a refusal.
namespace boresight {

// "tview (process 1234)"
[[nodiscard]] QString processText(const QString& name, const QString& number);
// By its number, as /proc shows it; "another program" if that is empty.
[[nodiscard]] QString nameOfProcess(const std::string& number);

}  // namespace boresight
