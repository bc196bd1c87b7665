// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scan_report.h"

#include <gmock/gmock.h>

namespace boresight::app {
namespace {

using moteus::Register;
using testing::HasSubstr;

FoundController controller(int id, std::uint32_t lastWord = 0x3130206d)
{
    FoundController one{.id = id};
    const auto tell = [&](Register reg, double value) {
        one.known.values.push_back({reg, moteus::Resolution::Int32, value});
    };
    tell(Register::Uuid, 0x65726f62);
    tell(Register::Uuid + 1, 0x68676973);
    tell(Register::Uuid + 2, 0x69732074);
    tell(Register::Uuid + 3, lastWord);
    tell(Register::FirmwareVersion, 0x010203);
    tell(Register::RegisterMapVersion, 5);
    tell(Register::Mode, 10);
    tell(Register::Position, -0.25004);
    tell(Register::HomeState, 2);
    tell(Register::Voltage, 23.96);
    tell(Register::Temperature, 31.24);
    tell(Register::Fault, 0);
    return one;
}

void change(FoundController& one, Register reg, double value)
{
    std::ranges::find(one.known.values, reg, &moteus::RegisterValue::reg)->value = value;
}

TEST(ScanReport, TableHasEverythingWithUnits)
{
    const std::vector found{controller(1)};
    EXPECT_EQ(
        table(found),
        "id  UUID                                  firmware  map  mode      fault  voltage  temperature  position"
        "     reference\n"
        "1   626f7265-7369-6768-7420-73696d203031  1.2.3     5    position  none   24.0 V   31.2 °C      -0.2500 rev"
        "  output referenced\n");
    EXPECT_TRUE(problems(found).empty());
}

TEST(ScanReport, WhatWasNotToldIsAQuestionMark)
{
    FoundController one = controller(1);
    one.known.values.resize(4);
    EXPECT_THAT(table(std::vector{one}), HasSubstr("203031  ?         ?    ?     ?      ?        ?"));
    ASSERT_EQ(problems(std::vector{one}).size(), 1u);
    EXPECT_THAT(problems(std::vector{one})[0].toStdString(), HasSubstr("some questions got no reply"));
}

TEST(ScanReport, AnActiveLimitIsNoFault)
{
    FoundController one = controller(1);
    change(one, Register::Fault, 96);
    EXPECT_THAT(table(std::vector{one}), HasSubstr("none (limit: "));
    EXPECT_TRUE(problems(std::vector{one}).empty());
    change(one, Register::Mode, 1);
    change(one, Register::Fault, 38);
    EXPECT_THAT(table(std::vector{one}), HasSubstr("38 over temperature"));
    ASSERT_EQ(problems(std::vector{one}).size(), 1u);
    EXPECT_THAT(problems(std::vector{one})[0].toStdString(), HasSubstr("id 1: fault 38, over temperature: "));
}

TEST(ScanReport, TwoBoardsWithOneIdAreToldApart)
{
    const std::vector found{controller(4), controller(4, 0x3230206d), controller(5)};
    const auto wrong = problems(found);
    ASSERT_EQ(wrong.size(), 1u);
    EXPECT_THAT(wrong[0].toStdString(), HasSubstr("id 4: 2 controllers have this id"));
}

TEST(ScanReport, AnAnswerThatNeverArrivesWholeIsProbablyTwoBoards)
{
    const std::vector found{FoundController{.id = 1}};
    const auto wrong = problems(found);
    ASSERT_EQ(wrong.size(), 1u);
    EXPECT_THAT(wrong[0].toStdString(), HasSubstr("Probably two controllers have this id"));
}

TEST(ScanReport, FirmwareWithoutUuidIsNotMistakenForTwoBoards)
{
    FoundController old = controller(1);
    std::erase_if(old.known.values,
                  [](const auto& item) { return item.reg <= Register::Uuid + 3 && item.reg >= Register::Uuid; });
    old.known.errors.push_back({Register::Uuid, 1, false});
    EXPECT_TRUE(problems(std::vector{old}).empty());
}

TEST(ScanReport, UnknownRegisterMapIsSaid)
{
    FoundController one = controller(2);
    change(one, Register::RegisterMapVersion, 4);
    const auto wrong = problems(std::vector{one});
    ASSERT_EQ(wrong.size(), 1u);
    EXPECT_THAT(wrong[0].toStdString(),
                HasSubstr("id 2: register map version 4 is unknown. Boresight supports version 5."));
}

TEST(ScanReport, SilenceTellsWhatToCheck)
{
    EXPECT_THAT(silenceText(QStringLiteral("socketcan:can0")).toStdString(),
                HasSubstr("no controller replied on socketcan:can0"));
    EXPECT_THAT(silenceText(QStringLiteral("socketcan:can0")).toStdString(), HasSubstr("120 Ω"));
}

}  // namespace
}  // namespace boresight::app
