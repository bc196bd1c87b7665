// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/system/gpredict_client.h"

#include <algorithm>
#include <array>
#include <cstdio>

namespace boresight::system_test {
namespace {

constexpr Seconds kDecisionPeriod{0.5};  // the cycle is 1 s, but this version has a doubled timer that halves it
constexpr Seconds kPause{0.7};
constexpr Seconds kBeforeRead{0.1};
constexpr Seconds kFinestLead{0.25};    // a quarter of the cycle
constexpr std::size_t kReadSize = 128;  // Gpredict receives with one recv of this size

}  // namespace

GpredictClient::GpredictClient(std::unique_ptr<fakes::TcpPeer> peer, const SatellitePass& pass, Angle threshold)
    : GpredictClient(std::move(peer),
                     {.at = [&pass](Seconds time) { return pass.at(time); }, .halfDuration = pass.halfDuration()},
                     threshold)
{}

GpredictClient::GpredictClient(std::unique_ptr<fakes::TcpPeer> peer, Pass pass, Angle threshold)
    : m_peer(std::move(peer)), m_pass(std::move(pass)), m_threshold(threshold)
{}

bool GpredictClient::apart(const SatellitePass::Look& one, const SatellitePass::Look& other) const
{
    return abs((one.azimuth - other.azimuth).wrapped180()) > m_threshold ||
           abs(one.elevation - other.elevation) > m_threshold;
}

void GpredictClient::tick(Seconds now)
{
    if (!m_nextRead) {  // just engaged: `p` comes first
        m_nextDecision = now;
        m_nextRead = now + kBeforeRead;
        m_nextTarget = *m_nextRead + kPause;
    }
    if (now >= *m_nextDecision) {
        decide(now);
        *m_nextDecision += kDecisionPeriod;
    }
    if (now >= *m_nextTarget) {
        sendTarget();
        m_nextRead = now + kBeforeRead;
        m_nextTarget = *m_nextRead + kPause;
    } else if (now >= *m_nextRead) {
        readPosition();
        m_nextRead = *m_nextTarget + kBeforeRead;
    }
}

void GpredictClient::decide(Seconds now)
{
    SatellitePass::Look wanted = m_pass.at(now);
    if (wanted.elevation < Angle()) {  // before the rise and after the set: that point of the horizon
        const Seconds edge = now < Seconds(0.0) ? -m_pass.halfDuration : m_pass.halfDuration;
        wanted = {.azimuth = m_pass.at(edge).azimuth, .elevation = Angle()};
    }
    if (m_read && apart(wanted, *m_read)) {
        m_due = wanted.elevation > Angle() ? leading(now) : wanted;
    }
}

// Searches the lead by halving its steps, as Gpredict does, down to kFinestLead.
SatellitePass::Look GpredictClient::leading(Seconds now) const
{
    const Seconds untilSet = m_pass.halfDuration - now;
    Seconds lead = untilSet / 2;
    for (Seconds step = untilSet / 4; step > kFinestLead; step /= 2) {
        lead += apart(m_pass.at(now + lead), m_pass.at(now)) ? -step : step;
    }
    SatellitePass::Look look = m_pass.at(now + lead);
    look.elevation = std::max(look.elevation, Angle());
    return look;
}

void GpredictClient::sendTarget()
{
    if (!m_due) {
        return;
    }
    std::array<char, 40> command{};
    std::snprintf(command.data(), command.size(), "P %.2f %.2f\n", m_due->azimuth.wrapped360().degrees(),
                  m_due->elevation.degrees());
    m_due.reset();
    const std::string reply = exchange(command.data(), 1);
    if (reply != "RPRT 0\n") {
        m_complaints.push_back(std::string(command.data()) + " -> " + reply);
    }
}

void GpredictClient::readPosition()
{
    const std::string reply = exchange("p\n", 2);
    double azimuth = 0.0;
    double elevation = 0.0;
    if (std::sscanf(reply.c_str(), "%lf\n%lf\n", &azimuth, &elevation) != 2) {
        m_complaints.push_back("p -> " + reply);
        return;
    }
    m_read = SatellitePass::Look{.azimuth = Angle::fromDegrees(azimuth), .elevation = Angle::fromDegrees(elevation)};
}

void GpredictClient::disengage()
{
    if (exchange("S\n", 1) != "RPRT 0\n") {
        m_complaints.emplace_back("S");
    }
    m_peer->send("q\n");
    m_peer.reset();
}

std::string GpredictClient::exchange(const std::string& command, int lines)
{
    const std::size_t before = m_peer->segments().size();
    m_peer->send(command);
    const auto whole = [lines](const std::string& bytes) {  // an error is one line for every command
        return std::ranges::count(bytes, '\n') >= (bytes.starts_with("RPRT") ? 1 : lines);
    };
    const std::string reply = m_peer->receive(whole, std::chrono::milliseconds(0), std::chrono::seconds(5));
    ++m_exchanges;
    m_longestReply = std::max(m_longestReply, reply.size());
    if (m_peer->segments().size() != before + 1 || reply.size() >= kReadSize) {
        m_complaints.push_back(command + " was not answered in one piece: " + reply);
    }
    return reply;
}

}  // namespace boresight::system_test
