// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"

#include <QCoreApplication>

#include <array>

class QWidget;

// The links of the station in the header: the line to the mount, both drives with their end switches, the orientation
// sensor, the transmit output and the brake. What does not exist takes no room. Gui thread.
namespace boresight::ui {

class ValueLabel;

class LinkLabels
{
    Q_DECLARE_TR_FUNCTIONS(LinkLabels)

public:
    // The labels are children of `header`, which lays them out.
    explicit LinkLabels(QWidget* header);

    void showStatus(const StationStatus& status);

    [[nodiscard]] std::array<QWidget*, 3> ofTheMount() const;
    [[nodiscard]] std::array<QWidget*, 3> besideTheTarget() const;

private:
    ValueLabel* m_line;
    ValueLabel* m_azimuth;
    ValueLabel* m_elevation;
    ValueLabel* m_sensor;
    ValueLabel* m_transmit;
    ValueLabel* m_brake;
};

}  // namespace boresight::ui
