// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/help_page.h"

#include "ui/kit/caption.h"
#include "ui/kit/theme.h"

#include <QDialogButtonBox>
#include <QGridLayout>
#include <QLabel>

namespace boresight::ui {

namespace {

struct Line
{
    const char* key;  // null: the caption of the lines below
    const char* does;
};

// The keys of the window. MainWindow and JogPad handle them.
constexpr Line kLines[] = {
    {nullptr, QT_TRANSLATE_NOOP("boresight::ui::HelpPage", "Stop")},
    {QT_TRANSLATE_NOOP("boresight::ui::HelpPage", "Pause, F12"),
     QT_TRANSLATE_NOOP("boresight::ui::HelpPage", "STOP from anywhere")},
    {QT_TRANSLATE_NOOP("boresight::ui::HelpPage", "Esc"),
     QT_TRANSLATE_NOOP("boresight::ui::HelpPage", "leave a field, list, menu, card or question. The next Esc is STOP")},
    {nullptr, QT_TRANSLATE_NOOP("boresight::ui::HelpPage", "Move by hand")},
    {QT_TRANSLATE_NOOP("boresight::ui::HelpPage", "arrows"),
     QT_TRANSLATE_NOOP("boresight::ui::HelpPage", "move while held. First arm the pad (click it, or press Enter)")},
    {QT_TRANSLATE_NOOP("boresight::ui::HelpPage", "Shift + arrow"),
     QT_TRANSLATE_NOOP("boresight::ui::HelpPage", "move at the fast rate")},
    {QT_TRANSLATE_NOOP("boresight::ui::HelpPage", "Ctrl + arrow"),
     QT_TRANSLATE_NOOP("boresight::ui::HelpPage", "move one step, or trim the target of a client")},
    {QT_TRANSLATE_NOOP("boresight::ui::HelpPage", "Page Up, Page Down"),
     QT_TRANSLATE_NOOP("boresight::ui::HelpPage", "change the jog rate (on the slider, also with arrows, Home, End)")},
    {QT_TRANSLATE_NOOP("boresight::ui::HelpPage", "gamepad"),
     QT_TRANSLATE_NOOP("boresight::ui::HelpPage", "hold LB or RB and move the left stick. B is STOP")},
    {QT_TRANSLATE_NOOP("boresight::ui::HelpPage", "Ctrl+G"),
     QT_TRANSLATE_NOOP("boresight::ui::HelpPage", "go to the Az field. Enter starts the move")},
    {QT_TRANSLATE_NOOP("boresight::ui::HelpPage", "Ctrl+H, Ctrl+P"),
     QT_TRANSLATE_NOOP("boresight::ui::HelpPage", "hold the position, park")},
    {nullptr, QT_TRANSLATE_NOOP("boresight::ui::HelpPage", "Panels")},
    {QT_TRANSLATE_NOOP("boresight::ui::HelpPage", "Ctrl+1 … Ctrl+5"),
     QT_TRANSLATE_NOOP("boresight::ui::HelpPage", "Jog, Charts, Limits, Clients, Log")},
    {QT_TRANSLATE_NOOP("boresight::ui::HelpPage", "Ctrl+T"), QT_TRANSLATE_NOOP("boresight::ui::HelpPage", "Passes")},
    {QT_TRANSLATE_NOOP("boresight::ui::HelpPage", "Ctrl+6 … Ctrl+8"),
     QT_TRANSLATE_NOOP("boresight::ui::HelpPage", "Mount: Drives, Protection, Profile")},
    {QT_TRANSLATE_NOOP("boresight::ui::HelpPage", "Ctrl+9"),
     QT_TRANSLATE_NOOP("boresight::ui::HelpPage", "North, or the question about the cable wrap")},
    {QT_TRANSLATE_NOOP("boresight::ui::HelpPage", "F3, Alt+Left, Alt+Right"),
     QT_TRANSLATE_NOOP("boresight::ui::HelpPage", "commissioning guide, its steps")},
    {QT_TRANSLATE_NOOP("boresight::ui::HelpPage", "Ctrl+F"),
     QT_TRANSLATE_NOOP("boresight::ui::HelpPage", "search the settings (in Profile)")},
    {QT_TRANSLATE_NOOP("boresight::ui::HelpPage", "F8"),
     QT_TRANSLATE_NOOP("boresight::ui::HelpPage", "acknowledge the alarms")},
    {nullptr, QT_TRANSLATE_NOOP("boresight::ui::HelpPage", "Sky and charts")},
    {QT_TRANSLATE_NOOP("boresight::ui::HelpPage", "Ctrl+E"),
     QT_TRANSLATE_NOOP("boresight::ui::HelpPage",
                       "edit the limits on the sky: drag (Shift: 0.1°), + adds, Del removes")},
    {QT_TRANSLATE_NOOP("boresight::ui::HelpPage", "Ctrl+0, Ctrl++, Ctrl+-"),
     QT_TRANSLATE_NOOP("boresight::ui::HelpPage", "magnify the sky around the target (also the wheel)")},
    {nullptr, QT_TRANSLATE_NOOP("boresight::ui::HelpPage", "Window")},
    {QT_TRANSLATE_NOOP("boresight::ui::HelpPage", "F10, Alt"),
     QT_TRANSLATE_NOOP("boresight::ui::HelpPage", "open the menu")},
    {QT_TRANSLATE_NOOP("boresight::ui::HelpPage", "Ctrl+D"),
     QT_TRANSLATE_NOOP("boresight::ui::HelpPage", "next theme: day, night, red")},
    {QT_TRANSLATE_NOOP("boresight::ui::HelpPage", "F11"), QT_TRANSLATE_NOOP("boresight::ui::HelpPage", "full screen")},
    {QT_TRANSLATE_NOOP("boresight::ui::HelpPage", "Ctrl+B"),
     QT_TRANSLATE_NOOP("boresight::ui::HelpPage", "save diagnostics for a bug report")},
    {QT_TRANSLATE_NOOP("boresight::ui::HelpPage", "F1, Shift+F1"),
     QT_TRANSLATE_NOOP("boresight::ui::HelpPage", "manual, this page")},
};

}  // namespace

HelpPage::HelpPage(QWidget* parent) : QDialog(parent)
{
    setWindowTitle(tr("Keys"));
    auto* const grid = new QGridLayout(this);
    grid->setHorizontalSpacing(3 * kGrid);
    grid->setVerticalSpacing(1);
    int row = 0;
    for (const Line& line : kLines) {
        if (line.key == nullptr) {
            grid->addWidget(makeGroupCaption(tr(line.does), this), row++, 0, 1, 2);
            continue;
        }
        QLabel* const key = makeCaption(tr(line.key), this);
        key->setFont(fonts::small());
        grid->addWidget(key, row, 0);
        grid->addWidget(makeCaption(tr(line.does), this), row++, 1);
    }
    grid->addWidget(makeCaption(tr("STOP is a function of this program: the mount slows down and holds its position.\n"
                                   "It does not replace the hard-wired emergency stop beside the mast."),
                                this),
                    row++, 0, 1, 2);
    auto* const buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    grid->addWidget(buttons, row, 0, 1, 2);
}

}  // namespace boresight::ui

#include "moc_help_page.cpp"
