// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"
#include "ui/link/profile_change.h"

#include <QWidget>

#include <array>

class QDoubleSpinBox;
class QPushButton;

// The guide's step for the ends of travel of both axes. An end is typed, or the mount is moved there while a button is
// held, and its position is taken. The station permits no motion beyond the present travel. So unknown ends are found
// from inside: the operator starts with a wide travel and makes it smaller. Nothing changes before "Use these ends".
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
    void done();  // the station has accepted the ends

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
        TravelRange shown{};  // of the profile, when the fields were last filled
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
