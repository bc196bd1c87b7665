// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/kit/axes.h"

#include <QCoreApplication>

#include <algorithm>

namespace boresight::ui {

QString name(Axis axis)
{
    return axis == Axis::Azimuth ? QCoreApplication::translate("Axes", "azimuth")
                                 : QCoreApplication::translate("Axes", "elevation");
}

QString shortName(Axis axis)
{
    return axis == Axis::Azimuth ? QCoreApplication::translate("Axes", "AZ")
                                 : QCoreApplication::translate("Axes", "EL");
}

QString shortName(Axis axis, const StationStatus& status)
{
    return !hasXY(status) ? shortName(axis) : axis == Axis::Azimuth ? QStringLiteral("X") : QStringLiteral("Y");
}

bool hasXY(const StationStatus& status)
{
    return status.profile->pointing.geometry.kind == pointing::Geometry::XY;
}

std::size_t axisIndex(Axis axis)
{
    return axis == Axis::Azimuth ? 0 : 1;
}

std::optional<Axis> missingAxis(const StationStatus& status)
{
    const auto missing = std::ranges::find_if(kAxes, [&](Axis axis) { return !status.capabilities.has(axis); });
    return missing == kAxes.end() ? std::nullopt : std::optional(*missing);
}

const AxisStatus& axisOf(const StationStatus& status, Axis axis)
{
    return axis == Axis::Azimuth ? status.azimuth : status.elevation;
}

const DrivesStatus& drivesOf(const StationStatus& status)
{
    static const DrivesStatus none;
    return status.drives ? *status.drives : none;
}

const DriveStatus& driveOf(const StationStatus& status, Axis axis)
{
    return axis == Axis::Azimuth ? drivesOf(status).azimuth : drivesOf(status).elevation;
}

bool isTurnKnown(const StationStatus& status, Axis axis)
{
    const bool countsItself = !status.drives && status.capabilities.has(axis) && !axisOf(status, axis).actual;
    return axisOf(status, axis).turnKnown || countsItself;
}

bool isTurnAwaited(const StationStatus& status, Axis axis)
{
    const bool reading = drivesOf(status).driveCheck == DriveCheckState::Running;
    return reading && !isTurnKnown(status, axis) && !driveOf(status, axis).turnQuestion;
}

bool areTurnsKnown(const StationStatus& status)
{
    return isTurnKnown(status, Axis::Azimuth) && isTurnKnown(status, Axis::Elevation);
}

std::optional<Axis> askingAxis(const StationStatus& status)
{
    for (const Axis axis : kAxes) {
        if (driveOf(status, axis).turnQuestion) {
            return axis;
        }
    }
    return std::nullopt;
}

}  // namespace boresight::ui
