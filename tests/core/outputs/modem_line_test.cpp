// SPDX-License-Identifier: GPL-3.0-or-later
// The use of the two lines, at a port that the test plays, because a pseudo-terminal has no such lines.
#include "core/outputs/modem_line.h"

#include "core/outputs/serial_modem_port.h"
#include "tests/fakes/pseudo_terminal.h"

#include <gmock/gmock.h>

#include <string>
#include <vector>

namespace boresight::outputs {
namespace {

using testing::ElementsAre;
using testing::EndsWith;
using testing::IsEmpty;

struct Calls
{
    std::vector<std::string> made;
    std::string broken;  // this call fails

    Result<> make(const std::string& call)
    {
        made.push_back(call);
        return call == broken ? failure(ErrorCode::Io, QStringLiteral("unplugged")) : Result<>{};
    }
    std::vector<std::string> take() { return std::exchange(made, {}); }
};

class PlayedPort final : public ModemPort
{
public:
    explicit PlayedPort(Calls& calls) : m_calls(calls) {}
    Result<> open() override { return m_calls.make("open"); }
    void close() override { (void)m_calls.make("close"); }
    Result<> set(Line line, bool high) override
    {
        return m_calls.make((line == Line::Dtr ? "dtr " : "rts ") + std::string(high ? "high" : "low"));
    }

private:
    Calls& m_calls;
};

// REQ-TRANSMIT-14: The serial port is opened once. Both lines are low at once, and the line that is not used stays low.
// If a line cannot be set the port is closed, and it is opened again at the next attempt.
TEST(ModemLine, OpensThePortOnceWithBothLinesLow)
{
    Calls calls;
    ModemLine line(std::make_unique<PlayedPort>(calls), Line::Rts);
    EXPECT_THAT(calls.take(), IsEmpty());
    ASSERT_TRUE(line.set(false));
    EXPECT_THAT(calls.take(), ElementsAre("open", "rts low", "dtr low", "rts low"));
    ASSERT_TRUE(line.set(true));
    ASSERT_TRUE(line.set(true));
    ASSERT_TRUE(line.set(false));
    EXPECT_THAT(calls.take(), ElementsAre("rts high", "rts high", "rts low"));
    ModemLine other(std::make_unique<PlayedPort>(calls), Line::Dtr);
    ASSERT_TRUE(other.set(true));
    EXPECT_THAT(calls.take(), ElementsAre("open", "dtr low", "rts low", "dtr high"));
}

// REQ-TRANSMIT-14
TEST(ModemLine, OpensThePortAgainAfterATrouble)
{
    Calls calls;
    ModemLine line(std::make_unique<PlayedPort>(calls), Line::Dtr);
    calls.broken = "open";
    EXPECT_FALSE(line.set(false));
    EXPECT_THAT(calls.take(), ElementsAre("open"));
    calls.broken = "rts low";
    EXPECT_FALSE(line.set(true));
    EXPECT_THAT(calls.take(), ElementsAre("open", "dtr low", "rts low", "close")) << "never high";
    calls.broken = "dtr high";
    EXPECT_EQ(line.set(true).error().text, QStringLiteral("unplugged"));
    EXPECT_THAT(calls.take(), ElementsAre("open", "dtr low", "rts low", "dtr high", "close"));
    calls.broken.clear();
    ASSERT_TRUE(line.set(true));
    EXPECT_THAT(calls.take(), ElementsAre("open", "dtr low", "rts low", "dtr high"));
}

// REQ-TRANSMIT-15: A port that is missing, or that has no such lines, is an error with its name.
TEST(SerialModemPort, APortWithoutLinesIsAnError)
{
    fakes::PseudoTerminal terminal;
    ModemLine line(std::make_unique<SerialModemPort>(terminal.path()), Line::Dtr);
    const Result<> low = line.set(false);
    ASSERT_FALSE(low);
    EXPECT_EQ(low.error().text, terminal.path() + QStringLiteral(" has no lines DTR and RTS"));
    EXPECT_FALSE(line.set(true)) << "it is tried again";
}

// REQ-TRANSMIT-15
TEST(SerialModemPort, AMissingPortIsAnError)
{
    ModemLine line(std::make_unique<SerialModemPort>(QStringLiteral("/dev/no-such-port")), Line::Rts);
    const Result<> done = line.set(true);
    ASSERT_FALSE(done);
    EXPECT_EQ(done.error().code, ErrorCode::NoDevice);
}

}  // namespace
}  // namespace boresight::outputs
