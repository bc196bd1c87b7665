// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/records/file_problems.h"

#include "core/base/control_characters.h"
#include "core/base/text.h"

#include <QStringList>

#include <algorithm>

namespace boresight::records {

void FileProblems::add(std::size_t line, const QString& problem)
{
    m_problems.push_back({line, printable(problem)});
}

QString FileProblems::text(const QString& fileName) const
{
    std::vector<Problem> sorted = m_problems;
    std::ranges::stable_sort(sorted, {}, &Problem::line);
    QStringList all;
    for (const Problem& problem : sorted) {
        all << QStringLiteral("%1:%2: %3").arg(fileName, QString::number(problem.line), problem.text);
    }
    return all.join(u'\n');
}

}  // namespace boresight::records
