// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/file_name.h"

#include <gtest/gtest.h>

namespace boresight {
namespace {

TEST(SafeFileName, KeepsPlainNamesAndTellsTheOthersApart)
{
    EXPECT_EQ(safeFileName(QStringLiteral("Mast-2_west")), QStringLiteral("Mast-2_west"));
    EXPECT_EQ(safeFileName(QStringLiteral("../etc/x")), QStringLiteral("___etc_x-2215be8e"));
    EXPECT_NE(safeFileName(QStringLiteral("a b")), safeFileName(QStringLiteral("a/b")));
    EXPECT_NE(safeFileName(QStringLiteral("a b")), safeFileName(QStringLiteral("a_b")));
    EXPECT_EQ(safeFileName(QStringLiteral("Höhe")).left(5), QStringLiteral("H_he-"));
    EXPECT_FALSE(safeFileName(QString()).isEmpty());
    EXPECT_LE(safeFileName(QString(5000, u'x')).size(), 80);
    EXPECT_NE(safeFileName(QString(5000, u'x')), safeFileName(QString(5001, u'x')));
}

}  // namespace
}  // namespace boresight
