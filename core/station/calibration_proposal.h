// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/calibration_record.h"
#include "core/calibration/pointing_fit.h"
#include "core/profile/profile.h"
#include "core/station/calibration_status.h"

#include <array>
#include <optional>
#include <span>
#include <vector>

// What a calibration would change of a profile, made from what was found. Pure.
namespace boresight {

struct Proposal
{
    std::uint64_t number = 0;
    QString title;
    QString text;
    std::vector<QString> warnings;
    pointing::PointingTerms terms;
    std::array<std::optional<Angle>, calibration::kTerms> sigmas;  // of the terms that were found out
    std::optional<calibration::SensorMounting> sensor;             // if that changes, too
    std::vector<calibration::CalibrationPoint> points;
};

[[nodiscard]] Proposal proposalOf(const calibration::SensorOffset& offset, const profile::Profile& profile);
// Of a place that is not hopeless.
[[nodiscard]] Proposal proposalOf(const SwingOutcome& swing, const profile::Profile& profile);
[[nodiscard]] Proposal proposalOf(const calibration::PointingFit& fit,
                                  std::span<const calibration::CalibrationPoint> points,
                                  const profile::Profile& profile);

// The terms of two models beside each other; sigmas and which are on are left to the caller.
[[nodiscard]] std::vector<TermStatus> termsBeside(const pointing::PointingTerms& present,
                                                  const pointing::PointingTerms& proposed);
// The terms that change, in words: "azimuth offset 0.00° → 37.41°".
[[nodiscard]] QString changeText(const pointing::PointingTerms& before, const pointing::PointingTerms& after);

}  // namespace boresight
