// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"
#include "ui/kit/symbol.h"

#include <QString>

// The state of the drive check, and whether it lets the mount move: one line each, with colour and symbol.
namespace boresight::ui {

struct Sentence
{
    QString text;
    Tone tone = Tone::Secondary;
    Symbol symbol = Symbol::None;
};

[[nodiscard]] Sentence driveCheckSentence(const DrivesStatus& drives);
[[nodiscard]] Sentence armingSentence(const StationStatus& status);

}  // namespace boresight::ui
