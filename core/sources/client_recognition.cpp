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
// A client whose point stands at the horizon for this time waits for a rise.
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
    if (m_newest && m_newest->direction == point.direction) {
        return;  // repeated
    }
    if (waitsForRise(now)) {
        m_points.clear();  // where the client has waited is no place of a motion
    }
    m_newest = point;
    m_came = now;
    m_triedRise.reset();
    const auto unit = recognise::unitOf(point.direction);
    if (!m_points.empty() &&
        recognise::angleBetween(recognise::unitOf(m_points.back().direction), unit) < kPointsApart) {
        return;
    }
    m_points.push_back(point);
    if (m_points.size() > kMostPoints) {
        m_points.erase(m_points.begin());
    }
    m_isNew = true;
}

bool ClientRecognition::waitsForRise(SteadyTime now) const
{
    return m_newest && recognise::waitsAtHorizon({*m_newest}) && now - m_came >= kWaits;
}

bool ClientRecognition::hasNewMotion() const
{
    return m_isNew && recognise::showsMotion(m_points);
}

bool ClientRecognition::isMotionDue(SteadyTime now) const
{
    const std::chrono::seconds pause(1 << std::min(m_tries, kMostDoublings));
    return hasNewMotion() && (m_tries == 0 || now - m_tried >= pause);
}

// Points that move along a target need no other explanation.
bool ClientRecognition::isRiseDue(SteadyTime now) const
{
    const bool isExplained = hasNewMotion() || (m_found.isMoving && !m_found.fits.empty());
    return waitsForRise(now) && !isExplained && (!m_triedRise || now - *m_triedRise >= kRisesAgain);
}

void ClientRecognition::step(const recognise::Sky& sky, SteadyTime now)
{
    if (m_future.isValid()) {
        return;
    }
    if (isMotionDue(now)) {
        m_tried = now;
        ++m_tries;
        m_isNew = false;
        compute(m_points, sky);
    } else if (isRiseDue(now)) {
        m_triedRise = now;
        recognise::SentPoint still = *m_newest;  // the client still waits there
        still.utc += std::chrono::duration_cast<UtcTime::duration>(now - m_came);
        compute({still}, sky);
    }
}

// The work owns its promise and its copies, so it can end safely after this was deleted.
void ClientRecognition::compute(const recognise::SentPoints& points, const recognise::Sky& sky)
{
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
