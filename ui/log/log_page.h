// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/log/log_model.h"

#include <QWidget>

class QCheckBox;
class QComboBox;
class QLineEdit;

// Lines of the log with filters by source, severity and text. One page shows all lines, another only who moved the
// mount, and why.
namespace boresight::ui {

class LinesView;

class LogPage : public QWidget
{
    Q_OBJECT

public:
    enum class Lines
    {
        All,
        MotionStarts
    };

    LogPage(LogModel& model, Lines lines, QWidget* parent = nullptr);

    [[nodiscard]] const LogFilter& shown() const { return *m_filter; }
    // Selects this line of the model. Filters that hide it are cleared.
    void reveal(int row);

private:
    void addSources();
    void addSeverity();
    void addText();

    LogFilter* m_filter;
    LinesView* m_view;
    QComboBox* m_source;
    QCheckBox* m_warnings = nullptr;  // on the page of all lines
    QLineEdit* m_text;
};

}  // namespace boresight::ui
