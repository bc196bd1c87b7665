// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/drives/drives_fixture.h"
#include "ui/drives/readings_model.h"
#include "ui/drives/readings_table.h"

#include <QApplication>
#include <QClipboard>
#include <QFile>
#include <QScrollBar>
#include <QTemporaryDir>

namespace boresight::ui {
namespace {

using namespace std::chrono_literals;

class ReadingsTest : public DrivesTest
{
protected:
    ReadingsTest() : panel(open<ReadingsTable>()) {}

    [[nodiscard]] QAbstractItemModel& readings() { return *named<QTableView>("Readings of the drives")->model(); }
    [[nodiscard]] QModelIndex at(const char* quantity, ReadingsModel::Column column)
    {
        for (int row = 0; row < readings().rowCount(); ++row) {
            if (readings().index(row, 0).data().toString() == QString::fromUtf8(quantity)) {
                return readings().index(row, column);
            }
        }
        ADD_FAILURE() << "no row " << quantity;
        return {};
    }
    [[nodiscard]] std::string azimuth(const char* quantity)
    {
        return at(quantity, ReadingsModel::Azimuth).data().toString().toStdString();
    }
    [[nodiscard]] std::string elevation(const char* quantity)
    {
        return at(quantity, ReadingsModel::Elevation).data().toString().toStdString();
    }
    void giveAge(std::chrono::milliseconds age)
    {
        StationStatus status = samples::idle();
        status.drives->elevation.readings.age = age;
        give(samples::update(status));
    }

