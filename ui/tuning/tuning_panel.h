// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"

#include <QWidget>

class QStackedWidget;

// The control quality of an axis, and the gains of its drive: two pages for one axis.
namespace boresight::ui {

class ChoiceButton;
class GainsPage;
class MeasurePage;
class RequestDesk;

class TuningPanel : public QWidget
{
    Q_OBJECT

public:
    explicit TuningPanel(RequestDesk& desk, QWidget* parent = nullptr);

    void showStatus(const StationStatus& status);

private:
    enum class Page
    {
        Measure,
        Gains
    };

    void build();
    void setAxis(Axis axis);
    void showPage(Page page);
    void leaveMissingAxis();

    ChoiceButton* m_azimuth;
    ChoiceButton* m_elevation;
    ChoiceButton* m_measureChoice;
    ChoiceButton* m_gainsChoice;
    QStackedWidget* m_pages;
    MeasurePage* m_measure;
    GainsPage* m_gains;
};

}  // namespace boresight::ui
