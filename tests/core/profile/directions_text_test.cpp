// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/profile/directions_text.h"

#include "core/profile/profile_file.h"
#include "tests/fakes/text_of.h"

#include <gtest/gtest.h>

using namespace boresight;
using namespace boresight::profile;

namespace {

const std::string kBus = "\n[bus]\nname = \"socketcan:can0\"  # on the roof\n";

std::string confirmed(const std::string& toml)
{
    const auto text = withDirectionsConfirmed(toml, QStringLiteral("m.toml"));
    return text ? *text : textOf(text.error());
}

}  // namespace

// REQ-PROFILE-06b (DirectionsText.*): Directions are confirmed in a file without any other change to it, or not at all.
TEST(DirectionsText, OnlyTheOneKeyIsChanged)
{
    EXPECT_EQ(confirmed("# mine\nversion = 1\n[mount]\nname = \"a\"\n  directions='unconfirmed' # ask Joe\n" + kBus),
              "# mine\nversion = 1\n[mount]\nname = \"a\"\n  directions = \"confirmed\" # ask Joe\n" + kBus);
    EXPECT_EQ(confirmed("version = 1\n[mount]\n# seen?\n# directions = \"unconfirmed\"\nname = \"a\"\n" + kBus),
              "version = 1\n[mount]\n# seen?\ndirections = \"confirmed\"\nname = \"a\"\n" + kBus);
    EXPECT_EQ(confirmed("version = 1\n [mount] # main\nname = \"a\"\n" + kBus),
              "version = 1\n [mount] # main\ndirections = \"confirmed\"\nname = \"a\"\n" + kBus);
    EXPECT_EQ(confirmed("version = 1" + kBus), "version = 1" + kBus + "\n[mount]\ndirections = \"confirmed\"\n");
}

TEST(DirectionsText, TheFileThatTheProgramWritesIsConfirmed)
{
    Profile profile;
    profile.bus = "socketcan:can0";
    profile.mount.directions = Directions::Unconfirmed;
    const auto text = withDirectionsConfirmed(toToml(profile), QStringLiteral("m.toml"));
    ASSERT_TRUE(text) << textOf(text.error());
    profile.mount.directions = Directions::Confirmed;
    EXPECT_EQ(*parseProfile(*text, QStringLiteral("m.toml")), profile);
}

TEST(DirectionsText, WhatCannotBeEditedIsRefused)
{
    EXPECT_EQ(confirmed("version = 1\nmount.directions = \"unconfirmed\"\n" + kBus),
              "m.toml: the place of the key was not found. Write directions = \"confirmed\" into the table [mount].");
    EXPECT_EQ(confirmed("version = 1\n"),
              "m.toml is the profile of the simulated mount. Set bus.name to the bus of the mount first.");
    EXPECT_EQ(confirmed("version = 2\n" + kBus).substr(0, 10), "m.toml:1: ");
}
