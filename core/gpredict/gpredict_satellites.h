// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"

#include <QString>

#include <optional>
#include <string_view>

// The satellite data of Gpredict on this computer: satdata/NUMBER.sat in its folder, one key file per satellite
// ([Satellite] with NAME, TLE1, TLE2), which Gpredict rewrites at each update. Blocking file access: neither on the gui
// thread nor on the station thread.
namespace boresight::profile {

struct GpredictSatellites
{
    QString folder;
    int files = 0;                  // number of .sat files
    std::optional<UtcTime> newest;  // epoch of the newest elements; empty if no file has elements

    bool operator==(const GpredictSatellites&) const = default;
};

// `folder` is Gpredict's own folder, which contains satdata.
[[nodiscard]] GpredictSatellites findGpredictSatellites(const QString& folder);

// The epoch in columns 19 to 32 of the first line of a TLE: the year (57 to 99 are 19xx) and the day of the year with
// its fraction, counted from 1.
[[nodiscard]] std::optional<UtcTime> elementEpoch(std::string_view line);

}  // namespace boresight::profile
