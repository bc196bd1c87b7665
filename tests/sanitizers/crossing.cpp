// SPDX-License-Identifier: GPL-3.0-or-later
//
// Two threads exchange values as the station and the window do: only by queued signals and queued calls. Under the tsan
// preset this must end without a report. With the argument "race" both threads also access one plain variable, and
// ThreadSanitizer must report it: what qt_event_order.cpp and tsan.supp allow must stay narrow.

#include <QtCore/QCoreApplication>
#include <QtCore/QString>
#include <QtCore/QThread>
#include <QtCore/QTimer>

#include <cstdio>
#include <string>
#include <utility>
#include <vector>

namespace {

constexpr int kExchanges = 300;

struct Values
{
    double number = 0;
    std::vector<double> path;
    std::string text;
    QString name;
};

Values makeValues(int number)
{
    // Longer than the small-string buffer, so that the text is on the heap.
    return {.number = double(number),
            .path = std::vector<double>(20, number),
            .text = std::string(40, 'x'),
            .name = QStringLiteral("status %1").arg(number)};
}

int g_unguarded = 0;

class Station : public QObject
{
    Q_OBJECT

public:
    explicit Station(bool race) : m_race(race)
    {
        m_tick.setParent(this);
        connect(&m_tick, &QTimer::timeout, this, &Station::tick);
    }

    void start() { m_tick.start(1); }
    void take(Values values) { m_last = std::move(values); }

Q_SIGNALS:
    void status(Values values);

private:
    void tick()
    {
        if (m_race) {
            ++g_unguarded;
        }
        Q_EMIT status(makeValues(++m_ticks));
    }

    const bool m_race;
    QTimer m_tick;
    int m_ticks = 0;
    Values m_last;
};

class Window : public QObject
{
    Q_OBJECT

public:
    Window(Station& station, bool race) : m_station(station), m_race(race)
    {
        connect(&station, &Station::status, this, &Window::show);
        connect(this, &Window::request, &station, &Station::take);
    }

Q_SIGNALS:
    void request(Values values);

private:
    void show(const Values& values)
    {
        m_sum += values.path.front() + double(values.text.size()) + double(values.name.size());
        Q_EMIT request(values);
        QMetaObject::invokeMethod(
            &m_station, [station = &m_station, values] { station->take(values); }, Qt::QueuedConnection);
        if (m_race) {
            m_sum += g_unguarded;  // after the last event to the other thread, so that nothing orders this access
        }
        if (++m_shown == kExchanges) {
            QCoreApplication::quit();
        }
    }

    Station& m_station;
    const bool m_race;
    double m_sum = 0;
    int m_shown = 0;
};

}  // namespace

int main(int argc, char** argv)
{
    QCoreApplication application(argc, argv);
    const bool race = argc > 1 && std::string(argv[1]) == "race";
    QThread thread;
    auto* station = new Station(race);
    Window window(*station, race);
    station->moveToThread(&thread);
    QObject::connect(&thread, &QThread::started, station, &Station::start);
    QObject::connect(&thread, &QThread::finished, station, &QObject::deleteLater);
    thread.start();
    QCoreApplication::exec();
    thread.quit();
    thread.wait();
    std::puts("finished");
    return 0;
}

#include "crossing.moc"
