// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

// What a survey of the drives found out of order: plain values, made on the station thread, raised as alarms.
namespace boresight::survey {

enum class FindingWeight
{
    Advice,
    Warning,
    Blocking,  // nothing moves before it is fixed
};

enum class FindingKind
{
    NobodyAnswers,
    Missing,      // the board of an axis
    SharedId,     // by two boards
    Stranger,     // a board that the profile does not know
    Swapped,      // the ids of the axes
    OtherBoard,   // than before, for an axis
    RegisterMap,  // unknown to Boresight
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
