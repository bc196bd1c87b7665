// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"

#include <QWidget>

class QDoubleSpinBox;
class QPlainTextEdit;
class QSpinBox;

// Step 2 of finding north: the compass swing. Before its start the page shows where it will turn. Afterwards it shows
// the curve with every sample, and how reliable it is.
namespace boresight::ui {

class CommandButton;
class DeviationPlot;
class RequestDesk;
class RunLine;
class ValueLabel;

class SwingPage : public QWidget
{
    Q_OBJECT

public:
    explicit SwingPage(RequestDesk& desk, QWidget* parent = nullptr);

    void showStatus(const StationStatus& status);

private:
    void build();
    void startOrEnd();
    void plan();

    RequestDesk& m_desk;
    bool m_running = false;
    std::shared_ptr<const SwingOutcome> m_swing;  // the one that is shown
    QDoubleSpinBox* m_rate;
    QSpinBox* m_headings;
    RunLine* m_run;
    DeviationPlot* m_plot;
    QPlainTextEdit* m_found;
    ValueLabel* m_notice;
    CommandButton* m_start;
};

}  // namespace boresight::ui
