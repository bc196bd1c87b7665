// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/gpredict/gpredict_qth.h"

#include "core/base/numbers.h"
#include "core/base/text.h"
#include "core/gpredict/key_file.h"
#include "core/profile/setting.h"
#include "core/profile/small_file.h"

#include <QDir>
#include <QFileInfo>
#include <QStandardPaths>

#include <algorithm>

namespace boresight::profile {

namespace {

Result<> readNumber(const QByteArray& text, const char* key, const char* setting, Profile& into)
{
    const auto value = keyFileValue(text, QStringLiteral("QTH"), QLatin1String(key));
    const auto number = value ? parseFinite(value->toStdString()) : std::nullopt;
    if (!number) {
        return failure(ErrorCode::InvalidInput,
                       (value ? Text::tr("%1 is not a number") : Text::tr("%1 is missing")).arg(QLatin1String(key)));
    }
    return findSetting(setting)->set(into, *number).map_error([&](const Error& error) {
        return Error{error.code, QStringLiteral("%1: %2").arg(QLatin1String(key), error.text)};
    });
}

}  // namespace

QString gpredictFolder(const GpredictSettings& settings)
{
    if (!settings.folder.empty()) {
        return QString::fromStdString(settings.folder);
    }
    return QStandardPaths::writableLocation(QStandardPaths::GenericConfigLocation) + QStringLiteral("/Gpredict");
}

Result<GpredictStation> parseQth(const QByteArray& text, const QString& name)
{
    Profile profile;
    return readNumber(text, "LAT", "site.latitude_deg", profile)
        .and_then([&] { return readNumber(text, "LON", "site.longitude_deg", profile); })
        .and_then([&] { return readNumber(text, "ALT", "site.height_m", profile); })
        .map([&] {
            return GpredictStation{
                .name = name,
                .location = keyFileValue(text, QStringLiteral("QTH"), QStringLiteral("LOCATION")).value_or(QString()),
                .site = profile.site};
        });
}

GpredictFiles findGpredict(const QString& folder)
{
    const auto settings = readFile(folder + QStringLiteral("/gpredict.cfg"));
    const QString defaultFile =
        keyFileValue(settings.value_or(QByteArray()), QStringLiteral("GLOBAL"), QStringLiteral("DEFAULT_QTH"))
            .value_or(QStringLiteral("sample.qth"));
    GpredictFiles found{.folder = folder, .satellites = findGpredictSatellites(folder)};
    const auto files = QDir(folder).entryInfoList({QStringLiteral("*.qth")}, QDir::Files, QDir::Name);
    for (const QFileInfo& file : files) {
        auto station = readFile(file.filePath()).and_then([&](const QByteArray& text) {
            return parseQth(text, file.completeBaseName());
        });
        if (station) {
            station->isDefault = file.fileName() == defaultFile;
            found.stations.push_back(*station);
        } else {
            found.problems.push_back(file.fileName() + QStringLiteral(": ") + station.error().text);
        }
    }
    std::ranges::stable_partition(found.stations, &GpredictStation::isDefault);
    return found;
}

}  // namespace boresight::profile
