// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/survey/bus_scan.h"

#include <QStringList>

#include <span>
#include <string>

// What a scan of a bus found, in words. Pure.
namespace boresight::app {

using survey::FoundController;

// One line per controller, units with every number; "?" is what it did not report. Lines end with LF.
[[nodiscard]] std::string table(std::span<const FoundController> controllers);

// What is wrong and what to do about it, one paragraph each without its LF; empty if all is in order.
[[nodiscard]] QStringList problems(std::span<const FoundController> controllers);

// Nobody answered: what to look at.
[[nodiscard]] QString silenceText(const QString& bus);

}  // namespace boresight::app
