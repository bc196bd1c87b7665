// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/passes/pass_columns.h"

#include "ui/kit/theme.h"
#include "ui/look/glyph.h"
#include "ui/passes/pass_table.h"

#include <QEvent>
#include <QHeaderView>
#include <QMenu>
#include <QScrollBar>
#include <QTableView>
#include <QToolButton>

#include <algorithm>
#include <utility>

namespace boresight::ui {

namespace {

constexpr int kCellMargins = 14;               // px
constexpr int kButtonSide = 44;                // px: the button of the star beside it
constexpr int kLeastName = 14;                 // letters
constexpr int kMostName = 24;                  // letters, as in a file of two-line elements
constexpr int kAlways = PassTable::Satellite;  // columns up to this one are always shown

// The most important first. Columns after Unwraps are shown only if the longest name is whole.
const std::pair<PassTable::Column, QString> kNames[] = {
    {PassTable::Rises, QStringLiteral("rises")},       {PassTable::Until, QStringLiteral("in")},
    {PassTable::Highest, QStringLiteral("highest")},   {PassTable::Lasts, QStringLiteral("lasts")},
    {PassTable::Unwraps, QStringLiteral("unwraps")},   {PassTable::Hidden, QStringLiteral("hidden")},
    {PassTable::Sets, QStringLiteral("sets")},         {PassTable::Sunlit, QStringLiteral("sunlit")},
    {PassTable::Elements, QStringLiteral("elements")}, {PassTable::HighestAt, QStringLiteral("highest_at")}};

// Stands for the columns that are always shown. Without it, a choice of no other column would be an empty list, which
// means "as many as there is room for".
const QString kAlwaysName = QStringLiteral("satellite");

}  // namespace

PassColumns::PassColumns(const PassTable& passes, QTableView& table, QWidget* panel)
    : QObject(panel), m_passes(passes), m_table(table), m_menu(new QMenu(&table))
{
    table.setHorizontalScrollBarPolicy(Qt::ScrollBarAsNeeded);
    table.setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
    header().setSectionResizeMode(QHeaderView::Fixed);
    header().setMinimumSectionSize(kRowHeight);
    header().setResizeContentsPrecision(0);  // only what is seen counts
    header().setContextMenuPolicy(Qt::CustomContextMenu);
    connect(&header(), &QWidget::customContextMenuRequested, this,
            [this](const QPoint& place) { m_menu->popup(header().mapToGlobal(place)); });
    makeMenu();
    m_menu->installEventFilter(this);
    table.viewport()->installEventFilter(this);
    connect(&passes, &QAbstractItemModel::modelReset, this, &PassColumns::beginAgain);
    connect(&passes, &QAbstractItemModel::dataChanged, this, &PassColumns::look);
    connect(table.verticalScrollBar(), &QScrollBar::valueChanged, this, &PassColumns::look);
    beginAgain();
}

void PassColumns::makeMenu()
{
    QAction* const roomy = m_menu->addAction(tr("As many columns as fit"));
    roomy->setCheckable(true);
    connect(roomy, &QAction::triggered, this, [this] { choose({}); });
    connect(m_menu->addAction(tr("All")), &QAction::triggered, this, [this] {
        QStringList all;
        for (const auto& [column, name] : kNames) {
            all << name;
        }
        choose(all);
    });
    m_menu->addSeparator();
    for (int column = kAlways + 1; column < m_passes.columnCount(); ++column) {
        const QString heading = m_passes.headerData(column, Qt::Horizontal, Qt::DisplayRole).toString();
        const QString help = m_passes.headerData(column, Qt::Horizontal, Qt::ToolTipRole).toString();
        QAction* const action = m_menu->addAction(tr("%1: %2").arg(heading, help));
        action->setCheckable(true);
        action->setData(column);
        connect(action, &QAction::triggered, this, [this, column](bool on) { toggle(column, on); });
    }
}

QToolButton* PassColumns::makeButton(QWidget* parent)
{
    auto* const button = new QToolButton(parent);
    button->setIcon(glyphIcon(Glyph::Menu));
    button->setMenu(m_menu);
    button->setPopupMode(QToolButton::InstantPopup);
    button->setFixedSize(kButtonSide, kButtonSide);
    button->setFocusPolicy(Qt::TabFocus);
    button->setAccessibleName(tr("Columns of the list"));
    button->setToolTip(tr("Columns of the list of passes"));
    return button;
}

QStringList PassColumns::chosen() const
{
    if (!m_chosen) {
        return {};
    }
    QStringList names{kAlwaysName};
    for (const auto& [column, name] : kNames) {
        if (m_chosen->contains(column)) {
            names << name;
        }
    }
    return names;
}

void PassColumns::choose(const QStringList& names)
{
    m_chosen.reset();
    if (!names.isEmpty()) {
        m_chosen.emplace();
        for (const auto& [column, name] : kNames) {
            if (names.contains(name)) {
                *m_chosen << column;
            }
        }
    }
    fit();
}

// The visible columns become the choice, with this change.
void PassColumns::toggle(int column, bool on)
{
    QList<int> columns = m_chosen.value_or(roomyColumns());
    columns.removeAll(column);
    if (on) {
        columns << column;
    }
    m_chosen = columns;
    fit();
}

bool PassColumns::eventFilter(QObject* watched, QEvent* event)
{
    if (watched == m_menu) {
        if (event->type() == QEvent::Show) {
            keepOffHeader();
        }
    } else if (event->type() == QEvent::FontChange) {
        beginAgain();
    } else if (event->type() == QEvent::Resize) {
        fit();
        look();
    } else if (event->type() == QEvent::Show) {
        look();
    }
    return QObject::eventFilter(watched, event);
}

// If there is too little room below, Qt would open the menu upwards, over the STOP button.
void PassColumns::keepOffHeader()
{
    const auto* const panel = static_cast<QWidget*>(parent());
    const QWidget& window = *m_table.window();
    if (m_menu->y() < panel->mapToGlobal(QPoint()).y()) {
        m_menu->move(m_menu->x(), window.mapToGlobal(QPoint(0, window.height() - m_menu->height())).y());
    }
}

void PassColumns::beginAgain()
{
    m_seen.clear();
    m_longestName = QFontMetrics(m_table.font()).horizontalAdvance(m_passes.longestName()) + kCellMargins;
    fit();
    look();
}

// A hidden table would measure all of its rows.
void PassColumns::look()
{
    const QAbstractItemView& view = m_table;
    bool isWider = false;
    for (int column = kAlways + 1; view.isVisible() && column < m_passes.columnCount(); ++column) {
        if (header().isSectionHidden(column)) {
            continue;
        }
        const int needed = view.sizeHintForColumn(column);
        isWider = isWider || needed > widthOf(column);
        m_seen[column] = std::max(m_seen[column], needed);
    }
    if (isWider) {
        fit();
    }
}

void PassColumns::fit()
{
    const QList<int> columns = m_chosen.value_or(roomyColumns());
    int others = kRowHeight;
    for (int column = kAlways + 1; column < m_passes.columnCount(); ++column) {
        const bool isShown = columns.contains(column);
        header().setSectionHidden(column, !isShown);
        if (isShown) {
            header().resizeSection(column, widthOf(column));
            others += widthOf(column);
        }
    }
    header().resizeSection(PassTable::Favourite, kRowHeight);
    header().resizeSection(PassTable::Satellite,
                           std::max(leastWidthOf(PassTable::Satellite), m_table.viewport()->width() - others));
    tick();
}

// Ticks the columns that are shown now.
void PassColumns::tick()
{
    for (QAction* const action : m_menu->actions()) {
        action->setChecked(action->data().isValid() ? !header().isSectionHidden(action->data().toInt())
                                                    : !m_chosen.has_value());
    }
}

int PassColumns::widthOf(int column) const
{
    const auto seen = m_seen.find(column);
    return std::max(leastWidthOf(column), seen == m_seen.end() ? 0 : seen->second);
}

int PassColumns::leastWidthOf(int column) const
{
    const QFontMetrics metrics(m_table.font());
    if (column == PassTable::Satellite) {
        return kLeastName * metrics.averageCharWidth() + kCellMargins;
    }
    const QString heading = m_passes.headerData(column, Qt::Horizontal, Qt::DisplayRole).toString();
    return std::max(metrics.horizontalAdvance(heading),
                    metrics.horizontalAdvance(PassTable::usual(static_cast<PassTable::Column>(column)))) +
           kCellMargins;
}

int PassColumns::wholeName() const
{
    const int most = kMostName * QFontMetrics(m_table.font()).averageCharWidth() + kCellMargins;
    return std::clamp(m_longestName, leastWidthOf(PassTable::Satellite), most);
}

QList<int> PassColumns::roomyColumns() const
{
    int room = m_table.viewport()->width() - kRowHeight;
    int name = leastWidthOf(PassTable::Satellite);
    QList<int> columns;
    for (const auto& [column, word] : kNames) {
        room -= widthOf(column);
        if (room < name) {
            break;
        }
        columns << column;
        name = column == PassTable::Unwraps ? wholeName() : name;
    }
    return columns;
}

QHeaderView& PassColumns::header() const
{
    return *m_table.horizontalHeader();
}

}  // namespace boresight::ui

#include "moc_pass_columns.cpp"
