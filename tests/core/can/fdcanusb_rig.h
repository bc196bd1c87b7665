// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/can/fdcanusb_link.h"
#include "tests/core/can/adapter_probe.h"
#include "tests/fakes/manual_clock.h"
#include "tests/fakes/pseudo_terminal.h"
#include "tests/fakes/text_of.h"
#include "tests/fakes/wait_until.h"

#include <QSignalSpy>

#include <gmock/gmock.h>

#include <array>
#include <vector>

// An fdcanusb link opened on a pseudo-terminal. The test plays the other end.
namespace boresight {

inline CanFrame frameTo(std::uint32_t id, std::initializer_list<std::uint8_t> bytes)
{
    CanFrame frame;
    frame.id = id;
    frame.extended = id > kMaxStandardId;
    frame.setPayload(std::vector<std::uint8_t>(bytes));
    return frame;
}

class FdcanusbLinkTest : public testing::Test
{
protected:
    FdcanusbLinkTest()
    {
        qRegisterMetaType<CanFrame>();
        qRegisterMetaType<LinkStatus>();
    }

    void SetUp() override
    {
        open(link);
        fakes::answerProbe(adapter, link);
        changes.clear();
    }
    static void open(FdcanusbLink& opened)
    {
        const auto result = opened.open();
        ASSERT_TRUE(result.has_value()) << textOf(result.error());
    }

    [[nodiscard]] CanFrame received(qsizetype index) const { return qvariant_cast<CanFrame>(frames.at(index).at(0)); }
    [[nodiscard]] std::string text() const { return link.status().text.toStdString(); }
    [[nodiscard]] bool written(const QByteArray& bytes) const
    {
        return fakes::waitUntil([this, &bytes] { return adapter.written == bytes; });
    }
    void sendOne() { ASSERT_TRUE(link.send(std::array{frameTo(0x8001, {0x50})}).has_value()); }

    fakes::ManualClock clock;
    fakes::PseudoTerminal adapter;
    FdcanusbLink link{adapter.path(), clock};
    QSignalSpy frames{&link, &CanLink::frameReceived};
    QSignalSpy changes{&link, &CanLink::statusChanged};
};

}  // namespace boresight
