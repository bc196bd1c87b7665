// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panel_tabs.h"

#include "ui/axes.h"
#include "ui/drives_panel.h"
#include "ui/jog_panel.h"
#include "ui/log_panel.h"
#include "ui/protection_panel.h"
#include "ui/turn_page.h"

#include <QEvent>
#include <QShortcut>
#include <QTabBar>

namespace boresight::ui {

PanelTabs::PanelTabs(const Clock& clock, RequestDesk& desk, const WindowSettings& settings, QWidget* parent)
    : QTabWidget(parent),
      m_jog(new JogPanel(clock, desk, settings, this)),
      m_log(new LogPanel(this)),
      m_drives(new DrivesPanel(desk, this)),
      m_protection(new ProtectionPanel(desk, this)),
      m_turn(new TurnPage(desk, settings.unwind, this))
{
    setFont(fonts::label());
    setAccessibleName(tr("Panels"));
    addPanel(*m_jog, tr("Jog"), tr("Jog panel (Ctrl+1)"), Qt::Key_1);
    addPanel(*m_log, tr("Log"), tr("Log panel (Ctrl+2)"), Qt::Key_2);
    addPanel(*m_drives, tr("Drives"), tr("Drives, bus and crash-stop proof (Ctrl+3)"), Qt::Key_3);
    addPanel(*m_protection, tr("Protection"), tr("The drives' own protections (Ctrl+4)"), Qt::Key_4);
    addPanel(*m_turn, tr("▲ Turn?"), tr("Which turn is the axis on? (Ctrl+5)"), Qt::Key_5);
    setTabVisible(indexOf(m_turn), false);
    tabBar()->setTabTextColor(indexOf(m_turn), currentTheme().warning);
}

void PanelTabs::addPanel(QWidget& panel, const QString& text, const QString& help, Qt::Key key)
{
    const int tab = addTab(&panel, text);
    setTabToolTip(tab, help);
    auto* const shortcut = new QShortcut(Qt::CTRL | key, this);
    shortcut->setContext(Qt::WindowShortcut);
    shortcut->setAutoRepeat(false);
    connect(shortcut, &QShortcut::activated, this, [this, tab] {
        if (isTabVisible(tab)) {
            setCurrentIndex(tab);
        }
    });
}

// The waiting question stands out among the tabs, by its shape in every theme.
void PanelTabs::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::PaletteChange) {
        tabBar()->setTabTextColor(indexOf(m_turn), currentTheme().warning);
    }
    QTabWidget::changeEvent(event);
}

void PanelTabs::showStatus(const StationStatus& status)
{
    m_jog->showStatus(status);
    m_drives->showStatus(status);
    m_protection->showStatus(status);
    m_turn->showStatus(status);
    showQuestion(status);
}

void PanelTabs::showQuestion(const StationStatus& status)
{
    const std::optional<Axis> asking = askingAxis(status);
    if (asking == m_asking) {
        return;
    }
    m_asking = asking;
    if (asking) {
        setTabVisible(indexOf(m_turn), true);
        setCurrentWidget(m_turn);
    } else {
        if (currentWidget() == m_turn) {
            setCurrentWidget(m_jog);
        }
        setTabVisible(indexOf(m_turn), false);
    }
}

}  // namespace boresight::ui
