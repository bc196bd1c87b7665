// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geomagnetism/coefficients.h"

#include "core/base/numbers.h"
#include "core/base/text.h"

#include <algorithm>
#include <vector>

namespace boresight::geomagnetism {

namespace {

using Words = std::vector<std::string_view>;

constexpr std::size_t kShortestEndLine = 4;  // the published files have 48 nines
constexpr double kFirstEpoch = 1900.0;
constexpr double kLastEpoch = 2200.0;

Words wordsOf(std::string_view line)
{
    constexpr std::string_view kBlanks = " \t\r";
    Words words;
    for (auto at = line.find_first_not_of(kBlanks); at != std::string_view::npos;) {
        const auto end = std::min(line.find_first_of(kBlanks, at), line.size());
        words.push_back(line.substr(at, end - at));
        at = line.find_first_not_of(kBlanks, end);
    }
    return words;
}

bool isEndLine(const Words& words)
{
    return words.size() == 1 && words.front().size() >= kShortestEndLine &&
           words.front().find_first_not_of('9') == std::string_view::npos;
}

// Parses the file line by line.
class CoefficientReader
{
public:
    Result<> take(const Words& words)
    {
        if (!m_headed) {
            m_headed = true;
            return takeHeader(words);
        }
        if (isEndLine(words)) {
            m_ended = true;
            return complete() ? Result<>{} : wrong(Text::tr("The term n = %1, m = %2 is missing.").arg(m_n).arg(m_m));
        }
        if (m_ended || complete()) {
            return wrong(Text::tr("A line of nines must follow degree %1.").arg(kDegree));
        }
        return takeTerm(words);
    }

    Result<Coefficients> finish() const
    {
        if (!m_ended) {
            return wrong(Text::tr("The file ends without a line of nines."));
        }
        return m_read;
    }

private:
    static tl::unexpected<Error> wrong(const QString& what) { return failure(ErrorCode::InvalidInput, what); }
    [[nodiscard]] bool complete() const { return m_n > kDegree; }

    Result<> takeHeader(const Words& words)
    {
        const auto epoch = words.size() == 3 ? parseFinite(words[0]) : std::nullopt;
        if (!epoch || *epoch < kFirstEpoch || *epoch > kLastEpoch) {
            return wrong(
                Text::tr("This is not the header of a magnetic model. A header has an epoch, a name and a date."));
        }
        m_read.epoch = *epoch;
        m_read.name = words[1];
        return {};
    }

    Result<> takeTerm(const Words& words)
    {
        if (words.size() != 6) {
            return wrong(Text::tr("The line has %1 numbers instead of 6: n, m, g, h and the changes of g and h.")
                             .arg(words.size()));
        }
        if (parseInteger(words[0]) != m_n || parseInteger(words[1]) != m_m) {
            return wrong(Text::tr("The term n = %1, m = %2 must come here.").arg(m_n).arg(m_m));
        }
        std::array<double, 4> values{};
        for (std::size_t i = 0; i < values.size(); ++i) {
            const auto value = parseFinite(words[i + 2]);
            if (!value) {
                return wrong(Text::tr("\"%1\" is not a number.").arg(toQString(words[i + 2])));
            }
            values[i] = *value;
        }
        if (m_m == 0 && (values[1] != 0.0 || values[3] != 0.0)) {
            return wrong(Text::tr("In a term with m = 0, h must be 0."));
        }
        m_read.main[termIndex(m_n, m_m)] = {values[0], values[1]};
        m_read.change[termIndex(m_n, m_m)] = {values[2], values[3]};
        m_m = m_m < m_n ? m_m + 1 : 0;
        m_n += m_m == 0 ? 1 : 0;
        return {};
    }

    Coefficients m_read;
    bool m_headed = false;
    bool m_ended = false;
    int m_n = 1;  // of the next term
    int m_m = 0;
};

}  // namespace

Result<Coefficients> parseCoefficients(std::string_view text)
{
    CoefficientReader reader;
    int line = 1;
    for (; !text.empty(); ++line) {
        const auto end = std::min(text.find('\n'), text.size());
        const Words words = wordsOf(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
        if (words.empty() && line > 1) {
            continue;
        }
        if (const auto taken = reader.take(words); !taken) {
            return failure(taken.error().code, Text::tr("line %1: %2").arg(QString::number(line), taken.error().text));
        }
    }
    return reader.finish();
}

}  // namespace boresight::geomagnetism
