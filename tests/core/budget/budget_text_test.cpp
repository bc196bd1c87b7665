// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/budget/budget_text.h"

#include <gtest/gtest.h>

namespace boresight::budget {
namespace {

// REQ-BUDGET-11: In words the budget has the sum in degrees and in dB. If a part is unknown, the words say "at least".
TEST(BudgetText, SaysHowFarTheBeamIsOff)
{
    ErrorBudget budget{.sum = 0.04_deg, .loss = 0.12};
    EXPECT_EQ(offByText(budget), QString::fromUtf8("Off by 0.04° (-0.1 dB)"));
    budget.isWhole = false;
    EXPECT_EQ(offByText(budget), QString::fromUtf8("Off by at least 0.04° (-0.1 dB)"));
    budget = {.sum = 20_deg, .loss = {}};
    EXPECT_EQ(offByText(budget), QString::fromUtf8("Off by 20.00° (beyond the main lobe)"));
    EXPECT_EQ(lossText(0.01), QStringLiteral("0.0 dB"));
    EXPECT_EQ(lossText(3.04), QStringLiteral("-3.0 dB"));
    EXPECT_EQ(lossText({}), QString());
}

// REQ-BUDGET-12: Each part is a line with its name, its error and where the number comes from. An unknown part says
// "unknown", and the wind says that it is not in the sum.
TEST(BudgetText, ListsTheParts)
{
    const ErrorBudget budget{
        .lines = {{.part = ErrorPart::Servo, .error = 0.03_deg, .basis = QStringLiteral("Measured.")},
                  {.part = ErrorPart::Clock, .basis = QStringLiteral("No time source.")},
                  {.part = ErrorPart::Wind, .basis = QStringLiteral("Nothing measures it.")}},
        .sum = 0.03_deg,
        .isWhole = false,
        .loss = 0.0};
    EXPECT_EQ(listText(budget), QString::fromUtf8("Servo: 0.030°. Measured.\n"
                                                  "Clock: unknown. No time source.\n"
                                                  "Wind: not in the sum. Nothing measures it.\n"
                                                  "Off by at least 0.03° (0.0 dB)"));
}

// REQ-BUDGET-12
TEST(BudgetText, EachPartHasANameAndAKey)
{
    for (const ErrorPart part : {ErrorPart::Servo, ErrorPart::Way, ErrorPart::Stream, ErrorPart::Clock,
                                 ErrorPart::Elements, ErrorPart::Calibration, ErrorPart::Wind}) {
        EXPECT_FALSE(nameOf(part).isEmpty());
        EXPECT_FALSE(keyOf(part).isEmpty());
    }
}

}  // namespace
}  // namespace boresight::budget
