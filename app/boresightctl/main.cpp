// SPDX-License-Identifier: GPL-3.0-or-later
// boresightctl: simulates, finds and explains moteus controllers, checks profiles, predicts satellites, Sun and Moon,
// reports recorded passes, and asks a running station. It never commands a drive directly.
#include "app/boresightctl/subcommand.h"
#include "app/log_output.h"
#include "core/base/text.h"
#include "core/base/version.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>
#include <cstdio>
#include <vector>

namespace {

using namespace boresight;
using namespace boresight::ctl;

constexpr std::array kSubcommands{&kSimulateCommand,     &kScanCommand,       &kDecodeCommand,
                                  &kCheckCommand,        &kProfileCommand,    &kConfirmDirectionsCommand,
                                  &kEphemerisCommand,    &kPassesCommand,     &kPlanCommand,
                                  &kExportCommand,       &kReplayCommand,     &kReportCommand,
                                  &kGotoCommand,         &kStopCommand,       &kResetStopCommand,
                                  &kOverrideWindCommand, &kUseNewTimeCommand, &kParkCommand,
                                  &kTrackCommand,        &kTakeCommand,       &kReleaseCommand,
                                  &kSatellitesCommand,   &kAntennaCommand,    &kScheduleCommand,
                                  &kStatusCommand,       &kConsoleCommand,    &kProtocolLogCommand};
constexpr std::size_t kNameWidth = 20;

const Subcommand* findSubcommand(const std::string& name)
{
    const auto found = std::ranges::find(kSubcommands, name, [](const Subcommand* one) { return one->name; });
    return found != kSubcommands.end() ? *found : nullptr;
}

std::string overview()
{
    std::string text = "usage: boresightctl SUBCOMMAND …\n\n";
    for (const Subcommand* one : kSubcommands) {
        text += "  " + std::string(one->name) + std::string(kNameWidth - one->name.size(), ' ') +
                std::string(one->summary) + '\n';
    }
    return text +
           "\n\"boresightctl help SUBCOMMAND\" explains one of them. BUS is fdcanusb:PATH, socketcan:IFACE or "
           "simulated.\nExit status: 0 in order, 1 something is wrong, 2 the command line is wrong,\n3 no station "
           "answers.\n";
}

std::string helpText(const Subcommand& subcommand)
{
    return "usage: boresightctl " + std::string(subcommand.name) + ' ' + std::string(subcommand.arguments) + "\n\n" +
           std::string(subcommand.summary) + ".\n\n" + subcommand.details;
}

ExitStatus unknown(const std::string& name)
{
    app::printError(QStringLiteral("boresightctl: there is no subcommand \"%1\"").arg(toQString(name)));
    std::fputs(overview().c_str(), stderr);
    return kUsage;
}

ExitStatus help(Arguments arguments)
{
    if (arguments.empty()) {
        print(overview());
        return kDone;
    }
    const Subcommand* const subcommand = findSubcommand(arguments.front());
    if (subcommand == nullptr) {
        return unknown(arguments.front());
    }
    print(helpText(*subcommand));
    return kDone;
}

bool asksForHelp(const std::string& argument)
{
    return argument == "--help" || argument == "-h";
}

ExitStatus run(Arguments arguments)
{
    if (arguments.empty()) {
        std::fputs(overview().c_str(), stderr);
        return kUsage;
    }
    const std::string& name = arguments.front();
    if (name == "help" || asksForHelp(name)) {
        return help(arguments.subspan(1));
    }
    if (name == "--version") {
        print("boresightctl " + std::string(kVersion) + '\n');
        return kDone;
    }
    const Subcommand* const subcommand = findSubcommand(name);
    if (subcommand == nullptr) {
        return unknown(name);
    }
    const Arguments rest = arguments.subspan(1);
    return std::ranges::any_of(rest, asksForHelp) ? help(arguments.first(1)) : subcommand->run(rest);
}

}  // namespace

int main(int argc, char** argv)
{
    const QCoreApplication application(argc, argv);
    const std::vector<std::string> arguments(argv + 1, argv + argc);
    return run(arguments);
}
