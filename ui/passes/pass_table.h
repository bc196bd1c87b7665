// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/elements/satellite_mark.h"
#include "ui/kit/table_model.h"
#include "ui/passes/pass_book.h"
#include "ui/passes/pass_details.h"
#include "ui/passes/pass_filter.h"

#include <memory>
#include <optional>
#include <vector>

// The passes that are still to come, or go on, as a table in the order in which they begin, as far as they were chosen.
// Favourites have a star. What a pass is worth is judged by core: the table only shows it. Gui thread.
namespace boresight::ui {

// Of the passes that are not over.
struct PassCount
{
    std::size_t coming = 0;  // listed or not
    std::size_t listed = 0;
    std::size_t satellites = 0;  // of what is listed

    bool operator==(const PassCount&) const = default;
};

class PassTable : public TableModel
{
    Q_OBJECT

public:
    enum Column
    {
        Favourite,
        Satellite,
        Rises,
        Until,
        HighestAt,
        Sets,
        Highest,
        Lasts,
        Hidden,
        Unwraps,
        Sunlit,
        Elements
    };

    explicit PassTable(QObject* parent = nullptr);

    // What a cell has room for from the beginning, so that its column does not move while the numbers change.
    [[nodiscard]] static QString usual(Column column);
    [[nodiscard]] QString longestName() const;  // of those that are listed

    void show(const std::shared_ptr<const PassBook>& book, UtcTime now);
    void setChoice(const PassChoice& choice);
    void setMarks(const orbit::SatelliteMarks& marks);
    [[nodiscard]] const orbit::SatelliteMarks& marks() const { return m_marks; }
    void tick(UtcTime now);  // passes that are over go

    [[nodiscard]] const BookedPass& pass(int row) const { return m_book->passes.at(m_rows.at(std::size_t(row))); }
    [[nodiscard]] const std::shared_ptr<const PassBook>& book() const { return m_book; }
    [[nodiscard]] const PassCount& count() const { return m_count; }
    // Of the same satellite, at nearly the same time: a new search finds it a little different.
    [[nodiscard]] std::optional<int> rowOf(std::int64_t number, UtcTime highest) const;
    // The first one of this satellite.
    [[nodiscard]] std::optional<int> nextOf(std::int64_t number) const;

    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

protected:
    [[nodiscard]] std::size_t rows() const override { return m_rows.size(); }

private:
    void select();
    void showDetails(std::size_t pass);
    void countAgain();
    [[nodiscard]] bool isFavourite(const BookedPass& one) const;
    [[nodiscard]] QVariant star(const BookedPass& one, int role) const;
    [[nodiscard]] QString text(std::size_t pass, int column) const;
    [[nodiscard]] QString detail(std::size_t pass, int column) const;
    [[nodiscard]] QString help(std::size_t pass, int column) const;

    std::shared_ptr<const PassBook> m_book = std::make_shared<const PassBook>();
    std::vector<std::size_t> m_rows;  // into the passes of the book
    PassDetails* m_details;           // worked out when they are seen
    PassCount m_count;
    PassChoice m_choice;
    orbit::SatelliteMarks m_marks;
    UtcTime m_now{};
};

}  // namespace boresight::ui
