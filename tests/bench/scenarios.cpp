// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/scenarios.h"

#include "core/base/text.h"
#include "tests/bench/clients.h"
#include "tests/bench/server.h"

#include <cmath>
#include <functional>

namespace boresight::bench {
namespace {

using namespace std::chrono_literals;

constexpr std::size_t kIdleClients = 500;
constexpr std::size_t kPacedClients = 100;
constexpr std::size_t kClientsAtOnce = 100;

using Figures = std::vector<Figure>;
using Scenario = std::function<Result<Figures>(const Server&, std::chrono::seconds)>;

const std::vector<Request>& getPosition()
{
    static const std::vector<Request> requests{{.text = "p\n", .form = ReplyForm::TwoNumbers}};
    return requests;
}

// The requests at a busy station: mostly positions, some targets inside the limits of every server, the extended form,
// the name.
const std::vector<Request>& mixedRequests()
{
    static const std::vector<Request> requests{
        {.text = "p\n", .form = ReplyForm::TwoNumbers},       {.text = "P 120.50 35.25\n", .form = ReplyForm::Report},
        {.text = "p\n", .form = ReplyForm::TwoNumbers},       {.text = "+\\get_pos\n", .form = ReplyForm::Report},
        {.text = "p\n", .form = ReplyForm::TwoNumbers},       {.text = "P 121,00 35,50\n", .form = ReplyForm::Report},
        {.text = "\\get_info\n", .form = ReplyForm::OneLine}, {.text = "p\n", .form = ReplyForm::TwoNumbers},
    };
    return requests;
}

// The requests of Gpredict during tracking, one exchange a second: a new target, then the position.
std::vector<Request> passRequests()
{
    std::vector<Request> requests;
    for (int second = 0; second < 60; ++second) {
        requests.push_back({.text = "P " + std::to_string(60 + second) + ".50 " + std::to_string(10 + second) + ".25\n",
                            .form = ReplyForm::Report});
        requests.push_back(getPosition().front());
    }
    return requests;
}

Result<Figures> closedLoop(const Server& server, std::chrono::seconds duration, const std::string& name,
                           const std::vector<Request>& requests, std::size_t count)
{
    auto clients = Clients::connect(server.endpoint(), count, requests);
    if (!clients) {
        return tl::unexpected(clients.error());
    }
    Measurement measured = clients->closedLoop(duration);
    const std::string title = name + ", " + std::to_string(count) + " clients: ";
    return Figures{
        {.name = title + "requests/s", .value = measured.perSecond(), .better = Better::Higher},
        {.name = title + "p50 [µs]", .value = measured.percentile(0.5)},
        {.name = title + "p99 [µs]", .value = measured.percentile(0.99)},
        {.name = title + "errors", .value = double(measured.errors)},
    };
}

Result<Figures> pacedClients(const Server& server, std::chrono::seconds duration)
{
    // One client starts a long motion of the mount.
    auto driver = Clients::connect(server.endpoint(), 1, {{.text = "P 300.00 80.00\n", .form = ReplyForm::Report}});
    auto clients = Clients::connect(server.endpoint(), kPacedClients, getPosition());
    if (!driver || !clients) {
        return tl::unexpected(driver ? clients.error() : driver.error());
    }
    const Measurement moving = driver->paced(10ms, 10ms);
    Measurement measured = clients->paced(1s, duration);
    return Figures{
        {.name = "100 clients at 1 Hz, mount moving: p50 [µs]", .value = measured.percentile(0.5)},
        {.name = "100 clients at 1 Hz, mount moving: p99 [µs]", .value = measured.percentile(0.99)},
        {.name = "100 clients at 1 Hz, mount moving: errors", .value = double(measured.errors + moving.errors)},
    };
}

Result<Figures> connectStorm(const Server& server, std::chrono::seconds /*duration*/)
{
    Measurement measured = connectAtOnce(server.endpoint(), kClientsAtOnce);
    return Figures{
        {.name = "100 connects back to back: all answered [ms]", .value = measured.percentile(1.0) / 1000},
        {.name = "100 connects back to back: errors", .value = double(measured.errors)},
    };
}

Result<Figures> idleClients(const Server& server, std::chrono::seconds duration)
{
    auto active = Clients::connect(server.endpoint(), 1, getPosition());
    if (!active) {
        return tl::unexpected(active.error());
    }
    Measurement alone = active->closedLoop(duration);
    const auto before = server.residentBytes();
    auto idle = Clients::connect(server.endpoint(), kIdleClients, getPosition());
    if (!idle) {
        return tl::unexpected(idle.error());
    }
    const auto after = server.residentBytes();
    Measurement among = active->closedLoop(duration);
    const double each = before && after ? (double(*after) - double(*before)) / 1000 / kIdleClients : std::nan("");
    return Figures{
        {.name = "1 client alone: requests/s", .value = alone.perSecond(), .better = Better::Higher},
        {.name = "1 client beside 500 idle: requests/s", .value = among.perSecond(), .better = Better::Higher},
        {.name = "memory of an idle client [kB]", .value = each},
    };
}

Result<Figures> shortConnections(const Server& server, std::chrono::seconds duration)
{
    Measurement measured = connectionPerRequest(server.endpoint(), duration);
    return Figures{
        {.name = "a connection per request: requests/s", .value = measured.perSecond(), .better = Better::Higher},
        {.name = "a connection per request: p99 [µs]", .value = measured.percentile(0.99)},
        {.name = "a connection per request: errors", .value = double(measured.errors)},
    };
}

Result<Figures> tracking(const Server& server, std::chrono::seconds duration)
{
    auto client = Clients::connect(server.endpoint(), 1, passRequests());
    if (!client) {
        return tl::unexpected(client.error());
    }
    const auto started = SteadyClock::now();
    const auto before = server.processorTime();
    const Measurement measured = client->paced(500ms, 3 * duration);
    const auto after = server.processorTime();
    const std::chrono::duration<double> elapsed = SteadyClock::now() - started;
    const auto resident = server.residentBytes();
    return Figures{
        {.name = "tracking for one client: CPU [% of a core]",
         .value = before && after ? 100 * (*after - *before) / elapsed : std::nan("")},
        {.name = "tracking for one client: resident memory [MB]",
         .value = resident ? double(*resident) / 1e6 : std::nan("")},
        {.name = "tracking for one client: errors", .value = double(measured.errors)},
    };
}

std::vector<Scenario> scenarios()
{
    const auto loop = [](const char* name, const std::vector<Request>& requests, std::size_t count) -> Scenario {
        return [=](const Server& server, std::chrono::seconds duration) {
            return closedLoop(server, duration, name, requests, count);
        };
    };
    return {loop("get_pos", getPosition(), 10),
            loop("get_pos", getPosition(), 100),
            loop("mixed", mixedRequests(), 10),
            loop("mixed", mixedRequests(), 100),
            pacedClients,
            connectStorm,
            idleClients,
            shortConnections,
            tracking};
}

Result<Figures> measure(const Scenario& scenario, const std::string& target, std::chrono::seconds duration)
{
    const auto server = Server::start(target);
    if (!server) {
        return tl::unexpected(server.error());
    }
    return awaitPosition(server->endpoint()).and_then([&] { return scenario(*server, duration); });
}

}  // namespace

Result<std::vector<Figures>> measureServers(const std::vector<std::string>& targets, std::chrono::seconds duration)
{
    std::vector<Figures> all(targets.size());
    for (const Scenario& scenario : scenarios()) {
        for (std::size_t i = 0; i < targets.size(); ++i) {
            const auto measured = measure(scenario, targets[i], duration);
            if (!measured) {
                return failure(measured.error().code,
                               QStringLiteral("%1 (%2)").arg(measured.error().text, toQString(targets[i])));
            }
            all[i].insert(all[i].end(), measured->begin(), measured->end());
        }
    }
    return all;
}

}  // namespace boresight::bench
