// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
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

// Where Gpredict keeps its files for this user; it need not exist.
[[nodiscard]] QString gpredictFolder();

struct GpredictStations
{
    std::vector<GpredictStation> stations;  // the default first, then by name
    QStringList problems;                   // of files that were passed over: "FILE: reason"
};
[[nodiscard]] GpredictStations findGpredictStations(const QString& folder);

// Satellite data, NUMBER.sat files with elements; empty if there is none.
[[nodiscard]] std::optional<QString> gpredictSatelliteFolder(const QString& folder);

// The text of one .qth file. A place that is incomplete is refused; Gpredict would take it for 0°, 0°.
[[nodiscard]] Result<GpredictStation> parseQth(const QByteArray& text, const QString& name);

}  // namespace boresight::profile
