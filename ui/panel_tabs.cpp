// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panel_tabs.h"

#include "ui/drives_panel.h"
#include "ui/jog_panel.h"
#include "ui/log_panel.h"
#include "ui/protection_panel.h"

#include <QShortcut>

namespace boresight::ui {

PanelTabs::PanelTabs(const Clock& clock, RequestDesk& desk, const WindowSettings& settings, QWidget* parent)
    : QTabWidget(parent),
      m_jog(new JogPanel(clock, desk, settings, this)),
      m_log(new LogPanel(this)),
      m_drives(new DrivesPanel(desk, this)),
      m_protection(new ProtectionPanel(desk, this))
{
    setFont(fonts::label());
    setAccessibleName(tr("Panels"));
    addPanel(*m_jog, tr("Jog"), tr("Jog panel (Ctrl+1)"), Qt::Key_1);
    addPanel(*m_log, tr("Log"), tr("Log panel (Ctrl+2)"), Qt::Key_2);
    addPanel(*m_drives, tr("Drives"), tr("Drives, bus and crash-stop proof (Ctrl+3)"), Qt::Key_3);
    addPanel(*m_protection, tr("Protection"), tr("The drives' own protections (Ctrl+4)"), Qt::Key_4);
}

void PanelTabs::addPanel(QWidget& panel, const QString& text, const QString& help, Qt::Key key)
{
    const int tab = addTab(&panel, text);
    setTabToolTip(tab, help);
    auto* const shortcut = new QShortcut(Qt::CTRL | key, this);
    shortcut->setContext(Qt::WindowShortcut);
    shortcut->setAutoRepeat(false);
    connect(shortcut, &QShortcut::activated, this, [this, tab] { setCurrentIndex(tab); });
}

void PanelTabs::showStatus(const StationStatus& status)
{
    m_jog->showStatus(status);
    m_drives->showStatus(status);
    m_protection->showStatus(status);
}

}  // namespace boresight::ui
