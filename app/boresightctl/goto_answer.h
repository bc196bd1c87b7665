// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/units/sky.h"

#include <QString>

// What the station made of the target of goto, in words for the operator. Pure.
namespace boresight::ctl {

struct GotoAnswer
{
    bool goesThere = true;  // false: the mount goes to another direction than the target
    QString text;
};

// `outcome` is the answer of the station to get_outcome (core/rotctld/HAMLIB.md): empty if the mount goes to the target
// as it was sent, or if the server does not report it.
[[nodiscard]] GotoAnswer gotoAnswer(const SkyPointing& asked, const QString& outcome);

}  // namespace boresight::ctl
