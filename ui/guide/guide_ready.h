// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/guide/guide_progress.h"

#include <QWidget>

#include <map>
#include <vector>

class QGridLayout;
class QPushButton;

// The guide's last page: what is done, what was skipped and what needs the operator, each with the way back to it; and
// what the first pass needs: the line of Gpredict, park, STOP. It follows the station and changes nothing.
namespace boresight::ui {

class StepButton;
class ValueLabel;

class GuideReady : public QWidget
{
    Q_OBJECT

public:
    explicit GuideReady(QWidget* parent = nullptr);

    void showStatus(const StationStatus& status, const GuideProgress& progress);

Q_SIGNALS:
    void stepWanted(boresight::ui::GuideStep step);

private:
    void build();
    void showSteps(const StationStatus& status, const GuideProgress& progress);
    void place(const std::vector<StepButton*>& buttons);
    void showFirstPass(const StationStatus& status);
    void copy();

    QString m_gpredict;
    std::map<GuideStep, StepButton*> m_steps;
    ValueLabel* m_summary;
    ValueLabel* m_inTheWay;
    ValueLabel* m_client;
    ValueLabel* m_pass;
    ValueLabel* m_end;
    QPushButton* m_copy;
    QGridLayout* m_grid;  // of the steps
    std::vector<StepButton*> m_placed;
};

}  // namespace boresight::ui
