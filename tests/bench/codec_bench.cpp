// SPDX-License-Identifier: GPL-3.0-or-later
//
// The speed of the moteus codec with the two frames of every control tick: a position command with limits and watchdog
// time together with the rotator's query, and the reply to it. A tick needs two of each. The default is 50 ticks a
// second.

#include "core/moteus/codec.h"

#include <benchmark/benchmark.h>

namespace {

using namespace boresight;
using namespace boresight::moteus;

Request tickRequest()
{
    PositionCommand command;
    command.position = Field(0.2537);
    command.velocity = Field(0.0112);
    command.maximumTorque = Field(1.5);
    command.watchdogTimeout = Field(0.1);
    command.velocityLimit = Field(0.2);
    command.accelerationLimit = Field(0.5);
    Request request;
    request.command = command;
    request.query = rotatorQuery();
    return request;
}

CanFrame replyToTick()
{
    std::vector<RegisterValue> values;
    for (const RegisterRead& read : rotatorQuery()) {
        values.push_back({.reg = read.reg, .resolution = read.resolution, .value = 1.0});
    }
    SubframeWriter writer;
    writer.appendReplies(values);
    return makeFrame({.source = 1, .destination = kHostId}, writer.bytes());
}

void encodeTick(benchmark::State& state)
{
    const Request request = tickRequest();
    for (auto step : state) {
        auto frame = encode(request);
        if (!frame) {
            state.SkipWithError("the request was refused");
            break;
        }
        benchmark::DoNotOptimize(frame);
    }
    state.SetItemsProcessed(state.iterations());
}
BENCHMARK(encodeTick);

void decodeTick(benchmark::State& state)
{
    const CanFrame frame = replyToTick();
    for (auto step : state) {
        auto reply = decodeReply(frame);
        if (!reply || reply->values.size() != rotatorQuery().size()) {
            state.SkipWithError("the reply was not read in full");
            break;
        }
        benchmark::DoNotOptimize(reply);
    }
    state.SetItemsProcessed(state.iterations());
}
BENCHMARK(decodeTick);

}  // namespace
