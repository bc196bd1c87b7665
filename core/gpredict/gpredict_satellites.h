// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"

#include <QString>

#include <optional>
#include <string_view>

// The satellite data of a Gpredict on the same computer: satdata/NUMBER.sat in its folder, one key file per satellite
// ([Satellite] with NAME, TLE1, TLE2), which Gpredict writes again at each update. Blocking file access: not on the gui
// thread, nor the station's.
namespace boresight::profile {

struct GpredictSatellites
{
    QString folder;
    int files = 0;                  // of .sat
    std::optional<UtcTime> newest;  // epoch of the newest elements; empty if no file has any

    bool operator==(const GpredictSatellites&) const = default;
};

// `folder` is Gpredict's own, above satdata.
[[nodiscard]] GpredictSatellites findGpredictSatellites(const QString& folder);

// Of the first line of a set of two-line elements, from its columns 19 to 32: year (57 to 99 are of the 20th century)
// and day of the year with its fraction, from 1.
[[nodiscard]] std::optional<UtcTime> elementEpoch(std::string_view line);

}  // namespace boresight::profile
