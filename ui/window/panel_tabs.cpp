// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/panel_tabs.h"

#include "ui/charts/charts_panel.h"
#include "ui/charts/strip_charts.h"
#include "ui/clients/clients_pages.h"
#include "ui/drives/box_console_panel.h"
#include "ui/drives/drives_panel.h"
#include "ui/drives/protection_panel.h"
#include "ui/drives/readings_table.h"
#include "ui/drives/turn_page.h"
#include "ui/jog/jog_panel.h"
#include "ui/kit/axes.h"
#include "ui/kit/page_room.h"
#include "ui/limits/limits_panel.h"
#include "ui/log/log_panel.h"
#include "ui/look/desk_style.h"
#include "ui/look/glyph.h"
#include "ui/north/calibration_panel.h"
#include "ui/passes/passes_panel.h"
#include "ui/passes/schedule_page.h"
#include "ui/passes/targets_page.h"
#include "ui/profile/profile_page.h"
#include "ui/tuning/tuning_panel.h"

#include <QEvent>
#include <QShortcut>
#include <QStyle>
#include <QTabBar>

#include <algorithm>

namespace boresight::ui {

namespace {
constexpr int kLeastTabSpace = 4;  // px beside the words of a tab, on both sides together
constexpr int kLeastSpaceWithIcons = kTabSpace - 4;
}  // namespace

PanelTabs::PanelTabs(const Clock& clock, RequestDesk& desk, HostDesk& host, ProfileDraft& draft,
                     const WindowSettings& settings, QWidget* parent)
    : QTabWidget(parent),
      m_jog(new JogPanel(clock, draft, desk, this)),
      m_passes(new PassesPanel(draft, desk, this)),
      m_schedule(new SchedulePage(draft, desk, this)),
      m_targets(new TargetsPage(desk, host, this)),
      m_charts(new ChartsPanel(clock, this)),
      m_limits(new LimitsPanel(draft, desk, this)),
      m_clients(new ClientsPages(draft, desk, this)),
      m_log(new LogPanel(desk, settings.alarmSound, this)),
      m_drives(new DrivesPanel(desk, this)),
      m_readings(new ReadingsTable(this)),
      m_protection(new ProtectionPanel(desk, this)),
      m_tuning(new TuningPanel(desk, this)),
      m_console(new BoxConsolePanel(draft, desk, this)),
      m_profile(new ProfilePage(draft, desk, settings.configDir, this)),
      m_north(new CalibrationPanel(clock, desk, draft, this)),
      m_turn(new TurnPage(desk, this)),
      m_passesTabs(makeGroup(tr("Passes of satellites"))),
      m_mountTabs(makeGroup(tr("The mount itself")))
{
    setFont(fonts::label());
    setAccessibleName(tr("Panels"));
    tabBar()->setAccessibleName(tr("Panels"));
    addPanel(*this, *m_jog, tr("Jog"), tr("Jog panel (Ctrl+1)"), Qt::Key_1);
    addTab(m_passesTabs, tr("Passes"));
    addPanel(*this, *m_charts, tr("Charts"), tr("Position, error and drive over time (Ctrl+2)"), Qt::Key_2);
    addPanel(*this, *m_limits, tr("Limits"), tr("Limits, horizon and keep-outs (Ctrl+3)"), Qt::Key_3);
    addPanel(*this, *m_clients, tr("Clients"), tr("rotctld clients, and which of them has control (Ctrl+4)"),
             Qt::Key_4);
    addPanel(*this, *m_log, tr("Log"), tr("Log panel (Ctrl+5)"), Qt::Key_5);
    addTab(m_mountTabs, tr("Mount"));
    setTabToolTip(addTab(m_north, tr("North")), tr("Finding north: sensor, swing, Sun and Moon (Ctrl+9)"));
    giveKey(*m_north, Qt::Key_9);
    fillPassesTabs();
    fillMountTabs();
    addTurnPage();
    showIcons(true);
    const auto openSettings = [this](const QString& words) {
        bringUp(*m_profile);
        m_profile->seek(words);
    };
    connect(m_north, &CalibrationPanel::settingsWanted, this, openSettings);
    connect(m_passes, &PassesPanel::settingsWanted, this, openSettings);
}

void PanelTabs::showIcons(bool on)
{
    const std::pair<QWidget*, Glyph> icons[] = {{m_jog, Glyph::Jog},         {m_passesTabs, Glyph::Passes},
                                                {m_charts, Glyph::Charts},   {m_limits, Glyph::Limits},
                                                {m_clients, Glyph::Clients}, {m_log, Glyph::Log},
                                                {m_mountTabs, Glyph::Mount}, {m_north, Glyph::North}};
    for (const auto& [panel, glyph] : icons) {
        setTabIcon(tabOf(*this, *panel), on ? glyphIcon(glyph) : QIcon());
    }
}

void PanelTabs::spaceTabs(int space)
{
    setTabSpace(*tabBar(), space);
    const int size = style()->pixelMetric(QStyle::PM_TabBarIconSize, nullptr, this);
    setIconSize({size, size});  // this lays the tabs out
}

bool PanelTabs::fitTabsWith(bool icons, int leastSpace)
{
    showIcons(icons);
    for (int space = kTabSpace; space >= leastSpace; space -= 2) {
        spaceTabs(space);
        if (tabBar()->sizeHint().width() <= width()) {
            return true;
        }
    }
    return false;
}

// In a narrow window only words without symbols, and long words closer to each other, so that all tabs stay visible.
void PanelTabs::fitTabs()
{
    if (!fitTabsWith(true, kLeastSpaceWithIcons)) {
        (void)fitTabsWith(false, kLeastTabSpace);
    }
}

void PanelTabs::resizeEvent(QResizeEvent* event)
{
    fitTabs();
    QTabWidget::resizeEvent(event);
}

void PanelTabs::addTurnPage()
{
    const int tab = addScrollingPage(*this, *m_turn, tr("▲ Wrap?"));
    setTabToolTip(tab, tr("Where is the axis now? (Ctrl+9)"));
    setTabVisible(tab, false);
    tabBar()->setTabTextColor(tab, currentTheme().warning);
}

// Pages behind one tab.
QTabWidget* PanelTabs::makeGroup(const QString& name)
{
    auto* const tabs = new QTabWidget(this);
    tabs->setFont(fonts::label());
    tabs->setAccessibleName(name);
    tabs->tabBar()->setAccessibleName(name);
    tabs->setDocumentMode(true);
    return tabs;
}

void PanelTabs::fillPassesTabs()
{
    addPanel(*m_passesTabs, *m_passes, tr("Coming"), tr("Coming passes of satellites (Ctrl+T)"), Qt::Key_T);
    m_passesTabs->setTabToolTip(addScrollingPage(*m_passesTabs, *m_schedule, tr("Schedule")),
                                tr("The passes that the mount tracks by itself"));
    m_passesTabs->setTabToolTip(addScrollingPage(*m_passesTabs, *m_targets, tr("Moon, Sun, others")),
                                tr("Targets other than satellites"));
}

void PanelTabs::fillMountTabs()
{
    addPanel(*m_mountTabs, *m_drives, tr("Drives"), tr("Drives, bus and crash-stop test (Ctrl+6)"), Qt::Key_6);
    m_mountTabs->setTabToolTip(addScrollingPage(*m_mountTabs, *m_readings, tr("Readings")),
                               tr("What the drives report now"));
    addPanel(*m_mountTabs, *m_protection, tr("Protection"), tr("Safety settings of the drives (Ctrl+7)"), Qt::Key_7);
    m_mountTabs->setTabToolTip(addScrollingPage(*m_mountTabs, *m_tuning, tr("Tuning")),
                               tr("Measure the axes and tune the gains of the drives"));
    m_mountTabs->setTabToolTip(addScrollingPage(*m_mountTabs, *m_console, tr("Console")),
                               tr("Type a line to the control box, or make a home run"));
    addPanel(*m_mountTabs, *m_profile, tr("Profile"), tr("All settings, and the stored mounts (Ctrl+8)"), Qt::Key_8);
}

void PanelTabs::addPanel(QTabWidget& tabs, QWidget& panel, const QString& text, const QString& help, Qt::Key key)
{
    tabs.setTabToolTip(addScrollingPage(tabs, panel, text), help);
    giveKey(panel, key);
}

void PanelTabs::giveKey(QWidget& panel, Qt::Key key)
{
    m_keys[key - Qt::Key_0] = &panel;
    auto* const shortcut = new QShortcut(Qt::CTRL | key, window());  // also while the guide is shown in our place
    shortcut->setContext(Qt::WindowShortcut);
    shortcut->setAutoRepeat(false);
    connect(shortcut, &QShortcut::activated, this, [this, &panel] { bringUpByKey(panel); });
}

void PanelTabs::bringUpByKey(QWidget& panel)
{
    const bool isAsked = &panel == m_north && m_asking;
    bringUp(isAsked ? static_cast<QWidget&>(*m_turn) : panel);
}

void PanelTabs::bringUp(QWidget& panel)
{
    for (int page = 0; page < count(); ++page) {
        auto* const group = qobject_cast<QTabWidget*>(widget(page));
        const int inside = group != nullptr ? tabOf(*group, panel) : -1;
        const bool isShown = tabOf(*this, panel) == page || (inside >= 0 && group->isTabVisible(inside));
        if (isTabVisible(page) && isShown) {
            setCurrentIndex(page);
            if (group != nullptr) {
                group->setCurrentIndex(inside);
            }
            Q_EMIT broughtUp();
        }
    }
}

void PanelTabs::offerCharts(bool on)
{
    if (!on && shownPage(*this) == m_charts) {
        setCurrentIndex(tabOf(*this, *m_jog));
    }
    setTabVisible(tabOf(*this, *m_charts), on);
    fitTabs();
}

void PanelTabs::open(AlarmHelp help)
{
    switch (help) {
        case AlarmHelp::OpenProtection:
            bringUp(*m_protection);
            break;
        case AlarmHelp::OpenDrives:
            bringUp(*m_drives);
            break;
        case AlarmHelp::OpenClients:
            bringUp(*m_clients);
            break;
        case AlarmHelp::OpenLimits:
        case AlarmHelp::MovePark:
            bringUp(*m_limits);
            break;
        case AlarmHelp::OpenNorth:
        case AlarmHelp::ConfirmWrap:
            bringUpByKey(*m_north);  // or the question, which is shown in its place
            break;
        case AlarmHelp::OpenProfile:
            bringUp(*m_profile);
            break;
        case AlarmHelp::OpenHomeRun:
            bringUp(m_mountTabs->isTabVisible(tabOf(*m_mountTabs, *m_console)) ? static_cast<QWidget&>(*m_console)
                                                                               : *m_profile);
            break;
        case AlarmHelp::None:
        case AlarmHelp::Rearm:
        case AlarmHelp::ResetStop:
        case AlarmHelp::Unwind:
        case AlarmHelp::HoldAtEnd:
        case AlarmHelp::Reconnect:
        case AlarmHelp::ParkNow:
        case AlarmHelp::OverrideWind:
        case AlarmHelp::UseNewTime:
        case AlarmHelp::OpenGuide:
            break;
    }
}

int PanelTabs::keyOf(const QWidget* panel) const
{
    const auto found = std::ranges::find_if(m_keys, [panel](const auto& one) { return one.second == panel; });
    return found == m_keys.end() ? 0 : found->first;
}

void PanelTabs::bringUp(int key)
{
    if (const auto found = m_keys.find(key); found != m_keys.end()) {
        bringUp(*found->second);
    }
}

WindowLayout PanelTabs::arrangement() const
{
    const int mountPanel = keyOf(shownPage(*m_mountTabs));
    const auto* const group = qobject_cast<const QTabWidget*>(currentWidget());
    return {.panel = keyOf(shownPage(group != nullptr ? *group : *this)),
            .mountPanel = mountPanel,
            .charts = m_charts->charts().choice(),
            .passes = m_passes->arrangement()};
}

void PanelTabs::arrange(const WindowLayout& layout)
{
    bringUp(layout.mountPanel);
    bringUp(layout.panel);
    m_charts->charts().choose(layout.charts);
    m_passes->arrange(layout.passes);
}

// The waiting question stands out among the tabs, by its shape in every theme.
void PanelTabs::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::PaletteChange) {
        tabBar()->setTabTextColor(tabOf(*this, *m_turn), currentTheme().warning);
    }
    QTabWidget::changeEvent(event);
}

