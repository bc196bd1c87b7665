// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/control_characters.h"
#include "core/base/numbers.h"
#include "core/base/text.h"
#include "core/base/trimmed.h"
#include "core/calibration/terms_fields.h"
#include "core/calibration/terms_text.h"

#include <QDateTime>
#include <QStringList>

#include <algorithm>
#include <cmath>
#include <vector>

namespace boresight::calibration {
namespace {

constexpr std::size_t kLongestText = 100000;
constexpr std::size_t kLongestQuote = 60;
constexpr std::size_t kMostProblems = 20;
constexpr int kTermsReaderEarliest = 1970;
constexpr int kTermsReaderLatest = 2200;
constexpr std::string_view kBlanks = " \t\r";

std::vector<std::string_view> wordsOf(std::string_view text)
{
    std::vector<std::string_view> words;
    for (text = trimmed(text); !text.empty(); text = trimmed(text)) {
        const std::size_t end = std::min(text.find_first_of(kBlanks), text.size());
        words.push_back(text.substr(0, end));
        text.remove_prefix(end);
    }
    return words;
}

QString quoted(std::string_view text)
{
    return QStringLiteral("\"%1\"").arg(toQString(printable(std::string(text.substr(0, kLongestQuote)))));
}

// How many degrees one unit has.
std::optional<double> degreesOf(std::string_view unit)
{
    if (unit == "deg") {
        return 1.0;
    }
    if (unit == "arcmin") {
        return 1.0 / 60.0;
    }
    return unit == "arcsec" ? std::optional(1.0 / 3600.0) : std::nullopt;
}

class TermsReader
{
public:
    explicit TermsReader(QString fileName) : m_fileName(std::move(fileName)) {}

    Result<TermSheet> read(std::string_view text)
    {
        while (!text.empty()) {
            const std::size_t end = std::min(text.find('\n'), text.size());
            ++m_line;
            readLine(trimmed(text.substr(0, end)));
            text.remove_prefix(std::min(end + 1, text.size()));
        }
        for (const Term term : kAllTerms) {
            if (m_lines[indexOf(term)] == 0) {
                complain(
                    Text::tr("%1 is missing. Write every term, also a term that is 0.").arg(toQString(nameOf(term))));
            }
        }
        if (!m_problems.isEmpty()) {
            return failure(ErrorCode::InvalidInput, m_problems.join(u'\n'));
        }
        return m_sheet;
    }

    // Reads a value from a line of the header.
    void text(std::string_view key, std::string& value)
    {
        if (key == m_key) {
            value = m_value;
        }
    }

    void date(std::string_view key, std::optional<UtcTime>& when)
    {
        if (key == m_key) {
            readDate(when);
        }
    }

    void site(std::string_view key, std::optional<RecordSite>& place)
    {
        if (key == m_key) {
            readSite(place);
        }
    }

private:
    void readLine(std::string_view line)
    {
        if (line.starts_with('#')) {
            readHeader(line.substr(1));
            return;
        }
        const auto words = wordsOf(line.substr(0, line.find('#')));
        if (!words.empty()) {
            readTerm(words);
        }
    }

    void readHeader(std::string_view comment)
    {
        const std::size_t colon = comment.find(':');
        if (colon == std::string_view::npos) {
            return;
        }
        m_key = trimmed(comment.substr(0, colon));
        m_value = printable(std::string(trimmed(comment.substr(colon + 1))));
        headerFields(*this, m_sheet);
    }

    void readDate(std::optional<UtcTime>& when)
    {
        const QDateTime date = QDateTime::fromString(toQString(m_value), Qt::ISODate);
        const bool isUtc = date.isValid() && date.timeSpec() == Qt::UTC;
        if (!isUtc || date.date().year() < kTermsReaderEarliest || date.date().year() > kTermsReaderLatest) {
            complain(Text::tr("%1 is not a date like 2026-11-21T21:34:00Z.").arg(quoted(m_value)));
            return;
        }
        when = UtcTime(std::chrono::seconds(date.toSecsSinceEpoch()));
    }

