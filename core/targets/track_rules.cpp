// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/targets/track_rules.h"

#include "core/base/text.h"
#include "core/base/time_of_day.h"
#include "core/elements/julian_date.h"
#include "core/units/duration_text.h"

#include <cmath>
#include <variant>

namespace boresight::targets {

namespace {

using Days = std::chrono::duration<double, std::chrono::days::period>;

double ageInDays(const orbit::ElementSet& elements, UtcTime now)
{
    return std::abs(Days(now - orbit::utcTime(elements.epoch)).count());
}

}  // namespace

Result<> hasSite(const Target& target, bool isSiteKnown)
{
    return isSiteKnown || !needsSite(target)
               ? Result<>{}
               : failure(ErrorCode::Refused, Text::tr("The site of the mount is not set. Enter it in the profile."));
}

Result<> isFresh(const Target& target, UtcTime now, double oldestDays)
{
    const auto* const elements = std::get_if<orbit::ElementSet>(&target.kind);
    return !elements || isFresh(*elements, now, oldestDays)
               ? Result<>{}
               : failure(ErrorCode::Refused,
                         Text::tr("The elements of %1 are %2 days old. The setting oldest_days permits "
                                  "%3. Load newer elements.")
                             .arg(target.name)
                             .arg(ageInDays(*elements, now), 0, 'f', 1)
                             .arg(oldestDays, 0, 'f', 0));
}

bool isFresh(const orbit::ElementSet& elements, UtcTime now, double oldestDays)
{
    return ageInDays(elements, now) <= oldestDays;
}

Result<> isSoon(const QString& name, UtcTime rises, UtcTime now)
{
    return rises - now <= kLongestWait
               ? Result<>{}
               : failure(ErrorCode::Refused,
                         Text::tr("%1 rises at %2, in %3. Track it in the last %4 minutes before that.")
                             .arg(name, timeOfDayText(rises), durationText(rises - now))
                             .arg(kLongestWait.count()));
}

}  // namespace boresight::targets
