// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/link/profile_draft.h"

#include "core/profile/profile_diff.h"
#include "tests/fakes/text_of.h"

#include <QSignalSpy>

#include <gtest/gtest.h>

#include <set>

namespace boresight::ui {
namespace {

using profile::Profile;

// A draft, and a station that answers when the test says so.
class ProfileDraftTest : public ::testing::Test
{
protected:
    ProfileDraftTest() : draft(desk), changes(&draft, &ProfileDraft::changed)
    {
        QObject::connect(&desk, &RequestDesk::requested, &desk,
                         [this](const NumberedRequest& request) { requests.push_back(request); });
        put(inForce);
    }

    void put(const Profile& profile, std::vector<std::string> waiting = {})
    {
        StationStatus status;
        status.permissions = permissions;
        status.profile = std::make_shared<const Profile>(profile);
        status.waitingKeys = std::move(waiting);
        draft.showStatus(status);
    }
    void setParkAzimuth(Angle azimuth)
    {
        draft.edit([azimuth](Profile& p) { p.park.azimuth = azimuth; });
    }
    void apply()
    {
        draft.apply(&asker, [this](const std::optional<Error>& error) { answers.push_back(error); });
    }
    void undo()
    {
        draft.undo(&asker, [this](const std::optional<Error>& error) { answers.push_back(error); });
    }
    void accept() { desk.take({{requests.back().id, std::nullopt}}); }
    const Profile& sent() const { return std::get<request::ApplyProfile>(requests.back().request).profile; }
    void applyAndAccept()
    {
        apply();
        accept();
        put(sent());
    }

