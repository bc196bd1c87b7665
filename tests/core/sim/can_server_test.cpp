// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/sim_bus/can_server.h"

#include "core/moteus/codec.h"
#include "tests/fakes/manual_clock.h"
#include "tests/fakes/wait_until.h"

#include <gtest/gtest.h>

#include <vector>

namespace boresight::sim {
namespace {

// The far end of a bus. It keeps what the server sends, and the test puts in the frames of the host.
class HeldLink final : public CanLink
{
public:
    [[nodiscard]] QString name() const override { return QStringLiteral("held"); }
    [[nodiscard]] LinkStatus status() const override { return {}; }
    Result<> open() override { return {}; }
    void close() override {}
    Result<> send(std::span<const CanFrame> frames) override
    {
        sent.insert(sent.end(), frames.begin(), frames.end());
        return {};
    }
    std::vector<CanFrame> sent;
};

class CanServerTest : public testing::Test
{
protected:
    void hear(const moteus::Request& request)
    {
        const auto frame = moteus::encode(request);
        ASSERT_TRUE(frame);
        Q_EMIT link.frameReceived(*frame);
    }

    fakes::ManualClock clock;
    HeldLink link;
    SimulatedPair pair{commissionedPair()};
    CanServer server{link, pair, clock};
};

TEST_F(CanServerTest, AnswersOnTheLink)
{
    hear({.destination = 2, .query = moteus::basicQuery()});
    ASSERT_EQ(link.sent.size(), 1u);
    EXPECT_EQ(link.sent.front().id, 0x200u);
    EXPECT_EQ(moteus::decodeReply(link.sent.front())->mode(), moteus::Mode::Stopped);
    hear({.destination = 7, .query = moteus::basicQuery()});
    EXPECT_EQ(link.sent.size(), 1u);
}

TEST_F(CanServerTest, CommandsActInTime)
{
    hear({.destination = 1, .command = moteus::Brake{}, .replyWanted = false});
    clock.advance(Seconds(0.1));
    hear({.destination = 1, .query = moteus::basicQuery()});
    ASSERT_EQ(link.sent.size(), 1u);
    EXPECT_EQ(moteus::decodeReply(link.sent.front())->mode(), moteus::Mode::Brake);
}

TEST_F(CanServerTest, LateAndDamagedReplies)
{
    pair.faults().add({.kind = FaultKind::LateReply, .axis = Axis::Azimuth, .value = 0.01});
    pair.faults().add({.kind = FaultKind::CorruptLine, .axis = Axis::Elevation, .value = 1.0});
    hear({.destination = 1, .query = moteus::basicQuery()});
    hear({.destination = 2, .query = moteus::basicQuery()});
    EXPECT_TRUE(link.sent.empty());
    clock.advance(Seconds(0.02));
    EXPECT_TRUE(fakes::waitUntil([&] { return link.sent.size() == 1; }));
    EXPECT_EQ(link.sent.front().id, 0x100u);
}

}  // namespace
}  // namespace boresight::sim
