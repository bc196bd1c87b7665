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

// What Gpredict, on the same computer, knows already: where the station is, and its satellites. Gpredict keeps one
// NAME.qth per station (a key file: [QTH] with LAT and LON in degrees, north and east positive, ALT in metres,
// LOCATION) and names the one it uses in gpredict.cfg ([GLOBAL] DEFAULT_QTH, sample.qth if nobody has chosen). Blocking
// file access: not on the gui thread, nor the station's.
namespace boresight::profile {

struct GpredictStation
{
    QString name;      // the file's: "home" of home.qth
    QString location;  // "Copenhagen, Denmark"; may be empty
    SiteSettings site;
    bool isDefault = false;

    bool operator==(const GpredictStation&) const = default;
};

// Where Gpredict keeps its files: as the profile says, else where it does for this user. It need not exist.
[[nodiscard]] QString gpredictFolder(const GpredictSettings& settings);

struct GpredictFiles
{
    QString folder;
    std::vector<GpredictStation> stations;  // the default first, then by name
    GpredictSatellites satellites;
    QStringList problems;  // of files that were passed over: "FILE: reason"
};
[[nodiscard]] GpredictFiles findGpredict(const QString& folder);

// The text of one .qth file. A place that is incomplete is refused; Gpredict would take it for 0°, 0°.
[[nodiscard]] Result<GpredictStation> parseQth(const QByteArray& text, const QString& name);

}  // namespace boresight::profile
