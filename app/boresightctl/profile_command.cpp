// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/boresightctl/subcommand.h"
#include "core/profile/profile_file.h"

namespace boresight::ctl {
namespace {

ExitStatus runProfile(Arguments arguments)
{
    if (arguments.size() != 1 || arguments.front() != "--default") {
        return usageError(kProfileCommand, QStringLiteral("write --default. There is no other profile to print"));
    }
    print(profile::toToml({}));
    return kDone;
}

}  // namespace

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
