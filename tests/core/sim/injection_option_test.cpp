// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/sim/injection_option.h"

#include "tests/fakes/text_of.h"

#include <gmock/gmock.h>

#include <cmath>

namespace boresight::sim {
namespace {

using testing::HasSubstr;

Result<Injection> parse(std::string_view name, std::string_view text)
{
    const InjectionOption* const option = findInjectionOption(name);
    return option != nullptr ? parseInjection(*option, text)
                             : failure(ErrorCode::NotAvailable, QStringLiteral("no such option"));
}

std::string refusal(std::string_view name, std::string_view text)
{
    const auto parsed = parse(name, text);
    return parsed ? "accepted" : textOf(parsed.error());
}

TEST(InjectionOption, HasAxisValueStartAndDuration)
{
    const auto wind = parse("wind", "az:-30Nm@5s+500ms");
    ASSERT_TRUE(wind) << textOf(wind.error());
    EXPECT_EQ(wind->kind, FaultKind::Wind);
    EXPECT_EQ(wind->axis, Axis::Azimuth);
    EXPECT_EQ(wind->value, -30.0);
    EXPECT_EQ(wind->at, Seconds(5.0));
    EXPECT_EQ(wind->duration, Seconds(0.5));
}

TEST(InjectionOption, EveryPartCanBeLeftOut)
{
    const auto late = parse("late", "20ms");
    ASSERT_TRUE(late);
    EXPECT_FALSE(late->axis);
    EXPECT_EQ(late->value, 0.02);
    EXPECT_EQ(late->at, Seconds(0.0));
    EXPECT_TRUE(std::isinf(late->duration.count()));
    const auto silence = parse("silence", "el@5+3");
    ASSERT_TRUE(silence);
    EXPECT_EQ(silence->axis, Axis::Elevation);
    EXPECT_FALSE(silence->value);
    EXPECT_EQ(silence->at, Seconds(5.0));
    EXPECT_EQ(silence->duration, Seconds(3.0));
    EXPECT_TRUE(parse("silence", ""));
    EXPECT_EQ(parse("stall", "+2")->duration, Seconds(2.0));
    EXPECT_FALSE(parse("power-loss", "@20+2")->value);
    EXPECT_EQ(parse("power-loss", "el:30@20+2")->value, 30.0);
    ASSERT_TRUE(parse("power-loss", ":300@20+2")) << "as its syntax [AXIS][:DEGREES] promises";
    EXPECT_EQ(parse("power-loss", ":300@20+2")->value, 300.0);
    EXPECT_FALSE(parse("power-loss", ":300")->axis);
    EXPECT_EQ(parse("duplicate-id", "")->axis, Axis::Elevation) << "with both swapped, no id would be there twice";
}

TEST(InjectionOption, ErrorsNameTheOptionAndWhatItExpects)
{
    EXPECT_EQ(refusal("wind", "az:x@5"),
              "--wind az:x@5: \"x\" is not a number. Expected [AXIS:]TORQUE[@START][+DURATION]");
    EXPECT_THAT(refusal("wind", "+30"), HasSubstr("value is missing"));
    EXPECT_THAT(refusal("wind", "nan"), HasSubstr("is not a number"));
    EXPECT_THAT(refusal("late", "soon"), HasSubstr("\"soon\" is not a time"));
    EXPECT_THAT(refusal("late", "11"), HasSubstr("outside 0…10"));
    EXPECT_THAT(refusal("lose", "1.5"), HasSubstr("outside 0…1"));
    EXPECT_THAT(refusal("fault", "az:38.5"), HasSubstr("not a whole number"));
    EXPECT_THAT(refusal("fault", "0"), HasSubstr("outside 1…255"));
    EXPECT_THAT(refusal("silence", "up"), HasSubstr("\"up\" is not an axis"));
    EXPECT_THAT(refusal("silence", "el@"), HasSubstr("the start \"\" is not a time"));
    EXPECT_THAT(refusal("silence", "el@-1"), HasSubstr("the start \"-1\" is not a time"));
    EXPECT_THAT(refusal("silence", "el@1e9"), HasSubstr("the start \"1e9\" is not a time"));
    EXPECT_THAT(refusal("silence", "el+0"), HasSubstr("the duration \"0\" is not a time above 0"));
    EXPECT_THAT(refusal("supply", "az:20"), HasSubstr("concerns both axes"));
    EXPECT_EQ(findInjectionOption("gremlins"), nullptr);
}

TEST(InjectionOption, NameAndTextAreOneLineForARunningStation)
{
    const auto gust = parseInjection("wind az:60Nm@5+3");
    ASSERT_TRUE(gust) << textOf(gust.error());
    EXPECT_EQ(gust->kind, FaultKind::Wind);
    EXPECT_EQ(gust->axis, Axis::Azimuth);
    EXPECT_EQ(gust->value, 60.0);
    EXPECT_EQ(gust->at, Seconds(5.0));
    EXPECT_EQ(gust->duration, Seconds(3.0));
    EXPECT_EQ(parseInjection("stall")->kind, FaultKind::Stall);
    EXPECT_THAT(textOf(parseInjection("gremlins az").error()), HasSubstr("no fault \"gremlins\""));
    EXPECT_THAT(textOf(parseInjection("wind").error()), HasSubstr("the value is missing"));
    EXPECT_FALSE(parseInjection(""));
}

TEST(InjectionOption, EveryFaultOfTheSimulatorHasOne)
{
    for (int kind = 0; kind <= static_cast<int>(FaultKind::SensorFrozen); ++kind) {
        const Injection injection{.kind = static_cast<FaultKind>(kind), .value = 1.0};
        EXPECT_THAT(describe(injection), testing::Not(HasSubstr("#"))) << kind;
    }
    EXPECT_THAT(injectionHelp(), HasSubstr("--power-loss [AXIS][:DEGREES][@START][+DURATION]"));
}

TEST(InjectionOption, IsDescribedInWordsWithUnits)
{
    EXPECT_EQ(describe(*parse("wind", "az:30")), "azimuth: wind of 30 Nm towards larger angles");
    EXPECT_EQ(describe(*parse("fault", "el:38")), "elevation: drive fault 38, over temperature");
    EXPECT_EQ(describe(*parse("late", "20ms")), "both axes: replies 0.02 s late");
    EXPECT_EQ(describe(*parse("power-loss", "")), "the mount has no power");
    EXPECT_EQ(describe(*parse("power-loss", "el:30")), "the mount has no power. Somebody turns it to 30° by hand");
    EXPECT_EQ(describe(*parse("bus-off", "")), "the adapter is off the bus");
}

}  // namespace
}  // namespace boresight::sim
