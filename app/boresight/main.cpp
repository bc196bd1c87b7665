// SPDX-License-Identifier: GPL-3.0-or-later
// boresight: the desktop program. The window runs on this thread, the station on its own thread.
#include "app/boresight/report_mode.h"
#include "app/host_search.h"
#include "app/log_output.h"
#include "app/options.h"
#include "app/profile_saver.h"
#include "app/station_thread.h"
#include "app/table_file_reader.h"
#include "app/unix_signals.h"
#include "core/base/version.h"
#include "core/local_socket/local_command.h"
#include "core/moteus_mount/link_factory.h"
#include "core/station/mount_factory.h"
#include "ui/jog/gamepad.h"
#include "ui/kit/language.h"
#include "ui/look/desk_style.h"
#include "ui/window/main_window.h"
#include "ui/window/start_problem.h"

#include <QApplication>
#include <QElapsedTimer>
#include <QScreen>
#include <QSettings>

#include <algorithm>
#include <cstdio>

namespace {

using namespace boresight;

const QString kThemeKey = QStringLiteral("theme");
const QString kBrightnessKey = QStringLiteral("brightness");
const QString kSoundKey = QStringLiteral("alarm_sound");
const QString kLanguageKey = QStringLiteral("language");
const QString kRecentKey = QStringLiteral("recent_go_tos");
const QString kGeometryKey = QStringLiteral("geometry");
const QString kPanelKey = QStringLiteral("panel");
const QString kMountPanelKey = QStringLiteral("mount_panel");
const QString kChartWindowKey = QStringLiteral("chart_seconds");
const QString kChartAxisKey = QStringLiteral("chart_axis");
const QString kChartQuantityKey = QStringLiteral("chart_quantity");
const QString kPassesViewKey = QStringLiteral("passes_view");
const QString kFavouritesKey = QStringLiteral("passes_favourites_only");
const QString kColumnsKey = QStringLiteral("passes_columns");
const QString kGuideKey = QStringLiteral("guide");

constexpr int kFailed = 2;       // exit status
constexpr int kDarkBelow = 128;  // of 255: a desktop with a lower lightness is dark

int complain(const QString& text)
{
    app::printError(QStringLiteral("boresight: ") + text);
    return kFailed;
}

ui::WindowLayout readLayout(const QSettings& kept)
{
    const ui::WindowLayout usual;
    const auto number = [&kept](const QString& key, int otherwise) { return kept.value(key, otherwise).toInt(); };
    return {.panel = number(kPanelKey, usual.panel),
            .mountPanel = number(kMountPanelKey, usual.mountPanel),
            .charts = {.axis = static_cast<Axis>(number(kChartAxisKey, 0)),
                       .window = std::chrono::seconds(number(kChartWindowKey, int(usual.charts.window.count()))),
                       .quantity = static_cast<ui::DriveQuantity>(number(kChartQuantityKey, 0))},
            .passes = {.view = number(kPassesViewKey, usual.passes.view),
                       .onlyFavourites = kept.value(kFavouritesKey, usual.passes.onlyFavourites).toBool(),
                       .columns = kept.value(kColumnsKey).toStringList()}};
}

void keepLayout(const ui::WindowLayout& layout, QSettings& kept)
{
    kept.setValue(kPanelKey, layout.panel);
    kept.setValue(kMountPanelKey, layout.mountPanel);
    kept.setValue(kChartWindowKey, int(layout.charts.window.count()));
    kept.setValue(kChartAxisKey, static_cast<int>(layout.charts.axis));
    kept.setValue(kChartQuantityKey, static_cast<int>(layout.charts.quantity));
    kept.setValue(kPassesViewKey, layout.passes.view);
    kept.setValue(kFavouritesKey, layout.passes.onlyFavourites);
    kept.setValue(kColumnsKey, layout.passes.columns);
}

// The guide opens by itself at the first start. Later it is open if it was open when the program ended.
ui::GuideProgress guideProgress(const app::Options& options, const QSettings& layout)
{
    if (!layout.contains(kGuideKey)) {
        return {.open = options.isFirstStart()};
    }
    return ui::guideProgressFrom(layout.value(kGuideKey).toString());
}

ui::WindowSettings windowSettings(const app::Options& options, const QSettings& layout)
{
    return {.theme = static_cast<ui::ThemeKind>(layout.value(kThemeKey, 0).toInt()),
            .brightness = static_cast<ui::Brightness>(std::clamp(layout.value(kBrightnessKey, 0).toInt(), 0, 2)),
            .language = layout.value(kLanguageKey).toString(),
            .guide = guideProgress(options, layout),
            .alarmSound = layout.value(kSoundKey, true).toBool(),
            .recentGoTos = layout.value(kRecentKey).toStringList(),
            .layout = readLayout(layout),
            .stateDir = options.stateDir,
            .configDir = options.configDir,
            .rotators = rotatorOffers(),
            .onlySimulated = options.simulation != Simulation::Off};
}

// Prints the time from main() to the first picture with a live status. For tests/bench.
void reportStart(const QElapsedTimer& sinceStart, ui::MainWindow& window)
{
    if (!qEnvironmentVariableIsSet("BORESIGHT_STARTUP_TIMING")) {
        return;
    }
    QObject::connect(
        &window, &ui::MainWindow::updateShown, &window,
        [sinceStart] {
            std::fprintf(stderr, "first picture after %lld ms\n", static_cast<long long>(sinceStart.elapsed()));
        },
        static_cast<Qt::ConnectionType>(Qt::QueuedConnection | Qt::SingleShotConnection));
}

// At the first start: the preferred size if it fits into the screen with a window frame, else maximized.
void showFirst(ui::MainWindow& window)
{
    const QSize frame(16, 48);  // generous: the real size of the frame is known only after the window is shown
    const QSize room = window.screen()->availableSize() - frame;
    if (window.width() <= room.width() && window.height() <= room.height()) {
        window.show();
    } else {
        window.showMaximized();
    }
}

void connectWindow(ui::MainWindow& window, app::StationThread& station, QSettings& layout)
{
    QObject::connect(&window, &ui::MainWindow::requested, &station, &app::StationThread::requested);
    QObject::connect(&window, &ui::MainWindow::updateShown, &station, &app::StationThread::updateTaken);
    QObject::connect(&station, &app::StationThread::updated, &window, &ui::MainWindow::showUpdate);
    QObject::connect(&window, &ui::MainWindow::closeRequested, &station, &app::StationThread::shutDownRequested);
    QObject::connect(&station, &app::StationThread::finished, &window, [&window, &layout] {
        layout.setValue(kGeometryKey, window.saveGeometry());
        keepLayout(window.arrangement(), layout);
        window.closeNow();
    });
    QObject::connect(&window, &ui::MainWindow::themeChanged, &window,
                     [&layout](ui::ThemeKind theme, ui::Brightness brightness) {
                         layout.setValue(kThemeKey, static_cast<int>(theme));
                         layout.setValue(kBrightnessKey, static_cast<int>(brightness));
                     });
    QObject::connect(&window, &ui::MainWindow::alarmSoundChanged, &window,
                     [&layout](bool on) { layout.setValue(kSoundKey, on); });
    QObject::connect(&window, &ui::MainWindow::guideProgressed, &window, [&layout](const ui::GuideProgress& progress) {
        layout.setValue(kGuideKey, ui::toText(progress));
    });
    QObject::connect(&window, &ui::MainWindow::languageChanged, &window,
                     [&layout](const QString& language) { layout.setValue(kLanguageKey, language); });
    QObject::connect(&window, &ui::MainWindow::recentGoTosChanged, &window,
                     [&layout](const QStringList& recent) { layout.setValue(kRecentKey, recent); });
}

void connectHost(ui::HostDesk& desk, app::HostSearch& search, app::TableFileReader& tables)
{
    QObject::connect(&desk, &ui::HostDesk::adaptersWanted, &search, &app::HostSearch::findAdapters);
    QObject::connect(&desk, &ui::HostDesk::rotatorModelsWanted, &search, &app::HostSearch::findRotatorModels);
    QObject::connect(&search, &app::HostSearch::rotatorModelsFound, &desk, &ui::HostDesk::rotatorModelsFound);
    QObject::connect(&desk, &ui::HostDesk::scanWanted, &search, &app::HostSearch::scan);
    QObject::connect(&desk, &ui::HostDesk::gpredictWanted, &search, &app::HostSearch::findGpredict);
    QObject::connect(&search, &app::HostSearch::adaptersFound, &desk, &ui::HostDesk::adaptersFound);
    QObject::connect(&search, &app::HostSearch::scanned, &desk, &ui::HostDesk::scanned);
    QObject::connect(&search, &app::HostSearch::gpredictFound, &desk, &ui::HostDesk::gpredictFound);
    QObject::connect(&desk, &ui::HostDesk::tableWanted, &tables, &app::TableFileReader::read);
    QObject::connect(&tables, &app::TableFileReader::wasRead, &desk, &ui::HostDesk::tableRead);
}

int run(QApplication& application, const app::Options& options, const QElapsedTimer& sinceStart)
{
    QSettings layout(options.stateDir + QStringLiteral("/window.ini"), QSettings::IniFormat);
    const ui::Translation translation(layout.value(kLanguageKey).toString());
    const SystemClock clock;
    app::ProfileSaver saver(options);
    const MountFactory mounts(saver.first(), clock);
    const auto make = [&](const profile::Profile& profile, const std::optional<EnteredPlace>& standingAt) {
        const Simulation simulation = options.simulationFor(profile);
        const MountMaker mount = mounts.make(profile, {options.stateDir, simulation, standingAt});
        auto station = std::make_unique<Station>(profile, mount, options.stateDir, clock);
        station->setSensorMaker(mounts.sensors(profile, simulation));
        station->setFaults(mounts.faults(profile, simulation));
        station->serveShell(local::runtimeFolder());
        station->wantRealTime();
        return station;
    };
    const auto build = [&](const profile::Profile& profile) { return make(profile, std::nullopt); };
    app::StationThread station(make(saver.first(), options.standingAt), build);
    ui::MainWindow window(clock, windowSettings(options, layout));
    app::HostSearch search(makeLink);
    app::TableFileReader tables;
    const bool known = window.restoreGeometry(layout.value(kGeometryKey).toByteArray());
    connectWindow(window, station, layout);
    const std::unique_ptr<ui::Gamepad> gamepad = ui::Gamepad::create();
    if (gamepad) {
        window.useGamepad(*gamepad);
    }
    connectHost(window.host(), search, tables);
    QObject::connect(&station, &app::StationThread::profileApplied, &saver, &app::ProfileSaver::save);
    QObject::connect(&station, &app::StationThread::nextWanted, &saver, &app::ProfileSaver::findNext);
    QObject::connect(&saver, &app::ProfileSaver::nextFound, &station, &app::StationThread::begin);
    QObject::connect(&saver, &app::ProfileSaver::failed, &window, &ui::MainWindow::warn);
    app::UnixSignals signals;
    QObject::connect(&signals, &app::UnixSignals::endRequested, &station, &app::StationThread::shutDownRequested);
    reportStart(sinceStart, window);
    station.start();
    known ? window.show() : showFirst(window);
    return application.exec();
}

}  // namespace

