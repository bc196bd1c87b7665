// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/boresightctl/subcommand.h"
#include "core/profile/profile_file.h"

namespace boresight::ctl {
namespace {

ExitStatus runProfile(Arguments arguments)
{
    if (arguments.size() != 1 || arguments.front() != "--default") {
        return usageError(kProfileCommand, QStringLiteral("which profile? --default is the only one there is"));
    }
    print(profile::toToml({}));
    return kDone;
}

}  // namespace

const Subcommand kProfileCommand{
    .name = "profile",
    .arguments = "--default",
    .summary = "Print a profile with every setting, its meaning, unit, range and default",
    .details = R"(The values are those the program has without a profile: the reference mount on the simulated bus.
With another bus.name the directions of its axes are unconfirmed: see "help confirm-directions".

Example:
  boresightctl profile --default > mount.toml
)",
    .run = runProfile};

}  // namespace boresight::ctl
