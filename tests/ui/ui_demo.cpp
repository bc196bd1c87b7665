// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/clock.h"
#include "tests/ui/sample_status.h"
#include "ui/window/main_window.h"

#include <QApplication>
#include <QCommandLineParser>
#include <QElapsedTimer>
#include <QTextStream>

#include <ctime>
#include <numbers>

// A look at the window without a station: a pass crossing north in quick motion at 20 Hz, or one scene of trouble.
//   ui_demo [--scene
//   track|stopped|fault|disconnected|limited|operator|stale|factory|fresh|reading|released|proof|turn|turns]
//   [--theme day|night|red] [--seconds N]
// With --seconds it ends by itself and prints the time to the first picture and the processor time used.
namespace {

using namespace boresight;

constexpr double kQuickMotion = 4.0;

StationStatus scene(const QString& name, double seconds)
{
    if (name == QLatin1String("stopped")) {
        return samples::stopped();
    }
    if (name == QLatin1String("fault")) {
        return samples::faulted();
    }
    if (name == QLatin1String("disconnected")) {
        return samples::disconnected();
    }
    if (name == QLatin1String("limited")) {
        return samples::limited();
    }
    if (name == QLatin1String("operator")) {
        return samples::operatorMoving();
    }
    if (name == QLatin1String("factory")) {
        return samples::factoryDrives();
    }
    if (name == QLatin1String("fresh")) {
        return samples::freshMount();  // F3 opens the guide
    }
    if (name == QLatin1String("reading")) {
        return samples::reading();
    }
    if (name == QLatin1String("released")) {
        return samples::released();
    }
    if (name == QLatin1String("proof")) {
        return samples::proving();
    }
    if (name == QLatin1String("turn")) {
        return samples::asking(Axis::Azimuth, 3, 360_deg / 2.0, true);
    }
    if (name == QLatin1String("turns")) {
        return samples::asking(Axis::Azimuth, 150, 3.6_deg, false);
    }
    const StationStatus status = samples::tracking(std::fmod(seconds * kQuickMotion, samples::kPassLength));
    return name == QLatin1String("stale") ? samples::withAge(status, std::chrono::milliseconds(900)) : status;
}

ui::ThemeKind themeNamed(const QString& name)
{
    return name == QLatin1String("night") ? ui::ThemeKind::Night
           : name == QLatin1String("red") ? ui::ThemeKind::Red
                                          : ui::ThemeKind::Day;
}

double processorSeconds()
{
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

}  // namespace

int main(int argc, char* argv[])
{
    QElapsedTimer running;
    running.start();
    QApplication app(argc, argv);
    QApplication::setStyle(QStringLiteral("Fusion"));
    QCommandLineParser options;
    options.addOptions({{QStringLiteral("scene"), {}, QStringLiteral("name"), QStringLiteral("track")},
                        {QStringLiteral("theme"), {}, QStringLiteral("name"), QStringLiteral("day")},
                        {QStringLiteral("size"), {}, QStringLiteral("width"), QStringLiteral("1280")},
                        {QStringLiteral("seconds"), {}, QStringLiteral("n"), QStringLiteral("0")}});
    options.process(app);

    const SystemClock clock;
    ui::WindowSettings settings;
    settings.theme = themeNamed(options.value(QStringLiteral("theme")));
    ui::MainWindow window(clock, settings);
    const bool small = options.value(QStringLiteral("size")) == QLatin1String("1024");
    window.resize(small ? QSize(1024, 700) : QSize(1280, 800));

    std::vector<Answer> answers;  // this station accepts everything and does nothing
    QObject::connect(&window, &ui::MainWindow::requested, &window, [&](const NumberedRequest& request) {
        answers.push_back({request.id, std::nullopt});
    });
    QObject::connect(&window, &ui::MainWindow::closeRequested, &window, [&] { window.closeNow(); });

    std::uint64_t ticks = 0;
    SteadyTime sampled = clock.now() - std::chrono::minutes(12);  // the charts start with past data
    QTimer tick;
    QObject::connect(&tick, &QTimer::timeout, &window, [&] {
        StationUpdate update = samples::update(scene(options.value(QStringLiteral("scene")), double(ticks) * 0.05));
        update.answers.swap(answers);
        update.samples = samples::ticks(sampled, Seconds(clock.now() - sampled).count());
        sampled += std::chrono::milliseconds(20) * static_cast<int>(update.samples.size());
        if (ticks++ % 20 == 0) {
            update.log.push_back(samples::logEntry(ticks / 20, Severity::Advisory,
                                                   QStringLiteral("rotctld 127.0.0.1:51234"),
                                                   update.status.targetText + QStringLiteral(": accepted")));
        }
        window.showUpdate(update);
    });
    tick.start(50);

    window.show();
    QTextStream out(stdout);
    double begin = 0.0;
    QTimer::singleShot(0, &window, [&] { out << "first picture after " << running.elapsed() << " ms" << Qt::endl; });
    const int seconds = options.value(QStringLiteral("seconds")).toInt();
    if (seconds > 0) {
        QTimer::singleShot(2000, &window, [&] { begin = processorSeconds(); });
        QTimer::singleShot(2000 + seconds * 1000, &window, [&] {
            out << "processor " << 100.0 * (processorSeconds() - begin) / seconds << " % of one core" << Qt::endl;
            QApplication::exit();  // quit() would close the window, which asks the operator
        });
    }
    return QApplication::exec();
}
