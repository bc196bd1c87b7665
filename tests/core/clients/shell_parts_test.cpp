// SPDX-License-Identifier: GPL-3.0-or-later
// What the local socket says about the parts beside the two axes: wind, brake, end switches, outputs, control box,
// third axis.
#include "tests/core/clients/shell_rig.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <string>

namespace boresight {
namespace {

using testing::HasSubstr;
using testing::Not;

// REQ-WIND-29: The shell reports the wind with the status where the profile reads it, and lets the operator override
// it.
TEST(StationShell, ReportsTheWindAndOverridesIt)
{
    ShellRig rig;
    EXPECT_THAT(rig.answerTo("status\n"), Not(HasSubstr("wind")));
    EXPECT_EQ(rig.answerTo("override-wind\n"), "error: The wind does not forbid any motion.\n");
    profile::Profile windy = rig.profile;
    windy.wind.source = "udp:4541";
    rig.setProfile(windy);
    EXPECT_THAT(rig.answerTo("status\n"), HasSubstr(R"("age":null,)"));
    EXPECT_THAT(rig.answerTo("status\n"), HasSubstr(R"("speed":null)"));
    rig.control.takeWind(21.0);
    rig.run(Seconds(1.0));
    EXPECT_THAT(rig.answerTo("status\n"), HasSubstr(R"("speed":21)"));
    EXPECT_THAT(rig.answerTo("status\n"), HasSubstr("The wind reached 21.0 m/s. The limit is 15.0 m/s."));
    EXPECT_EQ(rig.answerTo("override-wind\n"), "ok\n");
    EXPECT_THAT(rig.answerTo("status\n"), HasSubstr(R"("obstacle":"","overriddenUntil":"00:)"));
}

// REQ-STATION-972: The shell reports the error budget with the status: the sum, its loss, and each part. What is
// unknown is null.
TEST(StationShell, ReportsTheErrorBudget)
{
    ShellRig rig;
    EXPECT_THAT(rig.answerTo("status\n"), Not(HasSubstr("errorBudget")));
    rig.errorBudget = budget::ErrorBudget{
        .lines = {{.part = budget::ErrorPart::Servo, .error = 0.25_deg, .basis = QStringLiteral("Measured.")},
                  {.part = budget::ErrorPart::Clock, .basis = QStringLiteral("No time source.")}},
        .sum = 0.25_deg,
        .isWhole = false,
        .loss = {}};
    const std::string answer = rig.answerTo("status\n");
    EXPECT_THAT(answer, HasSubstr(R"("errorBudget":{"degrees":0.25,"loss":null,"parts":[)"));
    EXPECT_THAT(answer, HasSubstr(R"({"degrees":0.25,"from":"Measured.","part":"servo"},)"));
    EXPECT_THAT(answer, HasSubstr(R"({"degrees":null,"from":"No time source.","part":"clock"}],)"));
    EXPECT_THAT(answer, HasSubstr(R"j("text":"Off by at least 0.25° (beyond the main lobe)","whole":false})j"));
}

// REQ-BRAKE-35: The shell reports the brake with the status if the mount has one.
TEST(StationShell, ReportsTheBrake)
{
    ShellRig rig;
    EXPECT_THAT(rig.answerTo("status\n"), Not(HasSubstr("brake")));
    profile::Profile braked = rig.profile;
    braked.brake.output = "rts:/dev/ttyUSB0";
    rig.setProfile(braked);
    EXPECT_THAT(rig.answerTo("status\n"),
                HasSubstr(R"("brake":{"output":"rts:/dev/ttyUSB0","problem":"","state":"closes"})"));
    rig.control.takeBrake({.isOn = false});
    rig.run(Seconds(1.0));
    EXPECT_THAT(rig.answerTo("status\n"), HasSubstr(R"("state":"set"})"));
    rig.control.takeBrake({.problem = QStringLiteral("unplugged")});
    EXPECT_THAT(rig.answerTo("status\n"), HasSubstr(R"("problem":"unplugged","state":"failed"})"));
}

// REQ-ENDSWITCH-61: The shell reports the end switches of the profile with the status.
TEST(StationShell, ReportsTheEndSwitches)
{
    ShellRig rig;
    EXPECT_THAT(rig.answerTo("status\n"), Not(HasSubstr("endSwitches")));
    profile::Profile switched = rig.profile;
    switched.endSwitches.inputs[1] = "mqtt:roof/end";
    rig.setProfile(switched);
    EXPECT_THAT(rig.answerTo("status\n"),
                HasSubstr(R"("endSwitches":[{"end":"azimuth upper","input":"mqtt:roof/end",)"));
    EXPECT_THAT(rig.answerTo("status\n"), HasSubstr(R"("state":"unread")"));
}

// REQ-TRANSMIT-31: The shell reports whether the transmit output is on, or what keeps it off. Without an output the
// answer is an empty object.
TEST(StationShell, ReportsTheTransmitOutput)
{
    ShellRig rig;
    EXPECT_EQ(rig.answerTo("transmit\n"), "ok\n{}\n");
    rig.transmit = {.output = QStringLiteral("file:/run/transmit"),
                    .whyOff = QStringLiteral("The mount has no target."),
                    .within = 2.5_deg};
    EXPECT_EQ(rig.answerTo("transmit\n"),
              "ok\n{\"error\":null,\"on\":false,\"output\":\"file:/run/transmit\",\"problem\":\"\","
              "\"whyOff\":\"The mount has no target.\",\"within\":2.5}\n");
    rig.transmit.on = true;
    rig.transmit.whyOff.clear();
    rig.transmit.error = 0.25_deg;
    EXPECT_THAT(rig.answerTo("transmit\n"), HasSubstr("{\"error\":0.25,\"on\":true,"));
}

// REQ-STATION-945: The shell types a line to the control box of the mount by the rules of the page Console, and reports
// the typed lines with their answers. A mount without such a box refuses both.
TEST(StationShell, TypesToTheControlBox)
{
    ShellRig rig;
    EXPECT_EQ(rig.answerTo("console H\n"), "error: this rotator does not have this function\n");
    EXPECT_EQ(rig.answerTo("console-lines\n"), "error: This mount has no control box that takes typed lines.\n");
    EXPECT_THAT(rig.answerTo("console\n"), HasSubstr("error: This is not a command."));
    rig.console = QStringList{QStringLiteral("> H"), QStringLiteral("H \"help\"")};
    EXPECT_EQ(rig.answerTo("console-lines\n"), "ok\n[\"> H\",\"H \\\"help\\\"\"]\n");
}

// REQ-STATION-971: The shell begins and ends the protocol log, and reports its lines with their numbers, at most 100 in
// one answer. The next question continues after the last number.
TEST(StationShell, ReportsTheProtocolLog)
{
    ShellRig rig;
    EXPECT_EQ(rig.answerTo("protocol-log-on\n"), "ok\n");
    EXPECT_EQ(rig.answerTo("protocol-log-off\n"), "ok\n");
    EXPECT_EQ(rig.answerTo("protocol-lines 0\n"), "ok\n");
    for (int i = 0; i < 150; ++i) {
        rig.protocol.note({.kind = ProtocolAct::Kind::Stop});
        rig.protocol.add({.id = 3, .address = "10.0.0.7:51234"}, {.line = "S", .answer = "RPRT 0\n"});
    }
    const std::string first = rig.answerTo("protocol-lines 0\n");
    EXPECT_EQ(std::ranges::count(first, '\n'), 101);
    EXPECT_THAT(first, testing::StartsWith("ok\n1\t"));
    const std::string last = rig.answerTo("protocol-lines 149\n");
    EXPECT_THAT(last, testing::StartsWith("ok\n150\t"));
    EXPECT_THAT(last, testing::EndsWith("Z\trotctld 10.0.0.7:51234\t-\tS\tstop\tRPRT 0\n"));
    EXPECT_EQ(rig.answerTo("protocol-lines 150\n"), "ok\n");
    EXPECT_THAT(rig.answerTo("protocol-lines all\n"), HasSubstr("error: Write protocol-lines with the number"));
    EXPECT_THAT(rig.answerTo("protocol-lines\n"), HasSubstr("error: This is not a command."));
}

// REQ-THIRD-32: The shell reports the angle, the state, the mode, the fault and the temperature of the third axis.
TEST(StationShell, ReportsTheThirdAxis)
{
    ShellRig rig;
    EXPECT_THAT(rig.answerTo("status\n"), Not(HasSubstr("thirdAxis")));
    rig.third = ThirdAxisStatus{.name = QStringLiteral("polarisation"),
                                .state = ThirdAxisStatus::State::Holding,
                                .place = 12.5_deg,
                                .mode = QStringLiteral("position (10)"),
                                .boardTemperature = 31.0};
    EXPECT_THAT(
        rig.answerTo("status\n"),
        HasSubstr("\"thirdAxis\":{\"angle\":12.5,\"boardTemperature\":31,\"fault\":\"\",\"mode\":\"position (10)\","
                  "\"name\":\"polarisation\",\"rate\":null,\"state\":\"holding\"}"));
}

}  // namespace
}  // namespace boresight
