// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/passes/pass_table.h"

#include "core/targets/target.h"
#include "ui/kit/format.h"
#include "ui/passes/pass_words.h"

#include <algorithm>
#include <chrono>

namespace boresight::ui {

namespace {

constexpr std::chrono::minutes kSamePass{2};

bool matches(const orbit::ElementSet& elements, const QStringList& words)
{
    const QString text = QString::fromStdString(elements.name) + QLatin1Char(' ') + QString::number(elements.number);
    return std::ranges::all_of(words, [&](const QString& word) { return text.contains(word, Qt::CaseInsensitive); });
}

}  // namespace

PassTable::PassTable(QObject* parent)
    : TableModel({tr("Satellite"), tr("Rises (UTC)"), tr("In"), tr("Highest"), tr("Lasts")}, parent)
{}

void PassTable::show(const std::shared_ptr<const PassBook>& book, UtcTime now)
{
    m_book = book;
    m_now = now;
    select();
}

void PassTable::setWords(const QString& words)
{
    m_words = words;
    select();
}

void PassTable::setLowest(Angle elevation)
{
    m_lowest = elevation;
    select();
}

void PassTable::select()
{
    const QStringList words = m_words.split(QLatin1Char(' '), Qt::SkipEmptyParts);
    std::vector<bool> wanted;
    if (m_book->satellites) {
        std::ranges::transform(*m_book->satellites, std::back_inserter(wanted),
                               [&](const orbit::ElementSet& elements) { return matches(elements, words); });
    }
    beginResetModel();
    m_rows.clear();
    for (std::size_t i = 0; i < m_book->passes.size(); ++i) {
        const BookedPass& one = m_book->passes[i];
        if (wanted[one.satellite] && one.pass.los.utc > m_now && one.pass.tca.direction.elevation >= m_lowest) {
            m_rows.push_back(i);
        }
    }
    endResetModel();
}

void PassTable::tick(UtcTime now)
{
    m_now = now;
    const auto isOver = [&](std::size_t row) { return m_book->passes[row].pass.los.utc <= now; };
    for (auto over = std::ranges::find_if(m_rows, isOver); over != m_rows.end();
         over = std::ranges::find_if(m_rows, isOver)) {
        const int row = static_cast<int>(over - m_rows.begin());
        beginRemoveRows({}, row, row);
        m_rows.erase(over);
        endRemoveRows();
    }
    changeCells();
}

std::optional<int> PassTable::rowOf(std::int64_t number, UtcTime highest) const
{
    for (std::size_t row = 0; row < m_rows.size(); ++row) {
        const BookedPass& one = m_book->passes[m_rows[row]];
        if (m_book->elementsOf(one).number == number && std::chrono::abs(one.pass.tca.utc - highest) < kSamePass) {
            return static_cast<int>(row);
        }
    }
    return std::nullopt;
}

QVariant PassTable::data(const QModelIndex& index, int role) const
{
    const BookedPass& one = pass(index.row());
    if (role == Qt::TextAlignmentRole && index.column() != Satellite) {
        return QVariant(Qt::AlignRight | Qt::AlignVCenter);
    }
    if (role == Qt::ToolTipRole) {
        return factsOf(one, *m_book, m_now);
    }
    if (role != Qt::DisplayRole) {
        return {};
    }
    switch (index.column()) {
        case Satellite:
            return targets::satelliteName(m_book->elementsOf(one));
        case Rises:
            return riseText(one.pass);
        case Until:
            return untilText(one.pass, m_now);
        case Highest:
            return angleText(one.pass.tca.direction.elevation, 0);
        default:
            return one.pass.isUpAtStart && one.pass.isUpAtEnd ? tr("always") : lengthText(one.pass.duration());
    }
}

}  // namespace boresight::ui

#include "moc_pass_table.cpp"
