// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/calibration_status.h"
#include "ui/kit/table_model.h"

#include <vector>

// The terms of the pointing model as a table: the value in effect, the proposed value with its accuracy, and its
// origin. A term was found by the points, held within earlier knowledge, or entered by the operator.
namespace boresight::ui {

class TermModel : public TableModel
{
    Q_OBJECT

public:
    enum Column
    {
        Name,
        Present,
        Proposed,
        Sigma,
        Fit
    };

    explicit TermModel(QObject* parent = nullptr);

    // Shows the proposal if there is one, otherwise only the terms in effect.
    void show(const CalibrationStatus& calibration);

    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;

protected:
    [[nodiscard]] std::size_t rows() const override { return m_rows.size(); }

private:
    struct Row
    {
        QString name;
        Angle present;
        std::optional<Angle> proposed;
        std::optional<Angle> sigma;
        QString fit;
        bool stays = false;

        bool operator==(const Row&) const = default;
    };

    [[nodiscard]] static std::vector<Row> rowsOf(const CalibrationStatus& calibration);
    [[nodiscard]] static QString fitWord(const TermStatus& term, const CalibrationStatus& calibration);
    [[nodiscard]] static QString cell(const Row& row, int column);

    std::vector<Row> m_rows;
};

}  // namespace boresight::ui
