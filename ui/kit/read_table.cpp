// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/kit/read_table.h"

#include "ui/kit/theme.h"

#include <QHeaderView>
#include <QTableView>

namespace boresight::ui {

QTableView* makeReadTable(const QString& name, QAbstractItemModel& model, QWidget* parent)
{
    auto* const table = new QTableView(parent);
    table->setModel(&model);
    table->setFont(fonts::label());
    table->setAccessibleName(name);
    table->setSelectionBehavior(QAbstractItemView::SelectRows);
    table->setSelectionMode(QAbstractItemView::SingleSelection);
    table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    table->setTabKeyNavigation(false);
    table->setShowGrid(false);
    table->setWordWrap(false);
    table->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    table->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Expanding);  // the plot gets the remaining room
    const QFontMetrics metrics = table->fontMetrics();
    table->setMinimumHeight(4 * metrics.lineSpacing());
    table->verticalHeader()->hide();
    table->verticalHeader()->setDefaultSectionSize(kRowHeight);
    table->verticalHeader()->setMinimumSectionSize(metrics.lineSpacing());
    QHeaderView* const header = table->horizontalHeader();
    header->setFont(fonts::label());
    header->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    header->setHighlightSections(false);
    header->setSectionResizeMode(QHeaderView::ResizeToContents);
    return table;
}

}  // namespace boresight::ui
