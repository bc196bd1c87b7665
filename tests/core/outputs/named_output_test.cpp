// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/outputs/named_output.h"

#include "tests/fakes/manual_clock.h"
#include "tests/fakes/played_output.h"

#include <gmock/gmock.h>

#include <memory>
#include <string>
#include <vector>

namespace boresight::outputs {
namespace {

using fakes::PlayedOutput;
using testing::ElementsAre;

profile::Profile profileWith(const std::string& output)
{
    profile::Profile profile;
    profile.brake.output = output;
    return profile;
}

class NamedOutputTest : public testing::Test
{
protected:
    NamedOutputTest()
    {
        named.setMaker([this](const contacts::OutputName& name) {
            auto made = name.kind == contacts::OutputKind::None ? nullptr : std::make_unique<PlayedOutput>(calls);
            output = made.get();
            return made;
        });
        named.open();
    }
    [[nodiscard]] std::optional<bool> isOn() const { return named.answer().isOn; }

    fakes::ManualClock clock;
    profile::InForce inForce{profileWith("rts:/dev/ttyUSB0")};
    std::vector<std::string> calls;
    PlayedOutput* output = nullptr;
    NamedOutput named{inForce,
                      [](const profile::Profile& profile) -> const std::string& { return profile.brake.output; },
                      QStringLiteral("brake"), clock};
};

// REQ-BRAKE-27: An answer belongs to an order. A new order has no answer until the output has reached it, whatever the
// output answered before.
TEST_F(NamedOutputTest, AnAnswerBelongsToAnOrder)
{
    EXPECT_EQ(isOn(), false);
    named.order(true);
    EXPECT_EQ(isOn(), true);
    output->answers = false;
    named.order(false);
    EXPECT_EQ(isOn(), std::nullopt);
    named.order(true);
    EXPECT_EQ(isOn(), std::nullopt) << "it may be going off";
    Q_EMIT output->reached(false);
    EXPECT_EQ(isOn(), std::nullopt);
    Q_EMIT output->reached(true);
    EXPECT_EQ(isOn(), true);
}

// REQ-BRAKE-27
TEST_F(NamedOutputTest, ARepeatedOrderKeepsItsAnswer)
{
    named.order(true);
    output->answers = false;
    clock.advance(Seconds(1.0));
    named.order(true);
    EXPECT_THAT(calls, ElementsAre("off", "on", "on"));
    EXPECT_EQ(isOn(), true);
    clock.advance(Seconds(5.0));
    named.order(true);
    EXPECT_EQ(isOn(), std::nullopt);
    EXPECT_EQ(named.answer().problem, QStringLiteral("no answer for 5 s"));
}

// REQ-BRAKE-28: A problem of the output lasts until the output has reached its order.
TEST_F(NamedOutputTest, AProblemLastsUntilTheOrderIsReached)
{
    output->trouble = QStringLiteral("unplugged");
    named.order(true);
    EXPECT_EQ(isOn(), std::nullopt);
    EXPECT_EQ(named.answer().problem, QStringLiteral("unplugged"));
    Q_EMIT output->reached(false);
    EXPECT_EQ(named.answer().problem, QStringLiteral("unplugged"));
    output->trouble.clear();
    named.order(false);
    EXPECT_EQ(isOn(), false);
    EXPECT_EQ(named.answer().problem, QString());
}

TEST_F(NamedOutputTest, AnotherBrokerMattersToATopicOnly)
{
    profile::Profile before = *inForce;
    profile::Profile after = before;
    after.mqtt.host = "elsewhere";
    EXPECT_FALSE(named.differs(before, after));
    before.brake.output = after.brake.output = "mqtt:shack/brake";
    EXPECT_TRUE(named.differs(before, after));
    after = before;
    EXPECT_FALSE(named.differs(before, after));
    after.brake.output.clear();
    EXPECT_TRUE(named.differs(before, after));
}

}  // namespace
}  // namespace boresight::outputs
