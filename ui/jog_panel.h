// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/station/station_status.h"
#include "ui/jog_pad.h"
#include "ui/window_settings.h"

#include <QWidget>

#include <map>

class QLineEdit;

// The operator's own motion: the jog pad with its rates and steps, go to a direction, home, park. Typing and selecting
// move nothing; a refusal is shown below the controls, and the typed value stays for correction.
namespace boresight::ui {

class ChoiceButton;
class CommandButton;
class RequestDesk;
class ValueLabel;

class JogPanel : public QWidget
{
    Q_OBJECT

public:
    JogPanel(const Clock& clock, RequestDesk& desk, const WindowSettings& settings, QWidget* parent = nullptr);

    void showStatus(const StationStatus& status);
    void focusGoTo();  // Ctrl+G
    void park();       // Ctrl+P
    void hold();       // Ctrl+H
    void beat();       // a few times a second

    [[nodiscard]] JogPad& pad() { return *m_pad; }

private:
    void build();
    QWidget* makeChoices(const WindowSettings& settings);
    QWidget* makeGoTo();
    void showRates(bool turnsKnown);
    void go();
    void complain(QLineEdit& field, const QString& text);

    ValueLabel* m_notice;
    JogPad* m_pad;
    QLineEdit* m_azimuth;
    QLineEdit* m_elevation;
    CommandButton* m_go;
    CommandButton* m_home;
    CommandButton* m_park;
    std::map<JogRate, ChoiceButton*> m_rates;
    JogRate m_rate = JogRate::Normal;
    QWidget* m_choices;
};

}  // namespace boresight::ui
