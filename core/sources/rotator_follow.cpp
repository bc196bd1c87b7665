// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/sources/rotator_follow.h"

#include "core/alarms/catalogue.h"
#include "core/base/text.h"
#include "core/units/angle_between.h"
#include "core/units/degrees_text.h"

#include <utility>

namespace boresight::sources {
namespace {

// A position that is farther away than kFarthestJump after a gap of kSilentGap ends the tracking. It may come from a
// program that has just started, or from another rotator.
constexpr Seconds kSilentGap{1.0};
constexpr Angle kFarthestJump = Angle::fromDegrees(10.0);

const Source& rotatorSource()
{
    static const Source source{.kind = SourceKind::Operator, .name = QStringLiteral("rotctld")};
    return source;
}

}  // namespace

Result<> RotatorFollow::receive(const SourceReport& report)
{
    const auto* const read = std::get_if<RotatorReport>(&report);
    return read ? takeReport(*read) : Result<>{};
}

Result<> RotatorFollow::takeReport(const RotatorReport& report)
{
    const SteadyTime now = helm().now();
    if (!m_followed || m_followed->last.name != report.name) {
        m_found = report.direction ? std::optional(Reading{report.name, *report.direction, now}) : std::nullopt;
        return failure(ErrorCode::NotAvailable, Text::tr("the mount does not follow %1").arg(report.name));
    }
    if (!report.direction) {
        m_followed->trouble = report.direction.error().text;
        return {};
    }
    const Angle away = angleBetween(m_followed->last.direction, *report.direction);
    if (now - m_followed->last.when > kSilentGap && away > kFarthestJump) {
        m_followed->trouble = Text::tr("the new position is %1 from the last position").arg(degreesText(away, 1));
        return {};
    }
    m_followed->last = {report.name, *report.direction, now};
    m_followed->isNew = true;
    return {};
}

Result<> RotatorFollow::ask(const request::FollowRotator& wanted, const Source& by)
{
    return operatorOnly(by).and_then([&] { return helm().mayPoint(by); }).and_then([&]() -> Result<> {
        const SteadyTime now = helm().now();
        if (!m_found || m_found->name != wanted.name || now - m_found->when > kStale) {
            return failure(ErrorCode::NoAnswer, Text::tr("No position of %1 was received").arg(wanted.name));
        }
        const auto before = std::exchange(m_followed, Followed{.last = *m_found});
        Result<> driven = follow(true);
        if (driven) {
            m_found.reset();
            m_followed->motionId = helm().current().motionId();
            helm().clearAlarm(alarmEntry("followed.ended"));
            return driven;
        }
        m_followed = before;
        if (m_followed) {
            end(Text::tr("another rotator was requested, and refused"));
        }
        return driven;
    });
}

void RotatorFollow::step(SteadyTime now)
{
    if (!m_followed) {
        return;
    }
    const CurrentMotion& current = helm().current();
    if (!current.isFor(rotatorSource()) || !current.is(Activity::Streaming)) {
        m_followed.reset();  // the tracking was ended, or another source moves the mount
        return;
    }
    if (current.motionId() != m_followed->motionId) {
        m_followed.reset();
        helm().end(Severity::Advisory, Text::tr("ends the tracking, because control was given away"));
        return;
    }
    if (const QString why = whyToEnd(now); !why.isEmpty()) {
        end(why);
    } else if (m_followed->isNew) {
        if (const Result<> driven = follow(false); !driven) {
            end(driven.error().text);
        }
    }
}

QString RotatorFollow::whyToEnd(SteadyTime now) const
{
    const bool isSilent = now - m_followed->last.when > kStale;
    return isSilent && m_followed->trouble.isEmpty()
               ? Text::tr("no position was received for %1 s").arg(kStale.count(), 0, 'f', 0)
               : m_followed->trouble;
}

Result<> RotatorFollow::follow(bool anew)
{
    m_followed->isNew = false;
    return helm().streamTo(m_followed->last.direction, rotatorSource(),
                           Text::tr("follow %1").arg(m_followed->last.name), anew);
}

void RotatorFollow::end(const QString& why)
{
    m_followed.reset();
    helm().end(Severity::Warning, Text::tr("ends the tracking: %1").arg(why));
    helm().raiseAlarm(alarmEntry("followed.ended"), {why});
}

void RotatorFollow::describe(StationStatus& status) const
{
    if (m_followed) {
        status.tracked = TrackedTarget{.name = m_followed->last.name, .isUp = true};
    }
}

}  // namespace boresight::sources
