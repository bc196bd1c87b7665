// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/charts_panel.h"

#include "ui/charts/strip_charts.h"

#include <QVBoxLayout>

namespace boresight::ui {

ChartsPanel::ChartsPanel(const Clock& clock, QWidget* parent)
    : QWidget(parent), m_charts(new StripCharts(clock, this)), m_place(new QVBoxLayout(this))
{
    m_place->setContentsMargins(0, 0, 0, 0);
    takeBack();
}

void ChartsPanel::takeBack()
{
    m_place->addWidget(m_charts);
    m_charts->show();
}

}  // namespace boresight::ui

#include "moc_charts_panel.cpp"
