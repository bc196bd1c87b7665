// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/units/sky.h"
#include "ui/strip_frame.h"
#include "ui/theme.h"

#include <QString>

#include <array>

// How the window looks, kept from one run to the next; its size and place are kept besides.
namespace boresight::ui {

struct WindowLayout
{
    int panel = 1;       // in front, by the digit of its key
    int mountPanel = 6;  // the same within Mount
    ChartChoice charts;
};

}  // namespace boresight::ui

// What the window is told once, by value, when it is built. Rates and angles are those of the axes; everything that
// can change while the program runs comes with the status.
namespace boresight::ui {

struct WindowSettings
{
    AngularRate slow = 0.5_deg_s;
    AngularRate normal = 2_deg_s;
    AngularRate fast = 6_deg_s;
    AngularRate unwind = 2_deg_s;  // while it is not known on which turn an axis stands
    std::array<Angle, 3> steps{0.1_deg, 1_deg, 5_deg};
    AxisPosition park;  // shown in the tooltip of Park
    ThemeKind theme = ThemeKind::Day;
    QString language;        // what was chosen (ui/language.h); the texts have it already
    bool alarmSound = true;  // at a new alarm, once; silence is the operator's choice
    WindowLayout layout;
    QString stateDir;   // with logs and memory, for the diagnostics
    QString configDir;  // with the profiles of the mounts; empty: none are kept
};

}  // namespace boresight::ui
