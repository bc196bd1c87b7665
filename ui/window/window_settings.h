// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/rotator_offer.h"
#include "core/units/sky.h"
#include "ui/charts/strip_frame.h"
#include "ui/guide/guide_progress.h"
#include "ui/kit/theme.h"
#include "ui/passes/passes_layout.h"

#include <QString>
#include <QStringList>

#include <vector>

// How the window looks, kept from one run to the next; its size and place are kept besides.
namespace boresight::ui {

struct WindowLayout
{
    int panel = 1;       // in front, by the digit of its key
    int mountPanel = 6;  // the same within Mount
    ChartChoice charts;
    PassesLayout passes;
};

}  // namespace boresight::ui

// What the window is told once, by value, when it is built. Everything that can change while the program runs comes
// with the status.
namespace boresight::ui {

struct WindowSettings
{
    ThemeKind theme = ThemeKind::Day;
    Brightness brightness = Brightness::High;
    QString language;  // what was chosen (ui/language.h); the texts have it already
    GuideProgress guide;
    bool alarmSound = true;   // at a new alarm, once; silence is the operator's choice
    QStringList recentGoTos;  // of an earlier start, the newest first: "113.50 10.00"
    WindowLayout layout;
    QString stateDir;                    // with logs and memory, for the diagnostics
    QString configDir;                   // with the profiles of the mounts; empty: none are kept
    std::vector<RotatorOffer> rotators;  // that the guide offers
    bool onlySimulated = false;          // the command line says so: every mount is, whatever bus its profile names
};

}  // namespace boresight::ui
