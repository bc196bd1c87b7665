// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/boresightctl/subcommand.h"

#include "app/log_output.h"
#include "core/base/text.h"

#include <cstdio>

namespace boresight::ctl {

void print(const std::string& text)
{
    std::fwrite(text.data(), 1, text.size(), stdout);  // the text may have the byte 0
    std::fflush(stdout);
}

void printLine(const QString& line)
{
    print(line.toStdString() + '\n');
}

void complain(const Subcommand& subcommand, const QString& text)
{
    app::printError(QStringLiteral("boresightctl %1: %2").arg(toQString(subcommand.name), text));
}

ExitStatus usageError(const Subcommand& subcommand, const QString& text)
{
    complain(subcommand, text);
    app::printError(QStringLiteral("usage: boresightctl %1 %2\n\"boresightctl help %1\" explains this command")
                        .arg(toQString(subcommand.name), toQString(subcommand.arguments)));
    return kUsage;
}

}  // namespace boresight::ctl
