// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"

#include <QWidget>

// Asks whether the sensor applies the declination of the site, and shows what the present answer does to its headings.
namespace boresight::ui {

class CommandButton;
class ProfileChange;
class RequestDesk;
class ValueLabel;

class DeclinationBox : public QWidget
{
    Q_OBJECT

public:
    DeclinationBox(RequestDesk& desk, ProfileChange& change, ValueLabel& notice, QWidget* parent = nullptr);

    void showStatus(const StationStatus& status);

Q_SIGNALS:
    void settingsWanted();

private:
    void build();
    void showEffect(const SensorStatus& sensor);
    void showAnswer(CommandButton& button, geomagnetism::DeclinationBy by, const StationStatus& status);
    void answer(CommandButton& button, geomagnetism::DeclinationBy by);

    ProfileChange& m_change;
    CommandButton* m_yes;
    CommandButton* m_no;
    ValueLabel* m_effect;
};

}  // namespace boresight::ui
