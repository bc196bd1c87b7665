// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/profile/profile_file.h"

#include <QDateTime>
#include <QString>
#include <QStringList>

#include <gtest/gtest.h>

// The command line options to move the reference mount on a real bus: a profile with confirmed directions, and the
// position of the mount.
namespace boresight::fakes {

inline QStringList confirmedMount(const QString& folder, const QString& bus, profile::Profile profile = {})
{
    profile.bus = bus.toStdString();
    const QString path = folder + QStringLiteral("/mount.toml");
    EXPECT_TRUE(profile::saveProfile(profile, path));
    return {QStringLiteral("--profile"), path};
}

// `place` as AZ,EL, with the present time as the time when the operator looked.
inline QStringList standingAt(const QString& place)
{
    return {QStringLiteral("--standing-at"),
            place + QDateTime::currentDateTimeUtc().toString(QStringLiteral("@yyyy-MM-ddTHH:mm:ssZ"))};
}

}  // namespace boresight::fakes
