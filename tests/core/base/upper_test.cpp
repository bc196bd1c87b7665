// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/upper.h"

#include <gtest/gtest.h>

namespace boresight {
namespace {

TEST(Upper, ChangesOnlyAsciiLetters)
{
    EXPECT_EQ(upper("<Azimuth>az09[`{@"), "<AZIMUTH>AZ09[`{@");
    EXPECT_EQ(upper("\xe4\xc3\xa9\xff"), "\xe4\xc3\xa9\xff") << "no letter of ASCII";
    EXPECT_EQ(upper(""), "");
}

}  // namespace
}  // namespace boresight
