// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/kit/asking_panel.h"

#include <array>

class QTableView;

// The runs that measure an axis, one press each, and their figures and curves before and after a change of the gains.
// Also the first tuning, which says what to press next.
namespace boresight::ui {

class ChoiceButton;
class FiguresModel;
class ResponseChart;

class MeasurePage : public AskingPanel
{
    Q_OBJECT

public:
    explicit MeasurePage(RequestDesk& desk, QWidget* parent = nullptr);

    void setAxis(Axis axis);
    void showStatus(const StationStatus& status);

Q_SIGNALS:
    void gainsWanted();  // the next step is on the other page

private:
    void build();
    QTableView* makeTable();
    void choose(TuningRun run);
    void start(TuningRun run);
    void startOrEnd();
    void next();
    void showRun();
    void showFirstTuning();
    [[nodiscard]] const TuningPlan& plan(TuningRun run) const;
    [[nodiscard]] QString obstacle(TuningRun run) const;

    StationStatus m_status;
    Axis m_axis = Axis::Azimuth;
    TuningRun m_run = TuningRun::Step;  // the run whose figures are shown
    std::array<ChoiceButton*, kTuningRuns.size()> m_choices{};
    FiguresModel* m_model;
    QTableView* m_table;
    ResponseChart* m_chart;
    ChoiceButton* m_torque;
    ValueLabel* m_first;
    ValueLabel* m_state;
    ValueLabel* m_notice;
    CommandButton* m_next;
    CommandButton* m_start;
};

}  // namespace boresight::ui
