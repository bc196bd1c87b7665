// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/elements/element_address.h"

#include "core/base/text.h"
#include "core/elements/element_check.h"

#include <QCryptographicHash>
#include <QHostAddress>

#include <algorithm>

namespace boresight::orbit {

namespace {

constexpr std::string_view kCelestrak = "celestrak:";
constexpr std::size_t kLongestGroup = 40;
constexpr std::size_t kLongestAddress = 2000;

bool isLetterOrDigit(char character)
{
    return (character >= 'a' && character <= 'z') || (character >= 'A' && character <= 'Z') ||
           (character >= '0' && character <= '9');
}

bool isThisComputer(const QString& host)
{
    return host == QStringLiteral("localhost") || QHostAddress(host).isLoopback();
}

QString fileNameOf(const QString& start, const QUrl& url)
{
    constexpr qsizetype kLongestStart = 64;
    constexpr qsizetype kHashDigits = 12;
    QString name = start.left(kLongestStart);
    for (QChar& character : name) {
        const bool isPlain = character.unicode() < 128 && (character.isLetterOrNumber() || character == u'-' ||
                                                           character == u'.' || character == u'_');
        character = isPlain ? character : QChar(u'_');
    }
    const QByteArray hash = QCryptographicHash::hash(url.toEncoded(), QCryptographicHash::Sha256).toHex();
    return name + QChar(u'-') + QString::fromLatin1(hash.left(kHashDigits));
}

// The queries of CelesTrak: celestrak.org/NORAD/documentation/gp-data-formats.php. Boresight asks for JSON, because a
// truncated JSON answer can be recognised.
Result<ElementAddress> celestrakGroup(std::string_view group)
{
    const bool isName = !group.empty() && group.size() <= kLongestGroup &&
                        std::ranges::all_of(group, [](char c) { return isLetterOrDigit(c) || c == '-'; });
    if (!isName) {
        return failure(ErrorCode::InvalidInput,
                       Text::tr("\"%1\" is not the name of a CelesTrak group. An example is celestrak:stations")
                           .arg(quoted(group)));
    }
    const QString name = toQString(group).toLower();
    const QUrl url(QStringLiteral("https://celestrak.org/NORAD/elements/gp.php?GROUP=%1&FORMAT=json").arg(name));
    return ElementAddress{.name = Text::tr("CelesTrak group %1").arg(name),
                          .url = url,
                          .file = fileNameOf(QStringLiteral("celestrak-") + name, url)};
}

}  // namespace

bool isElementAddress(std::string_view entry)
{
    return entry.starts_with(kCelestrak) || (!entry.starts_with('/') && entry.find("://") != std::string_view::npos);
}

bool isPermittedAddress(const QUrl& url)
{
    const bool isHttp = url.scheme() == QStringLiteral("http");
    return url.scheme() == QStringLiteral("https") || (isHttp && isThisComputer(url.host()));
}

Result<ElementAddress> parseElementAddress(std::string_view entry)
{
    if (entry.starts_with(kCelestrak)) {
        return celestrakGroup(entry.substr(kCelestrak.size()));
    }
    QUrl url(toQString(entry), QUrl::StrictMode);
    if (entry.size() > kLongestAddress || !url.isValid() || url.host().isEmpty()) {
        return failure(ErrorCode::InvalidInput, Text::tr("\"%1\" is not an address").arg(quoted(entry)));
    }
    if (!isPermittedAddress(url)) {
        return failure(
            ErrorCode::InvalidInput,
            Text::tr("\"%1\" does not begin with https://. Without https others could change the elements on the way")
                .arg(quoted(entry)));
    }
    if (!url.userInfo().isEmpty()) {
        return failure(ErrorCode::InvalidInput, Text::tr("the address must not contain a user name or a password"));
    }
    url.setFragment({});
    const QString query = url.hasQuery() ? QStringLiteral("?…") : QString();
    return ElementAddress{
        .name = url.toDisplayString(QUrl::RemoveQuery) + query, .url = url, .file = fileNameOf(url.host(), url)};
}

std::vector<ElementAddress> elementAddresses(const std::vector<std::string>& entries)
{
    std::vector<ElementAddress> all;
    for (const std::string& entry : entries) {
        if (!isElementAddress(entry)) {
            continue;
        }
        const auto address = parseElementAddress(entry);
        if (address && std::ranges::find(all, *address) == all.end()) {
            all.push_back(*address);
        }
    }
    return all;
}

}  // namespace boresight::orbit
