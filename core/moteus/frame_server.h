// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/can_frame.h"
#include "core/moteus/arbitration.h"
#include "core/moteus/subframes.h"

#include <cstdint>
#include <map>
#include <optional>
#include <span>

// The drive side of an exchange. Reads a request and builds the one reply by the rules of the real frame server: which
// blocks are answered, errors, the 41-byte rule, UUID masks, the diagnostic tunnel with flow control. The ServedDevice
// gives the registers their meaning. Used by the simulated drives and by tests. No I/O, no clock.
namespace boresight::moteus {

// The device behind a FrameServer. Values are in physical units. Access and format were checked against the register
// map before.
class ServedDevice
{
public:
    virtual ~ServedDevice() = default;

    // Only readable registers. Identity registers are signed 32-bit numbers. NaN is "unset".
    [[nodiscard]] virtual double readRegister(Register reg) = 0;
    // Only writable registers, and not the UUID mask. Returns 0, or the error code for the reply. Before
    // completeFrame() a write must not change what is read, except in the command registers 0x020..0x048.
    [[nodiscard]] virtual std::uint32_t writeRegister(Register reg, double value) = 0;
    // The frame was read and its reply is built. Discarded: a UUID mask did not match, so its writes must have no
    // effect.
    enum class FrameEnd
    {
        Accepted,
        Discarded,
    };
    virtual void completeFrame(FrameEnd end) = 0;

    [[nodiscard]] virtual bool hasChannel(std::uint32_t channel) = 0;
    virtual void receiveText(std::uint32_t channel, std::span<const std::uint8_t> text) = 0;
    // pendingText(): the text that waits for the host. dropText(): drops its first `count` bytes. The span stays valid
    // until then.
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
    // Empty if the frame is not for this device, wants no reply, or was discarded. A reply frame may be empty.
    [[nodiscard]] std::optional<CanFrame> serve(const CanFrame& request, DeviceAddress address, ServedDevice& device);

private:
    // State of the tunnel with flow control: the number of the last packet, and how much pending text that packet
    // contains.
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

    std::map<std::uint32_t, Flow> m_flows;  // only channels that the device has
};

}  // namespace boresight::moteus
