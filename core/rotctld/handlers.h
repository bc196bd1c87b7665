// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/rotctld/command_parser.h"
#include "core/rotctld/reply_format.h"
#include "core/rotctld/rotator.h"

// Carries out each command: reads its arguments, calls the Rotator, writes values. `pause` and `q` are not here,
// because they belong to the session. Station thread. Never blocks.
namespace boresight::rotctld {

// The form of the default dump_state reply. Hamlib from 4.5.1 on reads tagged lines. Hamlib 4.0 … 4.5.0 (Ubuntu 22.04)
// reads four bare numbers by position, and without them refuses every set_pos itself. Newer clients skip the bare
// lines.
enum class DumpStateForm
{
    OldAndNew,  // both, the default
    AsHamlib    // tagged lines only, byte for byte what Hamlib 4.5.4 sends
};

struct Context
{
    Rotator& rotator;
    const Client& client;
    QString& outcome;  // for the list of clients: the changed target, as text
    DumpStateForm dumpState = DumpStateForm::OldAndNew;
};

[[nodiscard]] Result<> runCommand(const Command& command, const Context& context, ReplyWriter& reply);

// The parts of runCommand, one for each group of commands.
[[nodiscard]] Result<> runMotion(const Command& command, const Context& context, ReplyWriter& reply);
[[nodiscard]] Result<> runSetting(const Command& command, const Context& context, ReplyWriter& reply);
[[nodiscard]] Result<> runInformation(const Command& command, const Context& context, ReplyWriter& reply);
[[nodiscard]] Result<> runConversion(const Command& command, ReplyWriter& reply);

// The error about an argument, as the log shows it: `Elevation "abc" is not a number`.
[[nodiscard]] tl::unexpected<Error> badArgument(const Command& command, std::size_t index);

}  // namespace boresight::rotctld
