// SPDX-License-Identifier: GPL-3.0-or-later
// Boards from the factory receive their id and their gear ratio.
#include "tests/core/moteus_mount/care_rig.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace boresight {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

// Connects only the board of this axis.
void connectAlone(CareRig& rig, Axis axis)
{
    for (const Axis one : kAxes) {
        rig.pair.setFitted(one, one == axis);
    }
    rig.run(Seconds(5.0));
}

// REQ-SURVEY-955: Two boards from the factory receive their ids one after the other. The operator requests this and
// confirms each board by its UUID. The station permits it only while one board is connected, no drive is on and nothing
// moves. Meanwhile no other command goes to the drives.
TEST(BoardDesk, TwoBoardsFromTheFactoryGetTheirIds)
{
    CareRig rig(sim::factoryPair());
    rig.run(Seconds(5.0));
    ASSERT_FALSE(rig.drives().boards.empty());
    EXPECT_TRUE(rig.drives().boards.front().shared);
    EXPECT_THAT(rig.obstacle(Action::AssignElevationBoard), HasSubstr("Two boards have the id 1"));

    connectAlone(rig, Axis::Elevation);
    ASSERT_EQ(rig.drives().boards.size(), 1u);
    EXPECT_FALSE(rig.drives().boards.front().shared);
    EXPECT_THAT(rig.obstacle(Action::AssignAzimuthBoard), HasSubstr("has the id 1 of the azimuth already"));
    EXPECT_EQ(rig.obstacle(Action::AssignElevationBoard), "");
    const request::AssignBoard assign{.board = rig.drives().boards.front().uuid, .axis = Axis::Elevation};
    EXPECT_EQ(rig.refusal(assign), "");
    ASSERT_EQ(rig.ask(assign), "");
    EXPECT_TRUE(rig.drives().boardWork.running);
    EXPECT_THAT(rig.refusal(request::FixDrives{}), HasSubstr("Boresight is changing a board"));
    EXPECT_THAT(rig.ask(kGo), Not(""));
    rig.run(Seconds(6.0));
    EXPECT_FALSE(rig.drives().boardWork.running);
    EXPECT_FALSE(rig.drives().boardWork.failed) << rig.drives().boardWork.text.toStdString();
    EXPECT_THAT(rig.drives().boardWork.text.toStdString(), HasSubstr("has the id 2 now"));

    rig.pair.setFitted(Axis::Azimuth, true);
    ASSERT_TRUE(rig.reaches(DriveCheckState::Done));
    ASSERT_EQ(rig.drives().boards.size(), 2u);
    EXPECT_EQ(rig.drives().boards[0].id, 1);
    EXPECT_EQ(rig.drives().boards[1].id, 2);
    EXPECT_FALSE(rig.drives().boards[1].shared);
}

// REQ-SURVEY-955
TEST(BoardDesk, AnotherBoardThanTheConfirmedOneIsRefused)
{
    CareRig rig(sim::factoryPair());
    connectAlone(rig, Axis::Elevation);
    const request::AssignBoard assign{.board = rig.drives().boards.front().uuid, .axis = Axis::Elevation};
    connectAlone(rig, Axis::Azimuth);
    EXPECT_THAT(rig.refusal(assign), HasSubstr("is not the board that you confirmed"));
}

// REQ-SURVEY-956: A gear ratio that differs from the profile is written on request of the operator, after a text about
// the other settings that depend on it. It is never written while a drive is on.
TEST(BoardDesk, TheGearOfAFactoryBoardIsWrittenAndRead)
{
    sim::PairSettings settings = sim::factoryPair();
    settings.elevation.config.id = 2;
    CareRig rig(settings);
    profile::Profile geared;
    geared.elevation.geometry.gearRatio = 100.0;
    rig.setProfile(geared);
    ASSERT_TRUE(rig.reaches(DriveCheckState::Done));
    const auto gear = rig.drives().elevation.gear;
    ASSERT_TRUE(gear);
    EXPECT_EQ(gear->found, QStringLiteral("1"));
    EXPECT_EQ(gear->wanted, QStringLiteral("0.01"));
    EXPECT_THAT(gear->effect.toStdString(), HasSubstr("multiplies kp, ki and kd by 10000"));
    EXPECT_EQ(rig.obstacle(Action::SetElevationGear), "");
    ASSERT_EQ(rig.ask(request::SetGear{.axis = Axis::Elevation}), "");
    rig.run(Seconds(6.0));
    EXPECT_FALSE(rig.drives().gearWork.failed) << rig.drives().gearWork.text.toStdString();
    EXPECT_THAT(rig.drives().gearWork.text.toStdString(), HasSubstr("is 0.01 now"));
    EXPECT_EQ(rig.drives().boardWork.text, QString()) << "it is another subject";
    ASSERT_TRUE(rig.reaches(DriveCheckState::Done));
    ASSERT_EQ(rig.ask(request::ReadDrives{}), "");
    EXPECT_EQ(rig.drives().gearWork.text, QString()) << "it was read";
    ASSERT_TRUE(rig.reaches(DriveCheckState::Done));
    EXPECT_FALSE(rig.drives().elevation.gear) << "it is right now";
    EXPECT_TRUE(rig.logSays("counts from a new zero"));
    EXPECT_FALSE(rig.logSays("jump")) << "another gear, and no fault of the encoder";
    EXPECT_NE(rig.obstacle(Action::SetElevationGear), "");
    EXPECT_EQ(rig.pair.drive(Axis::Azimuth).driveConfig().motorPosition.rotorToOutputRatio, 1.0);
}

// REQ-SURVEY-956
TEST(BoardDesk, NoGearIsWrittenWhileADriveIsOn)
{
    CareRig rig;
    ASSERT_TRUE(rig.endsItsDriveCheck());
    ASSERT_EQ(rig.ask(kGo), "");
    rig.run(Seconds(1.0));
    EXPECT_THAT(rig.obstacle(Action::SetAzimuthGear), Not(""));
    EXPECT_THAT(rig.ask(request::SetGear{.axis = Axis::Azimuth}), Not(""));
    EXPECT_THAT(rig.ask(request::AssignBoard{.board = {}, .axis = Axis::Azimuth}), Not(""));
}

}  // namespace
}  // namespace boresight
