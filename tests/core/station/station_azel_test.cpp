// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/station/station_azel.h"

#include "tests/fakes/wait_until.h"

#include <QFile>
#include <QTemporaryDir>

#include <gtest/gtest.h>

#include <optional>

namespace boresight {
namespace {

const QByteArray kAzelText =
    "22:30:04,105.3, 59.9,Moon\n22:30:04,298.4,-59.7,Sun\n22:30:04,  0.0,  0.0,Source\n"
    " 1296,  2189.0,   -4.41,  1625.0,   -9.79,Doppler, R\n";

// REQ-AZEL-919: The station looks at the file of the profile four times a second from its opening on, beside its
// thread, also at the file of a changed profile.
TEST(StationAzelTest, LooksAtTheFileOfTheProfile)
{
    const QTemporaryDir folder;
    const auto naming = [&](const char* name) {
        profile::Profile profile;
        profile.azel.file = folder.filePath(QLatin1String(name)).toStdString();
        return profile;
    };
    QFile out(folder.filePath(QStringLiteral("azel.dat")));
    ASSERT_TRUE(out.open(QIODevice::WriteOnly));
    out.write(kAzelText);
    out.close();

    profile::InForce profile(naming("azel.dat"));
    StationAzel azel(profile, nullptr);
    std::optional<azel::AzelReading> last;
    int looks = 0;
    QObject::connect(&azel, &StationAzel::looked, [&](const azel::AzelReading& reading) {
        last = reading;
        ++looks;
    });
    azel.open();
    ASSERT_TRUE(fakes::waitUntil([&] { return looks > 1; }));
    ASSERT_TRUE(last->text);
    EXPECT_EQ(last->text->moon, (SkyPointing{105.3_deg, 59.9_deg}));
    profile.apply(naming("none.dat"));
    ASSERT_TRUE(fakes::waitUntil([&] { return !last->text; }));
    EXPECT_EQ(last->path, folder.filePath(QStringLiteral("none.dat")));
}

}  // namespace
}  // namespace boresight
