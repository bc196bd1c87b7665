// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/sources/step.h"

#include "core/base/numbers.h"
#include "core/base/text.h"

namespace boresight::sources {
namespace {

// A trim corrects a pointing error. A larger offset would be another target.
constexpr Angle kLargestTrim = Angle::fromDegrees(10.0);

}  // namespace

Result<> Step::ask(const request::Step& wanted, const Source& by)
{
    const AxisPosition from = helm().heading();
    const AxisPosition place{.azimuth = from.azimuth + wanted.azimuth, .elevation = from.elevation + wanted.elevation};
    const std::uint64_t motionId = helm().current().motionId();
    return helm().goTo(place, Activity::Pointing, by, Text::tr("step to %1").arg(helm().directionText(place))).map([&] {
        helm().keepMotionId(motionId);  // a step is a motion by hand, like a jog
    });
}

Result<> Step::ask(const request::Nudge& wanted, const Source& by)
{
    if (!helm().current().is(Activity::Streaming) || by.kind != SourceKind::Operator) {
        return ask(request::Step{.azimuth = wanted.azimuth, .elevation = wanted.elevation}, by);
    }
    const AxisPosition before = helm().view().motion.trim();
    const AxisPosition trim{.azimuth = before.azimuth + wanted.azimuth,
                            .elevation = before.elevation + wanted.elevation};
    if (!(abs(trim.azimuth) <= kLargestTrim && abs(trim.elevation) <= kLargestTrim)) {
        return failure(ErrorCode::OutOfRange,
                       Text::tr("A trim can be at most %1°.").arg(toQString(formatFixed(kLargestTrim.degrees(), 0))));
    }
    helm().setTrim(trim, by);
    return {};
}

}  // namespace boresight::sources
