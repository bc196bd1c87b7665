// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/elements/satdata_reader.h"

#include "core/base/text.h"
#include "core/base/trimmed.h"
#include "core/elements/element_check.h"
#include "core/elements/text_lines.h"
#include "core/elements/tle_fields.h"

#include <optional>
#include <utility>

namespace boresight::orbit {

namespace {

struct SatdataValue
{
    int line = 0;
    std::string_view text;
};

class SatdataReader
{
public:
    void take(std::string_view line, int number)
    {
        if (line.starts_with('[')) {
            finishGroup();
            m_group = number;
            return;
        }
        const std::size_t equals = line.find('=');
        if (m_group == 0 || equals == std::string_view::npos) {
            return;
        }
        const std::string_view key = trimmed(line.substr(0, equals));
        const SatdataValue value{number, trimmed(line.substr(equals + 1))};
        if (key == "NAME") {
            m_name = value.text;
        } else if (key == "TLE1") {
            m_first = value;
        } else if (key == "TLE2") {
            m_second = value;
        }
    }

    [[nodiscard]] bool isHopeless() const { return m_list.isHopeless(); }

    ElementList finish()
    {
        finishGroup();
        return std::move(m_list);
    }

private:
    void finishGroup()
    {
        const int group = std::exchange(m_group, 0);
        const auto name = std::exchange(m_name, {});
        const auto first = std::exchange(m_first, std::nullopt);
        const auto second = std::exchange(m_second, std::nullopt);
        if (group == 0) {
            return;
        }
        if (!first || !second) {
            m_list.addProblem(group, Text::tr("%1 is missing.").arg(QLatin1String(first ? "TLE2" : "TLE1")));
            return;
        }
        auto elements = parseTle(first->text, second->text);
        if (!elements) {
            const ElementProblem& problem = elements.error();
            m_list.addProblem(problem.line == 1 ? first->line : second->line, problem.reason);
            return;
        }
        elements->name = nameOf(name);
        m_list.sets.push_back(std::move(*elements));
    }

    ElementList m_list;
    int m_group = 0;  // line of its header, 0 before the first group
    std::string_view m_name;
    std::optional<SatdataValue> m_first;
    std::optional<SatdataValue> m_second;
};

}  // namespace

ElementList readSatdata(std::string_view text)
{
    SatdataReader reader;
    TextLines lines(text);
    while (!reader.isHopeless() && lines.next()) {
        reader.take(trimmed(lines.line()), lines.number());
    }
    return reader.finish();
}

}  // namespace boresight::orbit
