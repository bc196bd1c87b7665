// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

// A setting of a drive that protects the mount, as it is shown: what it should be, what was found. Plain values.
namespace boresight {

enum class Verdict
{
    Unread,
    Right,
    Advised,    // works, but is worth fixing
    Dangerous,  // nothing moves before it is right
};

// One setting of a drive that protects the mount.
struct ProtectionLine
{
    QString key;     // as the drive calls it
    QString wanted;  // with its unit: "-0.258 turns (-93.0°)"
    QString found;   // empty while unread
    // The same two where there is little room: "-93.0°".
    QString wantedBrief;
    QString foundBrief;
    QString reason;  // why it matters, for the operator
    QString fix;     // what Fix would write, with its unit; empty: it is right, or only a person may change it
    Verdict verdict = Verdict::Unread;
    // A bound of a drive that counts against the axis: its lower one is the axis's upper.
    bool reversed = false;

    bool operator==(const ProtectionLine&) const = default;
};

// Worth fixing, by Fix or by a person.
[[nodiscard]] inline bool differs(const ProtectionLine& line)
{
    return line.verdict == Verdict::Advised || line.verdict == Verdict::Dangerous;
}

}  // namespace boresight
