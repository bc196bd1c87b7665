// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/limits/limit_row.h"

#include "ui/kit/axes.h"
#include "ui/kit/caption.h"
#include "ui/kit/command_button.h"
#include "ui/kit/decimal_box.h"
#include "ui/kit/theme.h"
#include "ui/limits/limit_bar.h"
#include "ui/sky/sky_limits.h"

#include <QGridLayout>
#include <QSignalBlocker>

namespace boresight::ui {

namespace {

TravelRange pointing::Region::*rangeOf(Axis axis)
{
    return axis == Axis::Azimuth ? &pointing::Region::azimuth : &pointing::Region::elevation;
}

TravelRange within(const TravelRange& limits, const TravelRange& travel)
{
    return {.min = std::max(limits.min, travel.min), .max = std::min(limits.max, travel.max)};
}

}  // namespace

LimitRow::LimitRow(Axis axis, ProfileDraft& draft, QWidget& panel)
    : QObject(&panel),
      m_axis(axis),
      m_draft(draft),
      m_min(makeField(tr("Lowest %1").arg(name(axis)), &TravelRange::min, panel)),
      m_max(makeField(tr("Highest %1").arg(name(axis)), &TravelRange::max, panel)),
      m_bar(new LimitBar(&panel))
{
    m_bar->setToolTip(tr("Travel of the %1. Hatched: outside the limits. Pointer: present position").arg(name(axis)));
    connect(&m_draft, &ProfileDraft::changed, this, &LimitRow::showDraft);
}

QDoubleSpinBox* LimitRow::makeField(const QString& name, Angle TravelRange::*end, QWidget& panel)
{
    auto* const field = new DecimalBox(&panel);
    field->setFont(fonts::label());
    field->setDecimals(1);
    field->setSingleStep(0.5);
    field->setSuffix(QStringLiteral("°"));
    field->setKeyboardTracking(false);
    field->setAccessibleName(name);
    field->setMinimumHeight(kTouchSize);
    connect(field, &QDoubleSpinBox::valueChanged, this, [this, end](double degrees) {
        m_draft.edit([&](profile::Profile& p) { (p.limits.*rangeOf(m_axis)).*end = Angle::fromDegrees(degrees); });
    });
    return field;
}

void LimitRow::addTo(QGridLayout& grid, int row)
{
    m_caption = makeCaption(shortName(m_axis), *m_min);
    grid.addWidget(m_caption, row, 0);
    grid.addWidget(m_min, row, 1);
    grid.addWidget(m_bar, row, 2);
    grid.addWidget(m_max, row, 3);
}

std::string LimitRow::key(Angle TravelRange::*end) const
{
    return std::string("limits.") + (m_axis == Axis::Azimuth ? "azimuth" : "elevation") +
           (end == &TravelRange::min ? "_min_deg" : "_max_deg");
}

void LimitRow::showStatus(const StationStatus& status)
{
    const AxisStatus& axis = axisOf(status, m_axis);
    if (m_caption != nullptr) {
        m_caption->setText(shortName(m_axis, status));
    }
    if (axis.travel != m_travel) {
        m_travel = axis.travel;
        showDraft();
    }
    m_bar->setActual(isTurnKnown(status, m_axis) ? axis.actual : std::nullopt, freshness(axis.age));
}

void LimitRow::showDraft()
{
    const TravelRange inForce = within(m_draft.inForce().limits.*rangeOf(m_axis), m_travel);
    const TravelRange edited = within(m_draft.edited().limits.*rangeOf(m_axis), m_travel);
    showField(*m_min, edited.min, &TravelRange::min);
    showField(*m_max, edited.max, &TravelRange::max);
    m_bar->setRanges(m_travel, inForce, edited);
}

void LimitRow::showField(QDoubleSpinBox& field, Angle value, Angle TravelRange::*end)
{
    const QSignalBlocker quiet(&field);
    field.setRange(m_travel.min.degrees(), m_travel.max.degrees());
    if (!field.hasFocus() || std::abs(field.value() - value.degrees()) > 0.05) {
        field.setValue(value.degrees());
    }
    const QString problem = m_draft.problem(key(end));
    const QString travel = tr("%1, within the travel %2…%3")
                               .arg(field.accessibleName(), angleText(m_travel.min, 1), angleText(m_travel.max, 1));
    field.setToolTip(problem.isEmpty() ? travel : problem);
}

}  // namespace boresight::ui

#include "moc_limit_row.cpp"
