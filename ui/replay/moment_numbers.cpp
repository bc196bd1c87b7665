// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/replay/moment_numbers.h"

#include "ui/kit/axes.h"
#include "ui/kit/format.h"
#include "ui/kit/value_label.h"
#include "ui/kit/widest.h"

#include <QGridLayout>
#include <QLabel>

namespace boresight::ui {

namespace {

QString torqueText(double torque)
{
    return QStringLiteral("%1 Nm").arg(torque, 0, 'f', 2);
}

QString placeOf(const std::optional<Angle>& angle, Axis axis)
{
    if (!angle) {
        return noValue();
    }
    return axis == Axis::Azimuth ? azimuthText(*angle, 2) : angleText(*angle);
}

}  // namespace

MomentNumbers::MomentNumbers(QWidget* parent)
    : QWidget(parent),
      m_utc(new ValueLabel(tr("UTC"), fonts::clock(), dateText({}), this)),
      m_state(new ValueLabel(tr("State"), fonts::text(), widestStationState(fonts::text()), this))
{
    auto* const grid = new QGridLayout(this);
    grid->setContentsMargins(8, 0, 8, 0);
    grid->setHorizontalSpacing(16);
    grid->setVerticalSpacing(2);
    grid->addWidget(m_utc, 0, 0, 1, 3);
    grid->addWidget(m_state, 0, 3, 1, 2, Qt::AlignRight);
    const QStringList headings{tr("actual"), tr("commanded"), tr("target"), tr("torque")};
    for (int column = 0; column < headings.size(); ++column) {
        auto* const heading = new QLabel(headings[column], this);
        heading->setFont(fonts::label());
        grid->addWidget(heading, 1, column + 1, Qt::AlignRight);
    }
    for (const Axis axis : kAxes) {
        const int row = 2 + static_cast<int>(axisIndex(axis));
        auto* const heading = new QLabel(shortName(axis), this);
        heading->setFont(fonts::label());
        grid->addWidget(heading, row, 0);
        const QString widest = angleText(Angle::fromDegrees(-888.88));
        const QString name = ui::name(axis);
        m_axes[axisIndex(axis)] = {
            .actual = addNumber(*grid, row, 1, tr("Actual %1").arg(name), widest),
            .commanded = addNumber(*grid, row, 2, tr("Commanded %1").arg(name), widest),
            .target = addNumber(*grid, row, 3, tr("Target %1").arg(name), widest),
            .torque = addNumber(*grid, row, 4, tr("Torque of %1").arg(name), torqueText(-888.88))};
    }
    auto* const heading = new QLabel(tr("error"), this);
    heading->setFont(fonts::label());
    grid->addWidget(heading, 4, 0);
    m_error = addNumber(*grid, 4, 1, tr("Error on the sky"), angleText(Angle::fromDegrees(-888.88)));
    for (int column = 1; column <= headings.size(); ++column) {
        grid->setColumnStretch(column, 1);
    }
}

ValueLabel* MomentNumbers::addNumber(QGridLayout& grid, int row, int column, const QString& name, const QString& widest)
{
    auto* const number = new ValueLabel(name, fonts::small(), widest, this);
    number->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    grid.addWidget(number, row, column, Qt::AlignRight);
    return number;
}

void MomentNumbers::show(const StationStatus& status, const QString& state, const std::optional<Angle>& error)
{
    m_utc->setValue(dateText(status.utc));
    const Freshness age = freshness(status.azimuth.age);
    const bool isThere = age != Freshness::NoData;
    const Tone tone = age == Freshness::Live ? Tone::Normal : Tone::Secondary;
    m_state->setValue(isThere ? state : word(AxisState::NoData), tone);
    for (const Axis axis : kAxes) {
        const AxisStatus& one = axisOf(status, axis);
        const AxisLabels& labels = m_axes[axisIndex(axis)];
        const auto put = [&](ValueLabel& label, const std::optional<Angle>& angle) {
            label.setValue(isThere ? placeOf(angle, axis) : noValue(), tone);
        };
        put(*labels.actual, one.beam.actual);
        put(*labels.commanded, one.beam.commanded);
        put(*labels.target, one.beam.target);
        labels.torque->setValue(isThere && one.torque ? torqueText(*one.torque) : QStringLiteral("–"), tone);
    }
    m_error->setValue(isThere && error ? angleText(*error, 3) : noValue(), tone);
}

}  // namespace boresight::ui

#include "moc_moment_numbers.cpp"
