// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPointF>

#include <gtest/gtest.h>

namespace boresight::ui {

inline void expectNear(QPointF actual, QPointF expected, double tolerance)
{
    EXPECT_NEAR(actual.x(), expected.x(), tolerance);
    EXPECT_NEAR(actual.y(), expected.y(), tolerance);
}

}  // namespace boresight::ui
