// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/calibration_record.h"

#include <gtest/gtest.h>

namespace boresight::calibration {
namespace {

CalibrationRecord step(int north)
{
    CalibrationRecord record;
    record.title = QString::number(north);
    record.terms.before.azimuthOffset = Angle::fromDegrees(north - 1);
    record.terms.after.azimuthOffset = Angle::fromDegrees(north);
    return record;
}

// REQ-CALIBRATION-18 (CalibrationHistory.*): An applied calibration is kept with the one it replaced, and with date,
// site and drives. The operator can go back and forth. A calibration that was undone and then replaced stays readable.
// Another drive or site is detected.
TEST(CalibrationHistory, GoesBackAndForth)
{
    CalibrationHistory history;
    EXPECT_FALSE(history.canUndo());
    EXPECT_FALSE(history.canRedo());
    for (int north = 1; north <= 3; ++north) {
        history.add(step(north));
    }
    EXPECT_EQ(history.inForce(), 3U);
    EXPECT_EQ(history.undo(), step(3));
    EXPECT_EQ(history.undo(), step(2));
    EXPECT_EQ(history.inForce(), 1U);
    EXPECT_EQ(history.redo(), step(2));
    EXPECT_EQ(history.redo(), step(3));
    EXPECT_FALSE(history.canRedo());
}

TEST(CalibrationHistory, ANewOneTakesThePlaceOfWhatWasUndone)
{
    CalibrationHistory history({step(1), step(2), step(3)}, 3);
    history.undo();
    history.undo();
    history.add(step(9));
    EXPECT_EQ(history, CalibrationHistory({step(1), step(9)}, 2, {step(2), step(3)}));
    EXPECT_FALSE(history.canRedo());
    history.undo();
    history.add(step(10));
    EXPECT_EQ(history.undo(), step(10)) << "undo does not lead to what was superseded";
    EXPECT_EQ(history, CalibrationHistory({step(1), step(10)}, 1, {step(2), step(3), step(9)}));
}

TEST(CalibrationHistory, NoMoreIsInForceThanThereIs)
{
    EXPECT_EQ(CalibrationHistory({step(1)}, 7).inForce(), 1U);
}

// REQ-CALIBRATION-18 (MountDifference.*)
TEST(MountDifference, IsAnotherDriveOrAnotherSite)
{
    const RecordMount then{.azimuthDrive = "a", .elevationDrive = "b", .site = RecordSite{48_deg, 11_deg, 500.0}};
    RecordMount today = then;
    EXPECT_EQ(difference(then, today), MountDifference::None);
    today.site->latitude = Angle::fromDegrees(48.008);  // 0.9 km
    EXPECT_EQ(difference(then, today), MountDifference::None);
    today.site->latitude = Angle::fromDegrees(48.01);  // 1.1 km
    EXPECT_EQ(difference(then, today), MountDifference::OtherSite);
    today.site->latitude = 48_deg;
    today.site->longitude = Angle::fromDegrees(11.013);  // 0.97 km at this latitude
    EXPECT_EQ(difference(then, today), MountDifference::None);
    today.elevationDrive = "c";
    EXPECT_EQ(difference(then, today), MountDifference::OtherDrive);
    EXPECT_EQ(difference(then, RecordMount{}), MountDifference::None);  // nothing is known about the mount
}

}  // namespace
}  // namespace boresight::calibration
