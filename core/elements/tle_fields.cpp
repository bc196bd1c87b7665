// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/elements/tle_fields.h"

#include "core/base/numbers.h"
#include "core/base/text.h"
#include "core/base/trimmed.h"
#include "core/elements/element_check.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <string>
#include <utility>

namespace boresight::orbit {

namespace {

constexpr int kFirstYearOfTheCentury = 57;   // year of Sputnik: 57 to 99 are 19xx
constexpr std::int64_t kExtendedTheory = 4;  // ephemeris type of SGP4-XP

bool isDigit(char character)
{
    return character >= '0' && character <= '9';
}

bool areDigits(std::string_view text)
{
    return !text.empty() && std::ranges::all_of(text, isDigit);
}

// A decimal fraction in the form of TLE columns: no exponent, no blanks inside.
std::optional<double> plainNumber(std::string_view text)
{
    return text.find_first_not_of("+-.0123456789") == std::string_view::npos ? parseFinite(text) : std::nullopt;
}

// " 12345-3" means 0.12345e-3. The point and the "e" are implied but may be written, and the exponent may be absent.
std::optional<double> impliedNumber(std::string_view text)
{
    const bool isNegative = text.starts_with('-');
    if (isNegative || text.starts_with('+')) {
        text.remove_prefix(1);
    }
    if (text.starts_with('.')) {
        text.remove_prefix(1);
    }
    const std::size_t digits = std::min(text.find_first_not_of("0123456789"), text.size());
    std::string_view exponent = text.substr(digits);
    if (exponent.starts_with('e') || exponent.starts_with('E')) {
        exponent.remove_prefix(1);
    }
    const auto fraction = digits > 0 ? parseFinite("0." + std::string(text.substr(0, digits))) : std::nullopt;
    const auto power = exponent.empty() ? 0 : parseInteger(trimmed(exponent));
    if (!fraction || !power || std::abs(*power) > 9) {
        return std::nullopt;
    }
    return (isNegative ? -1.0 : 1.0) * *fraction * std::pow(10.0, static_cast<double>(*power));
}

// Reads the columns of a line, numbered from 1 as in the description of the format. Keeps the first problem.
class TleLine
{
public:
    TleLine(std::string_view text, int number) : m_text(text), m_number(number) {}

    [[nodiscard]] bool isGood() const { return m_problem.isEmpty(); }
    [[nodiscard]] ElementProblem problem() const { return {m_number, m_problem}; }

    void checkForm(std::initializer_list<std::size_t> blanks)
    {
        if (m_text.size() < kTleColumns) {
            complain(Text::tr("The line has %1 columns instead of 69.").arg(m_text.size()));
            return;
        }
        if (m_text.size() > kTleColumns && m_text[kTleColumns] != ' ') {
            complain(Text::tr("The line continues after column 69."));
        }
        for (const std::size_t column : blanks) {
            if (m_text[column - 1] != ' ') {
                complain(Text::tr("Column %1 is not blank. Is a column missing or added?").arg(column));
            }
        }
        checkSum();
    }

    [[nodiscard]] std::string_view columns(std::size_t first, std::size_t last) const
    {
        return trimmed(untrimmed(first, last));
    }

    double number(std::size_t first, std::size_t last, const QString& name)
    {
        return taken(plainNumber(columns(first, last)), first, last, name);
    }

    double implied(std::size_t first, std::size_t last, const QString& name)
    {
        return taken(impliedNumber(columns(first, last)), first, last, name);
    }

    std::int64_t digits(std::size_t first, std::size_t last, const QString& name)
    {
        const std::string_view text = columns(first, last);
        return taken(areDigits(text) ? parseInteger(text) : std::nullopt, first, last, name);
    }

    // Blank columns mean 0.
    std::int64_t count(std::size_t first, std::size_t last, const QString& name)
    {
        return columns(first, last).empty() ? 0 : digits(first, last, name);
    }

    std::int64_t satellite() { return taken(tleNumber(columns(3, 7)), 3, 7, Text::tr("the catalogue number")); }

    // The text continues an implied "0.". Leading blanks are zeros. A blank inside or at the end is an error.
    double fraction(std::size_t first, std::size_t last, const QString& name)
    {
        std::string text(untrimmed(first, last));
        for (std::size_t i = 0; i + 1 < text.size() && text[i] == ' '; ++i) {
            text[i] = '0';
        }
        return taken(areDigits(text) ? parseFinite("0." + text) : std::nullopt, first, last, name);
    }

    void complain(const QString& reason)
    {
        if (m_problem.isEmpty()) {
            m_problem = reason;
        }
    }

private:
    [[nodiscard]] std::string_view untrimmed(std::size_t first, std::size_t last) const
    {
        return first <= m_text.size() ? m_text.substr(first - 1, last - first + 1) : std::string_view();
    }

    void checkSum()
    {
        const int expected = tleChecksum(m_text);
        const char found = m_text[kTleColumns - 1];
        if (found != static_cast<char>('0' + expected)) {
            complain(Text::tr("The checksum in column 69 is \"%1\", expected %2.")
                         .arg(quoted({&found, 1}), QString::number(expected)));
        }
    }

