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

// The arrangement of the window, kept for the next run. Its size and place are stored separately.
namespace boresight::ui {

struct WindowLayout
{
    int panel = 1;       // the front panel, by the digit of its key
    int mountPanel = 6;  // the same behind the tab Mount
    ChartChoice charts;
    PassesLayout passes;
};

}  // namespace boresight::ui

// The values that the window receives once, when it is built. Everything that can change while the program runs comes
// with the status.
namespace boresight::ui {

struct WindowSettings
{
    ThemeKind theme = ThemeKind::Day;
    Brightness brightness = Brightness::High;
    QString language;  // the chosen language (ui/language.h); the texts are already in it
    GuideProgress guide;
    bool alarmSound = true;   // at a new alarm, once; the operator can switch it off
    QStringList recentGoTos;  // of an earlier start, the newest first: "113.50 10.00"
    WindowLayout layout;
    QString stateDir;                    // with logs and journal, for the diagnostics
    QString configDir;                   // with the profiles of the mounts; empty: no profiles are stored
    std::vector<RotatorOffer> rotators;  // that the guide offers
    // set by the command line: every mount is simulated, whatever bus its profile names
    bool onlySimulated = false;
};

}  // namespace boresight::ui
