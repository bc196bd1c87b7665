// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/drive_check/protections.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>

namespace boresight::drive_check {
namespace {

using testing::HasSubstr;

profile::Profile reference()
{
    return {};
}

Protection protection(const profile::Profile& profile, Axis axis, const std::string& key)
{
    const std::vector<Protection> all = protectionsOf(profile, axis);
    const auto found = std::ranges::find(all, key, &Protection::key);
    return found != all.end() ? *found : Protection{};
}

ProtectionLine judgedAs(const profile::Profile& profile, Axis axis, const std::string& key, const std::string& found)
{
    return judged(protection(profile, axis, key), {.state = Reading::State::Read, .text = found});
}

Verdict verdict(const std::string& key, const std::string& found, const profile::Profile& profile = reference())
{
    return judgedAs(profile, Axis::Azimuth, key, found).verdict;
}

// An azimuth of -90…450° is -0.25…1.25 turns, and the margin of 3° is 0.008333 turns.
// REQ-SURVEY-03 (Protections.*)
TEST(Protections, BoundsLieBetweenHalfAndOneDegreeAboveTheMargin)
{
    const std::string key = "servopos.position_max";
    EXPECT_EQ(verdict(key, "1.258333"), Verdict::Right);
    EXPECT_EQ(verdict(key, "1.254200"), Verdict::Right);
    EXPECT_EQ(verdict(key, "1.254100"), Verdict::Dangerous) << "1.48° beyond the travel";
    EXPECT_EQ(verdict(key, "1.261100"), Verdict::Right);
    EXPECT_EQ(verdict(key, "1.261200"), Verdict::Dangerous) << "4.03° beyond the travel";
    EXPECT_EQ(verdict(key, "1.200000"), Verdict::Dangerous) << "narrower than the travel";
    EXPECT_EQ(verdict(key, "nan"), Verdict::Dangerous);
    EXPECT_EQ(verdict("servopos.position_min", "-0.258333"), Verdict::Right);
    EXPECT_EQ(verdict("servopos.position_min", "-0.262000"), Verdict::Dangerous);
    EXPECT_EQ(verdict("servopos.position_min", "0.258333"), Verdict::Dangerous);
}

TEST(Protections, BoundsFollowMarginGearAndSign)
{
    profile::Profile profile;
    profile.control.driveLimitMargin = 9.0_deg;
    profile.elevation.geometry = {.sign = -1,
                                  .offset = 0.0_deg,
                                  .gearRatio = 40.0,
                                  .gearIn = pointing::GearIn::Host,
                                  .travel = {.min = -9.0_deg, .max = 90.0_deg}};
    const auto remedy = [&](const char* key) { return *protection(profile, Axis::Elevation, key).remedy; };
    EXPECT_NEAR(remedy("servopos.position_min"), -99.0 / 360.0 * 40.0, 1e-9);
    EXPECT_NEAR(remedy("servopos.position_max"), 18.0 / 360.0 * 40.0, 1e-9);
    EXPECT_EQ(judgedAs(profile, Axis::Elevation, "servopos.position_max", "2.000000").found,
              QStringLiteral("2 turns (-18.0°)"));
    EXPECT_EQ(judgedAs(profile, Axis::Elevation, "servopos.position_max", "2.000000").name,
              QStringLiteral("Lower limit"))
        << "the lower end of the axis";
    EXPECT_EQ(judgedAs(profile, Axis::Azimuth, "servopos.position_max", "1.258333").name,
              QStringLiteral("Upper limit"));
    EXPECT_EQ(judgedAs(profile, Axis::Elevation, "motor_position.rotor_to_output_ratio", "1.000000").verdict,
              Verdict::Right)
        << "geared in the host, the drive counts turns of the rotor";
}

// REQ-SURVEY-07
TEST(Protections, WhatFixWritesIsRight)
{
    profile::Profile profile;
    profile.azimuth.limits.speed = 0.5_deg_s;
    profile.azimuth.limits.acceleration = 100.0_deg_s2;
    profile.elevation.limits.speed = 60.0_deg_s;
    profile.elevation.timeoutMode = profile::TimeoutMode::Brake;
    for (const Axis axis : {Axis::Azimuth, Axis::Elevation}) {
        for (const Protection& one : protectionsOf(profile, axis)) {
            if (one.remedy) {
                const std::string text = settingText(*one.remedy);
                const ProtectionLine line = judged(one, {.state = Reading::State::Read, .text = text});
                EXPECT_EQ(line.verdict, Verdict::Right) << one.key << " " << text;
                EXPECT_TRUE(tookEffect(*one.remedy, {.state = Reading::State::Read, .text = text})) << one.key;
            }
        }
    }
}

TEST(Protections, EveryLineHasWantedAndReason)
{
    for (const Protection& one : protectionsOf(reference(), Axis::Elevation)) {
        EXPECT_FALSE(one.wanted.isEmpty()) << one.key;
        EXPECT_FALSE(one.reason.isEmpty()) << one.key;
        const ProtectionLine unread = judged(one, {});
        EXPECT_EQ(unread.verdict, Verdict::Unread) << one.key;
        EXPECT_TRUE(unread.found.isEmpty()) << one.key;
    }
}

TEST(Protections, TheTimeoutModeIsWhatTheProfileSays)
{
    EXPECT_EQ(verdict("servo.timeout_mode", "10"), Verdict::Right);
    for (const char* other : {"0", "11", "12", "15", "10.5", "nan"}) {
        EXPECT_EQ(verdict("servo.timeout_mode", other), Verdict::Dangerous) << other;
    }
    profile::Profile selfLocking;
    selfLocking.azimuth.timeoutMode = profile::TimeoutMode::Brake;
    EXPECT_EQ(verdict("servo.timeout_mode", "15", selfLocking), Verdict::Right);
    EXPECT_EQ(verdict("servo.timeout_mode", "10", selfLocking), Verdict::Dangerous);
    EXPECT_THAT(judgedAs(reference(), Axis::Azimuth, "servo.timeout_mode", "12").reason.toStdString(),
                HasSubstr("creeps down"));
}

TEST(Protections, TheDefaultTimeoutIsNeitherHastyNorLate)
{
    EXPECT_EQ(verdict("servo.default_timeout_s", "0.050000"), Verdict::Right);
    EXPECT_EQ(verdict("servo.default_timeout_s", "0.200000"), Verdict::Right);
    for (const char* wrong : {"0.000000", "0.040000", "0.250000", "nan"}) {
        EXPECT_EQ(verdict("servo.default_timeout_s", wrong), Verdict::Dangerous) << wrong;
    }
}

// 10°/s and 10°/s² are 0.02778 turns/s and turns/s².
TEST(Protections, DefaultLimitsAreAdvisedOnly)
{
    EXPECT_EQ(verdict("servo.default_velocity_limit", "0.041667"), Verdict::Right);
    EXPECT_EQ(verdict("servo.default_velocity_limit", "0.020000"), Verdict::Advised);
    EXPECT_EQ(verdict("servo.default_velocity_limit", "nan"), Verdict::Advised);
    EXPECT_EQ(verdict("servo.default_accel_limit", "0.350000"), Verdict::Right);
    EXPECT_EQ(verdict("servo.default_accel_limit", "0.250000"), Verdict::Advised) << "0.11 s from full speed";
    EXPECT_EQ(verdict("servo.default_accel_limit", "50.000000"), Verdict::Advised);
    EXPECT_DOUBLE_EQ(*protection(reference(), Axis::Azimuth, "servo.default_velocity_limit").remedy,
                     1.5 * 10.0 / 360.0);
    EXPECT_NEAR(*protection(reference(), Axis::Elevation, "servo.default_accel_limit").remedy, 100.0 / 360.0, 1e-12)
        << "from 8°/s to rest in 0.08 s";
}

// Story: a line showed "wanted 12°/s, found 14.4°/s: right", and a value that Fix had written read back as 10.0001°.
TEST(Protections, WhatMayVaryIsWantedAsARangeAndReadInRoundNumbers)
{
    const ProtectionLine speed = judgedAs(reference(), Axis::Azimuth, "servo.default_velocity_limit", "0.040000");
    EXPECT_EQ(speed.wanted, QStringLiteral("0.0278 to 0.0556 turns/s (10 to 20°/s)"));
    EXPECT_EQ(speed.found, QStringLiteral("0.04 turns/s (14.4°/s)"));
    EXPECT_EQ(speed.wantedBrief, QStringLiteral("10 to 20°/s"));
    EXPECT_EQ(speed.foundBrief, QStringLiteral("14.4°/s"));
    EXPECT_EQ(speed.verdict, Verdict::Right);
    EXPECT_EQ(judgedAs(reference(), Axis::Azimuth, "servo.fault_position_error", "0.027778").found,
              QStringLiteral("0.027778 turns (10°)"));
    EXPECT_EQ(judgedAs(reference(), Axis::Azimuth, "servo.timeout_mode", "12").found, QStringLiteral("12 (damp)"));
    EXPECT_EQ(judgedAs(reference(), Axis::Azimuth, "servo.timeout_mode", "12").wanted, QStringLiteral("10 (hold)"));
}

TEST(Protections, AnAngleIsEnoughWhereThereIsLittleRoom)
{
    const auto line = [](const char* key, const char* found) {
        return judgedAs(reference(), Axis::Azimuth, key, found);
    };
    EXPECT_EQ(line("servopos.position_max", "0.010000").wantedBrief, QStringLiteral("453.0°"));
    EXPECT_EQ(line("servopos.position_max", "0.010000").foundBrief, QStringLiteral("3.6°"));
    EXPECT_EQ(line("servopos.position_max", "nan").foundBrief, QStringLiteral("none"));
    EXPECT_EQ(line("servopos.position_max", "rubbish").foundBrief, QStringLiteral("\"rubbish\""));
    EXPECT_EQ(line("servo.timeout_mode", "12").foundBrief, QStringLiteral("12 (damp)"));
    EXPECT_EQ(line("servo.timeout_mode", "12").wantedBrief, QStringLiteral("10 (hold)"));
    EXPECT_EQ(line("id.id", "2").wantedBrief, QStringLiteral("1"));
    EXPECT_TRUE(judged(protection(reference(), Axis::Azimuth, "id.id"), {}).foundBrief.isEmpty());
}

TEST(Protections, TheGearIsComparedWithTheDrivesSixDecimals)
{
    profile::Profile profile;
    profile.azimuth.geometry.gearRatio = 81.0;
    const std::string key = "motor_position.rotor_to_output_ratio";
    EXPECT_EQ(verdict(key, "0.012346", profile), Verdict::Right);
    EXPECT_EQ(verdict(key, "0.012500", profile), Verdict::Dangerous) << "1:80";
    EXPECT_EQ(verdict(key, "1.000000", profile), Verdict::Dangerous);
    EXPECT_FALSE(protection(profile, Axis::Azimuth, key).remedy) << "the gains would have to change with it";
    EXPECT_FALSE(protection(profile, Axis::Azimuth, "id.id").remedy);
    EXPECT_FALSE(protection(profile, Axis::Azimuth, "motor_position.output.sign").remedy);
}

TEST(Protections, ATrustedPowerUpPositionNeedsAnEncoderOnTheAxis)
{
    const std::string key = "motor_position.output.reference_source";
    EXPECT_EQ(verdict(key, "-1"), Verdict::Right);
    profile::Profile trusting;
    trusting.azimuth.powerUpPosition = profile::PowerUpPosition::Trusted;
    EXPECT_EQ(verdict(key, "-1", trusting), Verdict::Advised);
    EXPECT_EQ(verdict(key, "1", trusting), Verdict::Right);
}

TEST(Protections, CurrentAndVoltage)
{
    EXPECT_EQ(verdict("servo.max_current_A", "30.000000"), Verdict::Right);
    EXPECT_EQ(verdict("servo.max_current_A", "0.000000"), Verdict::Dangerous);
    EXPECT_EQ(verdict("servo.max_current_A", "nan"), Verdict::Dangerous);
    EXPECT_EQ(verdict("servo.max_voltage", "46.000000"), Verdict::Right);
    EXPECT_EQ(verdict("servo.max_voltage", "60.000000"), Verdict::Dangerous);
    EXPECT_EQ(verdict("servo.max_voltage", "nan"), Verdict::Dangerous);
    EXPECT_EQ(verdict("servo.max_position_slip", "nan"), Verdict::Right);
    EXPECT_EQ(verdict("servo.max_position_slip", "0.001000"), Verdict::Advised);
    EXPECT_EQ(verdict("servo.fault_position_error", "nan"), Verdict::Advised);
}

TEST(Protections, WhatTheFirmwareDoesNotKnowIsSaidAndNeverRight)
{
    const Protection mode = protection(reference(), Axis::Azimuth, "servo.timeout_mode");
    const ProtectionLine line = judged(mode, {.state = Reading::State::Unknown});
    EXPECT_EQ(line.found, QStringLiteral("not known to this firmware"));
    EXPECT_EQ(line.verdict, Verdict::Dangerous);
}

TEST(Protections, GarbageIsShownAndNeverRight)
{
    const ProtectionLine line = judgedAs(reference(), Axis::Azimuth, "servo.timeout_mode", "10 emit");
    EXPECT_EQ(line.found, QStringLiteral("\"10 emit\""));
    EXPECT_EQ(line.verdict, Verdict::Dangerous);
}

TEST(Protections, TookEffectForgivesRoundingOnly)
{
    const auto took = [](double written, const char* text) {
        return tookEffect(written, {.state = Reading::State::Read, .text = text});
    };
    EXPECT_TRUE(took(453.0 / 360.0, "1.258333"));
    EXPECT_FALSE(took(453.0 / 360.0, "0.000000")) << "what the drive makes of garbage";
    EXPECT_TRUE(took(std::numeric_limits<double>::quiet_NaN(), "nan"));
    EXPECT_FALSE(took(std::numeric_limits<double>::quiet_NaN(), "0.000000"));
    EXPECT_FALSE(took(10.0, "nan"));
    EXPECT_FALSE(tookEffect(10.0, {.state = Reading::State::Unknown}));
}

}  // namespace
}  // namespace boresight::drive_check
