// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/protection_line.h"
#include "core/profile/profile.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

// The safety settings of a drive and the values that a profile wants. With these settings the drive protects the mount
// also without this program. Every line names the effect of a wrong value. Pure values.
namespace boresight::drive_check {

inline constexpr int kTimeoutHold = 10;  // servo.timeout_mode: brake, then hold

// The reading of one key.
struct Reading
{
    enum class State
    {
        Unread,
        Unknown,  // the firmware does not have the key
        Read,
    };
    State state = State::Unread;
    std::string text{};  // as the drive wrote it

    // NaN for the "none" of the drive. Empty if the text is no number.
    [[nodiscard]] std::optional<double> value() const;
    bool operator==(const Reading&) const = default;
};

struct Protection
{
    std::string key;
    QString unit;
    QString wanted;
    QString wantedBrief{};  // for narrow places; empty: the same as `wanted`
    std::function<bool(double)> isRight;
    Verdict otherwise = Verdict::Advised;
    std::optional<double> remedy;  // the value that Fix writes; empty: only a person may change it
    QString reason;                // for the operator
    // The effect of a particular wrong value, shown in place of `reason`. May be absent.
    std::function<QString(double)> consequence;
    // The value in units of the operator, shown after the value of the drive. May be absent.
    std::function<QString(double)> explain;
    bool isAngle = false;  // a narrow line shows only explain()
    // The drive counts opposite to the axis, so the lower bound of the drive is the upper bound of the axis.
    bool reversed = false;
};

// In the order in which they are shown.
[[nodiscard]] std::vector<Protection> protectionsOf(const profile::Profile& profile, Axis axis);

// "-0.258333 turns (-93°)".
[[nodiscard]] QString foundText(const Protection& protection, const Reading& reading);
[[nodiscard]] ProtectionLine judged(const Protection& protection, const Reading& reading);

// settingText(): the value in the form for `conf set`. tookEffect(): true if the value that reads back is the written
// one.
[[nodiscard]] std::string settingText(double value);
[[nodiscard]] bool tookEffect(double written, const Reading& reading);

[[nodiscard]] QString axisName(Axis axis);  // "azimuth", in the cause of an alarm
[[nodiscard]] QString axisText(Axis axis);  // the same, translated, for a sentence

}  // namespace boresight::drive_check
