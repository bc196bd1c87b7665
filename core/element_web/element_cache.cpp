// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/element_web/element_cache.h"

#include "core/base/control_characters.h"
#include "core/base/text.h"
#include "core/profile/small_file.h"

#include <QDateTime>
#include <QDir>
#include <QFileInfo>
#include <QJsonDocument>
#include <QJsonObject>
#include <QStandardPaths>

#include <algorithm>

namespace boresight::orbit {

namespace {

const QString kEtag = QStringLiteral("etag");
const QString kLastModified = QStringLiteral("last_modified");
const QString kLastTry = QStringLiteral("last_try");
const QString kFetched = QStringLiteral("fetched");
const QString kFailures = QStringLiteral("failures");
const QString kProblem = QStringLiteral("problem");

QString statePath(const QString& file)
{
    return file + QStringLiteral(".state");
}

QJsonValue timeValue(const std::optional<UtcTime>& time)
{
    return time ? QJsonValue(qint64(std::chrono::floor<std::chrono::seconds>(*time).time_since_epoch().count()))
                : QJsonValue();
}

std::optional<UtcTime> timeOf(const QJsonValue& value)
{
    constexpr qint64 kLatest = 9'000'000'000;  // s since 1970: the year 2255. UtcTime ends in 2262
    const qint64 seconds = value.toInteger(0);
    return seconds > 0 && seconds < kLatest ? std::optional(UtcTime(std::chrono::seconds(seconds))) : std::nullopt;
}

// A text for a header of the next request: Latin-1 and not too long.
QByteArray headerOf(const QJsonValue& value)
{
    constexpr qsizetype kLongest = 500;
    const QByteArray text = value.toString().toLatin1();
    return text.size() > kLongest || hasControlCharacters(text.toStdString()) ? QByteArray() : text;
}

// A text for the screen: printable and not too long.
QString problemOf(const QJsonValue& value)
{
    constexpr qsizetype kLongest = 750;
    const QString text = value.toString();
    return text.size() > kLongest || hasControlCharacters(text.toStdString()) ? QString() : text;
}

}  // namespace

QString ElementCache::userFolder()
{
    return QStandardPaths::writableLocation(QStandardPaths::GenericCacheLocation) +
           QStringLiteral("/boresight/elements");
}

QString ElementCache::fileOf(const ElementAddress& address) const
{
    return m_folder + QChar(u'/') + address.file;
}

CacheState ElementCache::state(const ElementAddress& address) const
{
    const QString file = fileOf(address);
    const QJsonObject stored =
        QJsonDocument::fromJson(profile::readFile(statePath(file)).value_or(QByteArray())).object();
    constexpr int kMostFailures = 1000;
    CacheState state{.lastTry = timeOf(stored.value(kLastTry)),
                     .failures = std::clamp(stored.value(kFailures).toInt(), 0, kMostFailures),
                     .problem = problemOf(stored.value(kProblem))};
    if (const QFileInfo content(file); content.isFile()) {
        const std::chrono::seconds written(content.lastModified().toSecsSinceEpoch());
        state.etag = headerOf(stored.value(kEtag));
        state.lastModified = headerOf(stored.value(kLastModified));
        state.fetched = timeOf(stored.value(kFetched)).value_or(UtcTime(written));
    }
    return state;
}

Result<> ElementCache::keepState(const ElementAddress& address, const CacheState& state) const
{
    const QJsonObject stored{{kEtag, QString::fromLatin1(state.etag)},
                             {kLastModified, QString::fromLatin1(state.lastModified)},
                             {kLastTry, timeValue(state.lastTry)},
                             {kFetched, timeValue(state.fetched)},
                             {kFailures, state.failures},
                             {kProblem, state.problem}};
    return keep(statePath(fileOf(address)), QJsonDocument(stored).toJson());
}

Result<> ElementCache::keepContent(const ElementAddress& address, const QByteArray& content) const
{
    return keep(fileOf(address), content);
}

Result<> ElementCache::keep(const QString& path, const QByteArray& bytes) const
{
    if (!QDir().mkpath(m_folder)) {
        return failure(ErrorCode::Io, Text::tr("%1: this folder cannot be made").arg(m_folder));
    }
    return profile::writeFile(path, bytes);
}

}  // namespace boresight::orbit
