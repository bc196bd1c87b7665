// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"

#include <QWidget>

class QStackedLayout;

// The place of the charts among the panels; while they stand in the place of the sky it says so.
namespace boresight::ui {

class StripCharts;

class ChartsPanel : public QWidget
{
    Q_OBJECT

public:
    explicit ChartsPanel(const Clock& clock, QWidget* parent = nullptr);

    // They may be lent to another place, and come back by takeBack().
    [[nodiscard]] StripCharts& charts() { return *m_charts; }
    void takeBack();

private:
    QWidget* makePlaceholder();

    StripCharts* m_charts;
    QStackedLayout* m_places;
};

}  // namespace boresight::ui
