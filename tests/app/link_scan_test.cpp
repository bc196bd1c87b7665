// SPDX-License-Identifier: GPL-3.0-or-later
// The scan of the simulated pair, in real time: a second or two each.
#include "app/link_scan.h"

#include "app/scan_report.h"
#include "core/sim_bus/simulated_link.h"
#include "tests/fakes/wait_until.h"

#include <gmock/gmock.h>

namespace boresight::app {
namespace {

using drive_check::FoundController;
using moteus::Register;

// A bus that records the queries.
class WatchedLink final : public CanLink
{
public:
    explicit WatchedLink(SimulatedLink& inner) : m_inner(inner)
    {
        connect(&inner, &CanLink::frameReceived, this, &CanLink::frameReceived);
    }
    [[nodiscard]] QString name() const override { return m_inner.name(); }
    [[nodiscard]] LinkStatus status() const override { return m_inner.status(); }
    Result<> open() override { return m_inner.open(); }
    void close() override { m_inner.close(); }
    Result<> send(std::span<const CanFrame> frames) override
    {
        sent.insert(sent.end(), frames.begin(), frames.end());
        return m_inner.send(frames);
    }

    std::vector<CanFrame> sent;

private:
    SimulatedLink& m_inner;
};

class LinkScanTest : public testing::Test
{
protected:
    void run(const sim::PairSettings& pair = sim::commissionedPair(), std::optional<sim::Injection> injection = {})
    {
        SimulatedLink inner(clock, pair);
        WatchedLink link(inner);
        ASSERT_TRUE(link.open());
        if (injection) {
            inner.inject(*injection);
        }
        LinkScan scan(link);
        bool done = false;
        QObject::connect(&scan, &LinkScan::finished, &scan, [&](const QString& reason) {
            done = true;
            problem = reason;
        });
        scan.start();
        ASSERT_TRUE(fakes::waitUntil([&] { return done; }));
        found = scan.controllers();
        sent = link.sent;
        modes = {inner.truth(Axis::Azimuth).mode, inner.truth(Axis::Elevation).mode};
    }

    SystemClock clock;
    QString problem;
    std::vector<FoundController> found;
    std::vector<CanFrame> sent;
    std::vector<moteus::Mode> modes;
};

TEST_F(LinkScanTest, FindsBothAndAsksThemEverything)
{
    run();
    EXPECT_TRUE(problem.isEmpty());
    ASSERT_EQ(found.size(), 2u);
    EXPECT_EQ(found[0].id, 1);
    EXPECT_EQ(found[1].id, 2);
    EXPECT_NE(found[0].known.uuid(), found[1].known.uuid());
    EXPECT_EQ(found[1].known.value(Register::FirmwareVersion), 0x010100);
    EXPECT_EQ(found[1].known.homeState(), moteus::HomeState::Output);
    EXPECT_TRUE(problems(found).empty());
}

// The only register that is written is the mask that addresses a board by its UUID.
TEST_F(LinkScanTest, NeverCommandsAnything)
{
    run();
    for (const CanFrame& frame : sent) {
        moteus::SubframeReader reader(frame.payload());
        while (const auto subframe = reader.next()) {
            if (const auto* write = std::get_if<moteus::WriteBlock>(&*subframe)) {
                EXPECT_GE(write->first, Register::UuidMask) << toString(frame);
                EXPECT_LE(write->first + (write->count - 1), Register::UuidMask + 3) << toString(frame);
            }
        }
    }
    EXPECT_GT(sent.size(), 100u);
    EXPECT_THAT(modes, testing::Each(moteus::Mode::Stopped));
}

TEST_F(LinkScanTest, NoticesTwoBoardsFreshFromTheBox)
{
    run(sim::factoryPair());
    ASSERT_EQ(found.size(), 1u);
    EXPECT_TRUE(found[0].isUnreadable());
}

TEST_F(LinkScanTest, FindsWhatAnswersLate)
{
    run(sim::commissionedPair(), sim::Injection{.kind = sim::FaultKind::LateReply, .value = 0.08});
    ASSERT_EQ(found.size(), 2u);
    EXPECT_TRUE(problems(found).empty());
}

TEST_F(LinkScanTest, AsksAgainWhatGotLost)
{
    run(sim::commissionedPair(), sim::Injection{.kind = sim::FaultKind::LostReply, .value = 0.1});
    ASSERT_EQ(found.size(), 2u);
    EXPECT_TRUE(problems(found).empty()) << problems(found).front().toStdString();
}

TEST_F(LinkScanTest, FindsNobodyOnASilentBus)
{
    run(sim::commissionedPair(), sim::Injection{.kind = sim::FaultKind::Silence});
    EXPECT_TRUE(problem.isEmpty());
    EXPECT_TRUE(found.empty());
}

TEST_F(LinkScanTest, EndsAtOnceWhenTheBusRefuses)
{
    run(sim::commissionedPair(), sim::Injection{.kind = sim::FaultKind::BusOff});
    EXPECT_TRUE(problem.contains(QStringLiteral("bus is off"))) << problem.toStdString();
    EXPECT_EQ(sent.size(), 1u);
}

}  // namespace
}  // namespace boresight::app
