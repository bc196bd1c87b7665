// SPDX-License-Identifier: GPL-3.0-or-later
//
// tick_load [--seconds N] [--rounds N] "COMMAND LINE OF boresightd"
//
// How late the control ticks come while the mount moves: with one client at 2 Hz, with 100 clients that send again as
// soon as they have a reply, and with 100 that never wait. At its end boresightd reports how late its ticks were
// (category boresight.tick). The cases take turns, each with a separate boresightd, and the median of the rounds is
// shown, so that other load of the computer affects all of them equally. The clients run with a nice value of 10,
// because the measurement is about the server under flood, not about the scheduler between server and flood.

#include "core/base/numbers.h"
#include "tests/bench/clients.h"
#include "tests/bench/flood.h"
#include "tests/bench/server.h"
#include "tests/fakes/text_of.h"

#include <sys/resource.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

namespace {

using namespace std::chrono_literals;
namespace bench = boresight::bench;

constexpr std::size_t kClients = 100;
constexpr int kClientNice = 10;

struct Arguments
{
    std::chrono::seconds duration{5};
    int rounds = 3;
    std::string command;
};

struct Ticks
{
    double requestsPerSecond = 0;
    double median = 0;  // lateness in ms
    double percentile99 = 0;
    double worst = 0;
};

using Load = std::function<double(const bench::Endpoint&, std::chrono::seconds)>;  // returns requests per second

struct Case
{
    const char* name;
    Load load;
    std::vector<Ticks> rounds;
};

// Targets far apart, so that the mount moves all the time, whichever client sent last.
const std::vector<bench::Request>& requests()
{
    static const std::vector<bench::Request> all{{.text = "p\n", .form = bench::ReplyForm::TwoNumbers},
                                                 {.text = "P 300.00 70.00\n", .form = bench::ReplyForm::Report},
                                                 {.text = "p\n", .form = bench::ReplyForm::TwoNumbers},
                                                 {.text = "P 60.00 20.00\n", .form = bench::ReplyForm::Report}};
    return all;
}

double oneClient(const bench::Endpoint& endpoint, std::chrono::seconds duration)
{
    auto client = bench::Clients::connect(endpoint, 1, requests());
    return client ? client->paced(500ms, duration).perSecond() : 0;
}

double closedLoop(const bench::Endpoint& endpoint, std::chrono::seconds duration)
{
    auto clients = bench::Clients::connect(endpoint, kClients, requests());
    return clients ? clients->closedLoop(duration).perSecond() : 0;
}

double pipelined(const bench::Endpoint& endpoint, std::chrono::seconds duration)
{
    std::string commands;
    for (const bench::Request& request : requests()) {
        commands += request.text;
    }
    const bench::FloodOutcome outcome = bench::flood(endpoint, kClients, commands, duration);
    constexpr double kLinesPerRequest = 1.5;  // two for p, one for P
    return static_cast<double>(outcome.lines) / kLinesPerRequest / std::chrono::duration<double>(duration).count();
}

std::optional<Ticks> readTicks(const std::string& log)
{
    Ticks ticks;
    const std::size_t begin = log.find("ticks ");
    const bool found = begin != std::string::npos &&
                       std::sscanf(log.c_str() + begin, "ticks %*u, late p50 %lf ms, p99 %lf ms, max %lf ms",
                                   &ticks.median, &ticks.percentile99, &ticks.worst) == 3;
    return found ? std::optional(ticks) : std::nullopt;
}

boresight::Result<Ticks> measure(const Load& load, const Arguments& arguments)
{
    auto server = bench::Server::start(arguments.command);
    if (!server) {
        return tl::unexpected(server.error());
    }
    if (const auto known = bench::awaitPosition(server->endpoint()); !known) {
        return tl::unexpected(known.error());
    }
    double requestsPerSecond = 0;
    std::thread clients([&] {
        setpriority(PRIO_PROCESS, 0, kClientNice);  // on Linux: of this thread
        requestsPerSecond = load(server->endpoint(), arguments.duration);
    });
    clients.join();
    auto ticks = readTicks(server->end());
    if (!ticks || requestsPerSecond == 0) {
        return boresight::failure(boresight::ErrorCode::NoAnswer,
                                  ticks ? QStringLiteral("the clients got no answers")
                                        : QStringLiteral("the server said nothing about its ticks"));
    }
    ticks->requestsPerSecond = requestsPerSecond;
    return *ticks;
}

double medianOf(std::vector<Ticks> rounds, double Ticks::*field)
{
    std::ranges::sort(rounds, {}, field);
    return rounds[rounds.size() / 2].*field;
}

void printTable(std::span<const Case> cases)
{
    std::printf("%-32s%12s%12s%12s%12s%14s\n", "lateness of the ticks [ms]", "requests/s", "p50", "p99", "max",
                "p99 to first");
    const double first = medianOf(cases[0].rounds, &Ticks::percentile99);
    for (const Case& one : cases) {
        const double percentile99 = medianOf(one.rounds, &Ticks::percentile99);
        std::printf("%-32s%12.0f%12.1f%12.1f%12.1f%14.2f\n", one.name, medianOf(one.rounds, &Ticks::requestsPerSecond),
                    medianOf(one.rounds, &Ticks::median), percentile99, medianOf(one.rounds, &Ticks::worst),
                    percentile99 / first);
    }
}

std::optional<Arguments> parseArguments(std::span<char*> words)
{
    Arguments arguments;
    for (std::size_t i = 0; i < words.size(); ++i) {
        const std::string_view word = words[i];
        if (word == "--seconds" || word == "--rounds") {
            const auto value = i + 1 < words.size() ? boresight::parseInteger(words[++i]) : std::nullopt;
            if (!value || *value < 1 || *value > 60) {
                return std::nullopt;
            }
            (word == "--rounds") ? void(arguments.rounds = static_cast<int>(*value))
                                 : void(arguments.duration = std::chrono::seconds(*value));
        } else if (arguments.command.empty() && !word.starts_with('-')) {
            arguments.command = word;
        } else {
            return std::nullopt;
        }
    }
    return arguments.command.empty() ? std::nullopt : std::optional(arguments);
}

}  // namespace

int main(int argc, char** argv)
{
    const auto arguments = parseArguments(std::span(argv, static_cast<std::size_t>(argc)).subspan(1));
    if (!arguments) {
        std::fputs("usage: tick_load [--seconds 1…60] [--rounds 1…60] \"COMMAND LINE OF boresightd\"\n", stderr);
        return 2;
    }
    std::array cases{Case{.name = "1 client at 2 Hz", .load = oneClient, .rounds = {}},
                     Case{.name = "100 clients, each waits", .load = closedLoop, .rounds = {}},
                     Case{.name = "100 clients, nobody waits", .load = pipelined, .rounds = {}}};
    for (int round = 0; round < arguments->rounds; ++round) {
        for (Case& one : cases) {
            const auto ticks = measure(one.load, *arguments);
            if (!ticks) {
                std::fprintf(stderr, "tick_load: %s: %s\n", one.name, textOf(ticks.error()).c_str());
                return 1;
            }
            one.rounds.push_back(*ticks);
        }
    }
    printTable(cases);
    return 0;
}
