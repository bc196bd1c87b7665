// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/replay/replay_player.h"

#include <algorithm>

namespace boresight::ui {

namespace {

constexpr std::chrono::milliseconds kPicturePeriod{50};

}  // namespace

ReplayPlayer::ReplayPlayer(const Clock& clock, UtcTime begin, UtcTime end, QObject* parent)
    : QObject(parent), m_clock(clock), m_begin(begin), m_end(end), m_moment(begin)
{
    m_timer.setInterval(kPicturePeriod);
    connect(&m_timer, &QTimer::timeout, this, &ReplayPlayer::advance);
}

void ReplayPlayer::play(bool on)
{
    if (on == isPlaying()) {
        return;
    }
    if (on) {
        if (m_moment >= m_end) {
            jumpTo(m_begin);
        }
        m_advanced = m_clock.now();
        m_timer.start();
    } else {
        m_timer.stop();
    }
    Q_EMIT changed();
}

void ReplayPlayer::jumpTo(UtcTime moment)
{
    m_moment = std::clamp(moment, m_begin, m_end);
    Q_EMIT moved();
}

void ReplayPlayer::advance()
{
    const SteadyTime now = m_clock.now();
    const auto passed = std::chrono::duration_cast<UtcTime::duration>(now - m_advanced);
    m_advanced = now;
    jumpTo(m_moment + passed * m_speed);
    if (m_moment >= m_end) {
        play(false);
    }
}

void ReplayPlayer::setSpeed(int speed)
{
    m_speed = speed;
    Q_EMIT changed();
}

void ReplayPlayer::changeSpeed(int steps)
{
    const auto* const now = std::ranges::find(kSpeeds, m_speed);
    const auto last = static_cast<int>(kSpeeds.size()) - 1;
    setSpeed(kSpeeds[static_cast<std::size_t>(std::clamp(static_cast<int>(now - kSpeeds.begin()) + steps, 0, last))]);
}

}  // namespace boresight::ui

#include "moc_replay_player.cpp"
