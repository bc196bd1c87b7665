// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/status_lines/line_reader.h"

#include "core/status_lines/serial_status_port.h"
#include "tests/fakes/manual_clock.h"
#include "tests/fakes/pseudo_terminal.h"
#include "tests/fakes/wait_until.h"

#include <QCoreApplication>

#include <gtest/gtest.h>

#include <atomic>
#include <mutex>

namespace boresight::status_lines {
namespace {

using contacts::InputKind;
using contacts::InputReading;

struct LineReaderTest : testing::Test
{
    Result<StatusLines> read()
    {
        ++calls;
        const std::scoped_lock lock(hanging);
        return next;
    }
    // Polls until the port was read once more.
    void pollOnce()
    {
        const int before = calls;
        reader.poll();
        ASSERT_TRUE(fakes::waitUntil([&] { return calls > before && !isBusy(); }));
    }
    [[nodiscard]] bool isBusy()
    {
        QCoreApplication::processEvents();
        return reader.isBusy();
    }

    fakes::ManualClock clock;
    std::atomic<int> calls = 0;
    std::mutex hanging;
    Result<StatusLines> next{StatusLines{.cts = true, .ri = true}};
    LineReader reader{[this] { return read(); }, clock};
};

// REQ-ENDSWITCH-40: The lines CTS, DSR, DCD and RI of a serial port are read by a thread, again and again. A reading
// that is older than 0.5 s does not count.
TEST_F(LineReaderTest, ReadsTheFourLines)
{
    EXPECT_EQ(reader.reading(InputKind::Cts), InputReading{});
    pollOnce();
    EXPECT_EQ(reader.reading(InputKind::Cts), (InputReading{.isOn = true}));
    EXPECT_EQ(reader.reading(InputKind::Dsr), (InputReading{.isOn = false}));
    EXPECT_EQ(reader.reading(InputKind::Dcd), (InputReading{.isOn = false}));
    EXPECT_EQ(reader.reading(InputKind::Ri), (InputReading{.isOn = true}));
    {
        const std::scoped_lock hangs(hanging);
        reader.poll();
        clock.advance(Seconds(0.6));
        EXPECT_EQ(reader.reading(InputKind::Cts), (InputReading{.problem = QStringLiteral("the port hangs")}));
    }
    ASSERT_TRUE(fakes::waitUntil([this] { return !isBusy(); }));
    EXPECT_EQ(reader.reading(InputKind::Cts), (InputReading{.isOn = true}));
}

// REQ-ENDSWITCH-41: A port that fails gives no reading but its problem. It is tried again after 1 s.
TEST_F(LineReaderTest, APortThatFailsIsTriedAgain)
{
    next = failure(ErrorCode::Io, QStringLiteral("/dev/ttyUSB0: Input/output error"));
    pollOnce();
    EXPECT_EQ(reader.reading(InputKind::Cts),
              (InputReading{.problem = QStringLiteral("/dev/ttyUSB0: Input/output error")}));
    clock.advance(Seconds(0.9));
    reader.poll();
    EXPECT_FALSE(isBusy());
    next = StatusLines{.cts = true};
    clock.advance(Seconds(0.2));
    pollOnce();
    EXPECT_EQ(reader.reading(InputKind::Cts), (InputReading{.isOn = true}));
}

// REQ-ENDSWITCH-42: A port without these lines is reported.
TEST(SerialStatusPort, APseudoTerminalHasNoLines)
{
    fakes::PseudoTerminal terminal;
    SerialStatusPort port(terminal.path());
    const auto read = port.read();
    ASSERT_FALSE(read);
    EXPECT_EQ(read.error().text, terminal.path() + QStringLiteral(" has no lines CTS, DSR, DCD and RI"));
    EXPECT_FALSE(SerialStatusPort(QStringLiteral("/dev/does-not-exist")).read());
}

}  // namespace
}  // namespace boresight::status_lines
