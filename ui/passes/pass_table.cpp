// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/passes/pass_table.h"

#include "core/targets/target.h"
#include "ui/kit/format.h"
#include "ui/look/glyph.h"
#include "ui/passes/pass_words.h"

#include <algorithm>

namespace boresight::ui {

namespace {

bool matches(const orbit::ElementSet& elements, const QStringList& words)
{
    const QString text = QString::fromStdString(elements.name) + QLatin1Char(' ') + QString::number(elements.number);
    return std::ranges::all_of(words, [&](const QString& word) { return text.contains(word, Qt::CaseInsensitive); });
}

}  // namespace

PassTable::PassTable(QObject* parent)
    : TableModel({QString(), tr("Satellite"), tr("Rises (UTC)"), tr("In"), tr("Highest at"), tr("Sets"), tr("Highest"),
                  tr("Lasts"), tr("Hidden"), tr("Unwraps"), tr("Sunlit"), tr("Elements")},
                 parent),
      m_details(new PassDetails(this))
{
    connect(m_details, &PassDetails::workedOut, this, &PassTable::showDetails);
}

QString PassTable::usual(Column column)
{
    switch (column) {
        case Rises:
        case HighestAt:
        case Sets:
            return QStringLiteral("00:00:00");
        case Until:
            return QStringLiteral("59 min");
        case Highest:
            return QStringLiteral("90°");
        case Lasts:
        case Hidden:
        case Unwraps:
        case Sunlit:
            return QStringLiteral("00:00");
        case Elements:
            return daysText({.days = QStringLiteral("99.9"), .late = {}, .shift = {}, .beam = {}});
        default:
            return {};
    }
}

QString PassTable::longestName() const
{
    const orbit::ElementSet* longest = nullptr;
    for (const std::size_t row : m_rows) {
        const orbit::ElementSet& one = m_book->elementsOf(m_book->passes[row]);
        if (longest == nullptr || one.name.size() > longest->name.size()) {
            longest = &one;
        }
    }
    return longest == nullptr ? QString() : targets::satelliteName(*longest);
}

void PassTable::show(const std::shared_ptr<const PassBook>& book, UtcTime now)
{
    m_book = book;
    m_now = now;
    m_details->begin(book);
    select();
}

void PassTable::setChoice(const PassChoice& choice)
{
    m_choice = choice;
    select();
}

void PassTable::setMarks(const orbit::SatelliteMarks& marks)
{
    m_marks = marks;
    if (m_choice.onlyFavourites) {
        select();
    } else {
        changeCells();
    }
}

void PassTable::select()
{
    const QStringList words = m_choice.words.split(QLatin1Char(' '), Qt::SkipEmptyParts);
    std::vector<bool> wanted;
    if (m_book->satellites) {
        std::ranges::transform(*m_book->satellites, std::back_inserter(wanted), [&](const orbit::ElementSet& elements) {
            const bool isKind = !m_choice.onlyFavourites || orbit::isFavourite(m_marks, elements.number);
            return isKind && matches(elements, words);
        });
    }
    beginResetModel();
    m_rows.clear();
    for (std::size_t i = 0; i < m_book->passes.size(); ++i) {
        const BookedPass& one = m_book->passes[i];
        if (wanted[one.satellite] && one.pass.los.utc > m_now && one.pass.tca.direction.elevation >= m_choice.lowest) {
            m_rows.push_back(i);
        }
    }
    countAgain();
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
    countAgain();
    changeCells();
}

void PassTable::showDetails(std::size_t pass)
{
    const auto found = std::ranges::find(m_rows, pass);
    if (found != m_rows.end()) {
        const int row = static_cast<int>(found - m_rows.begin());
        Q_EMIT dataChanged(index(row, Unwraps), index(row, Sunlit));
    }
}

void PassTable::countAgain()
{
    const auto isComing = [this](const BookedPass& one) { return one.pass.los.utc > m_now; };
    m_count = {.coming = static_cast<std::size_t>(std::ranges::count_if(m_book->passes, isComing)),
               .listed = m_rows.size(),
               .satellites = 0};
    std::vector<bool> isListed(m_book->satellites ? m_book->satellites->size() : 0);
    for (const std::size_t row : m_rows) {
        isListed[m_book->passes[row].satellite] = true;
    }
    m_count.satellites = static_cast<std::size_t>(std::ranges::count(isListed, true));
}

std::optional<int> PassTable::rowOf(std::int64_t number, UtcTime highest) const
{
    for (std::size_t row = 0; row < m_rows.size(); ++row) {
        const BookedPass& one = m_book->passes[m_rows[row]];
        if (m_book->elementsOf(one).number == number && isSameMoment(one.pass.tca.utc, highest)) {
            return static_cast<int>(row);
        }
    }
    return std::nullopt;
}

std::optional<int> PassTable::nextOf(std::int64_t number) const
{
    const auto isOf = [&](std::size_t row) { return m_book->elementsOf(m_book->passes[row]).number == number; };
    const auto found = std::ranges::find_if(m_rows, isOf);
    return found == m_rows.end() ? std::nullopt : std::optional(static_cast<int>(found - m_rows.begin()));
}

bool PassTable::isFavourite(const BookedPass& one) const
{
    return orbit::isFavourite(m_marks, m_book->elementsOf(one).number);
}

QVariant PassTable::star(const BookedPass& one, int role) const
{
    switch (role) {
        case Qt::DecorationRole:
            return glyphIcon(isFavourite(one) ? Glyph::Favourite : Glyph::NoFavourite);
        case Qt::AccessibleTextRole:
            return isFavourite(one) ? tr("Favourite") : tr("No favourite");
        case Qt::ToolTipRole:
            return isFavourite(one) ? tr("A favourite. A click removes the star")
                                    : tr("A click makes this satellite a favourite");
        default:
            return {};
    }
}

QVariant PassTable::data(const QModelIndex& index, int role) const
{
    const std::size_t pass = m_rows.at(std::size_t(index.row()));
    if (index.column() == Favourite) {
        return star(m_book->passes[pass], role);
    }
    switch (role) {
        case Qt::DisplayRole:
            return text(pass, index.column());
        case Qt::ToolTipRole:
            return help(pass, index.column());
        case Qt::TextAlignmentRole:
            return index.column() == Satellite ? QVariant() : QVariant(Qt::AlignRight | Qt::AlignVCenter);
        default:
            return {};
    }
}

QString PassTable::text(std::size_t pass, int column) const
{
    const BookedPass& one = m_book->passes[pass];
    switch (column) {
        case Satellite:
            return targets::satelliteName(m_book->elementsOf(one));
        case Rises:
            return riseText(one.pass);
        case Until:
            return untilText(one.pass, m_now);
        case HighestAt:
            return clockText(one.pass.tca.utc);
        case Sets:
            return setText(one.pass);
        case Highest:
            return angleText(one.pass.tca.direction.elevation, 0);
        case Lasts:
            return one.pass.isUpAtStart && one.pass.isUpAtEnd ? tr("always") : lengthText(one.pass.duration());
        case Hidden:
            return partText(hiddenTime(one.pass), one.pass.duration());
        case Unwraps:
        case Sunlit:
            return detail(pass, column);
        default:
            return daysText(ageOf(one, *m_book, m_now));
    }
}

// Empty until it is computed.
QString PassTable::detail(std::size_t pass, int column) const
{
    const PassDetails::Facts* const facts = m_details->find(pass);
    if (facts == nullptr) {
        return {};
    }
    return column == Unwraps ? briefCableText(facts->cable)
                             : partText(facts->sunlit, m_book->passes[pass].pass.duration());
}

QString PassTable::help(std::size_t pass, int column) const
{
    if (column != Unwraps && column != Sunlit) {
        return factsOf(m_book->passes[pass], *m_book, m_now);
    }
    const PassDetails::Facts* const facts = m_details->find(pass);
    if (facts == nullptr) {
        return {};
    }
    return column == Unwraps ? cableText(facts->cable) : lightText(facts->light);
}

QVariant PassTable::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation == Qt::Horizontal && role == Qt::TextAlignmentRole && section > Satellite) {
        return QVariant(Qt::AlignRight | Qt::AlignVCenter);  // as the numbers below it
    }
    if (orientation != Qt::Horizontal || role != Qt::ToolTipRole) {
        return TableModel::headerData(section, orientation, role);
    }
    switch (section) {
        case Rises:
            return tr("AOS: the satellite rises above the horizon, without refraction");
        case Until:
            return tr("time until the satellite rises");
        case HighestAt:
            return tr("TCA: the satellite is highest");
        case Sets:
            return tr("LOS: the satellite sets, without refraction");
        case Highest:
            return tr("the highest elevation of the pass");
        case Lasts:
            return tr("time from rise to set");
        case Hidden:
            return tr("how long horizon, keep-outs and limits hide the satellite");
        case Unwraps:
            return tr("whether the cable ends during the pass, and how much of the pass is lost");
        case Sunlit:
            return tr("how long the satellite is in sunlight");
        case Elements:
            return tr("age of the elements in days");
        default:
            return {};
    }
}

}  // namespace boresight::ui

#include "moc_pass_table.cpp"
