// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/moteus/exercise.h"

#include "core/moteus/codec.h"
#include "core/moteus/describe.h"
#include "core/moteus/diagnostic.h"
#include "core/moteus/frame_server.h"
#include "tests/core/moteus/recording_device.h"

#include <algorithm>
#include <cstdlib>
#include <iostream>

namespace boresight::moteus {
namespace {

void require(bool holds, const char* promise, const CanFrame& frame)
{
    if (!holds) {
        std::cerr << "broken: " << promise << ": " << toString(frame) << '\n';
        std::abort();
    }
}

// Only the shortest form of a number is ever written. A frame with a longer form can be read, but differs.
void exerciseSubframes(const CanFrame& frame)
{
    SubframeReader reader(frame.payload());
    SubframeWriter writer;
    while (const auto subframe = reader.next()) {
        writer.append(*subframe);
    }
    if (reader.end() != ParseEnd::Complete) {
        return;
    }
    require(writer.needed() <= frame.size, "writing back never needs more bytes than were read", frame);
    if (writer.needed() == frame.size) {
        require(std::ranges::equal(writer.bytes(), frame.payload()), "what was read writes back", frame);
    }
}

void exerciseServer(const CanFrame& frame)
{
    RecordingDevice device;
    device.text = "a line of the console that is longer than one packet can be\r\nOK\r\n";
    FrameServer server;
    CanFrame addressed = frame;
    addressed.id |= 0x8000;
    const auto destination = static_cast<std::uint8_t>(addressed.id & 0xff);
    const auto prefix = static_cast<std::uint16_t>(addressed.id >> 16 & kMaxPrefix);
    for (int repeat = 0; repeat < 3; ++repeat) {
        const auto reply = server.serve(addressed, {.id = destination, .prefix = prefix}, device);
        require(!device.ends.empty(), "an addressed frame is completed", frame);
        if (reply) {
            require(reply->size == legalCanLength(reply->size), "a reply has a legal length", frame);
            require(decodeReply(*reply).has_value(), "a reply can be decoded", frame);
        }
    }
}

void exerciseConsole(const Reply& reply)
{
    DiagnosticClient client({.destination = reply.source,
                             .prefix = reply.prefix,
                             .source = reply.destination,
                             .maxSilences = 2,
                             .maxEmptyAnswers = 2});
    static_cast<void>(client.start("conf enumerate"));
    for (int turn = 0; turn < 8 && !client.isFinished(); ++turn) {
        if (client.nextFrame()) {
            client.handleReply(reply);
        }
        client.handleSilence();
    }
    static_cast<void>(client.takeAnswer());
}

}  // namespace

CanFrame frameFromBytes(std::span<const std::uint8_t> bytes)
{
    CanFrame frame;
    const std::size_t idSize = std::min<std::size_t>(4, bytes.size());
    for (const std::uint8_t byte : bytes.first(idSize)) {
        frame.id = (frame.id << 8 | byte) & 0x1fffffff;
    }
    const auto payload = bytes.subspan(idSize);
    frame.extended = frame.id > kMaxStandardId;
    frame.setPayload(payload.first(std::min(payload.size(), kMaxCanPayload)));
    return frame;
}

void exercise(const CanFrame& frame)
{
    exerciseSubframes(frame);
    exerciseServer(frame);
    require(!describe(frame).empty(), "every frame has words", frame);
    if (const auto reply = decodeReply(frame)) {
        static_cast<void>(reply->mode());
        static_cast<void>(reply->fault());
        static_cast<void>(reply->homeState());
        static_cast<void>(reply->uuid());
        exerciseConsole(*reply);
    }
}

}  // namespace boresight::moteus