void PanelTabs::showStatus(const StationStatus& status)
{
    m_jog->showStatus(status);
    m_passes->showStatus(status);
    m_schedule->showStatus(status);
    m_targets->showStatus(status);
    m_charts->charts().showStatus(status);
    m_limits->showStatus(status);
    m_clients->showStatus(status);
    m_log->showStatus(status);
    m_drives->showStatus(status);
    m_readings->showStatus(status);
    m_protection->showStatus(status);
    m_tuning->showStatus(status);
    m_console->showStatus(status);
    m_profile->showStatus(status);
    m_north->showStatus(status);
    m_turn->showStatus(status);
    showMountTabs(status);
    showQuestion(status);
}

// For a mount without such drives, or without a control box, there is nothing to show.
void PanelTabs::showMountTabs(const StationStatus& status)
{
    const auto offer = [this](QWidget* panel, bool on) {
        const int tab = tabOf(*m_mountTabs, *panel);
        if (m_mountTabs->isTabVisible(tab) != on) {
            m_mountTabs->setTabVisible(tab, on);  // this lays the tabs out each time
        }
    };
    for (QWidget* const panel : std::initializer_list<QWidget*>{m_drives, m_readings, m_protection, m_tuning}) {
        offer(panel, status.drives.has_value());
    }
    offer(m_console, status.console.has_value() || status.capabilities.makesHomeRuns);
}

void PanelTabs::showQuestion(const StationStatus& status)
{
    const std::optional<Axis> asking = askingAxis(status);
    if (asking == m_asking) {
        return;
    }
    m_asking = asking;
    const int turn = tabOf(*this, *m_turn);
    const int north = tabOf(*this, *m_north);
    if (asking) {
        setTabVisible(north, false);
        setTabVisible(turn, true);
        setCurrentIndex(turn);
    } else {
        if (currentIndex() == turn) {
            setCurrentIndex(tabOf(*this, *m_jog));
        }
        setTabVisible(turn, false);
        setTabVisible(north, true);
    }
    fitTabs();
}

}  // namespace boresight::ui

#include "moc_panel_tabs.cpp"