namespace {

void nameProgram()
{
    QCoreApplication::setApplicationName(QStringLiteral("boresight"));
    QCoreApplication::setApplicationVersion(QString::fromUtf8(kVersion.data(), kVersion.size()));
}

// Help, version and errors of the command line or the profile are printed without a display.
tl::expected<app::Options, app::NoStart> readOptionsAlone(int argc, char** argv, const QStringList& more)
{
    const QCoreApplication application(argc, argv);
    nameProgram();
    return app::readOptions(QCoreApplication::arguments() + more,
                            QStringLiteral("Controls a ground-station antenna mount."));
}

// A program that was started from a menu has no terminal, so a window shows the problem and offers another profile. The
// end of the session closes the window like its button. Returns the chosen profile; empty: none.
QString complainInWindow(int argc, char** argv, const QString& text)
{
    QApplication::setStyle(QStringLiteral("Fusion"));
    const QApplication application(argc, argv);
    const ui::Translation translation({});
    const bool dark = QApplication::palette().color(QPalette::Window).lightness() < kDarkBelow;
    ui::applyTheme(dark ? ui::ThemeKind::Night : ui::ThemeKind::Day);
    ui::StartProblem problem(text);
    const app::UnixSignals signals;
    QObject::connect(&signals, &app::UnixSignals::endRequested, &problem, &QWidget::close);
    problem.show();
    complain(QStringLiteral("the window shows: ") + text);
    QApplication::exec();
    return problem.chosenProfile();
}

bool hasDisplay()
{
    return qEnvironmentVariableIsSet("DISPLAY") || qEnvironmentVariableIsSet("WAYLAND_DISPLAY") ||
           qEnvironmentVariableIsSet("QT_QPA_PLATFORM");
}

}  // namespace

int main(int argc, char** argv)
{
    QElapsedTimer sinceStart;
    sinceStart.start();
    app::logToStandardError();
    if (app::asksForReport(argc, argv)) {
        return app::runReport(argc, argv);
    }
    auto options = readOptionsAlone(argc, argv, {});
    while (!options) {
        const bool typed = argc > 1 && !options.error().byItsProfile;
        if (typed || !hasDisplay()) {
            return complain(options.error().error.text);
        }
        const QString profile = complainInWindow(argc, argv, options.error().error.text);
        if (profile.isEmpty()) {
            return kFailed;
        }
        options = readOptionsAlone(argc, argv, {QStringLiteral("--profile"), profile});
    }
    options->profile = options->startingProfile();
    if (!hasDisplay()) {
        return complain(QStringLiteral(
            "there is no display (DISPLAY and WAYLAND_DISPLAY are empty). Without a display run boresightd"));
    }
    QApplication application(argc, argv);
    ui::DeskStyle::install();
    nameProgram();
    QApplication::setApplicationDisplayName(QStringLiteral("Boresight"));
    QApplication::setDesktopFileName(QStringLiteral("boresight"));
    return run(application, *options, sinceStart);
}
