// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/help_page.h"

#include "ui/theme.h"

#include <QDialogButtonBox>
#include <QGridLayout>
#include <QLabel>

namespace boresight::ui {

namespace {

struct Line
{
    const char* key;
    const char* does;
};

// The keys of the window; MainWindow and JogPad act on them.
constexpr Line kLines[] = {
    {QT_TRANSLATE_NOOP("HelpPage", "Pause, F12"), QT_TRANSLATE_NOOP("HelpPage", "STOP from anywhere")},
    {QT_TRANSLATE_NOOP("HelpPage", "Esc"),
     QT_TRANSLATE_NOOP("HelpPage", "close the menu or dialog, cancel a drag; else STOP")},
    {QT_TRANSLATE_NOOP("HelpPage", "arrows"),
     QT_TRANSLATE_NOOP("HelpPage", "jog while held, after a click on the pad; up and down move elevation")},
    {QT_TRANSLATE_NOOP("HelpPage", "Shift + arrow"), QT_TRANSLATE_NOOP("HelpPage", "jog fast")},
    {QT_TRANSLATE_NOOP("HelpPage", "Ctrl + arrow"), QT_TRANSLATE_NOOP("HelpPage", "one step")},
    {QT_TRANSLATE_NOOP("HelpPage", "Ctrl+G"), QT_TRANSLATE_NOOP("HelpPage", "to the go-to fields; Enter = Go")},
    {QT_TRANSLATE_NOOP("HelpPage", "Ctrl+H"), QT_TRANSLATE_NOOP("HelpPage", "hold")},
    {QT_TRANSLATE_NOOP("HelpPage", "Ctrl+P"), QT_TRANSLATE_NOOP("HelpPage", "park")},
    {QT_TRANSLATE_NOOP("HelpPage", "Ctrl+1 … Ctrl+5"),
     QT_TRANSLATE_NOOP("HelpPage", "panels Jog, Charts, Limits, Clients, Log")},
    {QT_TRANSLATE_NOOP("HelpPage", "Ctrl+6, Ctrl+7"),
     QT_TRANSLATE_NOOP("HelpPage", "the mount itself: Drives, Protection")},
    {QT_TRANSLATE_NOOP("HelpPage", "Ctrl+9"),
     QT_TRANSLATE_NOOP("HelpPage", "which turn is the axis on? (while asked)")},
    {QT_TRANSLATE_NOOP("HelpPage", "Ctrl+L"),
     QT_TRANSLATE_NOOP("HelpPage", "charts in the place of the sky, and back")},
    {QT_TRANSLATE_NOOP("HelpPage", "Ctrl+E"),
     QT_TRANSLATE_NOOP("HelpPage", "change the limits on the plot: drag (Shift: 0.1°), + adds, Del removes")},
    {QT_TRANSLATE_NOOP("HelpPage", "Ctrl+0, Ctrl++, Ctrl+-"),
     QT_TRANSLATE_NOOP("HelpPage", "magnify the plot around the target; also the wheel")},
    {QT_TRANSLATE_NOOP("HelpPage", "F8"), QT_TRANSLATE_NOOP("HelpPage", "acknowledge the alarms")},
    {QT_TRANSLATE_NOOP("HelpPage", "Ctrl+D"), QT_TRANSLATE_NOOP("HelpPage", "theme: day, night, red")},
    {QT_TRANSLATE_NOOP("HelpPage", "F11"), QT_TRANSLATE_NOOP("HelpPage", "full screen")},
    {QT_TRANSLATE_NOOP("HelpPage", "F1"), QT_TRANSLATE_NOOP("HelpPage", "this page")},
};

}  // namespace

HelpPage::HelpPage(QWidget* parent) : QDialog(parent)
{
    setWindowTitle(tr("Keys"));
    auto* const grid = new QGridLayout(this);
    grid->setHorizontalSpacing(18);
    int row = 0;
    for (const Line& line : kLines) {
        auto* const key = new QLabel(tr(line.key), this);
        key->setFont(fonts::small());
        auto* const does = new QLabel(tr(line.does), this);
        does->setFont(fonts::label());
        grid->addWidget(key, row, 0);
        grid->addWidget(does, row++, 1);
    }
    auto* const drives =
        new QLabel(tr("Drives: who is on the bus, the bus for other tools, and how each axis stops when not fed.\n"
                      "Protection: ■ dangerous settings keep the mount from moving; Fix writes them, with the\n"
                      "drives switched off. ▲ Turn?: until it is answered only slow jogging is possible."),
                   this);
    drives->setFont(fonts::label());
    grid->addWidget(drives, row++, 0, 1, 2);
    auto* const stop = new QLabel(tr("STOP is a function of this program: the mount slows down and holds. It does not\n"
                                     "replace the hard-wired emergency stop beside the mast."),
                                  this);
    stop->setFont(fonts::label());
    grid->addWidget(stop, row++, 0, 1, 2);
    auto* const buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    grid->addWidget(buttons, row, 0, 1, 2);
}

}  // namespace boresight::ui
