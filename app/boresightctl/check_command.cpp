// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/boresightctl/subcommand.h"
#include "core/profile/advice.h"
#include "core/profile/commissioning.h"
#include "core/profile/profile_file.h"
#include "core/profile/setting.h"

#include <cstdio>

namespace boresight::ctl {
namespace {

ExitStatus run(Arguments arguments)
{
    if (arguments.size() != 1) {
        return usageError(kCheckCommand, "give one profile");
    }
    const std::string& path = arguments.front();
    const Result<profile::Profile> profile = profile::loadProfile(QString::fromStdString(path));
    if (!profile) {
        std::fputs((profile.error().text + '\n').c_str(), stderr);
        return kFoundWrong;
    }
    if (const QString warning = profile::exposedSecret(*profile, QString::fromStdString(path)); !warning.isEmpty()) {
        std::fputs(("warning: " + warning.toStdString() + '\n').c_str(), stderr);
    }
    if (const auto fits = profile::fitsRealMount(*profile); !profile::namesNoBus(*profile) && !fits) {
        std::fputs((path + ": " + fits.error().text + '\n').c_str(), stderr);
        return kFoundWrong;
    }
    print(path + ": in order: \"" + profile->mount.name + "\", bus " + profile->bus + ", azimuth id " +
          std::to_string(profile->azimuth.id) + ", elevation id " + std::to_string(profile->elevation.id) + '\n');
    for (const profile::Advice& advice : profile::adviceOn(*profile)) {
        print(advice.key + ": " + advice.what.toStdString() + ". " + advice.remedy.toStdString() + '\n');
    }
    return kDone;
}

}  // namespace

const Subcommand kCheckCommand{
    .name = "check",
    .arguments = "PROFILE",
    .summary = "Read a profile as the program would and tell every error in it",
    .details =
        R"(All errors come at once, one line each: FILE:LINE: KEY: reason. Nothing is changed. A file with a password that every
user can read is a warning.
What is permitted and hardly meant (brakes that are none) is told as KEY: with its numbers.
Exit status: 0 no error, 1 there are errors or the file cannot be read.

Example:
  boresightctl check mount.toml && boresightd --profile mount.toml
)",
    .run = run};

}  // namespace boresight::ctl
