// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/axis_readout.h"

#include "ui/kit/theme.h"

#include <QBoxLayout>

#include <utility>

namespace boresight::ui {

namespace {

constexpr QSize kUsualFrom{1280, 760};  // of the window
constexpr QSize kLargeFrom{1900, 1000};

}  // namespace

Numerals numeralsFor(QSize window)
{
    const auto reaches = [window](QSize size) { return window.expandedTo(size) == window; };
    return reaches(kLargeFrom) ? Numerals::Large : reaches(kUsualFrom) ? Numerals::Usual : Numerals::Small;
}

bool isLow(QSize window)
{
    return numeralsFor(window) == Numerals::Small;
}

AxisReadout::AxisReadout(QWidget* parent)
    : QWidget(parent),
      m_cards(new QBoxLayout(QBoxLayout::TopToBottom, this)),
      m_azimuth(new AxisCard(Axis::Azimuth, this)),
      m_elevation(new AxisCard(Axis::Elevation, this))
{
    m_cards->setContentsMargins(0, 0, 0, 0);
    m_cards->setSpacing(kGrid / 2);
    m_cards->addWidget(m_azimuth, 1);
    m_cards->addWidget(m_elevation, 1);
}

void AxisReadout::showStatus(const StationStatus& status)
{
    m_azimuth->showStatus(status);
    m_elevation->showStatus(status);
}

void AxisReadout::setNumerals(Numerals numerals)
{
    m_numerals = numerals;
    m_cards->setDirection(areBeside(numerals) ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
    m_azimuth->setNumerals(numerals);
    m_elevation->setNumerals(numerals);
}

// Measured once: the parts of a card have the size of their templates, whatever they show.
QSize AxisReadout::sizeWith(Numerals numerals)
{
    if (!m_sizes.contains(numerals)) {
        const Numerals now = m_numerals;
        setNumerals(numerals);
        m_sizes[numerals] = minimumSizeHint();
        setNumerals(now);
    }
    return m_sizes[numerals];
}

}  // namespace boresight::ui

#include "moc_axis_readout.cpp"