    template <class Value>
    Value taken(const std::optional<Value>& value, std::size_t first, std::size_t last, const QString& name)
    {
        if (!value) {
            complain(Text::tr("Columns %1 to %2 (%3) hold \"%4\". This is not a number.")
                         .arg(QString::number(first), QString::number(last), name, quoted(columns(first, last))));
        }
        return value.value_or(Value{});
    }

    std::string_view m_text;
    int m_number;
    QString m_problem;
};

// "98067A" becomes "1998-067A". Any other text stays unchanged.
std::string designatorOf(std::string_view columns)
{
    if (columns.size() < 5 || !areDigits(columns.substr(0, 5))) {
        return nameOf(columns);
    }
    const bool isOld = columns.substr(0, 2) >= std::to_string(kFirstYearOfTheCentury);
    return (isOld ? "19" : "20") + std::string(columns.substr(0, 2)) + "-" + nameOf(columns.substr(2));
}

JulianDate epochOf(TleLine& line)
{
    const auto shortYear = static_cast<int>(line.digits(19, 20, Text::tr("the year of the epoch")));
    const int year = shortYear + (shortYear < kFirstYearOfTheCentury ? 2000 : 1900);
    const double day = line.number(21, 32, Text::tr("the day of the epoch"));
    const double days = std::chrono::year(year).is_leap() ? 366.0 : 365.0;
    if (day < 1.0 || day >= days + 1.0) {
        line.complain(Text::tr("The day %1 of the epoch is not in the year %2.").arg(day).arg(year));
        return {};
    }
    return julianDate(year, day - 1.0);
}

void readFirst(TleLine& line, ElementSet& elements)
{
    line.checkForm({2, 9, 18, 33, 44, 53, 62, 64});
    elements.number = line.satellite();
    elements.classification = classificationOf(line.columns(8, 8));
    elements.designator = designatorOf(line.columns(10, 17));
    elements.epoch = epochOf(line);
    elements.meanMotionDot = line.number(34, 43, Text::tr("the first derivative of the mean motion"));
    elements.meanMotionDoubleDot = line.implied(45, 52, Text::tr("the second derivative of the mean motion"));
    elements.bstar = line.implied(54, 61, Text::tr("the drag term"));
    if (line.count(63, 63, Text::tr("the ephemeris type")) == kExtendedTheory) {
        line.complain(Text::tr("The set is made for SGP4-XP (ephemeris type 4), not for SGP4."));
    }
    elements.setNumber = line.count(65, 68, Text::tr("the set number"));
}

void readSecond(TleLine& line, ElementSet& elements)
{
    line.checkForm({2, 8, 17, 26, 34, 43, 52});
    const std::int64_t number = line.satellite();
    if (number != elements.number) {
        line.complain(Text::tr("Line 1 has the catalogue number %1, line 2 has %2.").arg(elements.number).arg(number));
    }
    elements.inclination = Angle::fromDegrees(line.number(9, 16, Text::tr("the inclination")));
    elements.ascendingNode = Angle::fromDegrees(line.number(18, 25, Text::tr("the ascending node")));
    elements.eccentricity = line.fraction(27, 33, Text::tr("the eccentricity"));
    elements.perigee = Angle::fromDegrees(line.number(35, 42, Text::tr("the argument of the perigee")));
    elements.meanAnomaly = Angle::fromDegrees(line.number(44, 51, Text::tr("the mean anomaly")));
    elements.revolutionsPerDay = line.number(53, 63, Text::tr("the mean motion"));
    elements.revolution = line.count(64, 68, Text::tr("the revolution number"));
    line.complain(elementProblem(elements));
}

}  // namespace

tl::expected<ElementSet, ElementProblem> parseTle(std::string_view first, std::string_view second)
{
    ElementSet elements;
    TleLine one(first, 1);
    readFirst(one, elements);
    if (!one.isGood()) {
        return tl::unexpected(one.problem());
    }
    TleLine two(second, 2);
    readSecond(two, elements);
    if (!two.isGood()) {
        return tl::unexpected(two.problem());
    }
    return elements;
}

int tleChecksum(std::string_view line)
{
    int sum = 0;
    for (const char character : line.substr(0, kTleColumns - 1)) {
        sum += isDigit(character) ? character - '0' : character == '-' ? 1 : 0;
    }
    return sum % 10;
}

std::optional<std::int64_t> tleNumber(std::string_view columns)
{
    constexpr std::string_view kLetters = "ABCDEFGHJKLMNPQRSTUVWXYZ";
    const std::size_t letter = columns.empty() ? std::string_view::npos : kLetters.find(columns.front());
    if (letter == std::string_view::npos) {
        return areDigits(columns) ? parseInteger(columns) : std::nullopt;
    }
    const auto rest =
        columns.size() == 5 && areDigits(columns.substr(1)) ? parseInteger(columns.substr(1)) : std::nullopt;
    return rest ? std::optional((static_cast<std::int64_t>(letter) + 10) * 10000 + *rest) : std::nullopt;
}

}  // namespace boresight::orbit
