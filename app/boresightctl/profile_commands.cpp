// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/boresightctl/subcommand.h"
#include "app/log_output.h"
#include "core/base/text.h"
#include "core/profile/advice.h"
#include "core/profile/commissioning.h"
#include "core/profile/profile_file.h"
#include "core/profile/setting.h"

namespace boresight::ctl {
namespace {

// For example "azimuth moteus id 1".
QString driverText(const QString& axis, const profile::AxisSettings& settings)
{
    if (settings.driver == profile::AxisDriver::None) {
        return QStringLiteral("no ") + axis;
    }
    const profile::DriverKind& kind = profile::kindOf(settings.driver);
    const QString text = QStringLiteral("%1 %2").arg(axis, toQString(kind.name));
    return kind.hasId ? QStringLiteral("%1 id %2").arg(text, QString::number(settings.id)) : text;
}

ExitStatus runCheck(Arguments arguments)
{
    if (arguments.size() != 1) {
        return usageError(kCheckCommand, QStringLiteral("name one profile"));
    }
    const QString path = toQString(arguments.front());
    const Result<profile::Profile> profile = profile::loadProfile(path);
    if (!profile) {
        app::printError(profile.error().text);
        return kFoundWrong;
    }
    if (const QString warning = profile::exposedSecret(*profile, path); !warning.isEmpty()) {
        app::printError(QStringLiteral("warning: ") + warning);
    }
    if (const auto fits = profile::fitsRealMount(*profile); !profile::namesNoBus(*profile) && !fits) {
        app::printError(QStringLiteral("%1: %2").arg(path, fits.error().text));
        return kFoundWrong;
    }
    printLine(QStringLiteral("%1: in order: \"%2\", bus %3, %4, %5")
                  .arg(path, toQString(profile->mount.name), toQString(profile->bus),
                       driverText(QStringLiteral("azimuth"), profile->azimuth),
                       driverText(QStringLiteral("elevation"), profile->elevation)));
    for (const profile::Advice& advice : profile::adviceOn(*profile)) {
        printLine(QStringLiteral("%1: %2. %3").arg(toQString(advice.key), advice.what, advice.remedy));
    }
    return kDone;
}

ExitStatus runProfile(Arguments arguments)
{
    if (arguments.size() != 1 || arguments.front() != "--default") {
        return usageError(kProfileCommand, QStringLiteral("write --default. There is no other profile to print"));
    }
    print(profile::toToml({}));
    return kDone;
}

}  // namespace

const Subcommand kCheckCommand{
    .name = "check",
    .arguments = "PROFILE",
    .summary = "Check a profile as the program does, and report every error",
    .details =
        R"(Prints each error as one line: FILE:LINE: KEY: reason. Changes nothing. Warns of a file with a password that every
user can read. Warns of permitted values that are probably wrong, such as a very long braking distance, as KEY: with the
numbers.
Exit status: 0 no error, 1 there are errors or the file cannot be read.

Example:
  boresightctl check mount.toml && boresightd --profile mount.toml
)",
    .run = runCheck};

const Subcommand kProfileCommand{
    .name = "profile",
    .arguments = "--default",
    .summary = "Print a profile with every setting, its meaning, unit, range and default",
    .details = R"(The values are the defaults of the program: the reference mount on the simulated bus.
With another bus.name the directions of the axes are unconfirmed. See "boresightctl help confirm-directions".

Example:
  boresightctl profile --default > mount.toml
)",
    .run = runProfile};

}  // namespace boresight::ctl
