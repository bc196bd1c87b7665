// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

// What a survey of the drives tells the operator: plain values, made on the station thread, shown on the screen.
namespace boresight::survey {

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
    QString key;     // as the drive calls it: "servopos.position_min"
    QString wanted;  // with its unit: "-0.258 turns"
    QString found;   // empty while unread
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

enum class SurveyState
{
    NotDone,  // nobody answers, or the bus was lost since
    Running,  // scan, identification or reading
    Fixing,   // settings are being written
    Done,
};

struct DriveIdentity
{
    QString uuid;      // 8-4-4-4-12 digits; empty while unknown
    QString firmware;  // "1.1.0"
    int registerMap = 0;

    bool operator==(const DriveIdentity&) const = default;
};

// A board on the bus that is none of ours.
struct Stranger
{
    int id = 0;
    DriveIdentity identity;

    bool operator==(const Stranger&) const = default;
};

enum class FindingWeight
{
    Advice,
    Warning,
    Blocking,  // nothing moves before it is mended
};

enum class FindingKind
{
    NobodyAnswers,
    Missing,      // the board of an axis
    SharedId,     // by two boards
    Stranger,     // a board that the profile does not know
    Swapped,      // the ids of the axes
    OtherBoard,   // than before, for an axis
    RegisterMap,  // that is not known here
    Unread,       // the settings of an axis
    NotStored,    // a setting of an axis
    Dangerous,    // settings of an axis, as the verdict
    Advised
};

// What the operator should know of the drives. It is the same trouble as long as it is of one kind about one thing.
struct Finding
{
    FindingKind kind = FindingKind::NobodyAnswers;
    QString about;  // "elevation", or the id of a board; may be empty
    FindingWeight weight = FindingWeight::Warning;
    QString what;
    QString remedy;

    bool operator==(const Finding&) const = default;
};

}  // namespace boresight::survey
