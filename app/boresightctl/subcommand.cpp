// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/boresightctl/subcommand.h"

#include <cstdio>

namespace boresight::ctl {

void print(const std::string& text)
{
    std::fputs(text.c_str(), stdout);
    std::fflush(stdout);
}

void complain(const Subcommand& subcommand, const std::string& text)
{
    std::fputs(("boresightctl " + std::string(subcommand.name) + ": " + text + '\n').c_str(), stderr);
}

ExitStatus usageError(const Subcommand& subcommand, const std::string& text)
{
    const std::string name(subcommand.name);
    complain(subcommand, text);
    std::fputs(("usage: boresightctl " + name + ' ' + std::string(subcommand.arguments) + "\n\"boresightctl help " +
                name + "\" tells more\n")
                   .c_str(),
               stderr);
    return kUsage;
}

}  // namespace boresight::ctl
