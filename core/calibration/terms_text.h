// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/calibration/calibration_record.h"

#include <QString>

#include <array>
#include <optional>
#include <string>
#include <string_view>

// The terms of a pointing model as a short text for people and other programs: a header of comments that describes the
// mount, then one term per line: name, value, unit, sigma. Pure.
//
//   # mount: Roof
//   # date: 2026-11-22T01:30:00Z
//   # site: 48.2 16.37 200
//   # azimuth drive: 18c0a7a5-…
//   # elevation drive: 18c0a7a5-…
//   azimuth_offset 37.400000000 deg 0.050000000
//   collimation    0.300000000  deg -
namespace boresight::calibration {

struct TermSheet
{
    std::string mountName;  // empty if unknown, like every other value of the header
    std::optional<UtcTime> when;
    RecordMount mount;
    pointing::PointingTerms terms;
    std::array<std::optional<Angle>, kTerms> sigmas;

    bool operator==(const TermSheet&) const = default;
};

// Angles in degrees with 9 decimals; the date in whole seconds.
[[nodiscard]] std::string toText(const TermSheet& sheet);

// Units are deg, arcmin and arcsec. The sigma may be missing or "-". Every term must occur once. All errors are
// reported together, one "FILE:LINE: reason" per line. Comments are ignored, except those of the header.
[[nodiscard]] Result<TermSheet> parseTerms(std::string_view text, const QString& fileName);

}  // namespace boresight::calibration
