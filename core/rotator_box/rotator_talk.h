// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/base/result.h"
#include "core/units/sky.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

// The conversation with a rotator that answers lines of text: decides when to send what, and which bytes are an answer.
// Each protocol has its own. Before the other end has proved to be such a rotator, only questions are sent. No I/O:
// time and bytes are passed in.
namespace boresight {

class RotatorTalk
{
public:
    enum class Proof
    {
        Unknown,  // it has not answered yet
        Box,
        Foreign  // another kind of device: nothing more is sent
    };
    struct Places
    {
        std::optional<Angle> azimuth;  // as the rotator counts: 370° is not 10°
        std::optional<Angle> elevation;
    };
    struct Counts
    {
        std::uint64_t sent = 0;
        std::uint64_t received = 0;  // answers
        std::uint64_t unknown = 0;   // lines without a meaning
    };

    virtual ~RotatorTalk() = default;

    // The line was opened again, perhaps to another device, which must prove itself again.
    virtual void restart() = 0;
    virtual void take(std::string_view bytes, SteadyTime now) = 0;
    // The newest positions since the last call. They contain what was asked for.
    [[nodiscard]] virtual std::optional<Places> takePlaces() = 0;
    // Sends a stop as soon as the device is proved, without another wait.
    virtual void stop() = 0;
    // The bytes to send now. Once per tick.
    [[nodiscard]] virtual std::string send(SteadyTime now) = 0;

    // Success if the operator may send this line to such a device, otherwise the reason.
    [[nodiscard]] virtual Result<> mayType(std::string_view line) const;
    // The bytes of a typed line. Then nothing else but a stop is sent during `pause`. Empty: not now, call it again.
    [[nodiscard]] virtual std::string type(std::string_view /*line*/, SteadyTime::duration /*pause*/,
                                           SteadyTime /*now*/)
    {
        return {};
    }
    [[nodiscard]] virtual bool takesLines() const { return false; }

    // Whether this protocol has a command by which the rotator drives to its own switches.
    [[nodiscard]] virtual bool makesHomeRuns() const { return false; }
    // Sends that command when everything else is answered. A stop drops it.
    virtual void home() {}
    // The answer to it, once: success, or why the rotator refuses.
    [[nodiscard]] virtual std::optional<Result<>> takeHomeAnswer() { return std::nullopt; }

    // The line must be closed and opened again, because answers do not fit the questions any more, or none come.
    [[nodiscard]] virtual bool wantsAnotherLine() const { return false; }

    [[nodiscard]] virtual Proof proof() const = 0;
    [[nodiscard]] virtual const Counts& counts() const = 0;
    // The last text that was received in place of an answer, printable.
    [[nodiscard]] virtual const std::string& strange() const = 0;

protected:
    RotatorTalk() = default;
    RotatorTalk(const RotatorTalk&) = default;
    RotatorTalk& operator=(const RotatorTalk&) = default;
};

}  // namespace boresight
