// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/drives_status.h"
#include "core/units/sky.h"
#include "ui/kit/table_model.h"

#include <QStringList>

#include <array>
#include <optional>
#include <vector>

// The safety settings of both drives as one table: one row for each setting, or one for each axis if the axes want
// different values. Settings to be corrected are on top. A verdict is a symbol and a word, and the symbol also marks
// the value in question.
namespace boresight::ui {

class ProtectionModel : public TableModel
{
    Q_OBJECT

public:
    enum Column
    {
        Setting,
        Wanted,
        FoundAzimuth,
        FoundElevation,
        Verdict
    };

    explicit ProtectionModel(QObject* parent = nullptr);

    void show(const DrivesStatus& drives);

    [[nodiscard]] QString explanation(int row) const;  // the values, and why the setting matters
    [[nodiscard]] int count(boresight::Verdict verdict) const;
    [[nodiscard]] QStringList changes() const;    // what Fix would write, one line each
    [[nodiscard]] QStringList leftAlone() const;  // the differences that only a person may change

    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;

protected:
    [[nodiscard]] std::size_t rows() const override { return m_rows.size(); }

private:
    using Lines = std::array<QList<ProtectionLine>, 2>;

    struct Row
    {
        QString label;
        QString key;
        QString wanted;
        QString wantedBrief;
        std::array<std::optional<ProtectionLine>, 2> found;  // by axis
    };

    [[nodiscard]] std::vector<Row> arranged() const;
    void reorder(std::vector<Row> rows);
    [[nodiscard]] static boresight::Verdict verdictOf(const Row& row);
    [[nodiscard]] static Row& rowFor(Axis axis, const ProtectionLine& line, std::vector<Row>& rows);
    [[nodiscard]] QString text(const Row& row, int column) const;
    [[nodiscard]] QString briefText(const Row& row, int column) const;
    [[nodiscard]] std::optional<boresight::Verdict> verdictIn(const Row& row, int column) const;

    Lines m_lines;
    std::vector<Row> m_rows;
};

}  // namespace boresight::ui
