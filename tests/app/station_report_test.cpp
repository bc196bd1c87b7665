// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/boresightctl/station_report.h"

#include <QJsonArray>

#include <gtest/gtest.h>

namespace boresight::ctl {
namespace {

QJsonObject reportWith(const QJsonObject& transmit)
{
    QJsonObject report{{QStringLiteral("station"), QStringLiteral("127.0.0.1:4533")},
                       {QStringLiteral("state"), QStringLiteral("MOVING")},
                       {QStringLiteral("actual"), QJsonValue()}};
    if (!transmit.isEmpty()) {
        report[QStringLiteral("transmit")] = transmit;
    }
    return report;
}

// REQ-TRANSMIT-32: If the station has a transmit output, boresightctl status has a line about it: whether it is on, its
// problem, and what keeps it off.
TEST(StationReport, HasTheTransmitOutput)
{
    EXPECT_EQ(reportText(reportWith({})),
              QStringLiteral("station:  127.0.0.1:4533\nstate:    MOVING\nactual:   unknown\n"));
    EXPECT_TRUE(reportText(reportWith({{QStringLiteral("on"), true}})).endsWith(QStringLiteral("\ntransmit: on\n")));
    EXPECT_TRUE(reportText(reportWith({{QStringLiteral("on"), false},
                                       {QStringLiteral("problem"), QStringLiteral("unplugged")},
                                       {QStringLiteral("whyOff"), QStringLiteral("STOP is latched.")}}))
                    .endsWith(QStringLiteral("\ntransmit: off. unplugged. STOP is latched.\n")));
}

// REQ-CTL-999: boresightctl status has the error budget of a station of this computer: the sum, and a line for each
// part.
TEST(StationReport, HasTheErrorBudget)
{
    QJsonObject report = reportWith({});
    report[QStringLiteral("errorBudget")] = QJsonObject{
        {QStringLiteral("text"), QString::fromUtf8("Off by at least 0.04° (-0.1 dB)")},
        {QStringLiteral("parts"),
         QJsonArray{QJsonObject{{QStringLiteral("part"), QStringLiteral("servo")},
                                {QStringLiteral("degrees"), 0.0312},
                                {QStringLiteral("from"), QStringLiteral("Measured.")}},
                    QJsonObject{{QStringLiteral("part"), QStringLiteral("clock")},
                                {QStringLiteral("degrees"), QJsonValue()},
                                {QStringLiteral("from"), QStringLiteral("No time source sets the clock.")}}}}};
    EXPECT_TRUE(reportText(report).endsWith(
        QString::fromUtf8("\nerror:    Off by at least 0.04° (-0.1 dB)\n"
                          "  servo:       0.031°. Measured.\n"
                          "  clock:       not in the sum. No time source sets the clock.\n")))
        << reportText(report).toStdString();
}

// REQ-BRAKE-34: boresightctl status has a line about the brake of a station of this computer: its state, and the
// problem of its output.
TEST(StationReport, HasTheBrake)
{
    QJsonObject report = reportWith({});
    report[QStringLiteral("brake")] =
        QJsonObject{{QStringLiteral("state"), QStringLiteral("open")}, {QStringLiteral("problem"), QString()}};
    EXPECT_TRUE(reportText(report).endsWith(QStringLiteral("\nbrake:    open\n")));
    report[QStringLiteral("brake")] = QJsonObject{{QStringLiteral("state"), QStringLiteral("failed")},
                                                  {QStringLiteral("problem"), QStringLiteral("unplugged")}};
    EXPECT_TRUE(reportText(report).endsWith(QStringLiteral("\nbrake:    failed. unplugged\n")));
}

// REQ-ENDSWITCH-60: boresightctl status has a line about each end switch of a station of this computer.
TEST(StationReport, HasTheEndSwitches)
{
    QJsonObject report = reportWith({});
    report[QStringLiteral("endSwitches")] =
        QJsonArray{QJsonObject{{QStringLiteral("end"), QStringLiteral("azimuth lower")},
                               {QStringLiteral("state"), QStringLiteral("free")},
                               {QStringLiteral("problem"), QString()}},
                   QJsonObject{{QStringLiteral("end"), QStringLiteral("azimuth upper")},
                               {QStringLiteral("state"), QStringLiteral("unread")},
                               {QStringLiteral("problem"), QStringLiteral("board 1 does not reply")}}};
    EXPECT_TRUE(reportText(report).endsWith(
        QStringLiteral("\nswitch:   azimuth lower free\nswitch:   azimuth upper unread. board 1 does not reply\n")));
}

// REQ-CTL-304: For a station on this computer, boresightctl status shows the state, its reason and the motion like the
// window.
TEST(StationReport, HasWhatTheWindowShows)
{
    QJsonObject report = reportWith({});
    report[QStringLiteral("state")] = QStringLiteral("TRACK");
    report[QStringLiteral("reason")] = QString();
    report[QStringLiteral("motion")] = QStringLiteral("track Moon");
    EXPECT_EQ(reportText(report),
              QStringLiteral("station:  127.0.0.1:4533\nstate:    TRACK\nmotion:   track Moon\nactual:   unknown\n"));
    report[QStringLiteral("sets")] = QStringLiteral("2026-11-29T17:09:25.000Z");
    report[QStringLiteral("schedule")] = QStringLiteral("armed");
    report[QStringLiteral("alarms")] = QJsonArray{QStringLiteral("One."), QStringLiteral("Two.")};
    EXPECT_EQ(reportText(report),
              QStringLiteral("station:  127.0.0.1:4533\nstate:    TRACK\nmotion:   track Moon\n"
                             "sets:     2026-11-29T17:09:25.000Z\nschedule: armed\nactual:   unknown\n"
                             "alarm:    One.\nalarm:    Two.\n"));
    report = reportWith({});
    report[QStringLiteral("state")] = QStringLiteral("FAULT");
    report[QStringLiteral("reason")] = QStringLiteral("both drives stopped replying");
    report[QStringLiteral("motion")] = QString();
    EXPECT_EQ(reportText(report),
              QStringLiteral("station:  127.0.0.1:4533\nstate:    FAULT\nreason:   both drives stopped replying\n"
                             "actual:   unknown\n"));
}

// REQ-WIND-52: boresightctl status has a line about the wind where the station of this computer reads it: speed, age,
// and what it forbids. An old speed is not shown.
TEST(StationReport, HasTheWind)
{
    QJsonObject report = reportWith({});
    const auto ends = [&](const QJsonObject& wind) {
        report[QStringLiteral("wind")] = wind;
        return reportText(report).section(QLatin1Char('\n'), -2);
    };
    QJsonObject wind{{QStringLiteral("speed"), 7.2},
                     {QStringLiteral("age"), 1.2},
                     {QStringLiteral("silent"), false},
                     {QStringLiteral("obstacle"), QString()}};
    EXPECT_EQ(ends(wind), QStringLiteral("wind:     7.2 m/s, 1 s old\n"));
    wind[QStringLiteral("obstacle")] = QStringLiteral("The wind reached 17.0 m/s.");
    EXPECT_EQ(ends(wind), QStringLiteral("wind:     7.2 m/s, 1 s old. The wind reached 17.0 m/s.\n"));
    wind[QStringLiteral("obstacle")] = QString();
    wind[QStringLiteral("overriddenUntil")] = QStringLiteral("01:01:59Z");
    EXPECT_EQ(ends(wind), QStringLiteral("wind:     7.2 m/s, 1 s old. Motion is permitted until 01:01:59Z\n"));
    wind[QStringLiteral("overriddenUntil")] = QJsonValue();
    wind[QStringLiteral("silent")] = true;
    wind[QStringLiteral("age")] = 45.0;
    wind[QStringLiteral("obstacle")] = QString();
    EXPECT_EQ(ends(wind), QStringLiteral("wind:     unknown, no reading for 45 s\n"));
    wind[QStringLiteral("speed")] = QJsonValue();
    wind[QStringLiteral("age")] = QJsonValue();
    wind[QStringLiteral("silent")] = false;
    EXPECT_EQ(ends(wind), QStringLiteral("wind:     unknown, no reading yet\n"));
}

// REQ-CTL-305: After the clock of the computer was set, boresightctl status has a line about the clock while the
// station uses the old time. `use-new-time` confirms the new time.
TEST(StationReport, HasAClockThatWasSet)
{
    QJsonObject report = reportWith({});
    report[QStringLiteral("clockSetBy")] = -3600.0;
    EXPECT_TRUE(reportText(report).endsWith(
        QStringLiteral("\nclock:    set by -3600.0 s. The station uses the old time until use-new-time\n")));
}

}  // namespace
}  // namespace boresight::ctl
