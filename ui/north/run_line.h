// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/calibration_status.h"

#include <QWidget>

class QProgressBar;

// How far a calibration run of one kind is, and how the last of its kind ended: a sentence, and a bar while it runs.
// The room is always the same, so that nothing moves when a run begins.
namespace boresight::ui {

class ValueLabel;

class RunLine : public QWidget
{
    Q_OBJECT

public:
    RunLine(CalibrationRun run, const QString& name, QWidget* parent = nullptr);

    // `otherwise` is said while it neither runs nor has ended yet.
    void showProgress(const CalibrationProgress& progress, const QString& otherwise);

private:
    CalibrationRun m_run;
    bool m_isOurs = false;  // the outcome: of the last run that was seen
    ValueLabel* m_text;
    QProgressBar* m_bar;
};

}  // namespace boresight::ui
