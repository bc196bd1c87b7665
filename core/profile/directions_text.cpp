// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/profile/directions_text.h"

#include "core/base/text.h"
#include "core/profile/commissioning.h"
#include "core/profile/profile_file.h"

#include <QRegularExpression>
#include <QStringList>

#include <optional>

namespace boresight::profile {
namespace {

const QString kTable = QStringLiteral("[mount]");
const QString kConfirmed = QStringLiteral("directions = \"confirmed\"");

struct Place
{
    qsizetype header = -1;
    qsizetype key = -1;        // line of `directions` in the table [mount]
    qsizetype commented = -1;  // line of `directions` as a comment, which the writer leaves for a default
};

Place placeOf(const QStringList& lines)
{
    static const QRegularExpression header(QStringLiteral(R"(^\s*\[\s*mount\s*\]\s*(#.*)?$)"));
    static const QRegularExpression key(QStringLiteral(R"(^\s*directions\s*=)"));
    static const QRegularExpression commented(QStringLiteral(R"(^\s*#\s*directions\s*=)"));
    Place place;
    bool inside = false;
    for (qsizetype i = 0; i < lines.size(); ++i) {
        if (lines[i].trimmed().startsWith(QLatin1Char('['))) {
            inside = header.match(lines[i]).hasMatch();
            place.header = inside ? i : place.header;
        } else if (inside && key.match(lines[i]).hasMatch()) {
            place.key = i;
        } else if (inside && commented.match(lines[i]).hasMatch()) {
            place.commented = i;
        }
    }
    return place;
}

QString edited(const QString& toml)
{
    static const QRegularExpression value(QStringLiteral(R"(directions\s*=\s*("[^"]*"|'[^']*'))"));
    QStringList lines = toml.split(QLatin1Char('\n'));
    const Place place = placeOf(lines);
    if (place.key >= 0) {
        lines[place.key].replace(value, kConfirmed);
    } else if (place.commented >= 0) {
        lines[place.commented] = kConfirmed;
    } else if (place.header >= 0) {
        lines.insert(place.header + 1, kConfirmed);
    } else {
        lines << kTable << kConfirmed << QString();
    }
    return lines.join(QLatin1Char('\n'));
}

}  // namespace

Result<std::string> withDirectionsConfirmed(const std::string& toml, const QString& fileName)
{
    return parseProfile(toml, fileName).and_then([&](Profile wanted) -> Result<std::string> {
        if (namesNoBus(wanted)) {
            return failure(ErrorCode::Refused,
                           Text::tr("%1 is the profile of the simulated mount. Set bus.name to the bus of the mount "
                                    "first.")
                               .arg(fileName));
        }
        wanted.mount.directions = Directions::Confirmed;
        const std::string text = edited(toQString(toml)).toStdString();
        if (const auto after = parseProfile(text, fileName); !after || *after != wanted) {
            return failure(ErrorCode::InvalidInput,
                           Text::tr("%1: the place of the key was not found. Write %2 into the table %3.")
                               .arg(fileName, kConfirmed, kTable));
        }
        return text;
    });
}

}  // namespace boresight::profile
