// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/messages/request.h"
#include "core/messages/station_status.h"
#include "ui/kit/request_desk.h"
#include "ui/link/host_desk.h"
#include "ui/link/profile_draft.h"
#include "ui/window/last_status.h"
#include "ui/window/window_settings.h"

#include <QMainWindow>
#include <QTimer>

class QGridLayout;

// The desktop window. It composes the panels and connects their signals, nothing else. It exchanges only two values
// with the station: StationUpdate comes in, NumberedRequest goes out. Gui thread.
// More than 15 members and 600 lines: the widgets that it composes, and its keys.
namespace boresight::ui {

class AboutPage;
class AlarmCard;
class AuthorityButton;
class ClosePrompt;
class ColumnHead;
class DiagnosticsSaver;
class Gamepad;
class GuideRoom;
class HeaderBar;
class HandBackPrompt;
class HelpPage;
class LockPrompt;
class ControlPrompt;
class MainMenu;
class ManualWindow;
class PanelTabs;
class PickPrompt;
class PlacesBar;
class PolarPlot;
class ProgressLine;
class ReplayOpener;
class StopKeys;
class ValueLabel;

class MainWindow : public QMainWindow
{
    Q_OBJECT

public:
    // The clock outlives the window.
    MainWindow(const Clock& clock, const WindowSettings& settings, QWidget* parent = nullptr);
    ~MainWindow() override;

    void useGamepad(Gamepad& gamepad);

    // The owner calls this when the station has ended. It closes without a question.
    void closeNow();

    [[nodiscard]] WindowLayout arrangement() const;

    // The functions of this computer that the pages need.
    [[nodiscard]] HostDesk& host() { return m_host; }

public Q_SLOTS:
    void showUpdate(const boresight::StationUpdate& update);
    // A problem outside the station, shown beside the alarm line. An empty text clears it.
    void warn(const QString& what);

Q_SIGNALS:
    void requested(const boresight::NumberedRequest& request);
    void updateShown();  // the station may send the next update
    // The operator closes the window, and has confirmed it if the mount was moving. The owner must stop the mount, then
    // call closeNow().
    void closeRequested();
    void themeChanged(boresight::ui::ThemeKind theme, boresight::ui::Brightness brightness);
    void alarmSoundChanged(bool on);
    void languageChanged(const QString& language);  // for the next start
    void recentGoTosChanged(const QStringList& recent);
    void guideProgressed(const boresight::ui::GuideProgress& progress);  // to be stored for the next start

protected:
    void closeEvent(QCloseEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void build();
    void placeLastCommand();
    void addPrompts();
    [[nodiscard]] QWidget* makeSide(QWidget& ground);
    void addKeys();
    void connectMenu();
    void stop();
    void showStatus(const StationStatus& status);
    void beat();
    void nextTheme();
    void chooseTheme(ThemeKind theme, Brightness brightness);
    void showEditing(bool on);  // of the limits on the plot
    void toggleEditing();
    void toggleFullScreen();
    void openMenu();
    void showManual();
    void showHelp();
    void showBelowHead(QWidget& page);
    void saveDiagnostics();
    void goTo();
    void park();

    const Clock& m_clock;
    RequestDesk m_desk;
    HostDesk m_host;
    ProfileDraft m_draft;
    LastStatus m_last;
    AlarmCard* m_alarms;
    AuthorityButton* m_authority;
    HeaderBar* m_header;
    ProgressLine* m_progress;
    PolarPlot* m_plot;
    QGridLayout* m_plotCell;  // the plot, and prompts over it
    QWidget* m_strip;         // the charts, in a wide window
    ColumnHead* m_head;
    PanelTabs* m_panels;
    PlacesBar* m_places;
    GuideRoom* m_side;
    ValueLabel* m_lastCommand;
    ControlPrompt* m_controlBar;
    HandBackPrompt* m_handBackBar;
    LockPrompt* m_lockBar;
    PickPrompt* m_pickBar;
    ClosePrompt* m_closeBar;
    HelpPage* m_help;
    ManualWindow* m_manual = nullptr;  // made when it is first opened
    AboutPage* m_about;
    MainMenu* m_menu;
    StopKeys* m_stopKeys;
    DiagnosticsSaver* m_diagnostics;
    ReplayOpener* m_replays;
    QString m_stateDir;
    QTimer m_beat{this};
    int m_beats = 0;
    bool m_mayClose = false;
};

}  // namespace boresight::ui
