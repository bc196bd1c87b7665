// SPDX-License-Identifier: GPL-3.0-or-later
//
// frame_gap
//
// How long the thread of the window is blocked. The whole desktop program without its main() runs on the simulated
// mount. It connects and checks the drives, scans, moves while the panels are changed, has faults, saves its profile
// again and again, and reconnects. A timer of 5 ms in the window's thread measures the gaps. A frame is late after 50
// ms. One line for each part: ticks, 99th percentile and worst gap in ms, gaps over 50 ms. Needs a display, or
// QT_QPA_PLATFORM=offscreen.

#include "app/profile_saver.h"
#include "app/station_thread.h"
#include "core/moteus_mount/moteus_connection.h"
#include "core/sim_bus/simulated_link.h"
#include "ui/window/main_window.h"

#include <QApplication>
#include <QElapsedTimer>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>

#include <algorithm>
#include <cstdio>
#include <vector>

namespace {

using namespace boresight;
using sim::FaultKind;

constexpr int kPeriod = 5;  // ms
constexpr double kLate = 50.0;

class GapTimer
{
public:
    GapTimer()
    {
        m_timer.setTimerType(Qt::PreciseTimer);
        QObject::connect(&m_timer, &QTimer::timeout, &m_timer, [this] {
            m_gaps.push_back(static_cast<double>(m_since.nsecsElapsed()) / 1e6);
            m_since.start();
        });
        m_since.start();
        m_timer.start(kPeriod);
    }

    void tell(const char* part)
    {
        std::ranges::sort(m_gaps);
        const auto late = std::ranges::count_if(m_gaps, [](double gap) { return gap > kLate; });
        const std::size_t count = m_gaps.size();
        std::printf("%-28s %5zu ticks  p99 %5.1f ms  worst %5.1f ms  late %td\n", part, count,
                    count > 0 ? m_gaps[count * 99 / 100] : 0.0, count > 0 ? m_gaps.back() : 0.0, late);
        m_gaps.clear();
    }

private:
    QTimer m_timer;
    QElapsedTimer m_since;
    std::vector<double> m_gaps;
};

// The program: station on its thread, saver, window.
class Desk
{
public:
    Desk()
        : m_station(build(m_profile), [this](const profile::Profile& next) { return build(next); }),
          m_saver({.profile = m_profile,
                   .profilePath = m_folder.filePath(QStringLiteral("mount.toml")),
                   .configDir = m_folder.path(),
                   .stateDir = m_folder.path(),
                   .simulation = Simulation::Reference}),
          m_window(m_clock, {.stateDir = m_folder.path(), .configDir = m_folder.path()})
    {
        QObject::connect(&m_window, &ui::MainWindow::requested, &m_station, &app::StationThread::requested);
        QObject::connect(&m_window, &ui::MainWindow::updateShown, &m_station, &app::StationThread::updateTaken);
        QObject::connect(&m_station, &app::StationThread::updated, &m_window, &ui::MainWindow::showUpdate);
        QObject::connect(&m_station, &app::StationThread::profileApplied, &m_saver, &app::ProfileSaver::save);
        QObject::connect(&m_station, &app::StationThread::nextWanted, &m_saver, &app::ProfileSaver::findNext);
        QObject::connect(&m_saver, &app::ProfileSaver::nextFound, &m_station, &app::StationThread::begin);
    }

    void start()
    {
        m_window.resize(1280, 800);
        m_window.show();
        m_station.start();
    }

    void ask(const Request& request) { Q_EMIT m_station.requested({.id = ++m_id, .request = request}); }

    void applyNextProfile()
    {
        m_profile.mount.beamWidth = Angle::fromDegrees(m_profile.mount.beamWidth.degrees() + 0.1);
        ask(request::ApplyProfile{m_profile});
    }

    void reconnect() { ask(request::Reconnect{m_profile}); }

    void nextPanel()
    {
        m_panel = m_panel % 8 + 1;
        QTest::keyClick(&m_window, static_cast<Qt::Key>(Qt::Key_0 + m_panel), Qt::ControlModifier);
    }

private:
    using Owned = std::unique_ptr<Station>;

    [[nodiscard]] Owned build(const profile::Profile& profile)
    {
        auto link = std::make_unique<SimulatedLink>(m_clock);
        // By the clock of the pair, within the part "faults".
        for (const sim::Injection& fault :
             {sim::Injection{.kind = FaultKind::BusOff, .at = Seconds(16.0), .duration = Seconds(1.5)},
              sim::Injection{.kind = FaultKind::DriveFault, .axis = Axis::Azimuth, .at = Seconds(20.0), .value = 38.0},
              sim::Injection{.kind = FaultKind::PowerLoss, .at = Seconds(22.0), .duration = Seconds(0.5)}}) {
            link->pair().faults().add(fault);
        }
        return std::make_unique<Station>(profile,
                                         moteusRotator(std::move(link), {m_folder.path(), Simulation::Reference}),
                                         m_folder.path(), m_clock);
    }

    [[nodiscard]] static profile::Profile onAnyPort()
    {
        profile::Profile profile;
        profile.rotctld.listen.port = 0;
        return profile;
    }

    QTemporaryDir m_folder;
    SystemClock m_clock;
    profile::Profile m_profile = onAnyPort();
    app::StationThread m_station;
    app::ProfileSaver m_saver;
    ui::MainWindow m_window;
    std::uint64_t m_id = 0;
    int m_panel = 0;
};

struct Part
{
    const char* name;
    int milliseconds;
    void (*begin)(Desk&);
    void (*again)(Desk&);  // every 200 ms
};

constexpr Part kParts[] = {{"connect and check the drives", 4000, [](Desk& desk) { desk.start(); }, [](Desk&) {}},
                           {"scan", 4000, [](Desk& desk) { desk.ask(request::ReadDrives{}); }, [](Desk&) {}},
                           {"move, all panels", 7000,
                            [](Desk& desk) { desk.ask(request::PointAxes{{.azimuth = 100_deg, .elevation = 45_deg}}); },
                            [](Desk& desk) { desk.nextPanel(); }},
                           {"bus off, faults, power loss", 10000, [](Desk&) {}, [](Desk& desk) { desk.nextPanel(); }},
                           {"apply and save", 4000, [](Desk&) {}, [](Desk& desk) { desk.applyNextProfile(); }},
                           {"reconnect", 5000, [](Desk& desk) { desk.reconnect(); }, [](Desk&) {}}};

}  // namespace

int main(int argc, char** argv)
{
    const QApplication application(argc, argv);
    QApplication::setStyle(QStringLiteral("Fusion"));
    GapTimer gaps;
    Desk desk;
    QTest::qWait(100);
    gaps.tell("window made");
    for (const Part& part : kParts) {
        part.begin(desk);
        QTimer again;
        QObject::connect(&again, &QTimer::timeout, &again, [&] { part.again(desk); });
        again.start(200);
        QTest::qWait(part.milliseconds);
        again.stop();
        gaps.tell(part.name);
    }
    return 0;
}
