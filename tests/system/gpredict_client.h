// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "tests/fakes/tcp_peer.h"
#include "tests/system/satellite_pass.h"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

// Gpredict's antenna control, byte for byte and with its timing, as recorded from Debian's version 2.3. It sends `p`
// 0.1 s after a reply to `P` or after the start of a cycle, and the next cycle starts 0.7 s later. A target is due when
// the satellite and the last position reading differ by more than the threshold. The target is then the point where the
// satellite will leave the threshold. Each reply is received with one recv of at most 128 bytes.
namespace boresight::system_test {

class GpredictClient
{
public:
    static constexpr Angle kThreshold = Angle::fromDegrees(0.1);

    // A pass in which the satellite rises and sets at this time before and after 0 s.
    struct Pass
    {
        std::function<SatellitePass::Look(Seconds)> at;
        Seconds halfDuration{};
    };

    // The pass outlives this.
    GpredictClient(std::unique_ptr<fakes::TcpPeer> peer, const SatellitePass& pass, Angle threshold = kThreshold);
    GpredictClient(std::unique_ptr<fakes::TcpPeer> peer, Pass pass, Angle threshold);

    // Sends what is due. The time is that of the pass.
    void tick(Seconds now);
    void disengage();  // sends S, then q
    void setThreshold(Angle threshold) { m_threshold = threshold; }

    [[nodiscard]] int exchanges() const { return m_exchanges; }
    [[nodiscard]] const std::vector<std::string>& complaints() const { return m_complaints; }
    [[nodiscard]] std::size_t longestReply() const { return m_longestReply; }

private:
    void decide(Seconds now);
    [[nodiscard]] bool apart(const SatellitePass::Look& one, const SatellitePass::Look& other) const;
    [[nodiscard]] SatellitePass::Look leading(Seconds now) const;
    void sendTarget();
    void readPosition();
    std::string exchange(const std::string& command, int lines);

    std::unique_ptr<fakes::TcpPeer> m_peer;
    Pass m_pass;
    Angle m_threshold;
    std::optional<SatellitePass::Look> m_due;
    std::optional<SatellitePass::Look> m_read;
    std::optional<Seconds> m_nextDecision;
    std::optional<Seconds> m_nextTarget;
    std::optional<Seconds> m_nextRead;
    int m_exchanges = 0;
    std::size_t m_longestReply = 0;
    std::vector<std::string> m_complaints;
};

}  // namespace boresight::system_test
