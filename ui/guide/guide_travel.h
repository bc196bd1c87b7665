// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"
#include "ui/link/profile_change.h"

#include <QWidget>

#include <array>

class QDoubleSpinBox;
class QPushButton;

// The guide's step for the ends of both axes: typed, or driven to while a button is held, and set where the mount
// stands. The station lets nothing go beyond the travel in force, so unknown ends are found from inside: a wide travel
// is narrowed. Nothing changes before "Use these ends".
namespace boresight::ui {

class CommandButton;
class HoldButtons;
class LimitBar;
class ValueLabel;

class GuideTravel : public QWidget
{
    Q_OBJECT

public:
    GuideTravel(ProfileChange& change, RequestDesk& desk, QWidget* parent = nullptr);

    void showStatus(const StationStatus& status);

Q_SIGNALS:
    void done();  // the station has taken the ends

private:
    struct Row  // of one axis
    {
        QWidget* box = nullptr;
        QDoubleSpinBox* min = nullptr;
        QDoubleSpinBox* max = nullptr;
        QPushButton* minHere = nullptr;
        QPushButton* maxHere = nullptr;
        LimitBar* bar = nullptr;
        HoldButtons* hold = nullptr;
        TravelRange shown{};  // of the profile, when the fields were filled
    };

    QWidget* makeAxis(Axis axis, RequestDesk& desk);
    QPushButton* makeHere(Axis axis, QDoubleSpinBox& field, const QString& end, QWidget* parent);
    void showAxis(Axis axis);
    [[nodiscard]] TravelRange entered(Axis axis) const;
    [[nodiscard]] ProfileChange::Edit edit() const;

    ProfileChange& m_change;
    StationStatus m_status;
    ValueLabel* m_notice;
    std::array<Row, 2> m_rows;  // by axis
    CommandButton* m_use;
};

}  // namespace boresight::ui
