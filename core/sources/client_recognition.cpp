// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/sources/client_recognition.h"

#include "core/recognise/moving_fit.h"

#include <QPromise>
#include <QThreadPool>

#include <algorithm>
#include <iterator>
#include <memory>

namespace boresight::sources {
namespace {

constexpr std::size_t kMostPoints = 5;
constexpr Angle kPointsApart = 0.1_deg;  // points that are nearer to each other show no rate
// The pause between two computations of moving points is 1 s at first, and doubles up to 8 s.
constexpr int kMostDoublings = 3;
// A client that sends one point and leaves the mount there does not wait for a rise.
constexpr std::chrono::seconds kWaits{3};
constexpr std::chrono::minutes kRisesAgain{1};  // another satellite may rise within the next half hour now

// The newest points that show a motion: the client may have changed its target.
recognise::SentPoints newestOf(const recognise::SentPoints& points)
{
    for (std::size_t count = 2; count < points.size(); ++count) {
        recognise::SentPoints newest(std::prev(points.end(), static_cast<std::ptrdiff_t>(count)), points.end());
        if (recognise::showsMotion(newest)) {
            return newest;
        }
    }
    return points;
}

recognise::Recognition recognised(const recognise::SentPoints& points, const recognise::Sky& sky)
{
    recognise::Recognition found = recognise::recognise(points, sky);
    const recognise::SentPoints newest = newestOf(points);
    return found.fits.empty() && newest != points ? recognise::recognise(newest, sky) : found;
}

}  // namespace

void ClientRecognition::add(const recognise::SentPoint& point, SteadyTime now)
{
    m_seen = now;
    const auto unit = recognise::unitOf(point.direction);
    if (m_points.empty()) {
        m_began = now;
    } else if (recognise::angleBetween(recognise::unitOf(m_points.back().direction), unit) < kPointsApart) {
        return;
    }
    m_points.push_back(point);
    if (m_points.size() > kMostPoints) {
        m_points.erase(m_points.begin());
    }
    m_isNew = true;
}

void ClientRecognition::clear()
{
    *this = {};
}

bool ClientRecognition::isDue(SteadyTime now) const
{
    if (m_points.empty() || m_future.isValid()) {
        return false;
    }
    const bool isMoving = m_points.size() > 1;
    const SteadyTime::duration pause =
        isMoving ? SteadyTime::duration(std::chrono::seconds(1 << std::min(m_tries, kMostDoublings))) : kRisesAgain;
    if (m_tries > 0 && now - m_asked < pause) {
        return false;
    }
    return isMoving ? m_isNew && recognise::showsMotion(m_points) : now - m_began >= kWaits && now - m_seen < kWaits;
}

// The work owns its promise and its copies, so it can end safely after this was deleted.
void ClientRecognition::step(const recognise::Sky& sky, SteadyTime now)
{
    if (!isDue(now)) {
        return;
    }
    m_asked = now;
    ++m_tries;
    m_isNew = false;
    recognise::SentPoints points = m_points;
    if (points.size() == 1) {
        points.front().utc +=
            std::chrono::duration_cast<UtcTime::duration>(now - m_began);  // the client still waits there
    }
    const auto promise = std::make_shared<QPromise<recognise::Recognition>>();
    m_future = promise->future();
    QThreadPool::globalInstance()->start([promise, points, sky] {
        promise->start();
        promise->addResult(recognised(points, sky));
        promise->finish();
    });
}

bool ClientRecognition::hasArrived()
{
    if (!m_future.isValid() || !m_future.isFinished()) {
        return false;
    }
    m_found = m_future.result();
    m_future = {};
    return true;
}

}  // namespace boresight::sources