    void readSite(std::optional<RecordSite>& place)
    {
        const auto words = wordsOf(m_value);
        const auto number = [&words](std::size_t index, double most) -> std::optional<double> {
            const auto found = parseFinite(words[index]);
            return found && std::abs(*found) <= most ? found : std::nullopt;
        };
        const bool isThree = words.size() == 3;
        const auto latitude = isThree ? number(0, 90.0) : std::nullopt;
        const auto longitude = isThree ? number(1, 180.0) : std::nullopt;
        const auto height = isThree ? number(2, 10000.0) : std::nullopt;
        if (!latitude || !longitude || !height) {
            complain(Text::tr("%1 is not a site. Write latitude, longitude and height, like 48.2 16.37 200.")
                         .arg(quoted(m_value)));
            return;
        }
        place = RecordSite{.latitude = Angle::fromDegrees(*latitude),
                           .longitude = Angle::fromDegrees(*longitude),
                           .heightMetres = *height};
    }

    void readTerm(const std::vector<std::string_view>& words)
    {
        const auto term = termOfName(words[0]);
        if (!term) {
            complain(Text::tr("%1 is not a known term.").arg(quoted(words[0])));
            return;
        }
        std::size_t& line = m_lines[indexOf(*term)];
        if (line != 0) {
            complain(Text::tr("%1 is already in line %2.").arg(quoted(words[0])).arg(line));
            return;
        }
        line = m_line;
        if (words.size() < 2) {
            complain(Text::tr("The value of %1 is missing.").arg(quoted(words[0])));
        } else if (!parseFinite(words[1])) {
            complain(Text::tr("%1 is not a number.").arg(quoted(words[1])));
        } else if (words.size() < 3) {
            complain(Text::tr("The unit of %1 is missing. Write deg, arcmin or arcsec.").arg(quoted(words[0])));
        } else if (!degreesOf(words[2])) {
            complain(Text::tr("%1 is not a known unit. Write deg, arcmin or arcsec.").arg(quoted(words[2])));
        } else if (words.size() > 4) {
            complain(
                Text::tr("%1 is one value too many. A line has name, value, unit and sigma.").arg(quoted(words[4])));
        } else {
            const double unit = *degreesOf(words[2]);
            valueOf(m_sheet.terms, *term) = Angle::fromDegrees(*parseFinite(words[1]) * unit);
            readSigma(*term, words.size() == 4 ? words[3] : "-", unit);
        }
    }

    void readSigma(Term term, std::string_view word, double unit)
    {
        if (word == "-") {
            return;
        }
        const auto sigma = parseFinite(word);
        if (!sigma || !(*sigma > 0.0)) {
            complain(Text::tr("%1 is not a sigma. Write a number above 0, or - for an unknown one.").arg(quoted(word)));
            return;
        }
        m_sheet.sigmas[indexOf(term)] = Angle::fromDegrees(*sigma * unit);
    }

    // Reports at most kMostProblems problems.
    void complain(const QString& reason)
    {
        if (++m_count > kMostProblems) {
            return;
        }
        m_problems << QStringLiteral("%1:%2: %3").arg(m_fileName, QString::number(m_line), reason);
    }

    QString m_fileName;
    TermSheet m_sheet;
    std::string_view m_key;  // of the present line of the header
    std::string m_value;
    std::array<std::size_t, kTerms> m_lines{};  // the line number of each term, from 1
    std::size_t m_line = 0;
    QStringList m_problems;
    std::size_t m_count = 0;
};

}  // namespace

Result<TermSheet> parseTerms(std::string_view text, const QString& fileName)
{
    constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";
    if (text.size() > kLongestText) {
        return failure(ErrorCode::InvalidInput,
                       Text::tr("%1 is too long to be the terms of a pointing model.").arg(fileName));
    }
    if (text.starts_with(kByteOrderMark)) {
        text.remove_prefix(kByteOrderMark.size());
    }
    return TermsReader(fileName).read(text);
}

}  // namespace boresight::calibration
