// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/drive_check/heartbeat.h"

#include "core/moteus/diagnostic.h"
#include "core/moteus/scaling.h"

#include <cstdlib>

namespace boresight::drive_check {
namespace {

using namespace std::chrono_literals;
using moteus::Register;

constexpr std::uint32_t kCounterAtBoot = 0x80000000u - 300000u;
constexpr auto kPeriod = 1s;
constexpr auto kAgain = 100ms;
// The clocks of computer and drive differ by up to a few percent. A late answer counts as the answer to a later query.
constexpr std::int64_t kToleranceMs = 1000;
constexpr std::int64_t kDriftPart = 50;  // one part in 50, which is 2 %

std::optional<std::chrono::milliseconds> uptimeIn(const moteus::Reply& reply)
{
    const std::optional<double> counter = reply.value(Register::MillisecondCounter);
    if (!counter) {
        return std::nullopt;
    }
    const std::uint32_t bits = moteus::toWire(*counter, moteus::Kind::Counter, moteus::Resolution::Int32);
    return std::chrono::milliseconds(bits - kCounterAtBoot);
}

}  // namespace

// True if the drive has been on for longer than the elapsed time, whatever the error of its clock. A drive whose
// counter overflowed a short time ago seems to have been on only since then.
bool Heartbeat::wasOn(std::int64_t elapsed, const Observation& after)
{
    return after.uptime.count() > elapsed + elapsed / kDriftPart + kToleranceMs;
}

// True if the counter advanced by the elapsed time, in the arithmetic of the counter. After a long time (a suspended
// computer, a lost bus) a drive that was power-cycled may have counted that much by chance.
bool Heartbeat::wentOn(const Observation& before, const Observation& after)
{
    const std::int64_t elapsed = std::chrono::duration_cast<std::chrono::milliseconds>(after.at - before.at).count();
    const auto counted =
        static_cast<std::uint32_t>(after.uptime.count()) - static_cast<std::uint32_t>(before.uptime.count());
    const auto excess = static_cast<std::int32_t>(counted - static_cast<std::uint32_t>(elapsed));
    const std::int64_t drift = elapsed / kDriftPart;
    const bool isLong = drift > kToleranceMs;
    return std::abs(std::int64_t{excess}) <= kToleranceMs + drift && (!isLong || wasOn(elapsed, after));
}

void Heartbeat::begin(const moteus::Uuid& board)
{
    m_board = board;
    m_sent.reset();
    m_doubted.reset();
    m_silences = 0;
}

std::optional<CanFrame> Heartbeat::frame(SteadyTime now)
{
    if (m_sent && now - *m_sent < (isAnswered() ? SteadyTime::duration(kPeriod) : kAgain)) {
        return std::nullopt;
    }
    const Result<CanFrame> frame =
        moteus::encode({.destination = static_cast<std::uint8_t>(m_drive),
                        .source = moteus::kDiagnosticHostId,
                        .query = {{Register::MillisecondCounter, moteus::Resolution::Int32}}});
    if (!frame) {
        return std::nullopt;
    }
    m_sent = now;
    ++m_silences;
    return *frame;
}

void Heartbeat::take(const moteus::Reply& reply)
{
    const auto uptime = uptimeIn(reply);
    if (m_silences == 0 || reply.source != m_drive || !uptime) {
        return;
    }
    const Observation now{.board = m_board, .uptime = *uptime, .at = *m_sent};
    const bool same = m_last && m_last->board == m_board;
    const bool running = same && wentOn(*m_last, now);
    // One old reply may arrive twice.
    const bool confirmed = m_doubted && m_doubted->uptime != now.uptime && wentOn(*m_doubted, now);
    if (same && !running && !confirmed) {
        m_doubted = now;  // counts as no answer, so that the query is repeated soon
        return;
    }
    m_doubted.reset();
    m_silences = 0;
    if (!running) {
        m_bootedAt = *m_sent - *uptime;
    }
    m_reboots += same && !running ? 1 : 0;
    m_last = now;
}

}  // namespace boresight::drive_check
