// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/end_switches/switch_watch.h"

#include <gtest/gtest.h>

namespace boresight::end_switches {
namespace {

using namespace std::chrono_literals;

struct SwitchWatchTest : testing::Test
{
    SwitchState after(std::chrono::milliseconds time, std::optional<bool> isPressed)
    {
        now += time;
        watch.step(isPressed, now);
        return watch.state();
    }

    SwitchWatch watch;
    SteadyTime now{};
};

// REQ-ENDSWITCH-03: A switch counts as pressed at its first pressed reading, and as free only after it was free for
// 0.3 s. A contact that bounces stays pressed.
TEST_F(SwitchWatchTest, ABouncingContactStaysPressed)
{
    EXPECT_EQ(watch.state(), SwitchState::Unread);
    EXPECT_EQ(after(0ms, false), SwitchState::Free);
    EXPECT_EQ(after(20ms, true), SwitchState::Pressed);
    for (int i = 0; i < 20; ++i) {
        EXPECT_EQ(after(200ms, false), SwitchState::Pressed);
        EXPECT_EQ(after(20ms, true), SwitchState::Pressed);
    }
    EXPECT_EQ(after(20ms, false), SwitchState::Pressed);
    EXPECT_EQ(after(280ms, false), SwitchState::Pressed);
    EXPECT_EQ(after(20ms, false), SwitchState::Free);
}

// REQ-ENDSWITCH-04: A switch that cannot be read is neither pressed nor free.
TEST_F(SwitchWatchTest, WithoutAReadingItIsUnread)
{
    EXPECT_EQ(after(0ms, std::nullopt), SwitchState::Unread);
    EXPECT_FALSE(watch.wasRead());
    EXPECT_EQ(after(20ms, true), SwitchState::Pressed);
    EXPECT_TRUE(watch.wasRead());
    EXPECT_EQ(after(20ms, std::nullopt), SwitchState::Unread);
    EXPECT_EQ(after(20ms, false), SwitchState::Free) << "its first reading after that";
}

}  // namespace
}  // namespace boresight::end_switches
