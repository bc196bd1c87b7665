// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/axis_readout.h"

#include "ui/kit/theme.h"

#include <QBoxLayout>

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

void AxisReadout::arrange(Numerals numerals, CardForm form)
{
    m_numerals = numerals;
    m_form = form;
    m_cards->setDirection(form == CardForm::Wide ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight);
    m_azimuth->arrange(numerals, form);
    m_elevation->arrange(numerals, form);
}

// Measured once: the parts of a card have the size of their templates, whatever they show.
QSize AxisReadout::sizeWith(Numerals numerals, CardForm form)
{
    const std::pair key(numerals, form);
    if (!m_sizes.contains(key)) {
        const std::pair now(m_numerals, m_form);
        arrange(numerals, form);
        m_sizes[key] = minimumSizeHint();
        arrange(now.first, now.second);
    }
    return m_sizes[key];
}

}  // namespace boresight::ui

#include "moc_axis_readout.cpp"
