// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/link/profile_change.h"

#include "core/profile/commissioning.h"
#include "ui/kit/command_button.h"
#include "ui/kit/value_label.h"

#include <gtest/gtest.h>

namespace boresight::ui {
namespace {

// A profile whose bus may wait for a reconnect.
class ProfileChangeTest : public ::testing::Test
{
protected:
    ProfileChangeTest()
    {
        QObject::connect(&desk, &RequestDesk::requested, &desk,
                         [this](const NumberedRequest& request) { asked = request; });
        put("fdcanusb:/dev/mount");
    }

    void put(const std::string& bus)
    {
        profile::Profile inForce;
        inForce.bus = bus;
        status.permissions = Permissions::all();
        status.profile = std::make_shared<const profile::Profile>(inForce);
        status.waitingKeys.clear();
        draft.showStatus(status);
    }

    // Everything is in effect at once except the bus, which waits for Reconnect.
    void applyBus(const std::string& bus)
    {
        draft.edit([&bus](profile::Profile& edited) { edited.bus = bus; });
        draft.apply(&desk, [](const std::optional<Error>&) {});
        desk.take({{asked.id, std::nullopt}});
        profile::Profile inForce = std::get<request::ApplyProfile>(asked.request).profile;
        inForce.bus = status.profile->bus;
        status.profile = std::make_shared<const profile::Profile>(inForce);
        status.waitingKeys = {"bus.name"};
        draft.showStatus(status);
    }

    [[nodiscard]] QString whyNotReverse() const
    {
        return change.whyNot(status, [](profile::Profile& edited) { profile::reverse(edited, Axis::Azimuth, {}); });
    }

    RequestDesk desk;
    ProfileDraft draft{desk};
    ProfileChange change{draft, desk};
    NumberedRequest asked{};
    StationStatus status;
};

TEST_F(ProfileChangeTest, NothingIsChangedOfAMountThatWaitsForReconnect)
{
    applyBus("socketcan:can0");
    EXPECT_TRUE(whyNotReverse().contains(QStringLiteral("socketcan:can0 is not in force yet")))
        << whyNotReverse().toStdString();
}

TEST_F(ProfileChangeTest, StartedWithSimulateThereIsNoOtherBus)
{
    put("simulated");
    draft.keepSimulated();
    EXPECT_EQ(whyNotReverse(), QString());
    const auto useAnother = [](profile::Profile& edited) { edited.bus = "socketcan:can1"; };
    EXPECT_TRUE(change.whyNot(status, useAnother).contains(QStringLiteral("--bus socketcan:can1")));
}

// One press, and no setting of the simulated mount is applied on the way.
TEST_F(ProfileChangeTest, ABusThatLeavesTheSimulationIsAReconnect)
{
    put("simulated");
    ValueLabel notice(QStringLiteral("Refused"), fonts::label(), {}, nullptr);
    CommandButton button(QStringLiteral("Connect"), {}, desk, notice);
    change.ask(button, [](profile::Profile& edited) { edited.bus = "socketcan:can1"; });
    ASSERT_TRUE(std::holds_alternative<request::Reconnect>(asked.request));
    EXPECT_EQ(std::get<request::Reconnect>(asked.request).profile.bus, "socketcan:can1");
    desk.take({{asked.id, Error{ErrorCode::Refused, QStringLiteral("the mount moves")}}});
    EXPECT_FALSE(draft.hasEdits()) << "what is refused leaves no edit behind";
    EXPECT_FALSE(button.isWaiting());
}

// Story: "Connect" with the simulated mount selected started to overwrite the calibration of the real mount.
// REQ-PROFILE-17c
TEST_F(ProfileChangeTest, ARealMountIsNotMadeTheSimulatedOne)
{
    const auto simulate = [](profile::Profile& edited) { edited.bus = "simulated"; };
    EXPECT_TRUE(change.whyNot(status, simulate).contains(QStringLiteral("start Boresight with --simulate")));
}

}  // namespace
}  // namespace boresight::ui
