// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/calibration_status.h"
#include "ui/kit/table_model.h"

#include <vector>

// The calibration points as a table, with their residuals for the model in effect and for the fit. On the sky, in
// degrees.
namespace boresight::ui {

class PointModel : public TableModel
{
    Q_OBJECT

public:
    enum Column
    {
        Label,
        Time,
        Sigma,   // the accuracy of the centring
        Before,  // with the model in effect
        After,   // with the fit
        LeftOut
    };

    explicit PointModel(QObject* parent = nullptr);

    void show(const std::vector<PointStatus>& points);

    [[nodiscard]] const PointStatus& point(int row) const { return m_points.at(static_cast<std::size_t>(row)); }

    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;

protected:
    [[nodiscard]] std::size_t rows() const override { return m_points.size(); }

private:
    std::vector<PointStatus> m_points;
};

}  // namespace boresight::ui
