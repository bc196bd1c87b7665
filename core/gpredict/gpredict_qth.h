// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/gpredict/gpredict_satellites.h"
#include "core/profile/profile.h"

#include <QByteArray>
#include <QString>
#include <QStringList>

#include <optional>
#include <vector>

// Reads the settings of Gpredict on this computer: the location of the station, and the satellites. Gpredict keeps one
// NAME.qth per station (a key file: [QTH] with LAT and LON in degrees, north and east positive, ALT in metres,
// LOCATION). gpredict.cfg names the one in use ([GLOBAL] DEFAULT_QTH; sample.qth if none was chosen). Blocking file
// access: neither on the gui thread nor on the station thread.
namespace boresight::profile {

struct GpredictStation
{
    QString name;      // from the name of the file: "home" for home.qth
    QString location;  // "Copenhagen, Denmark"; may be empty
    SiteSettings site;
    bool isDefault = false;

    bool operator==(const GpredictStation&) const = default;
};

// The folder of Gpredict: the one in the profile, or else Gpredict's usual folder for this user. It may be missing.
[[nodiscard]] QString gpredictFolder(const GpredictSettings& settings);

struct GpredictFiles
{
    QString folder;
    std::vector<GpredictStation> stations;  // the default station first, the others sorted by name
    GpredictSatellites satellites;
    QStringList problems;  // of files that were left out: "FILE: reason"
};
[[nodiscard]] GpredictFiles findGpredict(const QString& folder);

// Parses one .qth file. An incomplete position is refused, while Gpredict would use 0°, 0°.
[[nodiscard]] Result<GpredictStation> parseQth(const QByteArray& text, const QString& name);

}  // namespace boresight::profile
