// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"
#include "ui/link/profile_change.h"

#include <QWidget>

#include <array>
#include <optional>

class QGridLayout;

// The guide's step that shows which motor turns which axis. An axis moves slowly while a button is held. The arrow
// shows in which direction it should move. One press exchanges the motors or reverses a direction. Until the operator
// has confirmed the directions, the station moves the mount at most 2° far and at most at 5 °/s
// (core/motion/first_moves.h).
namespace boresight::ui {

class CommandButton;
class DirectionArrow;
class HoldButtons;
class ValueLabel;

class GuideDirections : public QWidget
{
    Q_OBJECT

public:
    static constexpr AngularRate kRate = 1_deg_s;
    static constexpr Angle kSeen = 0.3_deg;  // a person beside the mast sees this motion

    GuideDirections(ProfileChange& change, RequestDesk& desk, QWidget* parent = nullptr);

    void showStatus(const StationStatus& status);

private:
    struct Row  // of one axis
    {
        DirectionArrow* arrow = nullptr;
        HoldButtons* hold = nullptr;
        CommandButton* reverse = nullptr;
        ValueLabel* moved = nullptr;
        std::optional<Angle> origin{};
        Angle farthest{};
        bool turnKnown = false;  // when the wrap becomes known the angles change
    };

    void addAxis(QGridLayout& grid, Axis axis, RequestDesk& desk);
    void follow(Axis axis);
    void showButtons();
    void reverse(Axis axis);

    ProfileChange& m_change;
    StationStatus m_status;
    ValueLabel* m_notice;
    std::array<Row, 2> m_rows;  // by axis
    CommandButton* m_swap;
    CommandButton* m_confirm;
    ValueLabel* m_atTheBox;  // for an axis that can only be reversed at its motor or box
};

}  // namespace boresight::ui
