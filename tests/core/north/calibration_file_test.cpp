// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/north/calibration_file.h"

#include "tests/fakes/wait_until.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>

#include <gtest/gtest.h>

namespace boresight {
namespace {

calibration::CalibrationRecord north(int degrees)
{
    calibration::CalibrationRecord record{.title = QStringLiteral("North")};
    record.terms.after.azimuthOffset = Angle::fromDegrees(degrees);
    return record;
}

class CalibrationFileTest : public testing::Test
{
protected:
    [[nodiscard]] QString path() const { return calibrationPath(m_folder.path(), QStringLiteral("mast"), false); }
    [[nodiscard]] std::size_t entries() const { return CalibrationFile(path()).history().entries().size(); }

    QTemporaryDir m_folder;
};

// REQ-NORTH-38b (CalibrationFileTest.*): A worker writes the history, never a tick, and the history is on the disk
// before the program ends. A history that cannot be read or written raises an alarm, and is not overwritten.
TEST_F(CalibrationFileTest, SavingWritesNothingInTheCallersThread)
{
    CalibrationFile file(path());
    for (int i = 1; i <= 100; ++i) {
        file.add(north(i));
    }
    EXPECT_GT(100U, entries()) << "the first is perhaps on the disk, the newest waits for it";
    ASSERT_TRUE(fakes::waitUntil([&] { return entries() == 100U; }));
    EXPECT_TRUE(file.problem().isEmpty());
    file.undo();
    EXPECT_TRUE(fakes::waitUntil([&] { return CalibrationFile(path()).history().inForce() == 99U; }));
}

TEST_F(CalibrationFileTest, TheNewestIsOnTheDiskBeforeTheEndEvenWithoutAnEventLoop)
{
    {
        CalibrationFile file(path());
        file.add(north(1));
        file.add(north(2));
        file.flush();
        EXPECT_EQ(2U, entries());
        file.add(north(3));
    }
    EXPECT_EQ(3U, entries());
}

TEST_F(CalibrationFileTest, WhatCannotBeWrittenIsToldUntilItCan)
{
    CalibrationFile file(path());
    ASSERT_TRUE(QDir().mkpath(path()));  // nobody can overwrite a folder, not even root
    file.add(north(1));
    ASSERT_TRUE(fakes::waitUntil([&] { return !file.problem().isEmpty(); }));
    ASSERT_TRUE(QDir().rmdir(path()));
    file.add(north(2));
    ASSERT_TRUE(fakes::waitUntil([&] { return file.problem().isEmpty(); }));
    EXPECT_EQ(2U, entries());
}

// REQ-NORTH-38h
TEST_F(CalibrationFileTest, ThePointsLieBesideTheHistory)
{
    {
        CalibrationFile file(path());
        file.keepPoints({.title = QStringLiteral("Points"),
                         .points = {{.axes = {.azimuth = 12_deg, .elevation = 30_deg},
                                     .truth = {.azimuth = 50_deg, .elevation = 30_deg},
                                     .sigma = 0.1_deg,
                                     .label = QStringLiteral("Sun")}}});
    }
    EXPECT_FALSE(QFile::exists(path())) << "nothing was applied";
    CalibrationFile file(path());
    EXPECT_TRUE(file.problem().isEmpty()) << file.problem().toStdString();
    ASSERT_EQ(1U, file.points().size());
    EXPECT_EQ(QStringLiteral("Sun"), file.points().front().label);
    file.keepPoints({.title = QStringLiteral("Points")});
    file.flush();
    EXPECT_TRUE(CalibrationFile(path()).points().empty());
}

TEST_F(CalibrationFileTest, ASimulatedMountHasItsOwn)
{
    EXPECT_NE(path(), calibrationPath(m_folder.path(), QStringLiteral("mast"), true));
    EXPECT_NE(calibrationPath(m_folder.path(), QStringLiteral("mast.simulated"), false),
              calibrationPath(m_folder.path(), QStringLiteral("mast"), true));
}

}  // namespace
}  // namespace boresight
