// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/station/station_status.h"

#include <QWidget>

class QHBoxLayout;
class QStackedWidget;

// What happened, seen in two ways: who moved the mount and why; every event.
namespace boresight::ui {

class ChoiceButton;
class LogModel;
class LogPage;

class LogPanel : public QWidget
{
    Q_OBJECT

public:
    explicit LogPanel(QWidget* parent = nullptr);

    void append(const std::vector<LogEntry>& entries);

    [[nodiscard]] const LogPage& events() const { return *m_events; }
    [[nodiscard]] const LogPage& motions() const { return *m_motions; }

private:
    ChoiceButton* addPage(QWidget& page, const QString& text, const QString& help);

    LogModel* m_model;
    LogPage* m_events;
    LogPage* m_motions;
    QHBoxLayout* m_choice;
    QStackedWidget* m_pages;
};

}  // namespace boresight::ui
