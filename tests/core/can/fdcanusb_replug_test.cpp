// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/can/adapter_port.h"
#include "core/can/fdcanusb_link.h"
#include "tests/core/can/adapter_probe.h"
#include "tests/fakes/manual_clock.h"
#include "tests/fakes/pseudo_terminal.h"
#include "tests/fakes/text_of.h"
#include "tests/fakes/wait_until.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>

#include <gmock/gmock.h>

namespace boresight {
namespace {

using fakes::waitUntil;
using testing::HasSubstr;

CanFrame anyFrame()
{
    CanFrame frame;
    frame.id = 0x8001;
    frame.extended = true;
    frame.setPayload(std::vector<std::uint8_t>{0x50});
    return frame;
}

// An operator configured ttyACM0. The adapter is found again although it comes back as ttyACM1 and another device has
// become ttyACM0.
class FdcanusbReplugTest : public testing::Test
{
protected:
    void SetUp() override
    {
        ASSERT_TRUE(QDir(folder.path()).mkdir(QStringLiteral("by-id")));
        name("usb-mjbots_fdcanusb_F34E5D64-if00", first);
        const auto opened = link.open();
        ASSERT_TRUE(opened.has_value()) << textOf(opened.error());
        fakes::answerProbe(first, link);
    }
    [[nodiscard]] QString path(const char* entry) const
    {
        return folder.filePath(QStringLiteral("by-id/")) + QString::fromLatin1(entry);
    }
    void name(const char* entry, const fakes::PseudoTerminal& port) const
    {
        QFile::remove(path(entry));
        ASSERT_TRUE(QFile::link(port.path(), path(entry)));
    }
    void unplugFirst()
    {
        QFile::remove(path("usb-mjbots_fdcanusb_F34E5D64-if00"));
        first.unplug();
        ASSERT_TRUE(waitUntil([this] { return link.status().state == LinkState::Lost; }));
    }
    [[nodiscard]] bool reaches(const fakes::PseudoTerminal& port)
    {
        const CanFrame frame = anyFrame();
        return link.send({&frame, 1}).has_value() && waitUntil([&port] { return port.written.startsWith("can send"); });
    }

    fakes::ManualClock clock;
    QTemporaryDir folder;
    fakes::PseudoTerminal first;
    fakes::PseudoTerminal second;
    FdcanusbLink link{adapterPort(first.path(), folder.filePath(QStringLiteral("by-id"))), clock};
};

// REQ-CAN-18 (FdcanusbReplugTest.*): An adapter that is configured by a kernel name (`/dev/ttyACM0`) is found again by
// its name in `/dev/serial/by-id`, whatever kernel name it has then. Another device under the old name is left alone.
TEST_F(FdcanusbReplugTest, AdapterIsFoundAgainUnderItsStableName)
{
    unplugFirst();
    EXPECT_THAT(link.status().text.toStdString(), HasSubstr("by-id/usb-mjbots_fdcanusb_F34E5D64-if00"));
    const auto absent = link.open();
    ASSERT_FALSE(absent.has_value());
    EXPECT_EQ(absent.error().code, ErrorCode::NoDevice);
    EXPECT_THAT(textOf(absent.error()),
                HasSubstr("usb-mjbots_fdcanusb_F34E5D64-if00 does not exist. Plug the adapter in"));

    name("usb-mjbots_fdcanusb_F34E5D64-if00", second);
    ASSERT_TRUE(link.open().has_value());
    EXPECT_EQ(link.name(), QStringLiteral("fdcanusb:") + first.path());  // as configured
    fakes::answerProbe(second, link);
    EXPECT_TRUE(reaches(second));
}

TEST_F(FdcanusbReplugTest, AnotherDeviceThatTookTheNameIsLeftAlone)
{
    link.close();
    QFile::remove(path("usb-mjbots_fdcanusb_F34E5D64-if00"));
    name("usb-u-blox_GNSS_receiver-if00", first);
    EXPECT_EQ(link.open().error().code, ErrorCode::NoDevice);
    EXPECT_EQ(first.written, QByteArray());
}

TEST_F(FdcanusbReplugTest, SpareAdapterInItsPlaceIsTakenAndRemembered)
{
    link.close();
    QFile::remove(path("usb-mjbots_fdcanusb_F34E5D64-if00"));
    name("usb-mjbots_fdcanusb_79678ECE-if00", first);
    ASSERT_TRUE(link.open().has_value());
    first.unplug();
    ASSERT_TRUE(waitUntil([this] { return link.status().state == LinkState::Lost; }));
    EXPECT_THAT(link.status().text.toStdString(), HasSubstr("79678ECE"));
}

// A symbolic link that the operator chose is followed to wherever it leads next time.
TEST_F(FdcanusbReplugTest, ChosenLinkIsFollowed)
{
    link.close();
    name("chosen", first);
    FdcanusbLink chosen{adapterPort(path("chosen"), folder.filePath(QStringLiteral("by-id"))), clock};
    ASSERT_TRUE(chosen.open().has_value());
    chosen.close();
    name("chosen", second);
    ASSERT_TRUE(chosen.open().has_value());
    fakes::answerProbe(second, chosen);
    const CanFrame frame = anyFrame();
    ASSERT_TRUE(chosen.send({&frame, 1}).has_value());
    EXPECT_TRUE(waitUntil([this] { return second.written.startsWith("can send"); }));
}

}  // namespace
}  // namespace boresight
