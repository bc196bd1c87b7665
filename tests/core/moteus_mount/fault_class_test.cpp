// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/moteus_mount/fault_class.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

namespace boresight {
namespace {

using supervision::LossClass;

// REQ-SUPERVISION-21: Every fault code has a class. 33 and 44 are driver faults, because the code alone does not
// distinguish a low supply voltage from a burnt bridge. An unknown code is never retried.
TEST(ClassOfFault, FollowsTheTable)
{
    const std::map<LossClass, std::set<int>> table{
        {LossClass::Encoder, {35, 42, 43}}, {LossClass::Configuration, {36, 39, 41, 45, 47, 48}},
        {LossClass::Supply, {34, 40}},      {LossClass::OverTemperature, {38}},
        {LossClass::Motion, {49, 50}},      {LossClass::Driver, {1, 2, 3, 4, 5, 6, 7, 32, 33, 37, 44, 46}},
    };
    int seen = 0;
    for (const auto& [loss, codes] : table) {
        for (const int code : codes) {
            EXPECT_EQ(classOfFault(code), loss) << code;
            ++seen;
        }
    }
    EXPECT_EQ(seen, 26);  // 1..7 and 32..50
    EXPECT_EQ(classOfFault(77), LossClass::Driver) << "an unknown code is never retried";
}

}  // namespace
}  // namespace boresight
