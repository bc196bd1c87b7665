// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/sources/rotator_follow.h"

#include "core/alarms/catalogue.h"
#include "core/base/text.h"

namespace boresight::sources {
namespace {

const Source& rotatorSource()
{
    static const Source source{.kind = SourceKind::Operator, .name = QStringLiteral("rotctld")};
    return source;
}

}  // namespace

Result<> RotatorFollow::receive(const SourceReport& report)
{
    const auto* const read = std::get_if<RotatorReading>(&report);
    if (!read) {
        return {};
    }
    m_reading = Reading{.read = *read, .when = helm().now()};
    return m_followed && m_followed->name == read->name
               ? Result<>{}
               : failure(ErrorCode::NotAvailable, Text::tr("the mount does not follow %1").arg(read->name));
}

Result<> RotatorFollow::ask(const request::FollowRotator& wanted, const Source& by)
{
    return operatorOnly(by).and_then([&] { return helm().mayPoint(by); }).and_then([&]() -> Result<> {
        const SteadyTime now = helm().now();
        if (!m_reading || m_reading->read.name != wanted.name || now - m_reading->when > kStale) {
            return failure(ErrorCode::NoAnswer, Text::tr("No position of %1 was received").arg(wanted.name));
        }
        m_followed = Followed{.name = wanted.name};
        Result<> driven = follow(true);
        if (driven) {
            m_followed->errand = helm().current().errand();
            helm().clearAlarm(alarmEntry("followed.ended"));
        } else {
            m_followed.reset();
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
        m_followed.reset();  // somebody has ended it, or moves the mount
        return;
    }
    if (current.errand() != m_followed->errand) {
        m_followed.reset();
        helm().end(Severity::Advisory, Text::tr("ends the tracking, because control was given away"));
        return;
    }
    if (now - m_reading->when > kStale) {
        end(Text::tr("no position was received for %1 s").arg(kStale.count(), 0, 'f', 0));
        return;
    }
    if (m_reading->when != m_followed->reached) {
        if (const Result<> driven = follow(false); !driven) {
            end(driven.error().text);
        }
    }
}

Result<> RotatorFollow::follow(bool anew)
{
    m_followed->reached = m_reading->when;
    return helm().streamTo(m_reading->read.direction, rotatorSource(), Text::tr("follow %1").arg(m_followed->name),
                           anew);
}

void RotatorFollow::end(const QString& why)
{
    const QString name = m_followed->name;
    m_followed.reset();
    helm().end(Severity::Warning, Text::tr("ends the tracking: %1").arg(why));
    helm().raiseAlarm(alarmEntry("followed.ended"), {name, why});
}

void RotatorFollow::describe(StationStatus& status) const
{
    if (m_followed) {
        status.tracked = TrackedTarget{.name = m_followed->name, .isUp = true};
    }
}

}  // namespace boresight::sources
