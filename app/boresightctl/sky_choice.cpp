// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/boresightctl/sky_choice.h"

#include "app/log_output.h"
#include "core/base/clock.h"
#include "core/base/text.h"
#include "core/element_files/element_files.h"
#include "core/element_web/element_web.h"
#include "core/elements/element_address.h"
#include "core/gpredict/gpredict_qth.h"
#include "core/profile/small_file.h"

#include <QEventLoop>
#include <QFileInfo>

namespace boresight::ctl {

namespace {

QString commaSeparated(const std::vector<std::string>& entries)
{
    QStringList all;
    for (const std::string& entry : entries) {
        all << toQString(entry);
    }
    return all.join(QStringLiteral(", "));
}

// Downloads the addresses that are due, by the rules of the station, and returns the files of the cache.
QStringList downloaded(const std::vector<orbit::ElementAddress>& addresses)
{
    const QString folder = orbit::ElementCache::userFolder();
    const SystemClock clock;
    orbit::ElementWeb web(clock, folder);
    QEventLoop loop;
    QObject::connect(&web, &orbit::ElementWeb::idle, &loop, &QEventLoop::quit);
    web.setAddresses(addresses);
    if (web.isBusy()) {
        app::printError(QStringLiteral("Boresight downloads element sets …"));
        loop.exec();
    }
    for (const QString& problem : web.problems()) {
        app::printError(problem);
    }
    QStringList files;
    for (const orbit::ElementAddress& address : addresses) {
        if (const QString file = orbit::ElementCache(folder).fileOf(address); QFileInfo::exists(file)) {
            files << file;
        }
    }
    return files;
}

// The files of all entries, which are files or addresses.
QStringList filesOf(const std::vector<std::string>& entries)
{
    QStringList files;
    for (const std::string& entry : entries) {
        if (!orbit::isElementAddress(entry)) {
            files << toQString(entry);
        }
    }
    const auto addresses = orbit::elementAddresses(entries);
    return addresses.empty() ? files : files + downloaded(addresses);
}

}  // namespace

std::vector<orbit::ElementSet> chosenSatellites(const Subcommand& subcommand, const SkyOptions& options)
{
    orbit::ElementFiles files = orbit::readElementFiles(filesOf(options.elements));
    for (const QString& problem : files.problems) {
        app::printError(problem);
    }
    if (options.number) {
        std::erase_if(files.sets, [&](const orbit::ElementSet& set) { return set.number != *options.number; });
    }
    if (files.sets.empty()) {
        const QString where = commaSeparated(options.elements);
        complain(
            subcommand,
            (options.number
                 ? QStringLiteral("%1: there is no usable element set of number %2. ").arg(where).arg(*options.number)
                 : QStringLiteral("%1: there is no usable element set. ").arg(where)) +
                QStringLiteral("With --elements name a file that has one"));
    }
    return std::move(files.sets);
}

QString satelliteText(const orbit::ElementSet& set)
{
    const QString number = QString::number(set.number);
    return set.name.empty() ? number : QStringLiteral("%1 (%2)").arg(toQString(set.name), number);
}

Result<Site> chosenSite(const SkyOptions& options)
{
    if (options.site) {
        return *options.site;
    }
    const Result<QByteArray> text = profile::readFile(options.siteFile);
    if (!text) {
        return tl::unexpected(text.error());
    }
    const auto station = profile::parseQth(*text, options.siteFile);
    if (!station) {
        return failure(station.error().code, QStringLiteral("%1: %2").arg(options.siteFile, station.error().text));
    }
    return Site{station->site.latitude, station->site.longitude, station->site.heightMetres};
}

}  // namespace boresight::ctl
