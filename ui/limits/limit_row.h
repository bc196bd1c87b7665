// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"
#include "ui/link/profile_draft.h"

#include <QObject>

class QDoubleSpinBox;
class QGridLayout;

// The limits of one axis in a row of the Limits panel: the lowest, a bar with the actual position, the highest. Axis
// angles.
namespace boresight::ui {

class LimitBar;

class LimitRow : public QObject
{
    Q_OBJECT

public:
    LimitRow(Axis axis, ProfileDraft& draft, QWidget& panel);

    void addTo(QGridLayout& grid, int row);
    void showStatus(const StationStatus& status);

private:
    QDoubleSpinBox* makeField(const QString& name, Angle TravelRange::*end, QWidget& panel);
    void showDraft();
    void showField(QDoubleSpinBox& field, Angle value, Angle TravelRange::*end);
    [[nodiscard]] std::string key(Angle TravelRange::*end) const;

    Axis m_axis;
    ProfileDraft& m_draft;
    TravelRange m_travel;
    QDoubleSpinBox* m_min;
    QDoubleSpinBox* m_max;
    LimitBar* m_bar;
    QLabel* m_caption = nullptr;  // after addTo()
};

}  // namespace boresight::ui
