// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mqtt/newest_messages.h"

#include <gmock/gmock.h>

namespace boresight::mqtt {
namespace {

using testing::IsSupersetOf;

Message numbered(int number, qsizetype bytes = 4)
{
    return {.topic = QString::number(number), .payload = QByteArray(bytes, 'x')};
}

// REQ-MQTT-09c (NewestMessages.*)
TEST(NewestMessages, KeepsTheOrder)
{
    NewestMessages messages;
    for (int i = 0; i < 3; ++i) {
        messages.add(numbered(i));
    }
    EXPECT_EQ(messages.take(), (std::vector{numbered(0), numbered(1), numbered(2)}));
    EXPECT_TRUE(messages.take().empty());
}

TEST(NewestMessages, OfAFloodTheNewestAreKept)
{
    NewestMessages messages;
    for (int i = 0; i < 10'000; ++i) {
        messages.add(numbered(i));
    }
    const auto kept = messages.take();
    ASSERT_EQ(kept.size(), NewestMessages::kMost);
    EXPECT_EQ(kept.front(), numbered(10'000 - static_cast<int>(NewestMessages::kMost)));
    EXPECT_EQ(kept.back(), numbered(9999));
}

// Story: a faulty sensor, or somebody who flooded the command topic, displaced a STOP that was waiting in the same
// queue.
TEST(NewestMessages, AFloodOfOneTopicLeavesTheOthers)
{
    const Message stop{.topic = QStringLiteral("stop"), .payload = "stop"};
    NewestMessages messages;
    messages.add(stop);
    for (int i = 0; i < 1000; ++i) {
        messages.add({.topic = QStringLiteral("command"), .payload = QByteArray::number(i)});
    }
    auto kept = messages.take();
    ASSERT_EQ(kept.size(), NewestMessages::kMost);
    EXPECT_EQ(kept.front(), stop);
    EXPECT_EQ(kept.back().payload, "999");
    EXPECT_EQ(kept[1].payload, QByteArray::number(1000 - 31)) << "the newest of the others";

    messages.add(stop);
    for (int i = 0; i < 1000; ++i) {
        messages.add({.topic = QStringLiteral("command"), .payload = QByteArray::number(i)});
    }
    messages.add({.topic = QStringLiteral("wind"), .payload = "3.5"});
    kept = messages.take();
    EXPECT_EQ(kept.front(), stop) << "a message of a third topic takes no place of it";
    EXPECT_EQ(kept.back().payload, "3.5");

    messages.add(stop);
    messages.add({.topic = QStringLiteral("command"), .payload = QByteArray(kLargestMessage, 'x')});
    messages.add(stop);
    kept = messages.take();
    EXPECT_EQ(kept, (std::vector{stop, stop})) << "the large one goes";
}

Message command(const QByteArray& payload)
{
    return {.topic = QStringLiteral("command"), .payload = payload};
}

Urgency urgencyOf(const Message& message)
{
    if (message.payload.endsWith("stop")) {
        return Urgency::Stop;
    }
    return message.payload.trimmed() == "hold" ? Urgency::Hold : Urgency::None;
}

// Story: a hold that arrived on the command topic before a flood of targets was displaced by them, and never obeyed.
// REQ-MQTTCOMMANDS-07
TEST(NewestMessages, AnUrgentMessageIsNotDisplacedByItsOwnTopic)
{
    NewestMessages messages;
    messages.keepUrgent(urgencyOf);
    messages.add(command("1 1"));
    messages.add(command("hold"));
    for (int i = 0; i < 1000; ++i) {
        messages.add(command("10 " + QByteArray::number(i)));
    }
    messages.add(command(QByteArray(kLargestMessage, 'x')));
    auto kept = messages.take();
    EXPECT_EQ(kept.front(), command("hold"));

    messages.add(command("hold"));
    for (int i = 0; i < 1000; ++i) {
        messages.add(command("10 20"));
        messages.add(command("hold"));
    }
    messages.add(command("stop"));
    messages.add(command("30 20"));
    kept = messages.take();
    EXPECT_EQ(kept.size(), NewestMessages::kMost);
    EXPECT_EQ(kept.back(), command("30 20"));
    EXPECT_EQ(kept[kept.size() - 2], command("stop"));
    EXPECT_EQ(kept[kept.size() - 3], command("hold")) << "the newest one";
}

Message atStop(qsizetype bytes)
{
    return {.topic = QStringLiteral("stop"), .payload = QByteArray(bytes, 'x') + " stop"};
}

// Story: a STOP was dropped because 32 holds waited that differed only in their blanks. No two were alike, and the STOP
// was the newest message.
// REQ-MQTTCOMMANDS-07
TEST(NewestMessages, NoFloodOfHoldsDisplacesAStop)
{
    NewestMessages messages;
    messages.keepUrgent(urgencyOf);
    for (int i = 0; i < 100; ++i) {
        messages.add(command("hold" + QByteArray(i, ' ')));
    }
    messages.add(command("stop"));
    messages.add(atStop(1));
    EXPECT_THAT(messages.take(), IsSupersetOf({command("stop"), atStop(1)}));

    messages.add(command("stop"));
    messages.add(atStop(1));
    for (int i = 0; i < 100; ++i) {
        messages.add(command("hold" + QByteArray(i, ' ')));
        messages.add({.topic = QStringLiteral("sensor") + QString::number(i), .payload = "1"});
    }
    EXPECT_THAT(messages.take(), IsSupersetOf({command("stop"), atStop(1), command("hold" + QByteArray(99, ' '))}));
}

// Story: a STOP of 64 kB was dropped, because a hold waited.
// REQ-MQTTCOMMANDS-07
TEST(NewestMessages, ALargeStopStays)
{
    constexpr qsizetype kMostText = kLargestMessage - 5;
    NewestMessages messages;
    messages.keepUrgent(urgencyOf);
    messages.add(command("hold"));
    messages.add(atStop(kMostText));
    EXPECT_EQ(messages.take(), std::vector{atStop(kMostText)});

    messages.add(atStop(kMostText));
    messages.add(command("hold"));
    EXPECT_EQ(messages.take(), std::vector{atStop(kMostText)});

    messages.add(atStop(kMostText));
    messages.add(command("stop"));
    EXPECT_EQ(messages.take(), std::vector{command("stop")}) << "one STOP is enough";
}

// The messages of a sensor pass a flood of holds.
// REQ-MQTTCOMMANDS-07
TEST(NewestMessages, UrgentMessagesLeaveOtherTopicsTheirPlace)
{
    NewestMessages messages;
    messages.keepUrgent(urgencyOf);
    const Message wind{.topic = QStringLiteral("wind"), .payload = "3.5"};
    messages.add(wind);
    for (int i = 0; i < 1000; ++i) {
        messages.add(command("hold"));
    }
    EXPECT_EQ(messages.take().front(), wind);
}

TEST(NewestMessages, TheirBytesAreBoundedTogether)
{
    NewestMessages messages;
    for (int i = 0; i < 10; ++i) {
        messages.add(numbered(i, kLargestMessage / 2));
    }
    EXPECT_EQ(messages.take().size(), 2U);
    messages.add(numbered(10, kLargestMessage));
    EXPECT_EQ(messages.take().size(), 1U);
    messages.add(numbered(11));
    EXPECT_EQ(messages.take().size(), 1U) << "counted anew";
}

}  // namespace
}  // namespace boresight::mqtt
