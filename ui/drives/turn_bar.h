// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/units/sky.h"

#include <QWidget>

#include <optional>
#include <vector>

// The travel of an axis with its possible positions: an open mark for each, the chosen one filled, with its angle above
// it. Many positions become fine lines. Axis angles.
namespace boresight::ui {

class TurnBar : public QWidget
{
    Q_OBJECT

public:
    explicit TurnBar(QWidget* parent = nullptr);

    void show(TravelRange travel, const std::vector<Angle>& candidates, std::optional<Angle> chosen);

    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override { return sizeHint(); }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    [[nodiscard]] QRectF bar() const;
    [[nodiscard]] TravelRange range() const;  // travel, and every candidate

    TravelRange m_travel;
    std::vector<Angle> m_candidates;
    std::optional<Angle> m_chosen;
};

}  // namespace boresight::ui
