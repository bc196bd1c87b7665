// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/protection_line.h"
#include "core/profile/profile.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

// The settings of a drive that protect the mount, and what a profile wants of each. The drive is to be a second limit
// that holds without this program: every line says what happens if it is wrong. Pure values.
namespace boresight::survey {

inline constexpr int kTimeoutHold = 10;  // servo.timeout_mode: brake, then hold

// What was read of one key.
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

    // NaN is the drive's "none"; empty for what is no number.
    [[nodiscard]] std::optional<double> value() const;
    bool operator==(const Reading&) const = default;
};

struct Protection
{
    std::string key;
    QString unit;
    QString wanted;
    QString wantedBrief{};  // where there is little room; empty: as it is
    std::function<bool(double)> isRight;
    Verdict otherwise = Verdict::Advised;
    std::optional<double> remedy;  // what Fix writes; empty: only a person may change it
    QString reason;                // for the operator
    // What a particular wrong value does, instead of the reason; may be absent.
    std::function<QString(double)> consequence;
    // The value as the operator thinks of it, behind the drive's own; may be absent.
    std::function<QString(double)> explain;
    bool isAngle = false;   // a narrow line shows only explain()
    bool reversed = false;  // see ProtectionLine
};

// In the order in which they are shown.
[[nodiscard]] std::vector<Protection> protectionsOf(const profile::Profile& profile, Axis axis);

// "-0.258333 turns (-93°)".
[[nodiscard]] QString foundText(const Protection& protection, const Reading& reading);
[[nodiscard]] ProtectionLine judged(const Protection& protection, const Reading& reading);

// The value as `conf set` takes it, and whether what reads back is that value.
[[nodiscard]] std::string settingText(double value);
[[nodiscard]] bool tookEffect(double written, const Reading& reading);

[[nodiscard]] QString axisName(Axis axis);  // "azimuth", in the cause of an alarm
[[nodiscard]] QString axisText(Axis axis);  // the same in a sentence

}  // namespace boresight::survey
