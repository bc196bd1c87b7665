// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLayout>

#include <memory>
#include <vector>

// Widgets in a row that continues in the next line when they need more width. A hidden widget takes no room. The first
// right-aligned widget and all after it are at the right end, if there is room.
namespace boresight::ui {

class FlowRow : public QLayout
{
public:
    FlowRow();
    ~FlowRow() override;

    void addItem(QLayoutItem* item) override;
    [[nodiscard]] int count() const override { return static_cast<int>(m_items.size()); }
    [[nodiscard]] QLayoutItem* itemAt(int index) const override;
    QLayoutItem* takeAt(int index) override;

    [[nodiscard]] bool hasHeightForWidth() const override { return true; }
    [[nodiscard]] int heightForWidth(int width) const override;
    [[nodiscard]] QSize sizeHint() const override { return minimumSize(); }
    [[nodiscard]] QSize minimumSize() const override;
    void setGeometry(const QRect& room) override;

private:
    // Returns the height.
    int arrange(const QRect& room, bool place) const;
    [[nodiscard]] int widthFrom(std::size_t item) const;

    std::vector<std::unique_ptr<QLayoutItem>> m_items;
};

}  // namespace boresight::ui
