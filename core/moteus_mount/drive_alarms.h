// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/alarms/alarm_entry.h"
#include "core/base/text.h"
#include "core/moteus_mount/drive.h"
#include "core/supervision/symptom.h"

#include <QString>

#include <optional>
#include <string_view>

// Which alarm it is when something is wrong with a drive. `drive` is its label: "azimuth drive". Pure.
namespace boresight::drive_alarms {

// `advice`: what to do about a silent bus, when its kind is known; else empty.
[[nodiscard]] AlarmCase silenced(const QString& drive, Seconds watchdog, const QString& advice);
// Nothing was commanded.
[[nodiscard]] AlarmCase unheard(const QString& drive, const QString& advice, bool needsRearm);
// It answers again and waits for a re-arm. `moved`: its axis, meanwhile; empty if that is not known.
[[nodiscard]] AlarmCase answersAgain(const QString& drive, Seconds silent, const std::optional<Angle>& moved);
// The same three of both drives at the same time.
[[nodiscard]] AlarmCase bothSilenced(Seconds watchdog, const QString& advice);
[[nodiscard]] AlarmCase noneHeard(const QString& advice, bool needsRearm);
[[nodiscard]] AlarmCase bothAnswerAgain(Seconds silent, const std::optional<Angle>& azimuth,
                                        const std::optional<Angle>& elevation);
[[nodiscard]] AlarmCase timedOutByStall(const QString& drive, Seconds stalled);
// Of a silent drive silenced() knows more.
[[nodiscard]] AlarmCase lost(const QString& drive, DriveLoss loss, int faultCode);
[[nodiscard]] AlarmCase activeLimit(const QString& drive, int code);
[[nodiscard]] QString limitClause(int code);  // added to a sentence of the supervision
[[nodiscard]] AlarmCase supervised(const supervision::Observed& observed);
// Of the alarm that warns of it, or else stops the mount for it.
[[nodiscard]] const AlarmEntry& entryOf(supervision::Symptom symptom);
[[nodiscard]] AlarmCase unordered(const QString& drive, moteus::Mode mode);

}  // namespace boresight::drive_alarms
