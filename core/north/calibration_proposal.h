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

// The changes that a calibration proposes for a profile. Made from the results of a run. Pure.
namespace boresight {

// Empty: nothing is known about this term.
using TermSigmas = std::array<std::optional<Angle>, calibration::kTerms>;

struct Proposal
{
    std::uint64_t number = 0;
    QString title;
    QString reason;  // where it comes from, in one or two words
    QString text;
    QString remark;               // one sentence about the level; usually empty
    std::vector<QString> doubts;  // why the result is unreliable. Only an operator who overrides them can apply it
    std::vector<QString> warnings;
    QString stays;  // which terms in force stay because they are known better than this run found them; usually empty
    pointing::PointingTerms terms;
    TermSigmas sigmas;                                  // of the terms that were found
    std::optional<calibration::SensorMounting> sensor;  // only if the sensor's mounting or curve changes, too
    std::vector<calibration::CalibrationPoint> points;
};

// `told`: the sigmas of the terms in force, if points gave them. A term that points know better stays as long as the
// sensor agrees with it, and the sensor's offset is adapted to the term.
[[nodiscard]] Proposal proposalOf(const calibration::SensorOffset& offset, const profile::Profile& profile,
                                  const TermSigmas& told = {});
// Call it only if the swing found the compass usable.
[[nodiscard]] Proposal proposalOf(const SwingOutcome& swing, const profile::Profile& profile,
                                  const TermSigmas& told = {});
[[nodiscard]] Proposal proposalOf(const calibration::PointingFit& fit,
                                  std::span<const calibration::CalibrationPoint> points,
                                  const profile::Profile& profile, const TermSigmas& told = {});

// Terms as the operator entered them, and their source. Sigmas only where they were entered. Nothing else in the
// profile changes.
struct GivenTerms
{
    QString title;
    QString reason;
    pointing::PointingTerms terms;
    TermSigmas sigmas;
    std::vector<QString> warnings;
};
[[nodiscard]] Proposal proposalOf(const GivenTerms& given, const profile::Profile& profile);
// Rounded as the profile stores them. The refusal names every term that is out of its range, and the range.
[[nodiscard]] Result<pointing::PointingTerms> asSettings(const pointing::PointingTerms& terms);
// Why terms from a text may not fit this mount.
[[nodiscard]] std::vector<QString> otherMountWarnings(const calibration::TermSheet& sheet,
                                                      const calibration::TermSheet& today);

// The terms of two models beside each other. The caller fills in the sigmas and which terms are on.
[[nodiscard]] std::vector<TermStatus> termsBeside(const pointing::PointingTerms& present,
                                                  const pointing::PointingTerms& proposed);
// The terms that change, in words: "azimuth offset 0.00° → 37.41°". Also names a change of the sensor's mounting or
// curve.
[[nodiscard]] QString changeText(const pointing::PointingTerms& before, const pointing::PointingTerms& after,
                                 bool changesSensor = false);

}  // namespace boresight
