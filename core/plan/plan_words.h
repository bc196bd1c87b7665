// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/plan/pass_plan.h"

#include <QString>

// A plan in words for people. Any thread.
namespace boresight::plan {

// "Over the top"
[[nodiscard]] QString titleOf(PlanWay way);

// The largest error to expect, with the loss for the beam width: "0.10° (−0.1 dB)", "5.30° (beyond the beam)".
[[nodiscard]] QString errorText(const Forecast& forecast);

// Direct, with an error that costs less than 0.1 dB: there is nothing to report.
[[nodiscard]] bool isPlain(const PlanVariant& variant);

// "Over the top, off by up to 0.10° (−0.0 dB)", "Unwraps in the pass, off target for 37 s".
[[nodiscard]] QString summaryText(const PlanVariant& variant);

// What the mount does during the pass, for the log: one or two sentences without the last full stop. Empty: it follows
// the target all the time, upright.
[[nodiscard]] QString planText(const PlanVariant& variant, const QString& target);

// The target is lost while the mount unwraps, or while it waits at the end of the cable: "The mount unwraps from
// 12:30:10Z to 12:31:02Z." Empty if the plan has a wrap for the whole pass.
[[nodiscard]] QString splitText(const PlanVariant& variant);

}  // namespace boresight::plan
