// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"

#include <QWidget>

// The Moon of WSJT-X: the content of its azel.dat, whether that content can be used, and the button that lets the mount
// track it. Gui thread.
namespace boresight::ui {

class CommandButton;
class RequestDesk;
class ValueLabel;

class AzelBox : public QWidget
{
    Q_OBJECT

public:
    AzelBox(RequestDesk& desk, QWidget* parent = nullptr);

    void showStatus(const StationStatus& status);

private:
    void build();
    void followOrHold();

    ValueLabel* m_file;
    ValueLabel* m_state;
    ValueLabel* m_refused;
    CommandButton* m_follow;
    bool m_isFollowed = false;
};

}  // namespace boresight::ui
