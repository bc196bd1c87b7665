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

// The present and coming passes that match the filter, as a table in the order of their beginning. Favourites have a
// star. Core judges the passes. The table only shows the result. Gui thread.
namespace boresight::ui {

// Counts the passes that are not over.
struct PassCount
{
    std::size_t coming = 0;  // with and without the filter
    std::size_t listed = 0;
    std::size_t satellites = 0;  // number of satellites among the listed passes

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

    // The text for which a column has room from the beginning, so that it does not move while numbers change.
    [[nodiscard]] static QString usual(Column column);
    [[nodiscard]] QString longestName() const;  // of the listed passes

    void show(const std::shared_ptr<const PassBook>& book, UtcTime now);
    void setChoice(const PassChoice& choice);
    void setMarks(const orbit::SatelliteMarks& marks);
    [[nodiscard]] const orbit::SatelliteMarks& marks() const { return m_marks; }
    void tick(UtcTime now);  // removes passes that are over

    [[nodiscard]] const BookedPass& pass(int row) const { return m_book->passes.at(m_rows.at(std::size_t(row))); }
    [[nodiscard]] const std::shared_ptr<const PassBook>& book() const { return m_book; }
    [[nodiscard]] const PassCount& count() const { return m_count; }
    // The row of this pass. `highest` may differ slightly, because a new search finds slightly different times.
    [[nodiscard]] std::optional<int> rowOf(std::int64_t number, UtcTime highest) const;
    // The row of the first pass of this satellite.
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
    std::vector<std::size_t> m_rows;  // indices of passes in the book
    PassDetails* m_details;           // computed when the rows are shown
    PassCount m_count;
    PassChoice m_choice;
    orbit::SatelliteMarks m_marks;
    UtcTime m_now{};
};

}  // namespace boresight::ui
