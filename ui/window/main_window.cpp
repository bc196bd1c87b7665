// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/main_window.h"

#include "ui/charts/charts_panel.h"
#include "ui/charts/strip_charts.h"
#include "ui/clients/clients_pages.h"
#include "ui/clients/control_prompt.h"
#include "ui/clients/hand_back_prompt.h"
#include "ui/clients/lock_prompt.h"
#include "ui/jog/gamepad.h"
#include "ui/jog/jog_panel.h"
#include "ui/jog/places_bar.h"
#include "ui/kit/accessibility.h"
#include "ui/kit/focus_frame.h"
#include "ui/kit/format.h"
#include "ui/kit/theme.h"
#include "ui/kit/value_label.h"
#include "ui/limits/limits_panel.h"
#include "ui/link/motion_state.h"
#include "ui/log/log_panel.h"
#include "ui/look/desk_style.h"
#include "ui/manual/manual_window.h"
#include "ui/north/calibration_panel.h"
#include "ui/passes/passes_panel.h"
#include "ui/profile/profile_page.h"
#include "ui/replay/replay_opener.h"
#include "ui/sky/polar_plot.h"
#include "ui/window/about_page.h"
#include "ui/window/alarm_card.h"
#include "ui/window/authority_button.h"
#include "ui/window/axis_readout.h"
#include "ui/window/chart_strip.h"
#include "ui/window/close_prompt.h"
#include "ui/window/column_head.h"
#include "ui/window/diagnostics_saver.h"
#include "ui/window/guide_room.h"
#include "ui/window/header_bar.h"
#include "ui/window/help_page.h"
#include "ui/window/main_menu.h"
#include "ui/window/panel_tabs.h"
#include "ui/window/pick_prompt.h"
#include "ui/window/progress_line.h"
#include "ui/window/stop_keys.h"

#include <QApplication>
#include <QCloseEvent>
#include <QGridLayout>
#include <QIcon>
#include <QResizeEvent>
#include <QScreen>
#include <QShortcut>
#include <QStyle>
#include <QVBoxLayout>

#include <algorithm>
#include <memory>

