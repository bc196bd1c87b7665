// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"

#include <QWidget>

// A balloon or rocket that reports its position: its place, the age of the report, and the button that lets the mount
// track it. Hidden while the profile names no source of positions. Gui thread.
namespace boresight::ui {

class CommandButton;
class RequestDesk;
class ValueLabel;

class PositionBox : public QWidget
{
    Q_OBJECT

public:
    PositionBox(RequestDesk& desk, QWidget* parent = nullptr);

    void showStatus(const StationStatus& status);

private:
    void build();
    void followOrHold();

    ValueLabel* m_place;
    ValueLabel* m_state;
    ValueLabel* m_refused;
    CommandButton* m_follow;
    bool m_isFollowed = false;
};

}  // namespace boresight::ui
