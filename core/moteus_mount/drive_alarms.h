// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/alarms/alarm_entry.h"
#include "core/base/text.h"
#include "core/moteus_mount/drive.h"
#include "core/supervision/symptom.h"

#include <QString>

#include <optional>
#include <string_view>

// The alarms about a drive. `drive` is the label of the drive: "azimuth drive". Pure.
namespace boresight::drive_alarms {

// `advice`: what to do about a silent bus, if the kind of the bus is known. Otherwise empty.
[[nodiscard]] AlarmCase silenced(const QString& drive, Seconds watchdog, const QString& advice);
// The drive does not reply, and it was not under our commands.
[[nodiscard]] AlarmCase unheard(const QString& drive, const QString& advice, bool needsRearm);
// The drive answers again and waits for a re-arm. `moved`: how far its axis moved meanwhile. Empty if not known.
[[nodiscard]] AlarmCase answersAgain(const QString& drive, Seconds silent, const std::optional<Angle>& moved);
// The same three for both drives at the same time.
[[nodiscard]] AlarmCase bothSilenced(Seconds watchdog, const QString& advice);
[[nodiscard]] AlarmCase noneHeard(const QString& advice, bool needsRearm);
[[nodiscard]] AlarmCase bothAnswerAgain(Seconds silent, const std::optional<Angle>& azimuth,
                                        const std::optional<Angle>& elevation);
[[nodiscard]] AlarmCase timedOutByStall(const QString& drive, Seconds stalled);
// For every loss but Silent, for which silenced() knows more.
[[nodiscard]] AlarmCase lost(const QString& drive, DriveLoss loss, int faultCode);
// The temperatures that a drive reports, in °C. Empty: not reported.
struct Heat
{
    std::optional<double> board;
    std::optional<double> motor;
};
// A fault by heat. `then`: at the fault. The remedy shows how the drive cools down.
[[nodiscard]] AlarmCase tooHot(const QString& drive, int faultCode, const Heat& then, const Heat& now);
[[nodiscard]] AlarmCase activeLimit(const QString& drive, int code, const Heat& now);
[[nodiscard]] QString limitClause(int code);  // added to a sentence of core/supervision
[[nodiscard]] AlarmCase supervised(const supervision::Observed& observed);
// The alarm that warns of the symptom. If it has no warning, the alarm that stops the mount.
[[nodiscard]] const AlarmEntry& entryOf(supervision::Symptom symptom);
[[nodiscard]] AlarmCase unordered(const QString& drive, moteus::Mode mode);

}  // namespace boresight::drive_alarms
