// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"
#include "ui/link/profile_change.h"

#include <QWidget>

#include <array>
#include <optional>

class QGridLayout;

// The guide's step that shows which motor is which: each axis is moved a little while a button is held, the arrow says
// which way it should have gone, and one press puts right what went wrong. Until the operator has confirmed it the
// station moves nothing farther than 2° or faster than 5 °/s (core/station/first_moves.h).
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
    static constexpr Angle kSeen = 0.3_deg;  // an eye beside the mast sees it

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
        bool turnKnown = false;  // its angles are then others
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
    ValueLabel* m_atTheBox;  // where a direction is changed that is not changed here
};

}  // namespace boresight::ui