    Profile inForce;
    Permissions permissions = Permissions::all();
    RequestDesk desk;
    ProfileDraft draft;
    QSignalSpy changes;
    QObject asker;
    std::vector<NumberedRequest> requests;
    std::vector<std::optional<Error>> answers;
};

// REQ-UI-16: The profile in effect is only read from the status. Edits stay edits until the station has accepted them.
// They are checked while they are made, and are lost neither by a refusal nor by a change made elsewhere.
TEST_F(ProfileDraftTest, AnEditChangesNothingInForceUntilItIsAppliedAndSeenInTheStatus)
{
    setParkAzimuth(12_deg);
    EXPECT_TRUE(draft.hasEdits());
    EXPECT_EQ(changes.count(), 1);
    EXPECT_EQ(draft.inForce(), inForce);
    EXPECT_EQ(draft.editedKeys(), std::vector<std::string>{"park.azimuth_deg"});
    EXPECT_TRUE(requests.empty());

    apply();
    ASSERT_EQ(requests.size(), 1u);
    EXPECT_EQ(sent().park.azimuth, 12_deg);
    EXPECT_EQ(draft.inForce(), inForce);
    accept();
    ASSERT_EQ(answers.size(), 1u);
    EXPECT_FALSE(answers[0].has_value());
    put(sent());
    EXPECT_EQ(draft.inForce().park.azimuth, 12_deg);
    EXPECT_FALSE(draft.hasEdits());
}

// REQ-UI-16
TEST_F(ProfileDraftTest, ARefusalGoesToTheAskerAndTheEditsStay)
{
    setParkAzimuth(12_deg);
    apply();
    desk.take({{requests.back().id, Error{ErrorCode::Refused, QStringLiteral("the mount is in motion")}}});
    ASSERT_EQ(answers.size(), 1u);
    EXPECT_EQ(textOf(*answers[0]), "the mount is in motion");
    EXPECT_TRUE(draft.hasEdits());
    EXPECT_EQ(draft.whyNoApply(), QString());
    EXPECT_FALSE(draft.whyNoUndo().isEmpty());
}

// REQ-UI-16
TEST_F(ProfileDraftTest, WhatTheLiveCheckFindsIsNotSent)
{
    draft.edit([](Profile& p) { p.elevation.id = p.azimuth.id; });
    EXPECT_TRUE(draft.problem("elevation.id").contains(QStringLiteral("same as azimuth.id")));
    EXPECT_EQ(draft.problem("azimuth.id"), QString());
    apply();
    EXPECT_TRUE(requests.empty());
    ASSERT_EQ(answers.size(), 1u);
    EXPECT_NE(textOf(*answers[0]).find("id (Elevation axis)"), std::string::npos);
    draft.edit([](Profile& p) { p.elevation.id = p.azimuth.id + 1; });
    EXPECT_TRUE(draft.problems().empty());
    EXPECT_FALSE(draft.hasEdits());
}

TEST_F(ProfileDraftTest, WithoutEditsThereIsNothingToApplyRevertOrUndo)
{
    apply();
    undo();
    EXPECT_TRUE(requests.empty());
    EXPECT_EQ(answers.size(), 2u);
    EXPECT_FALSE(draft.whyNoRevert().isEmpty());
    put(inForce);
    EXPECT_EQ(changes.count(), 0);  // an equal profile in another object is no change
}

// A preset is saved while the limits are being edited: only the preset is applied, and it causes no conflict.
// REQ-UI-02c
TEST_F(ProfileDraftTest, AChangeAppliedAloneLeavesTheEditsEdits)
{
    setParkAzimuth(12_deg);
    const auto addPreset = [](Profile& p) { p.presets.push_back({"mast", {10_deg, 20_deg}}); };
    const auto answered = [this](const std::optional<Error>& error) { answers.push_back(error); };
    draft.applyAlone(addPreset, &desk, answered);
    ASSERT_EQ(requests.size(), 1u);
    EXPECT_EQ(sent().presets.size(), 1u);
    EXPECT_EQ(sent().park, inForce.park);
    accept();
    put(sent());
    EXPECT_EQ(draft.editedKeys(), std::vector<std::string>{"park.azimuth_deg"});
    EXPECT_TRUE(draft.overtakenKeys().empty());
    EXPECT_EQ(draft.edited().presets.size(), 1u);
    EXPECT_EQ(draft.edited().park.azimuth, 12_deg);

    draft.applyAlone(addPreset, &desk, answered);  // the same name again
    EXPECT_EQ(requests.size(), 1u);
    ASSERT_EQ(answers.size(), 2u);
    EXPECT_NE(textOf(*answers[1]).find("is used twice"), std::string::npos);
}

// Story: the star of a satellite was lost, because the edited antenna of another satellite was applied after it.
// REQ-UI-02c
TEST_F(ProfileDraftTest, AChangeAloneIsRefusedWhereAnEditWouldTakeItBack)
{
    draft.edit([](Profile& p) { orbit::setAntenna(p.satellites, 25544, "70 cm"); });
    const auto answered = [this](const std::optional<Error>& error) { answers.push_back(error); };
    draft.applyAlone([](Profile& p) { orbit::setFavourite(p.satellites, 27607, true); }, &desk, answered);
    EXPECT_TRUE(requests.empty());
    ASSERT_EQ(answers.size(), 1u);
    EXPECT_EQ(textOf(*answers[0]),
              "This list has edits on the page Profile that are not applied. Apply or revert them first.");
    draft.revert();
    draft.applyAlone([](Profile& p) { orbit::setFavourite(p.satellites, 27607, true); }, &desk, answered);
    EXPECT_EQ(requests.size(), 1u);
}

TEST_F(ProfileDraftTest, RevertDropsTheEdits)
{
    setParkAzimuth(12_deg);
    draft.revert();
    EXPECT_FALSE(draft.hasEdits());
    EXPECT_EQ(draft.edited(), inForce);
}

TEST_F(ProfileDraftTest, UndoAppliesWhatWasAppliedBeforeStepByStep)
{
    setParkAzimuth(12_deg);
    applyAndAccept();
    setParkAzimuth(24_deg);
    applyAndAccept();
    undo();
    EXPECT_EQ(sent().park.azimuth, 12_deg);
    EXPECT_FALSE(draft.whyNoUndo().isEmpty()) << "one after the other";
    accept();
    put(sent());
    undo();
    EXPECT_EQ(sent().park.azimuth, 0_deg);
    accept();
    put(sent());
    EXPECT_EQ(draft.edited(), inForce);
    EXPECT_FALSE(draft.whyNoUndo().isEmpty());
}

TEST_F(ProfileDraftTest, UndoWaitsForTheEditsAndDiesWithAChangeFromElsewhere)
{
    setParkAzimuth(12_deg);
    applyAndAccept();
    EXPECT_TRUE(draft.whyNoUndo().isEmpty());
    setParkAzimuth(13_deg);
    EXPECT_FALSE(draft.whyNoUndo().isEmpty());
    draft.revert();
    EXPECT_TRUE(draft.whyNoUndo().isEmpty());
    Profile other = draft.applied();
    other.mount.name = "Somebody's";
    put(other);
    EXPECT_FALSE(draft.whyNoUndo().isEmpty());
}

TEST_F(ProfileDraftTest, EditsMadeWhileTheAnswerIsUnderWayStayEdits)
{
    setParkAzimuth(12_deg);
    apply();
    setParkAzimuth(30_deg);
    put(sent());  // the status may come before the answer
    accept();
    EXPECT_EQ(draft.edited().park.azimuth, 30_deg);
    EXPECT_TRUE(draft.overtakenKeys().empty());
    EXPECT_TRUE(draft.whyNoApply().isEmpty());
    draft.revert();
    EXPECT_EQ(draft.edited().park.azimuth, 12_deg);
}

// REQ-UI-16
TEST_F(ProfileDraftTest, AChangeFromElsewhereIsTakenOverSilentlyOnlyWithoutEdits)
{
    Profile other = inForce;
    other.mount.name = "Somebody's";
    put(other);
    EXPECT_EQ(draft.edited().mount.name, "Somebody's");

    setParkAzimuth(12_deg);
    other.jog.slow = 0.1_deg_s;
    put(other);
    EXPECT_EQ(draft.overtakenKeys(), std::vector<std::string>{"jog.slow_deg_s"});
    EXPECT_FALSE(draft.whyNoApply().isEmpty());
    EXPECT_EQ(draft.edited().park.azimuth, 12_deg);
    EXPECT_EQ(draft.inForce().jog.slow, 0.1_deg_s);
}

// REQ-UI-16
TEST_F(ProfileDraftTest, KeptEditsComeUponWhatWasChangedElsewhere)
{
    setParkAzimuth(12_deg);
    draft.edit([](Profile& p) { p.limits.horizon = {{10_deg, -5_deg}}; });
    Profile other = inForce;
    other.jog.slow = 0.1_deg_s;
    other.limits.horizon = {{20_deg, -7_deg}};
    other.limits.keepOuts = {{"mast", 80_deg, 90_deg, 0_deg, 40_deg}};
    put(other);
    draft.keepEdits();
    EXPECT_TRUE(draft.overtakenKeys().empty());
    EXPECT_TRUE(draft.whyNoApply().isEmpty());
    EXPECT_NEAR(draft.edited().jog.slow.degrees(), 0.1, 1e-9);
    EXPECT_NEAR(draft.edited().park.azimuth.degrees(), 12.0, 1e-9);
    EXPECT_EQ(draft.edited().limits.horizon.front().azimuth, 10_deg);  // both changed it: the edit counts
    EXPECT_EQ(draft.edited().limits.keepOuts, other.limits.keepOuts);
    const std::vector<std::string> keys = draft.editedKeys();
    EXPECT_EQ(std::set(keys.begin(), keys.end()), (std::set<std::string>{"park.azimuth_deg", "limits.horizon"}));
}

TEST_F(ProfileDraftTest, RevertAfterAChangeFromElsewhereTakesThatChange)
{
    setParkAzimuth(12_deg);
    Profile other = inForce;
    other.park.azimuth = 50_deg;
    put(other);
    draft.revert();
    EXPECT_EQ(draft.edited(), other);
}

TEST_F(ProfileDraftTest, WhatWaitsForAReconnectIsAppliedAndGoesWithIt)
{
    draft.edit([](Profile& p) { p.control.tickHz = 100; });
    apply();
    accept();
    put(inForce, {"control.tick_hz"});  // not yet in effect
    EXPECT_EQ(draft.inForce().control.tickHz, 50);
    EXPECT_EQ(draft.applied().control.tickHz, 100);
    EXPECT_FALSE(draft.hasEdits());
    EXPECT_EQ(draft.waitingKeys(), std::vector<std::string>{"control.tick_hz"});

    EXPECT_TRUE(draft.whyNoReconnect().isEmpty());
    draft.reconnect(&asker, [](const std::optional<Error>&) {});
    EXPECT_EQ(std::get<request::Reconnect>(requests.back().request).profile.control.tickHz, 100);
}

// REQ-UI-920: Reconnect, and Apply that leaves the simulation, are offered when the station permits a reconnect.
TEST_F(ProfileDraftTest, AReconnectIsOfferedWhenTheStationPermitsIt)
{
    put(inForce, {"control.tick_hz"});
    QSignalSpy told(&draft, &ProfileDraft::permissionChanged);
    permissions.refuse(Action::Reconnect, QStringLiteral("The mount moves. Stop it first."));
    put(inForce, {"control.tick_hz"});
    EXPECT_EQ(told.count(), 1);
    EXPECT_EQ(draft.whyNoReconnect(), QStringLiteral("The mount moves. Stop it first."));
    draft.edit([](Profile& p) { p.bus = "socketcan:can0"; });
    ASSERT_TRUE(draft.leavesSimulation());
    EXPECT_EQ(draft.whyNoApply(), QStringLiteral("The mount moves. Stop it first."));
    permissions = Permissions::all();
    put(inForce, {"control.tick_hz"});
    EXPECT_EQ(told.count(), 2);
    EXPECT_EQ(draft.whyNoReconnect(), QString());
    EXPECT_EQ(draft.whyNoApply(), QString());
}

// Story: the bus was typed in the table. The north of the simulated mount was taken along, and the real mount pointed
// 37.4° wrong. What was edited together with the bus is found by comparing with what was applied before.
// REQ-PROFILE-17a
TEST_F(ProfileDraftTest, ABusTypedByHandLeavesTheSimulationWhole)
{
    inForce.pointing.azimuthOffset = 37.4_deg;
    put(inForce);
    draft.edit([](Profile& p) { p.bus = "socketcan:can0"; });
    draft.edit([](Profile& p) { p.park.azimuth = 12_deg; });
    EXPECT_TRUE(draft.leavesSimulation());
    EXPECT_EQ(draft.editedKeys(), (std::vector<std::string>{"bus.name", "park.azimuth_deg"}));
    apply();
    Profile asked = inForce;
    asked.bus = "socketcan:can0";
    asked.park.azimuth = 12_deg;
    EXPECT_EQ(std::get<request::Reconnect>(requests.back().request).profile, asked);
    desk.take({{requests.back().id, Error{ErrorCode::Refused, QStringLiteral("the mount moves")}}});
    EXPECT_TRUE(draft.hasEdits()) << "a refusal leaves them";
    apply();
    accept();
    Profile real;
    real.bus = "socketcan:can0";
    real.park.azimuth = 12_deg;
    put(real);
    EXPECT_EQ(draft.edited(), real);
    EXPECT_FALSE(draft.hasEdits());
    EXPECT_FALSE(draft.leavesSimulation());
}

// Without this decision, a north that was found meanwhile would count as changed together with the bus, and a north
// whose change was undone would count as entered.
// REQ-PROFILE-17a
TEST_F(ProfileDraftTest, AChangeFromElsewhereIsDecidedUponBeforeTheSimulationIsLeft)
{
    draft.edit([](Profile& p) { p.bus = "socketcan:can0"; });
    Profile other = inForce;
    other.pointing.azimuthOffset = 37.4_deg;
    put(other);
    EXPECT_FALSE(draft.whyNoApply().isEmpty());
    draft.keepEdits();
    EXPECT_TRUE(draft.whyNoApply().isEmpty());
    EXPECT_EQ(draft.editedKeys(), std::vector<std::string>{"bus.name"});
}

// REQ-PROFILE-17a
TEST_F(ProfileDraftTest, ABusThatIsTypedBackLeavesNothingEdited)
{
    draft.edit([](Profile& p) { p.bus = "socketcan:can0"; });
    draft.edit([](Profile& p) { p.bus = "simulated"; });
    EXPECT_FALSE(draft.hasEdits());
    EXPECT_FALSE(draft.leavesSimulation());
}

// REQ-PROFILE-17a
TEST_F(ProfileDraftTest, AnInvalidEditIsNotTakenToTheRealMount)
{
    draft.edit([](Profile& p) {
        p.bus = "socketcan:can0";
        p.sensor.source = profile::SensorSource::Simulated;
    });
    EXPECT_TRUE(draft.whyNoApply().startsWith(QStringLiteral("Source (Orientation sensor): ")));
}

// REQ-PROFILE-17b: If the profile of a real mount is imported, restored or undone while the simulated mount runs, it is
// tried on the simulated mount.
TEST_F(ProfileDraftTest, AProfileThatIsTakenOverStaysSimulated)
{
    Profile real = inForce;
    real.bus = "socketcan:can0";
    real.pointing.tiltNorth = 1_deg;
    draft.takeOver(real, {"bus.name", "pointing.tilt_north_deg"});
    real.bus = "simulated";
    EXPECT_EQ(draft.edited(), real);
}

// REQ-PROFILE-17a
TEST_F(ProfileDraftTest, ARealMountTakesNothingFromASimulatedOne)
{
    Profile simulated = inForce;
    simulated.pointing.azimuthOffset = 37.4_deg;
    simulated.azimuth.geometry.offset = 5_deg;
    simulated.mount.directions = profile::Directions::Unconfirmed;
    simulated.sensor.source = profile::SensorSource::Simulated;
    simulated.jog.slow = 0.7_deg_s;
    Profile real;
    real.bus = "socketcan:can0";
    real.pointing.azimuthOffset = 12_deg;
    put(real);
    draft.takeOver(simulated, profile::changedKeys(real, simulated));
    real.jog.slow = 0.7_deg_s;
    EXPECT_EQ(draft.edited(), real);
}

// Story: an operator turned a calibrated mount into the simulated one to look around. When its bus was typed again, all
// its calibration was reset as if it belonged to the simulated mount.
// REQ-PROFILE-17c: Another bus does not turn the profile of a real mount into that of the simulated one. `--simulate`
// tries such a profile and leaves its file unchanged.
TEST_F(ProfileDraftTest, ARealMountDoesNotBecomeTheSimulatedOne)
{
    Profile real;
    real.bus = "socketcan:can0";
    real.pointing.azimuthOffset = 12_deg;
    put(real);
    const auto simulate = [](Profile& p) { p.bus = "simulated"; };
    draft.edit(simulate);
    EXPECT_TRUE(draft.problem("bus.name").contains(QStringLiteral("--simulate")));
    apply();
    draft.edit([](Profile& p) { p.bus = "socketcan:can0"; });
    EXPECT_EQ(draft.edited(), real);
    EXPECT_FALSE(draft.hasEdits());
    draft.applyAlone(simulate, &asker, [this](const std::optional<Error>& error) { answers.push_back(error); });
    EXPECT_TRUE(requests.empty());
    ASSERT_EQ(answers.size(), 2u);
    EXPECT_TRUE(answers[0] && answers[1]);
}

// Story: the edit was made while another one was on its way to the station.
TEST_F(ProfileDraftTest, WhatSpeaksAgainstEditsIsToldUponWhatIsAppliedNow)
{
    draft.edit([](Profile& p) { p.bus = "socketcan:can0"; });
    EXPECT_TRUE(draft.problems().empty());
    Profile real;
    real.bus = "socketcan:can1";
    draft.edit([](Profile& p) { p.bus = "simulated"; });
    draft.edit([](Profile& p) { p.park.azimuth = 12_deg; });
    put(real);
    EXPECT_FALSE(draft.problem("bus.name").isEmpty());
}

TEST_F(ProfileDraftTest, StartedWithSimulateThereIsNoOtherBus)
{
    Profile real;
    real.bus = "socketcan:can7";
    put(real);
    draft.keepSimulated();
    draft.edit([](Profile& p) { p.bus = "socketcan:can0"; });
    EXPECT_TRUE(draft.problem("bus.name").contains(QStringLiteral("--bus socketcan:can0")));
    EXPECT_FALSE(draft.whyNoApply().isEmpty());
    EXPECT_FALSE(draft.leavesSimulation());
}

// The bus of the real mount stays in its profile, and the simulated mount has a sensor.
TEST_F(ProfileDraftTest, StartedWithSimulateTheProfileOfARealMountIsTriedWhole)
{
    Profile real;
    real.bus = "socketcan:can7";
    put(real);
    draft.edit([](Profile& p) { p.sensor.source = profile::SensorSource::Simulated; });
    EXPECT_FALSE(draft.problem("sensor.source").isEmpty()) << "not on a real mount";
    draft.revert();
    draft.keepSimulated();
    draft.edit([](Profile& p) { p.sensor.source = profile::SensorSource::Simulated; });
    EXPECT_TRUE(draft.whyNoApply().isEmpty());
    draft.revert();
    Profile other = real;
    other.bus = "socketcan:can1";
    other.park.azimuth = 12_deg;
    draft.takeOver(other, profile::changedKeys(real, other));
    EXPECT_EQ(draft.editedKeys(), std::vector<std::string>{"park.azimuth_deg"});
}

TEST_F(ProfileDraftTest, AnAskerThatIsGoneDoesNotKeepTheDraftWaiting)
{
    setParkAzimuth(12_deg);
    {
        QObject gone;
        draft.apply(&gone, [](const std::optional<Error>&) { FAIL() << "the asker is gone"; });
    }
    accept();
    put(sent());
    EXPECT_FALSE(draft.hasEdits());
    EXPECT_TRUE(draft.whyNoUndo().isEmpty());
}

}  // namespace
}  // namespace boresight::ui
