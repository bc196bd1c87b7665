// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"

#include <QWidget>

#include <optional>

// The azimuth cable: its travel as a bar with a tick each 90°, hatched beyond the ends, a pointer at actual, a mark at
// commanded, a band from 0° (cable not wound) to actual, and the number in words; when the path that is followed leads
// beyond an end, how soon. Angles are mechanical.
namespace boresight::ui {

class CableBar : public QWidget
{
    Q_OBJECT

public:
    explicit CableBar(QWidget* parent = nullptr);

    void showStatus(const StationStatus& status);

    [[nodiscard]] const QString& text() const { return m_text; }
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override { return sizeHint(); }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    [[nodiscard]] QRectF bar() const;

    TravelRange m_travel;
    std::optional<Angle> m_actual;  // empty when it is too old, or the turn is not known
    std::optional<Angle> m_commanded;
    bool m_late = false;
    bool m_ends = false;  // soon
    QString m_text;
};

}  // namespace boresight::ui