    ReadingsTable& panel;
};

// REQ-UI-910: One table shows the readings of each drive with their units: position and velocity in degrees and in
// turns of the drive, torque, both currents, power, voltage, temperatures, mode, fault, age of the reply, lost replies.
TEST_F(ReadingsTest, EachQuantityStandsInItsRowAndAxis)
{
    StationStatus status = samples::idle();
    status.azimuth.actual = 112.95_deg;
    status.azimuth.rate = -0.45_deg_s;
    status.drives->azimuth.readings.dCurrent = 0.3;
    status.drives->azimuth.readings.motorTemperature = 51.5;
    give(samples::update(status));
    EXPECT_TRUE(panel.isVisible());
    EXPECT_EQ(azimuth("Position of the axis (°)"), "112.95");
    EXPECT_EQ(azimuth("Position of the drive (turns)"), "0.31375");
    EXPECT_EQ(azimuth("Velocity of the axis (°/s)"), "-0.45");
    EXPECT_EQ(azimuth("Velocity of the drive (turns/s)"), "-0.00125");
    EXPECT_EQ(azimuth("Torque (Nm)"), "1.25");
    EXPECT_EQ(elevation("Torque (Nm)"), "-2.40");
    EXPECT_EQ(azimuth("Current q (A)"), "2.1");
    EXPECT_EQ(azimuth("Current d (A)"), "0.3");
    EXPECT_EQ(elevation("Electrical power (W)"), "11.8");
    EXPECT_EQ(azimuth("Supply voltage (V)"), "24.1");
    EXPECT_EQ(azimuth("Board temperature (°C)"), "38.0");
    EXPECT_EQ(azimuth("Motor temperature (°C)"), "51.5");
    EXPECT_EQ(elevation("Motor temperature (°C)"), "—") << "not reported";
    EXPECT_EQ(azimuth("Mode"), "position (10)");
    EXPECT_EQ(azimuth("Fault"), "none");
    EXPECT_EQ(azimuth("Age of the reply (s)"), "0.01");
    EXPECT_EQ(azimuth("Frames sent"), "30451");
    EXPECT_EQ(azimuth("Replies lost"), "0");
    EXPECT_EQ(elevation("Replies lost"), "12");
}

// REQ-UI-911: Old readings never look live. After 0.5 s they are dimmed, after 2 s they are not shown. The age of the
// last reply is always shown, in the warning colour.
TEST_F(ReadingsTest, OldReadingsDoNotLookLive)
{
    const auto colour = [this](const char* quantity) {
        return at(quantity, ReadingsModel::Elevation).data(Qt::ForegroundRole).value<QColor>();
    };
    EXPECT_EQ(colour("Torque (Nm)"), currentTheme().text);
    giveAge(600ms);
    EXPECT_EQ(elevation("Torque (Nm)"), "-2.40");
    EXPECT_EQ(colour("Torque (Nm)"), currentTheme().secondary);
    EXPECT_EQ(colour("Age of the reply (s)"), currentTheme().warning);
    giveAge(2500ms);
    for (const char* const quantity : {"Position of the axis (°)", "Torque (Nm)", "Mode", "Fault"}) {
        EXPECT_EQ(elevation(quantity), "—") << quantity;
    }
    EXPECT_EQ(elevation("Age of the reply (s)"), "2.50");
    EXPECT_EQ(colour("Age of the reply (s)"), currentTheme().warning);
    EXPECT_EQ(elevation("Replies lost"), "12");
    EXPECT_EQ(azimuth("Torque (Nm)"), "1.25") << "the other axis is live";
}

// REQ-UI-991: Below the readings are the power of all drives, and the energy and the highest power of the running
// motion, or else of the last one. Power that is not reported, and gaps in it, are named.
TEST_F(ReadingsTest, PowerAndEnergyOfAMotionAreShown)
{
    StationStatus status = samples::tracking(150.0);
    status.power = {.total = 54.12, .running = MotionEnergy{.joules = 1260.0, .peak = 61.2, .time = Seconds(120.0)}};
    give(samples::update(status));
    EXPECT_EQ(text("Electrical power and energy").toStdString(), "Power: 54.1 W. This motion: 0.35 Wh, peak 61 W.");
    status.power = {.last =
                        MotionEnergy{.joules = -120.0, .peak = 12.0, .time = Seconds(120.0), .unknown = Seconds(3.2)}};
    give(samples::update(status));
    EXPECT_EQ(text("Electrical power and energy").toStdString(),
              "Power: not reported. Last motion: -120 J, peak 12 W, 3 s not reported.");
}

// REQ-UI-912: The readings are copied separated by tabs, and saved as CSV with UTC, units and the ids of the boards.
// The values are those of the moment of the press.
TEST_F(ReadingsTest, TheReadingsAreCopiedAndSaved)
{
    click("Copy");
    const QString copied = QApplication::clipboard()->text();
    EXPECT_TRUE(copied.startsWith(QStringLiteral("2026-11-21 "))) << copied.toStdString();
    EXPECT_TRUE(copied.contains(QStringLiteral("\nTorque (Nm)\t1.25\t-2.40\n"))) << copied.toStdString();
    const QTemporaryDir folder;
    click("Save as …");
    giveAge(5s);
    chooseFile(folder.filePath(QStringLiteral("readings")));
    QFile file(folder.filePath(QStringLiteral("readings.csv")));
    ASSERT_TRUE(comesTrue([&file] { return file.exists(); }));
    ASSERT_TRUE(file.open(QIODevice::ReadOnly));
    const QStringList lines = QString::fromUtf8(file.readAll()).split(QLatin1Char('\n'));
    EXPECT_EQ(lines.at(0), QStringLiteral("\"UTC\",\"Quantity\",\"Unit\",\"azimuth\",\"elevation\""));
    EXPECT_TRUE(lines.at(1).endsWith(QStringLiteral("Z\",\"Id\",\"\",\"1\",\"2\""))) << lines.at(1).toStdString();
    EXPECT_FALSE(lines.filter(QStringLiteral("\"Torque\",\"Nm\",\"1.25\",\"-2.40\"")).isEmpty());
    EXPECT_FALSE(lines.filter(QStringLiteral("\"Motor temperature\",\"°C\",\"\",\"\"")).isEmpty());
    EXPECT_EQ(text("Outcome"), QStringLiteral("Readings saved"));
}

// REQ-UI-913: A board that is only watched has a separate column under its name, also in copied and saved text.
TEST_F(ReadingsTest, AWatchedBoardHasAColumn)
{
    StationStatus status = samples::idle();
    status.drives->watched = {{.id = 3, .name = QStringLiteral("polarisation"), .readings = {}}};
    status.drives->watched[0].readings.torque = 0.75;
    status.drives->watched[0].readings.age = 100ms;
    give(samples::update(status));
    ASSERT_EQ(readings().columnCount(), 4);
    EXPECT_EQ(readings().headerData(3, Qt::Horizontal, Qt::DisplayRole).toString(), QStringLiteral("polarisation"));
    EXPECT_EQ(at("Torque (Nm)", ReadingsModel::FirstWatched).data().toString(), QStringLiteral("0.75"));
    EXPECT_EQ(at("Position of the axis (°)", ReadingsModel::FirstWatched).data().toString(), QStringLiteral("—"));
    click("Copy");
    EXPECT_TRUE(QApplication::clipboard()->text().contains(QStringLiteral("Torque (Nm)\t1.25\t-2.40\t0.75\n")));
    give(samples::update(samples::idle()));
    EXPECT_EQ(readings().columnCount(), 3) << "the profile does not name it any more";
}

TEST_F(ReadingsTest, AllRowsAreSeenAtTheUsualSize)
{
    window.resize(1280, 800);
    QApplication::processEvents();
    auto* const view = named<QTableView>("Readings of the drives");
    EXPECT_LE(view->verticalScrollBar()->maximum(), 0);
}

}  // namespace
}  // namespace boresight::ui
