// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/axis_readout.h"

#include "ui/kit/theme.h"
#include "ui/window/axis_card.h"

#include <QVBoxLayout>

namespace boresight::ui {

namespace {

constexpr QSize kUsualFrom{1280, 760};  // of the window
constexpr QSize kLargeFrom{1900, 1000};

Numerals numeralsFor(QSize window)
{
    const auto reaches = [window](QSize size) { return window.expandedTo(size) == window; };
    return reaches(kLargeFrom) ? Numerals::Large : reaches(kUsualFrom) ? Numerals::Usual : Numerals::Small;
}

}  // namespace

AxisReadout::AxisReadout(QWidget* parent)
    : QWidget(parent), m_azimuth(new AxisCard(Axis::Azimuth, this)), m_elevation(new AxisCard(Axis::Elevation, this))
{
    auto* const column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(kGrid / 2);
    column->addWidget(m_azimuth);
    column->addWidget(m_elevation);
}

void AxisReadout::showStatus(const StationStatus& status)
{
    m_azimuth->showStatus(status);
    m_elevation->showStatus(status);
}

void AxisReadout::setRoom(QSize window)
{
    m_azimuth->setNumerals(numeralsFor(window));
    m_elevation->setNumerals(numeralsFor(window));
}

}  // namespace boresight::ui

#include "moc_axis_readout.cpp"
