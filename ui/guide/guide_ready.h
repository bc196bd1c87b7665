// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/guide/guide_progress.h"

#include <QWidget>

#include <map>
#include <vector>

class QGridLayout;
class QPushButton;

// The guide's last page. It lists the steps that are done, skipped or need the operator, each with a button that opens
// it. It also shows what the first pass needs: the settings for Gpredict, park and STOP. It shows the station's status
// and changes nothing.
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
    QGridLayout* m_grid;  // of the step buttons
    std::vector<StepButton*> m_placed;
};

}  // namespace boresight::ui
