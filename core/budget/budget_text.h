// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/budget/error_budget.h"

#include <QString>

#include <optional>

// A budget in words, for screen and shell. Pure, any thread.
namespace boresight::budget {

[[nodiscard]] QString nameOf(ErrorPart part);    // "Age of elements"
[[nodiscard]] QByteArray keyOf(ErrorPart part);  // as other programs read it: "elements"
// "-0.1 dB", "0.0 dB". Empty: the error is beyond the main lobe.
[[nodiscard]] QString lossText(const std::optional<double>& loss);
// "0.04°", "at least 0.04°".
[[nodiscard]] QString sumText(const ErrorBudget& budget);
// "Off by 0.04° (-0.1 dB)", "Off by at least 0.04° (-0.1 dB)", "Off by 20.00° (beyond the main lobe)".
[[nodiscard]] QString offByText(const ErrorBudget& budget);
// "0.040°", "unknown", and for the wind "not in the sum".
[[nodiscard]] QString errorText(const ErrorLine& line);
// One line for each part, and the sum: "Servo: 0.040°. Measured: …".
[[nodiscard]] QString listText(const ErrorBudget& budget);

}  // namespace boresight::budget
