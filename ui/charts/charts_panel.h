// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"

#include <QWidget>

class QVBoxLayout;

// The panel with the charts, while they are not shown beside the panels.
namespace boresight::ui {

class StripCharts;

class ChartsPanel : public QWidget
{
    Q_OBJECT

public:
    explicit ChartsPanel(const Clock& clock, QWidget* parent = nullptr);

    // They may be shown in another place, and come back by takeBack().
    [[nodiscard]] StripCharts& charts() { return *m_charts; }
    void takeBack();

private:
    StripCharts* m_charts;
    QVBoxLayout* m_place;
};

}  // namespace boresight::ui
