// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/boresightctl/sky_choice.h"

#include "app/log_output.h"
#include "core/base/text.h"
#include "core/element_files/element_files.h"
#include "core/gpredict/gpredict_qth.h"
#include "core/profile/small_file.h"

namespace boresight::ctl {

std::vector<orbit::ElementSet> chosenSatellites(const Subcommand& subcommand, const SkyOptions& options)
{
    orbit::ElementFiles files = orbit::readElementFiles(options.elements);
    for (const QString& problem : files.problems) {
        app::printError(problem);
    }
    if (options.number) {
        std::erase_if(files.sets, [&](const orbit::ElementSet& set) { return set.number != *options.number; });
    }
    if (files.sets.empty()) {
        const QString where = options.elements.join(QStringLiteral(", "));
        complain(
            subcommand,
            (options.number
                 ? QStringLiteral("%1: there is no usable element set of number %2. ").arg(where).arg(*options.number)
                 : QStringLiteral("%1: there is no usable element set. ").arg(where)) +
                QStringLiteral("Give a file that has one with --elements"));
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
