// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/station/station_status.h"
#include "ui/window_settings.h"

#include <QTabWidget>

// The panels, one at a time.
namespace boresight::ui {

class DrivesPanel;
class JogPanel;
class LogPanel;
class ProtectionPanel;
class RequestDesk;

class PanelTabs : public QTabWidget
{
    Q_OBJECT

public:
    PanelTabs(const Clock& clock, RequestDesk& desk, const WindowSettings& settings, QWidget* parent = nullptr);

    void showStatus(const StationStatus& status);

    [[nodiscard]] JogPanel& jog() { return *m_jog; }
    [[nodiscard]] LogPanel& log() { return *m_log; }

private:
    void addPanel(QWidget& panel, const QString& text, const QString& help, Qt::Key key);

    JogPanel* m_jog;
    LogPanel* m_log;
    DrivesPanel* m_drives;
    ProtectionPanel* m_protection;
};

}  // namespace boresight::ui
