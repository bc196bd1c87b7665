// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

// The problems that a check of the drives found: plain values, made on the station thread, raised as alarms.
namespace boresight::drive_check {

enum class FindingWeight
{
    Advice,
    Warning,
    Blocking,  // nothing moves before it is fixed
};

enum class FindingKind
{
    NobodyAnswers,
    Missing,       // no board for an axis
    SharedId,      // two boards have the same id
    UnknownBoard,  // a board that the profile does not know
    Swapped,       // the ids of the two axes are interchanged
    OtherBoard,    // an axis has another board than before
    RegisterMap,   // a register map that Boresight does not know
    Unread,        // the settings of an axis were not read
    NotStored,     // a setting of an axis was not stored
    Dangerous,     // settings of an axis with the verdict Dangerous
    Advised
};

// A message for the operator about the drives. Findings of the same kind about the same thing are the same trouble.
struct Finding
{
    FindingKind kind = FindingKind::NobodyAnswers;
    QString about;  // "elevation", or the id of a board; may be empty
    FindingWeight weight = FindingWeight::Warning;
    QString what;
    QString remedy;

    bool operator==(const Finding&) const = default;
};

}  // namespace boresight::drive_check
