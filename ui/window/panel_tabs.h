// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/messages/station_status.h"
#include "ui/window/window_settings.h"

#include <QTabWidget>

#include <map>
#include <optional>

// The panels, one at a time. Those for daily operation are side by side, and those about the mount itself are behind
// one tab. Each has its key. The question about a wrap is one of them and is shown only while it is open. It has the
// place and the key of the North panel, which needs the answer. It comes to the front once by itself, covers nothing
// but the other panels, and waits behind its tab when the operator leaves it.
// More than 15 members: the panels that it composes.
namespace boresight::ui {

class BoxConsolePanel;
class CalibrationPanel;
class ChartsPanel;
class ClientsPages;
class DrivesPanel;
class HostDesk;
class JogPanel;
class LimitsPanel;
class LogPanel;
class PassesPanel;
class ProfileDraft;
class ProfilePage;
class ProtectionPanel;
class ReadingsTable;
class RequestDesk;
class SchedulePage;
class TargetsPage;
class TuningPanel;
class TurnPage;

class PanelTabs : public QTabWidget
{
    Q_OBJECT

public:
    PanelTabs(const Clock& clock, RequestDesk& desk, HostDesk& host, ProfileDraft& draft,
              const WindowSettings& settings, QWidget* parent = nullptr);

    void showStatus(const StationStatus& status);
    [[nodiscard]] WindowLayout arrangement() const;
    void arrange(const WindowLayout& layout);
    void offerCharts(bool on);     // off while they are shown beside the panels
    void bringUp(QWidget& panel);  // to the front, also from behind the tab "Mount"
    void open(AlarmHelp help);     // the panel that helps against an alarm

    [[nodiscard]] JogPanel& jog() { return *m_jog; }
    [[nodiscard]] CalibrationPanel& north() { return *m_north; }
    [[nodiscard]] ChartsPanel& charts() { return *m_charts; }
    [[nodiscard]] LimitsPanel& limits() { return *m_limits; }
    [[nodiscard]] LogPanel& log() { return *m_log; }
    [[nodiscard]] ClientsPages& clients() { return *m_clients; }
    [[nodiscard]] PassesPanel& passes() { return *m_passes; }
    [[nodiscard]] ProfilePage& profile() { return *m_profile; }

Q_SIGNALS:
    void broughtUp();  // a panel must be shown in place of whatever covers the panels

protected:
    void changeEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void showIcons(bool on);
    void spaceTabs(int space);
    bool fitTabsWith(bool icons, int leastSpace);
    void fitTabs();
    void addPanel(QTabWidget& tabs, QWidget& panel, const QString& text, const QString& help, Qt::Key key);
    void giveKey(QWidget& panel, Qt::Key key);
    void bringUpByKey(QWidget& panel);
    [[nodiscard]] QTabWidget* makeGroup(const QString& name);
    void fillPassesTabs();
    void fillMountTabs();
    void addTurnPage();
    void showMountTabs(const StationStatus& status);
    void showQuestion(const StationStatus& status);
    [[nodiscard]] int keyOf(const QWidget* panel) const;  // its digit; 0: none
    void bringUp(int key);

    std::map<int, QWidget*> m_keys;  // panels by the digit of their key
    JogPanel* m_jog;
    PassesPanel* m_passes;
    SchedulePage* m_schedule;
    TargetsPage* m_targets;
    ChartsPanel* m_charts;
    LimitsPanel* m_limits;
    ClientsPages* m_clients;
    LogPanel* m_log;
    DrivesPanel* m_drives;
    ReadingsTable* m_readings;
    ProtectionPanel* m_protection;
    TuningPanel* m_tuning;
    BoxConsolePanel* m_console;
    ProfilePage* m_profile;
    CalibrationPanel* m_north;
    TurnPage* m_turn;
    QTabWidget* m_passesTabs;
    QTabWidget* m_mountTabs;
    std::optional<Axis> m_asking;  // the axis of the question that was brought to the front
};

}  // namespace boresight::ui
