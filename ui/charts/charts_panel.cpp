// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/charts_panel.h"

#include "ui/charts/strip_charts.h"
#include "ui/kit/push_button.h"
#include "ui/kit/theme.h"

#include <QLabel>
#include <QStackedLayout>
#include <QVBoxLayout>

namespace boresight::ui {

ChartsPanel::ChartsPanel(const Clock& clock, QWidget* parent)
    : QWidget(parent), m_charts(new StripCharts(clock, this)), m_places(new QStackedLayout(this))
{
    m_places->addWidget(makePlaceholder());
    takeBack();
}

QWidget* ChartsPanel::makePlaceholder()
{
    auto* const page = new QWidget(this);
    auto* const column = new QVBoxLayout(page);
    auto* const text = new QLabel(tr("The charts stand in the place of the sky."), page);
    text->setFont(fonts::label());
    text->setAlignment(Qt::AlignCenter);
    QPushButton* const back = makePushButton({.text = tr("Back to this panel"),
                                              .name = tr("Charts back to this panel"),
                                              .help = tr("Show the sky again (Ctrl+L)")},
                                             page);
    connect(back, &QPushButton::clicked, this, [this] { Q_EMIT m_charts->largeWanted(false); });
    column->addStretch(1);
    column->addWidget(text);
    column->addWidget(back, 0, Qt::AlignHCenter);
    column->addStretch(1);
    return page;
}

void ChartsPanel::takeBack()
{
    m_places->addWidget(m_charts);
    m_places->setCurrentWidget(m_charts);
    m_charts->setLarge(false);
}

}  // namespace boresight::ui

#include "moc_charts_panel.cpp"
