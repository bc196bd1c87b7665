// SPDX-License-Identifier: GPL-3.0-or-later
// The drive check on the simulated pair: reading, refusing, retrying.
#include "core/drive_check/drive_check.h"

#include "tests/core/drive_check/drive_check_rig.h"

#include <gmock/gmock.h>

#include <random>

namespace boresight::drive_check {
namespace {

using sim::FaultKind;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::UnorderedElementsAre;

// REQ-SURVEY-01: On the reference mount every line of the drive check is right. A complete check takes less than 3 s at
// a tick of 20 ms (2.6 s on the simulated pair), with at most one frame for each drive and tick.
TEST(DriveCheck, TheReferenceMountIsRightInEveryLine)
{
    DriveCheckRig rig;
    EXPECT_THAT(obstacle(rig.drives), HasSubstr("drive check has not run"));
    rig.driveCheck();
    ASSERT_EQ(rig.drives.state(), DriveCheckState::Done) << rig.drives.progress().toStdString();
    for (const Axis axis : {Axis::Azimuth, Axis::Elevation}) {
        EXPECT_EQ(rig.drives.protections(axis).size(), 16u);
        for (const ProtectionLine& line : rig.drives.protections(axis)) {
            EXPECT_EQ(line.verdict, Verdict::Right)
                << line.key.toStdString() << " is " << line.found.toStdString() << ": " << line.reason.toStdString();
        }
    }
    EXPECT_THAT(causes(rig.drives), IsEmpty());
    EXPECT_EQ(obstacle(rig.drives), "");
    EXPECT_THAT(rig.drives.takeChanges(), IsEmpty());
}

// REQ-SURVEY-01
TEST(DriveCheck, ReadsBothDrivesWithinThreeSeconds)
{
    DriveCheckRig rig;
    rig.driveCheck();
    ASSERT_EQ(rig.drives.state(), DriveCheckState::Done);
    RecordProperty("milliseconds", static_cast<int>(rig.elapsed().count() * 1000.0));
    EXPECT_LT(rig.elapsed(), Seconds(3.0));
    EXPECT_LE(rig.mostFramesForOneDrive, 1u);
}

TEST(DriveCheck, TellsWhoTheDrivesAre)
{
    DriveCheckRig rig;
    rig.driveCheck();
    const auto& facts = rig.drives.facts(Axis::Elevation);
    ASSERT_TRUE(facts);
    EXPECT_EQ(facts->uuid, QStringLiteral("626f7265-7369-6768-7420-73696d203032"));
    EXPECT_EQ(facts->identity,
              (DriveIdentity{.uuid = facts->uuid, .firmware = QStringLiteral("1.1.0"), .registerMap = 5}));
    EXPECT_FALSE(facts->outputEncoder);
    EXPECT_DOUBLE_EQ(facts->rotorToOutputRatio, 0.01);
    const Seconds sinceBoot = rig.now() - facts->bootedAt;
    EXPECT_NEAR(sinceBoot.count(), rig.elapsed().count() + 60.0, 0.005);
}

// Every register write is a motion command, except the mask that addresses a board by its UUID.
// REQ-SURVEY-02: The drive check sends no motion command.
TEST(DriveCheck, NeverCommandsAnything)
{
    DriveCheckRig rig(freshFromTheBox());
    rig.driveCheck();
    ASSERT_TRUE(rig.drives.fix(rig.now()));
    rig.run(Seconds(10.0));
    for (const CanFrame& frame : rig.sent) {
        moteus::SubframeReader reader(frame.payload());
        while (const auto subframe = reader.next()) {
            const auto* write = std::get_if<moteus::WriteBlock>(&*subframe);
            EXPECT_TRUE(write == nullptr || write->first >= moteus::Register::UuidMask) << toString(frame);
        }
    }
    EXPECT_GT(rig.sent.size(), 400u);
    EXPECT_EQ(rig.pair.truth(Axis::Azimuth).mode, moteus::Mode::Stopped);
}

// REQ-SURVEY-03: Factory settings are refused, and the text says what each of them would do.
TEST(DriveCheck, SaysWhatTheFactorySettingsWouldDo)
{
    DriveCheckRig rig(freshFromTheBox());
    rig.driveCheck();
    ASSERT_EQ(rig.drives.state(), DriveCheckState::Done) << rig.drives.progress().toStdString();
    const auto expectDangerous = [&](const char* key, const char* reason) {
        const ProtectionLine found = line(rig.drives, Axis::Elevation, key);
        EXPECT_EQ(found.verdict, Verdict::Dangerous) << key;
        EXPECT_THAT(found.reason.toStdString(), HasSubstr(reason));
    };
    expectDangerous("servopos.position_min", "The factory limits are ±3.6°. With them every motion ends in fault 39.");
    expectDangerous("servopos.position_max", "fault 39");
    expectDangerous("servo.timeout_mode", "Without commands a loaded elevation creeps down.");
    expectDangerous("motor_position.rotor_to_output_ratio", "Boresight also changes the gains");
    EXPECT_EQ(line(rig.drives, Axis::Elevation, "servo.default_accel_limit").verdict, Verdict::Advised);
    EXPECT_EQ(line(rig.drives, Axis::Elevation, "servo.default_velocity_limit").found, QStringLiteral("none"));
    EXPECT_THAT(causes(rig.drives), UnorderedElementsAre("drives.dangerous.azimuth", "drives.dangerous.elevation",
                                                         "drives.advised.azimuth", "drives.advised.elevation"));
    EXPECT_THAT(obstacle(rig.drives), HasSubstr("The first: Lower limit is -3.6°"));
    EXPECT_THAT(obstacle(rig.drives), HasSubstr("4 settings of the azimuth drive are unsafe"));
}

// REQ-SURVEY-04: The drive check distinguishes two boards with the same id, a missing, swapped, replaced or third
// board, and an unknown register map.
TEST(DriveCheck, NoticesTwoBoardsWithOneId)
{
    DriveCheckRig rig(sim::factoryPair());
    rig.driveCheck();
    EXPECT_EQ(rig.drives.state(), DriveCheckState::NotDone);
    EXPECT_THAT(causes(rig.drives), ElementsAre("drives.shared-id.1", "drives.missing.elevation"));
    EXPECT_THAT(obstacle(rig.drives), HasSubstr("two boards have the id 1"));
    EXPECT_FALSE(rig.drives.facts(Axis::Azimuth));
}

// REQ-SURVEY-04
TEST(DriveCheck, NoticesABoardThatAnswersUnderTheOthersId)
{
    DriveCheckRig rig;
    const auto fault = rig.pair.faults().add({.kind = FaultKind::DuplicateId, .axis = Axis::Azimuth});
    rig.driveCheck();
    EXPECT_THAT(causes(rig.drives), ElementsAre("drives.shared-id.2", "drives.missing.azimuth"));
    rig.pair.faults().remove(fault);
    EXPECT_TRUE(rig.reaches(DriveCheckState::Done)) << "looked for again by itself";
    EXPECT_THAT(causes(rig.drives), IsEmpty());
}

// REQ-SURVEY-04
TEST(DriveCheck, NoticesAMissingAndAnUnknownBoard)
{
    sim::PairSettings pair = sim::commissionedPair();
    pair.elevation.config.id = 7;
    DriveCheckRig rig(pair);
    rig.driveCheck();
    EXPECT_THAT(causes(rig.drives), ElementsAre("drives.missing.elevation", "drives.foreign-board.7"));
    EXPECT_THAT(obstacle(rig.drives), HasSubstr("(id 2) does not answer"));
    EXPECT_EQ(line(rig.drives, Axis::Azimuth, "servo.timeout_mode").found, QStringLiteral("10 (hold)"))
        << "read all the same";
    EXPECT_EQ(line(rig.drives, Axis::Elevation, "servo.timeout_mode").verdict, Verdict::Unread);
}

// REQ-SURVEY-04
TEST(DriveCheck, ReadsNoBoardOfAnAxisWithoutDrive)
{
    for (const Axis axis : kAxes) {
        DriveCheckRig rig(sim::commissionedPair(), {}, {}, axesIf(axis == Axis::Azimuth, axis == Axis::Elevation));
        rig.driveCheck();
        EXPECT_EQ(rig.drives.state(), DriveCheckState::Done);
        EXPECT_TRUE(rig.drives.facts(axis));
        ASSERT_EQ(rig.drives.unknownBoards().size(), 1U);
        const int strange = axis == Axis::Azimuth ? 2 : 1;
        EXPECT_EQ(rig.drives.unknownBoards().front().id, strange);
        EXPECT_TRUE(rig.drives.fitToMove()) << obstacle(rig.drives);
        rig.sent.clear();
        rig.run(Seconds(5.0));
        EXPECT_FALSE(rig.sent.empty());
        for (const CanFrame& frame : rig.sent) {
            EXPECT_NE(moteus::fromCanId(frame.id).destination, strange) << "after the scan, which asks all";
        }
    }
}

// REQ-SURVEY-04
// REQ-SURVEY-06
TEST(DriveCheck, NoticesASilentBus)
{
    DriveCheckRig rig;
    rig.pair.faults().add({.kind = FaultKind::Silence, .duration = Seconds(5.0)});
    rig.driveCheck();
    EXPECT_THAT(causes(rig.drives), ElementsAre("drives.none"));
    EXPECT_TRUE(rig.reaches(DriveCheckState::Done));
    EXPECT_EQ(obstacle(rig.drives), "");
}

// Story: the page changed between "not read", "looking" and "reading …" every two seconds.
// REQ-SURVEY-13: While the drive check repeats because a drive is missing, its state is `NotDone` with one text.
// Unknown boards are listed.
TEST(DriveCheck, RepeatsItselfWithOneTextAndListsStrangers)
{
    profile::Profile profile;
    profile.elevation.id = 5;
    DriveCheckRig rig(sim::commissionedPair(), profile);
    rig.driveCheck();
    const QString text = rig.drives.progress();
    EXPECT_THAT(text.toStdString(), HasSubstr("every 2 s"));
    for (int i = 0; i < 400; ++i) {
        rig.tick();
        ASSERT_EQ(rig.drives.progress(), text) << i;
        ASSERT_EQ(rig.drives.state(), DriveCheckState::NotDone) << i;
        ASSERT_EQ(rig.drives.unknownBoards().size(), 1U) << i;
    }
    EXPECT_EQ(rig.drives.unknownBoards().front().id, 2);
    EXPECT_FALSE(rig.drives.unknownBoards().front().identity.uuid.isEmpty());
    rig.drives.begin(rig.now());
    EXPECT_EQ(rig.drives.state(), DriveCheckState::Running) << "when somebody asks for it";
}

// REQ-SURVEY-04
TEST(DriveCheck, RefusesAnUnknownRegisterMap)
{
    DriveCheckRig rig;
    rig.pair.faults().add(
        {.kind = FaultKind::RegisterMap, .axis = Axis::Azimuth, .duration = Seconds(4.0), .value = 6});
    rig.driveCheck();
    EXPECT_THAT(causes(rig.drives), ElementsAre("drives.map.azimuth"));
    EXPECT_THAT(obstacle(rig.drives), HasSubstr("has the register map 6. Boresight supports only version 5"));
    EXPECT_TRUE(rig.reaches(DriveCheckState::Done)) << "after other firmware was installed";
}

// REQ-SURVEY-04
TEST(DriveCheck, RefusesSwappedBoards)
{
    DriveCheckRig once;
    once.driveCheck();
    const KnownBoards swapped{once.drives.facts(Axis::Elevation)->uuid, once.drives.facts(Axis::Azimuth)->uuid};
    DriveCheckRig rig(sim::commissionedPair(), {}, swapped);
    rig.driveCheck();
    EXPECT_THAT(causes(rig.drives), ElementsAre("drives.swapped"));
    EXPECT_THAT(obstacle(rig.drives), HasSubstr("the board with the id 1"));
    rig.drives.setKnownBoards({swapped[1], swapped[0]});
    EXPECT_EQ(obstacle(rig.drives), "");
}

// REQ-SURVEY-04
TEST(DriveCheck, WarnsOfAnotherBoardThanBefore)
{
    DriveCheckRig rig(sim::commissionedPair(), {}, {QString(), QStringLiteral("00000000-0000-0000-0000-000000000001")});
    rig.driveCheck();
    EXPECT_THAT(causes(rig.drives), ElementsAre("drives.other.elevation"));
    EXPECT_EQ(obstacle(rig.drives), "") << "a warning only";
}

// REQ-SURVEY-05: One in ten replies or commands lost, late replies, and telemetry or half a line of another tool do not
// change the result.
TEST(DriveCheck, LostFramesDoNotBreakAReading)
{
    for (const FaultKind kind : {FaultKind::LostReply, FaultKind::LostCommand}) {
        for (std::uint32_t seed = 1; seed <= 20; ++seed) {
            sim::PairSettings pair = sim::commissionedPair();
            pair.seed = seed;
            DriveCheckRig rig(pair);
            rig.pair.faults().add({.kind = kind, .value = 0.1});
            rig.drives.begin(rig.now());
            EXPECT_TRUE(rig.reaches(DriveCheckState::Done, Seconds(15.0))) << rig.drives.progress().toStdString();
            EXPECT_EQ(obstacle(rig.drives), "") << "seed " << seed;
            EXPECT_THAT(rig.drives.takeChanges(), IsEmpty());
        }
    }
}

// REQ-SURVEY-05
TEST(DriveCheck, LateRepliesDoNotConfuseAReading)
{
    for (const double delay : {0.03, 0.06, 0.09}) {
        DriveCheckRig rig;
        rig.pair.faults().add({.kind = FaultKind::LateReply, .value = delay});
        rig.drives.begin(rig.now());
        EXPECT_TRUE(rig.reaches(DriveCheckState::Done, Seconds(30.0))) << delay << rig.drives.progress().toStdString();
        EXPECT_EQ(obstacle(rig.drives), "");
    }
}

// REQ-SURVEY-05
TEST(DriveCheck, TelemetryOfAnotherToolIsStoppedFirst)
{
    DriveCheckRig rig;
    rig.otherToolSays(Axis::Azimuth, "tel text");
    rig.otherToolSays(Axis::Azimuth, "tel rate servo_stats 10");
    rig.otherToolSays(Axis::Elevation, "conf get servo.kp\nconf ge");
    rig.run(Seconds(1.0));
    rig.drives.begin(rig.now());
    EXPECT_TRUE(rig.reaches(DriveCheckState::Done));
    EXPECT_EQ(obstacle(rig.drives), "");
}

// REQ-SURVEY-06: A drive that falls silent ends the drive check with a reason. The check is repeated until the drive is
// back.
TEST(DriveCheck, ADriveThatFallsSilentEndsTheReadingUntilItIsBack)
{
    DriveCheckRig rig;
    rig.pair.faults().add(
        {.kind = FaultKind::Silence, .axis = Axis::Elevation, .at = Seconds(1.8), .duration = Seconds(4.0)});
    rig.driveCheck();
    EXPECT_EQ(rig.drives.state(), DriveCheckState::NotDone);
    EXPECT_THAT(causes(rig.drives), ElementsAre("drives.unread.elevation"));
    EXPECT_THAT(obstacle(rig.drives), HasSubstr("the check of elevation ended early"));
    EXPECT_THAT(obstacle(rig.drives), HasSubstr("Drive 2 does not answer on its console."));
    EXPECT_TRUE(rig.reaches(DriveCheckState::Done));
    EXPECT_EQ(obstacle(rig.drives), "");
}

// REQ-SURVEY-11: After `forget()` nothing is known and nothing is sent.
TEST(DriveCheck, ForgettingLeavesNothingKnown)
{
    DriveCheckRig rig;
    rig.driveCheck();
    rig.drives.forget();
    EXPECT_EQ(rig.drives.state(), DriveCheckState::NotDone);
    EXPECT_FALSE(rig.drives.facts(Axis::Azimuth));
    EXPECT_EQ(line(rig.drives, Axis::Azimuth, "servo.timeout_mode").verdict, Verdict::Unread);
    EXPECT_THAT(obstacle(rig.drives), HasSubstr("drive check has not run"));
    rig.sent.clear();
    rig.run(Seconds(5.0));
    EXPECT_THAT(rig.sent, IsEmpty()) << "silent until begin()";
}

// REQ-SURVEY-09: Changes by another tool are reported, also if the bus was lost in between, and separately from what
// Fix wrote.
TEST(DriveCheck, TellsWhatAnotherToolChanged)
{
    DriveCheckRig rig;
    rig.driveCheck();
    rig.drives.forget();  // the bus was released
    rig.otherToolSays(Axis::Elevation, "conf set servo.timeout_mode 12");
    rig.otherToolSays(Axis::Elevation, "conf set servopos.position_max nan");
    rig.driveCheck();
    EXPECT_THAT(
        rig.drives.takeChanges(),
        ElementsAre(Change{QStringLiteral("elevation: servopos.position_max was -0.241667 turns (-3.0°), is none")},
                    Change{QStringLiteral("elevation: servo.timeout_mode was 10 (hold), is 12 (damp)")}));
    EXPECT_THAT(rig.drives.takeChanges(), IsEmpty());
    EXPECT_THAT(line(rig.drives, Axis::Elevation, "servopos.position_max").reason.toStdString(),
                HasSubstr("no limit of its own"));
    EXPECT_THAT(causes(rig.drives), ElementsAre("drives.dangerous.elevation"));
}

moteus::CountOrigin originOf(const DriveCheckRig& rig, Axis axis)
{
    const auto& facts = rig.drives.facts(axis);
    return facts && facts->origin.origin ? *facts->origin.origin : moteus::CountOrigin{.beginning = 0};
}

// Setting the position of a drive changes this origin, and no motion changes it.
// REQ-SURVEY-14: The origin of a drive's position is reported after every reading, and on request. No motion changes
// it, and every setting of the position does.
TEST(DriveCheck, TellsWhatThePositionCountsFrom)
{
    DriveCheckRig rig;
    rig.driveCheck();
    const moteus::CountOrigin azimuth = originOf(rig, Axis::Azimuth);
    ASSERT_NE(azimuth.beginning, 0U);
    const double before = rig.pair.drive(Axis::Azimuth).reportedPosition();
    rig.otherToolSays(Axis::Azimuth, "d pos nan 0.05 nan");
    rig.run(Seconds(1.0));
    rig.driveCheck();
    ASSERT_GT(std::abs(rig.pair.drive(Axis::Azimuth).reportedPosition() - before), 0.02);
    EXPECT_NEAR(originOf(rig, Axis::Azimuth).offset.turns(), azimuth.offset.turns(), 1e-6) << "moved";
    EXPECT_EQ(originOf(rig, Axis::Azimuth).beginning, azimuth.beginning);

    rig.otherToolSays(Axis::Azimuth, "d exact 0.7");
    const SteadyTime set = rig.now();
    rig.drives.readOrigin(Axis::Azimuth);
    EXPECT_FALSE(rig.drives.facts(Axis::Azimuth)->origin.asked > set);
    rig.run(Seconds(0.5));
    EXPECT_GT(rig.drives.facts(Axis::Azimuth)->origin.asked, set);
    EXPECT_GT(std::abs(originOf(rig, Axis::Azimuth).offset.turns() - azimuth.offset.turns()), 0.1);
    EXPECT_EQ(rig.drives.state(), DriveCheckState::Done);
}

// REQ-SURVEY-14
TEST(DriveCheck, TellsThatTheEncoderSettingsBeganTheCountAnew)
{
    DriveCheckRig rig;
    rig.driveCheck();
    const moteus::CountOrigin before = originOf(rig, Axis::Elevation);
    rig.otherToolSays(Axis::Elevation, "conf set motor_position.output.sign -1");
    rig.otherToolSays(Axis::Elevation, "conf set motor_position.output.sign 1");
    rig.driveCheck();
    EXPECT_EQ(originOf(rig, Axis::Elevation).beginning, before.beginning + 2);
}

TEST(DriveCheck, SaysWhatItDoes)
{
    DriveCheckRig rig;
    rig.drives.begin(rig.now());
    rig.tick();
    EXPECT_EQ(rig.drives.progress(), QStringLiteral("looking for the drives"));
    EXPECT_EQ(obstacle(rig.drives), "The drive check is running. Wait some seconds.") << "sentences: more may follow";
    rig.run(Seconds(1.8));
    EXPECT_THAT(rig.drives.progress().toStdString(),
                testing::MatchesRegex("reading .* of azimuth, reading .* of elevation"));
}

// Replies with plausible first bytes, and sometimes an arbitrary frame.
CanFrame rubbish(std::minstd_rand& random)
{
    const auto below = [&](std::uint32_t end) {
        return std::uniform_int_distribution<std::uint32_t>(0, end - 1)(random);
    };
    constexpr std::array<std::uint8_t, 7> kStarts{0x20, 0x24, 0x28, 0x2c, 0x41, 0x43, 0x31};
    std::array<std::uint8_t, 64> bytes{};
    std::ranges::generate(bytes, [&] { return static_cast<std::uint8_t>(below(256)); });
    bytes[0] = static_cast<std::uint8_t>(kStarts[below(kStarts.size())] + below(2));
    CanFrame frame{.id = below(16) == 0 ? below(1u << 29) : (below(3) << 8 | moteus::kDiagnosticHostId)};
    frame.setPayload(std::span(bytes).first(legalCanLength(below(65))));
    return frame;
}

// REQ-SURVEY-12: No reply can crash the drive check or spoil a later one (200,000 random replies).
TEST(DriveCheck, SurvivesAnyReply)
{
    DriveCheckRig rig;
    std::minstd_rand random(7);
    for (int i = 0; i < 200000; ++i) {
        if (i % 20000 == 0) {
            rig.drives.begin(rig.now());
        }
        if (i % 50 == 0) {
            rig.tick();
        }
        rig.drives.take(rubbish(random));
    }
    rig.driveCheck();
    EXPECT_TRUE(rig.reaches(DriveCheckState::Done, Seconds(20.0)));
    EXPECT_EQ(obstacle(rig.drives), "");
}

}  // namespace
}  // namespace boresight::drive_check