namespace boresight::ui {

namespace {

constexpr std::chrono::milliseconds kBeat{100};
constexpr int kBeatsPerSecond = 10;
constexpr int kWidthWithCharts = 1600;
constexpr int kColumnOfLowWindow = 520;  // px: in a window of 1024x700 the disc of the sky beside it has 440 px
constexpr int kFootOfSky = 48;           // px: prompts leave legend and cable free
constexpr int kColumn = 576;             // px: at least 590 px in a window of 1280x800, where the numbers are larger

// Must come before the first widget: its size depends on the style, and its description for screen readers is created
// with it.
void prepare(const WindowSettings& settings)
{
    describeOwnWidgets();
    DeskStyle::install();
    applyTheme(settings.theme, settings.brightness);
}

}  // namespace

MainWindow::MainWindow(const Clock& clock, const WindowSettings& settings, QWidget* parent)
    : QMainWindow((prepare(settings), parent)),
      m_clock(clock),
      m_host(settings.rotators),
      m_draft(m_desk),
      m_last(clock),
      m_alarms(new AlarmCard(m_draft, m_desk, this)),
      m_authority(new AuthorityButton(m_desk, m_alarms->notice(), this)),
      m_header(new HeaderBar(*m_authority, this)),
      m_progress(new ProgressLine(this)),
      m_plot(new PolarPlot(m_draft, m_desk, this)),
      m_plotCell(new QGridLayout),
      m_strip(new ChartStrip(this)),
      m_head(new ColumnHead(*m_alarms, m_desk, this)),
      m_panels(new PanelTabs(clock, m_desk, m_host, m_draft, settings, this)),
      m_places(new PlacesBar(m_draft, m_desk, settings.recentGoTos, this)),
      m_side(new GuideRoom(*m_panels, m_last, m_draft, m_desk, m_host, settings.guide, this)),
      m_lastCommand(new ValueLabel(tr("Last line of the log"), fonts::label(), {}, this)),
      m_controlBar(new ControlPrompt(m_desk, this)),
      m_handBackBar(new HandBackPrompt(m_desk, this)),
      m_lockBar(new LockPrompt(m_desk, this)),
      m_pickBar(new PickPrompt(m_desk, this)),
      m_closeBar(new ClosePrompt(this)),
      m_help(new HelpPage(this)),
      m_about(new AboutPage(this)),
      m_menu(new MainMenu(settings.language, *this)),
      m_stopKeys(new StopKeys(*this)),
      m_diagnostics(new DiagnosticsSaver(this)),
      m_replays(new ReplayOpener(clock, settings.stateDir, this)),
      m_stateDir(settings.stateDir)
{
    if (settings.onlySimulated) {
        m_draft.keepSimulated();
        m_header->setOnlySimulated();
    }
    new FocusFrame(this);
    setWindowTitle(tr("Boresight"));
    setWindowIcon(QIcon(QStringLiteral(":/boresight/icons/boresight.svg")));
    build();
    addKeys();
    connectMenu();
    connect(&m_desk, &RequestDesk::requested, this, &MainWindow::requested);
    connect(m_header, &HeaderBar::stopPressed, this, &MainWindow::stop);
    connect(m_stopKeys, &StopKeys::stopPressed, this, &MainWindow::stop);
    connect(m_plot, &PolarPlot::clicked, m_pickBar, &PickPrompt::pick);
    connect(m_plot, &PolarPlot::goHereWanted, m_pickBar, &PickPrompt::goTo);
    connect(m_pickBar, &PickPrompt::picked, m_plot, &PolarPlot::setPicked);
    connect(&m_panels->passes(), &PassesPanel::wayChosen, m_plot, &PolarPlot::setChosenWay);
    connect(&m_panels->passes(), &PassesPanel::beamChosen, m_plot, &PolarPlot::setChosenBeam);
    connect(&m_panels->passes(), &PassesPanel::favouritesMoved, m_plot, &PolarPlot::setSatellites);
    connect(&m_panels->log(), &LogPanel::beepWanted, this, &QApplication::beep);
    connect(&m_panels->log(), &LogPanel::soundChanged, this, &MainWindow::alarmSoundChanged);
    connect(&m_panels->jog(), &JogPanel::stopPressed, this, &MainWindow::stop);
    connect(m_places, &PlacesBar::recentGoTosChanged, this, &MainWindow::recentGoTosChanged);
    connect(m_plot, &PolarPlot::editingChanged, this, &MainWindow::showEditing);
    connect(m_alarms, &AlarmCard::panelWanted, this, [this](AlarmHelp help) {
        help == AlarmHelp::OpenGuide ? m_side->showStep(GuideStep::Connect) : m_panels->open(help);
    });
    connect(m_alarms, &AlarmCard::lineWanted, this, [this](const Alarm& alarm) {
        m_panels->bringUp(m_panels->log());
        m_panels->log().showAlarm(alarm);
    });
    connect(m_alarms, &AlarmCard::listWanted, this, [this] {
        m_panels->bringUp(m_panels->log());
        m_panels->log().showAlarms();
    });
    connect(&m_panels->log(), &LogPanel::diagnosticsWanted, this, &MainWindow::saveDiagnostics);
    connect(m_diagnostics, &DiagnosticsSaver::saved, this, [this](const QString& path) {
        m_alarms->sayForAWhile(tr("Diagnostics saved: %1").arg(path), m_clock.now());
    });
    connect(m_diagnostics, &DiagnosticsSaver::failed, this,
            [this](const QString& reason) { warn(tr("Diagnostics not saved: %1").arg(reason)); });
    m_panels->arrange(settings.layout);
    m_stopKeys->setFirstUse([this] { return m_plot->editor().cancelDrag(); });
    connect(&m_beat, &QTimer::timeout, this, &MainWindow::beat);
    connect(m_side, &GuideRoom::progressChanged, this, &MainWindow::guideProgressed);
    m_beat.start(kBeat);
    showStatus(m_last.received());
    resize(1280, 800);
}

MainWindow::~MainWindow()
{
    // The panels end what is still pressed with a last request, and this needs the desk. So they are deleted first.
    const std::unique_ptr<QWidget> panels(takeCentralWidget());
}

void MainWindow::useGamepad(Gamepad& gamepad)
{
    connect(&gamepad, &Gamepad::plugged, &m_panels->jog(), &JogPanel::showGamepad);
    connect(&gamepad, &Gamepad::sampled, &m_panels->jog(), &JogPanel::takeGamepad);
}

void MainWindow::build()
{
    auto* const ground = new QWidget(this);
    auto* const grid = new QGridLayout(ground);
    grid->setContentsMargins(0, 4, 4, 4);  // the square of the sky has free corners, so beside it no margin is lost
    grid->setHorizontalSpacing(4);
    grid->setVerticalSpacing(4);
    grid->addWidget(m_header, 0, 0, 1, 3);
    grid->addWidget(m_progress, 1, 0, 1, 3);
    grid->addLayout(m_plotCell, 2, 0);
    grid->addWidget(makeSide(*ground), 2, 1);
    grid->addWidget(m_strip, 2, 2);
    grid->setRowStretch(2, 1);
    grid->setColumnStretch(0, 4);
    grid->setColumnStretch(1, 3);
    m_plotCell->addWidget(m_plot, 0, 0, 2, 1);
    addPrompts();
    new QVBoxLayout(m_strip);
    m_strip->hide();
    setCentralWidget(ground);
}

// The same width in every language, with every panel and alarm, so that the sky keeps its size. Wider only if large
// letters need it.
QWidget* MainWindow::makeSide(QWidget& ground)
{
    auto* const side = new QWidget(&ground);
    auto* const column = new QVBoxLayout(side);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(m_head);
    // The guide needs the room and moves the mount by its own buttons.
    connect(m_side, &GuideRoom::guideShown, m_places, &QWidget::setHidden);
    column->addWidget(m_side, 1);
    column->addWidget(m_places);
    m_lastCommand->setStretching(true);
    m_lastCommand->setBySentences(true);
    return side;
}

void MainWindow::addPrompts()
{
    m_plotCell->setRowStretch(0, 1);
    m_plotCell->setRowMinimumHeight(1, kFootOfSky);
    auto* const below = new QVBoxLayout;  // so that none lies on another one
    m_plotCell->addLayout(below, 0, 0, Qt::AlignBottom);
    below->addWidget(m_pickBar, 0, Qt::AlignHCenter);
    below->addWidget(m_handBackBar, 0, Qt::AlignHCenter);
    below->addWidget(m_lockBar, 0, Qt::AlignLeft);
    below->addWidget(m_controlBar, 0, Qt::AlignLeft);
    m_plotCell->addWidget(m_closeBar, 0, 0, Qt::AlignHCenter | Qt::AlignTop);
    connect(m_closeBar, &ClosePrompt::confirmed, this, &MainWindow::closeRequested);
}

void MainWindow::addKeys()
{
    const auto add = [this](const QKeySequence& key, auto* receiver, auto act) {
        auto* const shortcut = new QShortcut(key, this);
        shortcut->setAutoRepeat(false);
        connect(shortcut, &QShortcut::activated, receiver, act);
    };
    const auto zoomIn = [this] { m_plot->zoomBy(1); };
    add(Qt::CTRL | Qt::Key_G, this, &MainWindow::goTo);
    add(Qt::CTRL | Qt::Key_H, &m_panels->jog(), &JogPanel::hold);
    add(Qt::CTRL | Qt::Key_P, this, &MainWindow::park);
    add(Qt::CTRL | Qt::Key_D, this, &MainWindow::nextTheme);
    add(Qt::CTRL | Qt::Key_E, this, &MainWindow::toggleEditing);
    add(Qt::CTRL | Qt::Key_0, m_plot, &PolarPlot::toggleZoom);
    add(Qt::CTRL | Qt::Key_Plus, m_plot, zoomIn);
    add(Qt::CTRL | Qt::Key_Equal, m_plot, zoomIn);  // the same key without Shift
    add(Qt::CTRL | Qt::Key_Minus, m_plot, [this] { m_plot->zoomBy(-1); });
    add(Qt::CTRL | Qt::Key_B, this, &MainWindow::saveDiagnostics);
    add(Qt::Key_F8, m_alarms, &AlarmCard::acknowledge);
    add(Qt::Key_F10, this, &MainWindow::openMenu);
    add(Qt::Key_F11, this, &MainWindow::toggleFullScreen);
    add(Qt::Key_F1, this, &MainWindow::showManual);
    add(Qt::SHIFT | Qt::Key_F1, this, &MainWindow::showHelp);
    add(Qt::Key_F3, m_side, &GuideRoom::toggle);
}

void MainWindow::connectMenu()
{
    connect(m_header, &HeaderBar::menuWanted, this, &MainWindow::openMenu);
    connect(m_menu, &MainMenu::openWanted, this, &MainWindow::openMenu);
    connect(m_menu, &MainMenu::themeChosen, this, &MainWindow::chooseTheme);
    connect(m_menu, &MainMenu::languageChosen, this, &MainWindow::languageChanged);
    connect(m_menu, &MainMenu::fullScreenWanted, this, &MainWindow::toggleFullScreen);
    connect(m_menu, &MainMenu::manualWanted, this, &MainWindow::showManual);
    connect(m_menu, &MainMenu::keysWanted, this, &MainWindow::showHelp);
    connect(m_menu, &MainMenu::guideWanted, m_side, &GuideRoom::showGuide);
    connect(m_head, &ColumnHead::antennasWanted, this, [this] {
        m_panels->bringUp(m_panels->profile());
        m_panels->profile().showAntennas();
    });
    connect(m_menu, &MainMenu::profileWanted, this, [this] { m_panels->bringUp(m_panels->profile()); });
    connect(m_menu, &MainMenu::diagnosticsWanted, this, &MainWindow::saveDiagnostics);
    connect(m_menu, &MainMenu::recordingWanted, this, [this] { m_replays->ask(*this); });
    connect(m_replays, &ReplayOpener::failed, this, &MainWindow::warn);
    connect(m_menu, &MainMenu::aboutWanted, this, [this] { showBelowHead(*m_about); });
}

void MainWindow::showUpdate(const StationUpdate& update)
{
    m_last.take(update.status);
    m_panels->log().append(update.log);
    m_panels->clients().append(update.protocol);
    m_panels->charts().charts().add(update.samples);
    if (!update.log.empty()) {
        const LogEntry& last = update.log.back();
        m_lastCommand->setValue(
            clockText(last.utc) + QStringLiteral("  ") + sourceText(last.source) + QStringLiteral("  ") + last.text,
            Tone::Secondary);
    }
    m_desk.take(update.answers);
    m_draft.showStatus(update.status);
    showStatus(m_last.now());
    m_side->resume();
    Q_EMIT updateShown();
}

void MainWindow::showStatus(const StationStatus& status)
{
    m_header->showStatus(status);
    m_progress->setDone(status.slew ? std::optional(status.slew->done) : std::nullopt);
    m_alarms->showStatus(status);
    m_authority->showStatus(status);
    m_plot->showStatus(status);
    m_head->showStatus(status);
    m_panels->showStatus(status);
    m_places->showStatus(status);
    m_side->showStatus(status);
    m_controlBar->showStatus(status);
    m_handBackBar->showStatus(status);
    m_lockBar->showStatus(status);
    if (!isMoving(status)) {
        m_closeBar->withdraw();
    }
    m_pickBar->showStatus(status);
}

// Ten times a second, also without a status from the station: old numbers age, alarms flash, the pad disarms.
void MainWindow::beat()
{
    ++m_beats;
    if (m_last.ages()) {
        showStatus(m_last.now());
    }
    m_alarms->beat(m_clock.now(), m_beats % kBeatsPerSecond < kBeatsPerSecond / 2);
    m_panels->jog().beat();
    m_panels->north().beat();
    if (m_beats % kBeatsPerSecond == 0) {
        m_plot->describe(m_last.received());
    }
}

void MainWindow::stop()
{
    m_header->setStopRequested();
    m_last.stopAsked();
    m_desk.send(request::Stop{}, this, [this](const std::optional<Error>& error) {
        if (error) {
            m_last.stopRefused();
            m_header->setStopRefused();
            m_alarms->notice().setValue(tr("STOP: %1").arg(error->text), Tone::Alarm, Symbol::Alarm);
        }
    });
}

void MainWindow::warn(const QString& what)
{
    m_alarms->notice().setValue(what, Tone::Warning, what.isEmpty() ? Symbol::None : Symbol::Warning);
}

// A wide window has room for everything: sky, panels, and the charts beside them.
void MainWindow::resizeEvent(QResizeEvent* event)
{
    QMainWindow::resizeEvent(event);
    m_head->setRoom(size());
    auto* const grid = static_cast<QGridLayout*>(centralWidget()->layout());
    grid->setColumnMinimumWidth(1, isLow(size()) ? kColumnOfLowWindow : kColumn);
    placeLastCommand();
    const bool beside = width() >= kWidthWithCharts;
    if (beside != m_strip->isHidden()) {
        return;
    }
    m_strip->setVisible(beside);
    if (beside) {
        m_strip->layout()->addWidget(&m_panels->charts().charts());
        m_panels->charts().charts().show();
    } else {
        m_panels->charts().takeBack();
    }
    m_panels->offerCharts(!beside);
}

// The last command is at the end of the column. In a low window it is below the sky, because the disc of the sky leaves
// room there.
void MainWindow::placeLastCommand()
{
    QLayout* const column = m_head->parentWidget()->layout();
    const bool below = isLow(size());
    if ((below ? m_plotCell : column)->indexOf(m_lastCommand) >= 0) {
        return;
    }
    if (below) {
        m_plotCell->addWidget(m_lastCommand, 2, 0);
        m_lastCommand->setAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    } else {
        column->addWidget(m_lastCommand);
        m_lastCommand->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    }
}

void MainWindow::closeEvent(QCloseEvent* event)
{
    if (m_mayClose) {
        event->accept();
        return;
    }
    event->ignore();
    if (isMoving(m_last.received())) {
        m_closeBar->ask();
    } else {
        m_closeBar->confirm();
    }
}

void MainWindow::closeNow()
{
    m_mayClose = true;
    QApplication::closeAllWindows();  // also help, manual and replays
}

void MainWindow::nextTheme()
{
    chooseTheme(next(currentTheme().kind), currentBrightness());
}

void MainWindow::chooseTheme(ThemeKind theme, Brightness brightness)
{
    applyTheme(theme, brightness);
    Q_EMIT themeChanged(theme, brightness);
}

void MainWindow::showEditing(bool on)
{
    m_pickBar->withdraw();
    if (on) {
        m_panels->bringUp(m_panels->limits());
    }
}

void MainWindow::toggleEditing()
{
    m_plot->setEditing(!m_plot->editor().isEditing());
}

void MainWindow::toggleFullScreen()
{
    setWindowState(windowState() ^ Qt::WindowFullScreen);
}

void MainWindow::openMenu()
{
    m_menu->openBelow(m_header->menuButton());
}

void MainWindow::showManual()
{
    if (m_manual == nullptr) {
        m_manual = new ManualWindow(this);
    }
    showBelowHead(*m_manual);
}

void MainWindow::showHelp()
{
    showBelowHead(*m_help);
}

// Never over STOP and the state, and below the alarm and the numbers while the screen has room there. Beyond its edge
// nobody could read the page to its end or press Close.
void MainWindow::showBelowHead(QWidget& page)
{
    const auto placeOf = [this](const QWidget& part, QPoint corner) {
        return mapToGlobal(part.mapTo(this, corner)).y();
    };
    page.show();  // now it has its size. A desktop may tell its frame later
    const int frame = std::max(page.frameGeometry().height() - page.height(),
                               page.style()->pixelMetric(QStyle::PM_TitleBarHeight, nullptr, &page));
    const int lowest = screen()->availableGeometry().bottom() + 1 - page.height() - frame;
    const int below = placeOf(*m_head, m_head->rect().bottomLeft());
    page.move(mapToGlobal(QPoint()).x(), std::max(std::min(below, lowest), placeOf(*m_plot, {})));
    page.raise();
    page.activateWindow();
}

void MainWindow::saveDiagnostics()
{
    m_diagnostics->askWhere(*this, m_clock.utc(), [this] {
        return std::pair(diagnostics::Snapshot{.status = m_last.received(),
                                               .applied = m_draft.applied(),
                                               .stateDir = m_stateDir,
                                               .when = m_clock.utc()},
                         takeExcerpt(m_panels->charts().charts().store(), DiagnosticsSaver::kTelemetry, m_clock.now(),
                                     m_clock.utc()));
    });
}

WindowLayout MainWindow::arrangement() const
{
    return m_panels->arrangement();
}

void MainWindow::goTo()
{
    m_side->showPanels();
    m_places->focusGoTo();
}

void MainWindow::park()
{
    m_side->showPanels();  // a refusal is shown below the panels
    m_places->park();
}

}  // namespace boresight::ui

#include "moc_main_window.cpp"
