// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/can_frame.h"
#include "core/moteus/arbitration.h"
#include "core/moteus/subframes.h"

#include <cstdint>
#include <map>
#include <optional>
#include <span>

// The drive's side of an exchange: walks a request and builds the one reply, by the rules of the real frame server
// (which blocks are answered, errors, the 41-byte rule, UUID masks, the diagnostic tunnel with flow control). What the
// registers mean is the device's business. Used by the simulated drives and by tests; no I/O, no clock.
namespace boresight::moteus {

// What a FrameServer serves. Registers come in physical units, already checked against the map's access and format.
class ServedDevice
{
public:
    virtual ~ServedDevice() = default;

    // Readable registers only; identity registers as signed 32-bit numbers. NaN is "unset".
    [[nodiscard]] virtual double readRegister(Register reg) = 0;
    // Writable registers only, except the UUID mask. Returns 0, or the error code for the reply. Nothing may take
    // effect on what is read before completeFrame(), except the command registers 0x020..0x048.
    [[nodiscard]] virtual std::uint32_t writeRegister(Register reg, double value) = 0;
    // The frame has been walked and its reply is built. Discarded: a UUID mask did not match, forget its writes.
    enum class FrameEnd
    {
        Accepted,
        Discarded,
    };
    virtual void completeFrame(FrameEnd end) = 0;

    [[nodiscard]] virtual bool hasChannel(std::uint32_t channel) = 0;
    virtual void receiveText(std::uint32_t channel, std::span<const std::uint8_t> text) = 0;
    // Text waiting for the host, and dropping the first `count` bytes of it. The span must stay valid until then.
    [[nodiscard]] virtual std::span<const std::uint8_t> pendingText(std::uint32_t channel) = 0;
    virtual void dropText(std::uint32_t channel, std::size_t count) = 0;

protected:
    ServedDevice() = default;
    ServedDevice(const ServedDevice&) = default;
    ServedDevice& operator=(const ServedDevice&) = default;
};

struct DeviceAddress
{
    std::uint8_t id = 1;
    std::uint16_t prefix = 0;
};

class FrameServer
{
public:
    // Empty: the frame is not for this device, wants no reply, or was discarded. An empty reply frame is an answer.
    [[nodiscard]] std::optional<CanFrame> serve(const CanFrame& request, DeviceAddress address, ServedDevice& device);

private:
    // Of the flow-controlled tunnel: the last packet sent, and how much pending text it holds unacknowledged.
    struct Flow
    {
        std::uint8_t number = 0;
        std::size_t unacknowledged = 0;
    };

    enum class Next
    {
        Continue,
        EndFrame,
        Discard,
    };

    // One request being served.
    struct Exchange
    {
        ServedDevice& device;
        SubframeWriter reply;
        bool replyWanted = false;
    };

    [[nodiscard]] Next serveSubframe(Exchange& exchange, const Subframe& subframe);
    [[nodiscard]] static Next serveWrites(Exchange& exchange, const WriteBlock& block);
    [[nodiscard]] static Next serveReads(Exchange& exchange, const ReadBlock& block);
    [[nodiscard]] Next servePlainText(Exchange& exchange, std::uint32_t channel, std::size_t maximum);
    [[nodiscard]] Next serveFlowPoll(Exchange& exchange, const TunnelPollFlow& poll);

    std::map<std::uint32_t, Flow> m_flows;  // only channels the device has
};

}  // namespace boresight::moteus
