// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

// A safety setting of a drive as the screen shows it: the wanted value and the value in the drive. Plain values.
namespace boresight {

enum class Verdict
{
    Unread,
    Right,
    Advised,    // works, but is worth fixing
    Dangerous,  // nothing moves until it is corrected
};

// One setting of a drive that protects the mount.
struct ProtectionLine
{
    QString key;     // as the drive calls it
    QString name;    // for the operator: "Lower limit"
    QString wanted;  // with its unit: "-0.258 turns (-93.0°)"
    QString found;   // empty: not read
    // Short forms of both for narrow places: "-93.0°".
    QString wantedBrief;
    QString foundBrief;
    QString reason;  // why the setting matters, for the operator
    QString fix;     // the value that Fix would write, with its unit; empty: Fix does not change this setting
    Verdict verdict = Verdict::Unread;

    bool operator==(const ProtectionLine&) const = default;
};

// True if the setting should be corrected, by Fix or by a person.
[[nodiscard]] inline bool differs(const ProtectionLine& line)
{
    return line.verdict == Verdict::Advised || line.verdict == Verdict::Dangerous;
}

}  // namespace boresight
