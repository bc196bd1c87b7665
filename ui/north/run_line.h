// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/calibration_status.h"

#include <QWidget>

class QProgressBar;

// The progress of a calibration run of one kind, and the end of the last one: a sentence, and a bar during the run. It
// always takes the same room, so that nothing moves when a run begins.
namespace boresight::ui {

class ValueLabel;

class RunLine : public QWidget
{
    Q_OBJECT

public:
    RunLine(CalibrationRun run, const QString& name, QWidget* parent = nullptr);

    // `otherwise` is shown while there is neither a run nor the result of one.
    void showProgress(const CalibrationProgress& progress, const QString& otherwise);

private:
    CalibrationRun m_run;
    bool m_isOurs = false;  // the outcome belongs to the last run that was seen
    ValueLabel* m_text;
    QProgressBar* m_bar;
};

}  // namespace boresight::ui
