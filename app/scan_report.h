// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/drive_check/bus_scan.h"

#include <QStringList>

#include <span>
#include <string>

// The result of a scan of a bus, in words. Pure.
namespace boresight::app {

using drive_check::FoundController;

// One line per controller, every number with its unit. "?" stands for a value that was not reported. Lines end with LF.
[[nodiscard]] std::string table(std::span<const FoundController> controllers);

// For a bus with simulated boards, above the table. Without a final LF.
[[nodiscard]] QString simulatedText();

// The problems and their remedies, one paragraph each without a final LF. Empty: no problem.
[[nodiscard]] QStringList problems(std::span<const FoundController> controllers);

// The text for a scan without answers: what to check.
[[nodiscard]] QString silenceText(const QString& bus);

}  // namespace boresight::app
