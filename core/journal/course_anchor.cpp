// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/journal/course_anchor.h"

#include "core/base/text.h"
#include "core/journal/place_words.h"

#include <algorithm>

namespace boresight::journal {
namespace {

// The errors of the compass at both ends, twice ±11°, plus what the axis turns during the latency of the last value.
constexpr Angle kWorth = Angle::fromDegrees(30.0);

bool isWithin(Angle place, Angle bySensor)
{
    return abs(place - bySensor) <= kWorth;
}

}  // namespace

std::optional<Angle> placeBySensor(const std::optional<CourseAnchor>& anchor, const std::optional<SensorCourse>& now)
{
    if (!anchor || !now || anchor->course.unbroken != now->unbroken) {
        return std::nullopt;
    }
    return anchor->axis + (now->azimuth - anchor->course.azimuth);
}

void addSensorTurning(TurnQuestion& question, Angle bySensor)
{
    QString sentence = Text::tr("The sensor followed the axis since the cable wrap was known. It shows %1 (± %2).")
                           .arg(inWords(bySensor), inWords(kWorth));
    const bool possible = std::ranges::any_of(question.candidates, [&](Angle one) { return isWithin(one, bySensor); });
    if (question.proposed && !isWithin(*question.proposed, bySensor)) {
        sentence += Text::tr(" This contradicts %1, so Boresight proposes nothing. Look at the cable.")
                        .arg(inWords(*question.proposed));
        question.proposed.reset();
    } else if (question.proposed) {
        sentence += Text::tr(" This agrees with the proposal.");
    } else if (!question.candidates.empty() && !possible) {
        sentence += Text::tr(" None of the possible places is near this angle.");
    }
    question.evidence.insert(question.evidence.empty() ? question.evidence.end() : std::prev(question.evidence.end()),
                             sentence);
}

}  // namespace boresight::journal
