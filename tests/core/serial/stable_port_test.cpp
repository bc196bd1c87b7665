// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/serial/stable_port.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>

#include <gtest/gtest.h>

namespace boresight {
namespace {

// Story: a CAN adapter received the device name of an unplugged sensor, and was opened as that sensor.
TEST(StablePort, AnotherDeviceTakesItsPlaceOnlyAsASpareOne)
{
    const QTemporaryDir folder;
    const auto path = [&](const char* name) { return folder.filePath(QString::fromLatin1(name)); };
    ASSERT_TRUE(QDir(folder.path()).mkdir(QStringLiteral("by-id")));
    for (const char* const device : {"ttyACM0", "ttyACM1"}) {
        ASSERT_TRUE(QFile(path(device)).open(QIODevice::WriteOnly));
    }
    ASSERT_TRUE(QFile::link(path("ttyACM0"), path("by-id/usb-feather")));
    StablePort sensor(path("ttyACM0"), path("by-id"));
    StablePort adapter(path("ttyACM0"), path("by-id"),
                       [](const QString& name) { return name == QStringLiteral("usb-adapter"); });
    sensor.storeName();
    adapter.storeName();

    QFile::remove(path("by-id/usb-feather"));
    ASSERT_TRUE(QFile::link(path("ttyACM0"), path("by-id/usb-adapter")));
    EXPECT_EQ(sensor.device(), path("by-id/usb-feather"));
    EXPECT_EQ(adapter.device(), path("ttyACM0"));

    ASSERT_TRUE(QFile::link(path("ttyACM1"), path("by-id/usb-feather")));
    EXPECT_EQ(adapter.device(), path("by-id/usb-feather")) << "the stored one comes first, wherever it is plugged in";
}

}  // namespace
}  // namespace boresight
