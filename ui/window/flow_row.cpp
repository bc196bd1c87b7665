// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/flow_row.h"

#include <algorithm>
#include <utility>

namespace boresight::ui {

FlowRow::FlowRow()
{
    setContentsMargins(0, 0, 0, 0);
    setSpacing(8);
}

FlowRow::~FlowRow() = default;

void FlowRow::addItem(QLayoutItem* item)
{
    m_items.emplace_back(item);
}

QLayoutItem* FlowRow::itemAt(int index) const
{
    return index >= 0 && index < count() ? m_items[static_cast<std::size_t>(index)].get() : nullptr;
}

QLayoutItem* FlowRow::takeAt(int index)
{
    if (index < 0 || index >= count()) {
        return nullptr;
    }
    const auto taken = m_items.begin() + index;
    QLayoutItem* const item = taken->release();
    m_items.erase(taken);
    return item;
}

int FlowRow::heightForWidth(int width) const
{
    return arrange(QRect(0, 0, width, 0), false);
}

// The minimum width is that of the widest item. The height depends on the width.
QSize FlowRow::minimumSize() const
{
    QSize least;
    for (const auto& item : m_items) {
        least = item->isEmpty() ? least : least.expandedTo(item->minimumSize());
    }
    return least;
}

void FlowRow::setGeometry(const QRect& room)
{
    QLayout::setGeometry(room);
    arrange(room, true);
}

int FlowRow::widthFrom(std::size_t item) const
{
    int width = 0;
    for (; item < m_items.size(); ++item) {
        if (!m_items[item]->isEmpty()) {
            width += m_items[item]->sizeHint().width() + (width > 0 ? spacing() : 0);
        }
    }
    return width;
}

int FlowRow::arrange(const QRect& room, bool place) const
{
    QPoint at = room.topLeft();
    int rowHeight = 0;
    bool atTheRight = false;
    for (std::size_t i = 0; i < m_items.size(); ++i) {
        const auto& item = m_items[i];
        if (item->isEmpty()) {
            continue;
        }
        if (item->alignment().testFlag(Qt::AlignRight) && !std::exchange(atTheRight, true)) {
            at.setX(std::max(at.x(), room.right() + 1 - widthFrom(i)));
        }
        const QSize size = item->sizeHint();
        if (at.x() > room.left() && at.x() + size.width() > room.right() + 1) {
            at = QPoint(room.left(), at.y() + rowHeight + spacing());
            rowHeight = 0;
        }
        if (place) {
            item->setGeometry(QRect(at, size));
        }
        at.rx() += size.width() + spacing();
        rowHeight = std::max(rowHeight, size.height());
    }
    return at.y() + rowHeight - room.top();
}

}  // namespace boresight::ui
