// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/profile/in_force.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace boresight::profile {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(InForce, IsReadWhereItIsUsed)
{
    InForce inForce{Profile()};
    const InForce& reader = inForce;
    Profile wanted;
    wanted.jog.fast = AngularRate::fromDegrees(3.0);
    inForce.apply(wanted);
    EXPECT_EQ(reader->jog.fast, AngularRate::fromDegrees(3.0));
    EXPECT_EQ(*reader, wanted);
    EXPECT_THAT(reader.waitingKeys(), IsEmpty());
}

TEST(InForce, WhatWaitsForAConnectionIsWantedOnly)
{
    InForce inForce{Profile()};
    Profile wanted;
    wanted.bus = "socketcan:can0";
    wanted.jog.fast = AngularRate::fromDegrees(3.0);
    inForce.apply(wanted);
    EXPECT_EQ(inForce->bus, Profile().bus);
    EXPECT_EQ(inForce->jog.fast, AngularRate::fromDegrees(3.0));
    EXPECT_EQ(inForce.wanted(), wanted);
    EXPECT_THAT(inForce.waitingKeys(), ElementsAre("bus.name"));
}

// The window may still use the shared value in its own thread.
TEST(InForce, AValueThatWasSharedStaysAsItWas)
{
    InForce inForce{Profile()};
    const auto before = inForce.shared();
    Profile wanted;
    wanted.jog.fast = AngularRate::fromDegrees(3.0);
    inForce.apply(wanted);
    EXPECT_EQ(*before, Profile());
    EXPECT_NE(before, inForce.shared());
}

}  // namespace
}  // namespace boresight::profile
