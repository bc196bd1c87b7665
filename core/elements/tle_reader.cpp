// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/elements/tle_reader.h"

#include "core/base/text.h"
#include "core/base/trimmed.h"
#include "core/elements/element_check.h"
#include "core/elements/text_lines.h"
#include "core/elements/tle_fields.h"

#include <optional>
#include <string>
#include <utility>

namespace boresight::orbit {

namespace {

struct TleTextLine
{
    int number = 0;
    std::string_view text;
};

// A name has at most 24 columns. So a longer text that begins with "1 " is an element line, not a name.
bool isElementLine(std::string_view text, char digit)
{
    constexpr std::size_t kColumnsOfName = 24;
    return text.size() > kColumnsOfName + 2 && text[0] == digit && text[1] == ' ';
}

class TleTextReader
{
public:
    void take(const TleTextLine& line)
    {
        if (line.text.empty() || line.text.front() == '#') {
            return;
        }
        if (isElementLine(line.text, '1')) {
            dropFirst();
            m_first = line;
            // A truncated second line counts, too.
        } else if (isElementLine(line.text, '2') || (m_first && line.text.starts_with("2 "))) {
            takeSecond(line);
        } else {
            dropFirst();
            dropName();
            m_name = line;
        }
    }

    [[nodiscard]] bool isHopeless() const { return m_list.isHopeless(); }

    ElementList finish()
    {
        dropFirst();
        dropName();
        return std::move(m_list);
    }

private:
    void takeSecond(const TleTextLine& line)
    {
        if (!m_first) {
            m_list.addProblem(line.number, Text::tr("There is no line 1 before this line 2."));
            m_name.reset();
            return;
        }
        auto elements = parseTle(m_first->text, line.text);
        if (elements) {
            elements->name = takeName();
            m_list.sets.push_back(std::move(*elements));
        } else {
            const ElementProblem& problem = elements.error();
            m_list.addProblem(problem.line == 1 ? m_first->number : line.number, problem.reason);
        }
        m_first.reset();
        m_name.reset();
    }

    void dropFirst()
    {
        if (m_first) {
            m_list.addProblem(m_first->number, Text::tr("There is no line 2 after this line 1."));
            m_first.reset();
            m_name.reset();
        }
    }

    void dropName()
    {
        if (m_name) {
            m_list.addProblem(m_name->number,
                              Text::tr("\"%1\" is not part of an element set.").arg(quoted(m_name->text)));
            m_name.reset();
        }
    }

    std::string takeName()
    {
        if (!m_name) {
            return {};
        }
        std::string_view name = m_name->text;
        if (name.starts_with("0 ")) {
            name.remove_prefix(2);
        }
        return nameOf(trimmed(name));
    }

    ElementList m_list;
    std::optional<TleTextLine> m_name;
    std::optional<TleTextLine> m_first;
};

}  // namespace

ElementList readTle(std::string_view text)
{
    TleTextReader reader;
    TextLines lines(text);
    while (!reader.isHopeless() && lines.next()) {
        reader.take({lines.number(), lines.line()});
    }
    return reader.finish();
}

}  // namespace boresight::orbit
