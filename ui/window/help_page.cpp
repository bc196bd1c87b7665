// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/help_page.h"

#include "ui/kit/language.h"
#include "ui/kit/theme.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>

#include <algorithm>

namespace boresight::ui {

namespace {

struct Line
{
    const char* key;
    const char* does;
};

// The keys of the window; MainWindow and JogPad act on them.
constexpr Line kLines[] = {
    {QT_TRANSLATE_NOOP("boresight::ui::HelpPage", "Pause, F12"),
     QT_TRANSLATE_NOOP("boresight::ui::HelpPage", "STOP from anywhere")},
    {QT_TRANSLATE_NOOP("boresight::ui::HelpPage", "Esc"),
     QT_TRANSLATE_NOOP("boresight::ui::HelpPage", "leaves a field, a list or a question first. The next Esc is STOP")},
    {QT_TRANSLATE_NOOP("boresight::ui::HelpPage", "arrows"),
     QT_TRANSLATE_NOOP("boresight::ui::HelpPage",
                       "jog while held, after a click on the pad or Enter; up and down move elevation")},
    {QT_TRANSLATE_NOOP("boresight::ui::HelpPage", "Shift + arrow"),
     QT_TRANSLATE_NOOP("boresight::ui::HelpPage", "jog fast")},
    {QT_TRANSLATE_NOOP("boresight::ui::HelpPage", "Ctrl + arrow"),
     QT_TRANSLATE_NOOP("boresight::ui::HelpPage", "one step; trims the target while a client is followed")},
    {QT_TRANSLATE_NOOP("boresight::ui::HelpPage", "Page Up, Page Down"),
     QT_TRANSLATE_NOOP("boresight::ui::HelpPage", "on the slider: jog rate; also arrows, Home, End")},
    {QT_TRANSLATE_NOOP("boresight::ui::HelpPage", "gamepad"),
     QT_TRANSLATE_NOOP("boresight::ui::HelpPage",
                       "jog by the left stick while LB or RB is held (panel Jog); B is STOP")},
    {QT_TRANSLATE_NOOP("boresight::ui::HelpPage", "Ctrl+G"),
     QT_TRANSLATE_NOOP("boresight::ui::HelpPage", "to the go-to fields; Enter = Go")},
    {QT_TRANSLATE_NOOP("boresight::ui::HelpPage", "Ctrl+H"), QT_TRANSLATE_NOOP("boresight::ui::HelpPage", "hold")},
    {QT_TRANSLATE_NOOP("boresight::ui::HelpPage", "Ctrl+P"), QT_TRANSLATE_NOOP("boresight::ui::HelpPage", "park")},
    {QT_TRANSLATE_NOOP("boresight::ui::HelpPage", "Ctrl+1 … Ctrl+5"),
     QT_TRANSLATE_NOOP("boresight::ui::HelpPage", "panels Jog, Charts, Limits, Clients, Log")},
    {QT_TRANSLATE_NOOP("boresight::ui::HelpPage", "Ctrl+6 … Ctrl+8"),
     QT_TRANSLATE_NOOP("boresight::ui::HelpPage", "the mount itself: Drives, Protection, Profile")},
    {QT_TRANSLATE_NOOP("boresight::ui::HelpPage", "Ctrl+9"),
     QT_TRANSLATE_NOOP("boresight::ui::HelpPage", "panel North; while asked: which turn is the axis on?")},
    {QT_TRANSLATE_NOOP("boresight::ui::HelpPage", "Ctrl+L"),
     QT_TRANSLATE_NOOP("boresight::ui::HelpPage", "charts in the place of the sky, and back")},
    {QT_TRANSLATE_NOOP("boresight::ui::HelpPage", "Ctrl+E"),
     QT_TRANSLATE_NOOP("boresight::ui::HelpPage",
                       "change the limits on the plot: drag (Shift: 0.1°), + adds, Del removes")},
    {QT_TRANSLATE_NOOP("boresight::ui::HelpPage", "Ctrl+0, Ctrl++, Ctrl+-"),
     QT_TRANSLATE_NOOP("boresight::ui::HelpPage", "magnify the plot around the target; also the wheel")},
    {QT_TRANSLATE_NOOP("boresight::ui::HelpPage", "Ctrl+F"),
     QT_TRANSLATE_NOOP("boresight::ui::HelpPage", "search the settings (in Profile)")},
    {QT_TRANSLATE_NOOP("boresight::ui::HelpPage", "Ctrl+B"),
     QT_TRANSLATE_NOOP("boresight::ui::HelpPage", "save diagnostics for a bug report")},
    {QT_TRANSLATE_NOOP("boresight::ui::HelpPage", "F3, Alt+Left, Alt+Right"),
     QT_TRANSLATE_NOOP("boresight::ui::HelpPage", "commissioning guide and back; its steps; Space held moves")},
    {QT_TRANSLATE_NOOP("boresight::ui::HelpPage", "F8"),
     QT_TRANSLATE_NOOP("boresight::ui::HelpPage", "acknowledge the alarms")},
    {QT_TRANSLATE_NOOP("boresight::ui::HelpPage", "Ctrl+D"),
     QT_TRANSLATE_NOOP("boresight::ui::HelpPage", "theme: day, night, red")},
    {QT_TRANSLATE_NOOP("boresight::ui::HelpPage", "F11"), QT_TRANSLATE_NOOP("boresight::ui::HelpPage", "full screen")},
    {QT_TRANSLATE_NOOP("boresight::ui::HelpPage", "F1"), QT_TRANSLATE_NOOP("boresight::ui::HelpPage", "this page")},
};

}  // namespace

HelpPage::HelpPage(const QString& language, QWidget* parent) : QDialog(parent)
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
    grid->addLayout(languageRow(language), row++, 0, 1, 2);
    auto* const buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    grid->addWidget(buttons, row, 0, 1, 2);
}

QLayout* HelpPage::languageRow(const QString& chosen)
{
    auto* const label = new QLabel(tr("&Language"), this);
    auto* const choice = new QComboBox(this);
    auto* const since = new QLabel(this);  // says so once another one is chosen
    choice->addItem(tr("System"), QString());
    for (const QString& language : languages()) {
        choice->addItem(languageName(language), language);
    }
    choice->setCurrentIndex(std::max(0, choice->findData(chosen)));
    choice->setAccessibleName(tr("Language"));
    choice->setToolTip(tr("The language of the program's texts, from its next start on"));
    label->setBuddy(choice);
    connect(choice, &QComboBox::activated, this, [this, choice, since] {
        since->setText(tr("in force at the next start"));
        Q_EMIT languageChosen(choice->currentData().toString());
    });
    auto* const row = new QHBoxLayout;
    for (QWidget* const part :
         {static_cast<QWidget*>(label), static_cast<QWidget*>(choice), static_cast<QWidget*>(since)}) {
        part->setFont(fonts::label());
        row->addWidget(part);
    }
    row->addStretch();
    return row;
}

}  // namespace boresight::ui

#include "moc_help_page.cpp"
