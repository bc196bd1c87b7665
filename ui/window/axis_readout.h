// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"

#include <QWidget>

// A card for each axis, with numerals that fit the window. Gui thread.
namespace boresight::ui {

class AxisCard;

class AxisReadout : public QWidget
{
    Q_OBJECT

public:
    explicit AxisReadout(QWidget* parent = nullptr);

    void showStatus(const StationStatus& status);
    void setRoom(QSize window);

private:
    AxisCard* m_azimuth;
    AxisCard* m_elevation;
};

}  // namespace boresight::ui
