// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/gs232_mount/offset_question.h"

#include <utility>

namespace boresight::gs232 {
namespace {

bool isCalibrated(const esp32::Digits& digits)
{
    constexpr int kBest = 3;
    return digits.system == kBest && digits.gyroscope == kBest && digits.accelerometer == kBest &&
           digits.magnetometer == kBest && !digits.blocks;
}

}  // namespace

void OffsetQuestion::askAgain()
{
    m_wanted = true;
    m_lines.forget();
    m_doubtful.reset();
}

bool OffsetQuestion::wants(const std::optional<esp32::Digits>& digits, SteadyTime now) const
{
    const bool isTried = m_asked && now - *m_asked < kBetweenAsks;
    return m_wanted && !isTried && !m_doubtful && digits && isCalibrated(*digits);
}

void OffsetQuestion::asked(SteadyTime now)
{
    m_asked = now;
    m_lines.forget();
}

// The first and the last line of the answer are for people.
bool OffsetQuestion::take(std::string_view line, SteadyTime now)
{
    if (!m_lines.take(line)) {
        return m_asked && now - *m_asked < kAnswerTime && line.starts_with("---");
    }
    if (const auto offsets = m_lines.offsets()) {
        m_doubtful = offsets;
        m_lines.forget();
    }
    return true;
}

void OffsetQuestion::take(const esp32::Digits& digits)
{
    const auto offsets = std::exchange(m_doubtful, std::nullopt);
    if (offsets && isCalibrated(digits)) {
        m_known = offsets;
        m_wanted = false;
    }
}

}  // namespace boresight::gs232
