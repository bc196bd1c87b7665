// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/rotctld/command_parser.h"
#include "core/rotctld/reply_format.h"
#include "core/rotctld/rotator.h"

// What each command does: reads its arguments, asks the Rotator, writes values. Everything but `pause` and `q`, which
// belong to the session. Station thread; returns at once.
namespace boresight::rotctld {

// The form of the default dump_state reply. Hamlib from 4.5.1 on reads tagged lines; 4.0 … 4.5.0 (Ubuntu 22.04) reads
// four bare numbers by position and refuses every set_pos itself without them. Newer clients skip the bare lines.
enum class DumpStateForm
{
    OldAndNew,  // both, the default
    AsHamlib    // tagged lines only, byte for byte what Hamlib 4.5.4 sends
};

struct Context
{
    Rotator& rotator;
    const Client& client;
    QString& outcome;  // for the list of clients: what became of an accepted target, in words
    DumpStateForm dumpState = DumpStateForm::OldAndNew;
};

[[nodiscard]] Result<> runCommand(const Command& command, const Context& context, ReplyWriter& reply);

// Parts of runCommand, one per family.
[[nodiscard]] Result<> runMotion(const Command& command, const Context& context, ReplyWriter& reply);
[[nodiscard]] Result<> runSetting(const Command& command, const Context& context, ReplyWriter& reply);
[[nodiscard]] Result<> runInformation(const Command& command, const Context& context, ReplyWriter& reply);
[[nodiscard]] Result<> runConversion(const Command& command, ReplyWriter& reply);

// The failure of an argument, in the words the log shows: `Elevation "abc" is not a number`.
[[nodiscard]] tl::unexpected<Error> badArgument(const Command& command, std::size_t index);

}  // namespace boresight::rotctld
