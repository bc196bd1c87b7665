// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/plan/pass_plan.h"
#include "ui/plan/pass_planner.h"

#include <QString>

// The plan of a pass, and its variants, in words. Pure.
namespace boresight::ui {

// The loss of the signal at the peak error: "−0.1 dB", ">12 dB" beyond the main lobe.
[[nodiscard]] QString lossText(const plan::Forecast& forecast);
// "0:14", and nothing for less than half a second.
[[nodiscard]] QString spentText(Seconds time);

// The best variant, and the direct way beside it: "Over the top: 0.10° (−0.0 dB). Direct: 5.30° (beyond the beam), 14 s
// off by more than 2.5°." For a pass without anything special, or without a plan, a sentence that says so.
[[nodiscard]] QString planSentence(const PlanAnswer& answer);

// One variant for screen readers: the azimuths, the ramp, the unwrap, the hidden time and the error.
[[nodiscard]] QString describedVariant(const plan::PlanVariant& variant, const TravelRange& azimuths);

}  // namespace boresight::ui
