// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/calibration_record.h"
#include "core/calibration/pointing_fit.h"
#include "core/messages/calibration_status.h"
#include "core/profile/profile.h"

#include <array>
#include <optional>
#include <span>
#include <vector>

// What a calibration would change of a profile, made from what was found. Pure.
namespace boresight {

// Empty: nothing is known of a term.
using TermSigmas = std::array<std::optional<Angle>, calibration::kTerms>;

struct Proposal
{
    std::uint64_t number = 0;
    QString title;
    QString reason;  // where it comes from, in a word or two
    QString text;
    QString remark;  // what it says of the level, a sentence; mostly empty
    std::vector<QString> warnings;
    QString stays;  // which of the terms in force are known better than they were found here; mostly empty
    pointing::PointingTerms terms;
    TermSigmas sigmas;                                  // of the terms that were found out
    std::optional<calibration::SensorMounting> sensor;  // if that changes, too
    std::vector<calibration::CalibrationPoint> points;
};

// `told`: how well points have told the terms in force. What they know better stays as long as it agrees, and the
// sensor is turned to it.
[[nodiscard]] Proposal proposalOf(const calibration::SensorOffset& offset, const profile::Profile& profile,
                                  const TermSigmas& told = {});
// Of a place that is not hopeless.
[[nodiscard]] Proposal proposalOf(const SwingOutcome& swing, const profile::Profile& profile,
                                  const TermSigmas& told = {});
[[nodiscard]] Proposal proposalOf(const calibration::PointingFit& fit,
                                  std::span<const calibration::CalibrationPoint> points,
                                  const profile::Profile& profile, const TermSigmas& told = {});

// Terms as an operator gives them, and where from. Sigmas only where they were told. Nothing else of the profile
// changes.
struct GivenTerms
{
    QString title;
    QString reason;
    pointing::PointingTerms terms;
    TermSigmas sigmas;
    std::vector<QString> warnings;
};
[[nodiscard]] Proposal proposalOf(const GivenTerms& given, const profile::Profile& profile);
// As the profile keeps them. Refused with every term that is out of its range, and the range.
[[nodiscard]] Result<pointing::PointingTerms> asSettings(const pointing::PointingTerms& terms);
// What speaks against terms that were found on the mount of a text.
[[nodiscard]] std::vector<QString> otherMountWarnings(const calibration::TermSheet& sheet,
                                                      const calibration::TermSheet& today);

// The terms of two models beside each other; sigmas and which are on are left to the caller.
[[nodiscard]] std::vector<TermStatus> termsBeside(const pointing::PointingTerms& present,
                                                  const pointing::PointingTerms& proposed);
// The terms that change, in words: "azimuth offset 0.00° → 37.41°"; and that the sensor's mounting or curve does.
[[nodiscard]] QString changeText(const pointing::PointingTerms& before, const pointing::PointingTerms& after,
                                 bool changesSensor = false);

}  // namespace boresight
