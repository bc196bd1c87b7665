// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/boresightctl/subcommand.h"
#include "core/base/text.h"
#include "core/profile/directions_text.h"
#include "core/profile/profile_file.h"
#include "core/profile/small_file.h"

#include <iostream>

namespace boresight::ctl {
namespace {

ExitStatus fail(const Error& error)
{
    complain(kConfirmDirectionsCommand, error.text);
    return kFoundWrong;
}

// Names each axis that the mount has.
QString question(const profile::Profile& profile)
{
    QStringList speeds;
    QStringList seen;
    const auto add = [&](const profile::AxisSettings& axis, const QString& name, const QString& what) {
        if (axis.driver != profile::AxisDriver::None) {
            speeds += QStringLiteral("%1 °/s in %2").arg(QString::number(axis.limits.speed.degrees(), 'f', 1), name);
            seen += QStringLiteral("  %1\n").arg(what);
        }
    };
    add(profile.azimuth, QStringLiteral("azimuth"),
        QStringLiteral("azimuth:   to the right (M 16) the beam turns clockwise, seen from above"));
    add(profile.elevation, QStringLiteral("elevation"), QStringLiteral("elevation: up (M 2) the beam rises"));
    return QStringLiteral(
               "Mount \"%1\", bus %2.\n"
               "After this Boresight moves the mount to every place of its travel, at up to %3.\n"
               "Confirm only what a person at the mast has seen:\n"
               "%4Type yes if the mount turns like this: ")
        .arg(toQString(profile.mount.name), toQString(profile.bus), speeds.join(QStringLiteral(" and ")),
             seen.join(QString()));
}

bool isConfirmedByHand(const profile::Profile& profile)
{
    print(question(profile).toStdString());
    std::string answer;
    std::getline(std::cin, answer);
    return answer == "yes";
}

ExitStatus runConfirmDirections(Arguments arguments)
{
    if (arguments.size() != 1) {
        return usageError(kConfirmDirectionsCommand, QStringLiteral("name one profile"));
    }
    const QString path = QString::fromStdString(arguments.front());
    const auto toml = profile::readFile(path);
    const auto profile = profile::loadProfile(path);
    if (!toml || !profile) {
        return fail(toml ? profile.error() : toml.error());
    }
    const auto confirmed = profile::withDirectionsConfirmed(toml->toStdString(), toQString(arguments.front()));
    if (!confirmed) {
        return fail(confirmed.error());
    }
    if (profile->mount.directions == profile::Directions::Confirmed) {
        printLine(QStringLiteral("%1: the directions are confirmed already").arg(path));
        return kDone;
    }
    if (!isConfirmedByHand(*profile)) {
        return fail({ErrorCode::Refused, QStringLiteral("Nothing was confirmed. The file is unchanged.")});
    }
    const auto written = profile::writeFile(path, QByteArray::fromStdString(*confirmed), profile::readersOf(path));
    if (!written) {
        return fail(written.error());
    }
    printLine(QStringLiteral("%1: the directions are confirmed. Start Boresight again.").arg(path));
    return kDone;
}

}  // namespace

const Subcommand kConfirmDirectionsCommand{
    .name = "confirm-directions",
    .arguments = "PROFILE",
    .summary = "Confirm in a profile that each axis turns in the direction of the profile",
    .details = R"(Before that, Boresight moves a real mount at most 2° at 5 °/s. With boresightd, which has no window:
  1. Start boresightd with this profile, and stand where you see the antenna.
  2. rotctl -m 2 -r localhost:4533, and in it: M 16 20 (right), M 2 20 (up). The mount stops by itself.
  3. If an axis turned the wrong way, change its sign in the profile, and begin again.
  4. If each axis turned the right way, run this command. Then start boresightd again.
This command asks before it writes. It writes only mount.directions. Comments and all other lines stay.
Exit status: 0 the directions are confirmed, 1 they are not: the file is unchanged.

Example:
  boresightctl confirm-directions /etc/boresight/profile.toml
)",
    .run = runConfirmDirections};

}  // namespace boresight::ctl
