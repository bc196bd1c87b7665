// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/kit/decimal_box.h"

#include <QLineEdit>
#include <QTest>

#include <gtest/gtest.h>

namespace boresight::ui {
namespace {

struct DecimalBoxTest : testing::Test
{
    DecimalBoxTest()
    {
        box.setDecimals(4);
        box.setRange(-360.0, 360.0);
        box.setSuffix(QStringLiteral("°"));
        box.selectAll();
    }

    DecimalBox box;
};

// Story: a tilt of -0,45 became -4, and a landmark at 12,5 became 125.
TEST_F(DecimalBoxTest, ACommaIsAPoint)
{
    QTest::keyClicks(&box, QStringLiteral("-0,45"));
    EXPECT_EQ(box.value(), -0.45);
    box.selectAll();
    QTest::keyClicks(&box, QStringLiteral("12,5"));
    EXPECT_EQ(box.value(), 12.5);
    EXPECT_EQ(box.text(), QStringLiteral("12.5°"));
}

TEST_F(DecimalBoxTest, APointIsOne)
{
    QTest::keyClicks(&box, QStringLiteral("-0.45"));
    EXPECT_EQ(box.value(), -0.45);
}

TEST_F(DecimalBoxTest, WhatIsPastedWithACommaToo)
{
    box.findChild<QLineEdit*>()->insert(QStringLiteral("118,25"));
    EXPECT_EQ(box.value(), 118.25);
}

}  // namespace
}  // namespace boresight::ui
