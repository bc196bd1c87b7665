// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/limits/region_models.h"

#include <algorithm>

namespace boresight::ui {

namespace {

using pointing::HorizonPoint;

QStringList horizonHeaders()
{
    return {DraftTableModel::tr("Az °"), DraftTableModel::tr("El °")};
}

QStringList keepOutHeaders()
{
    return {DraftTableModel::tr("Name"), DraftTableModel::tr("From °"), DraftTableModel::tr("To °"),
            DraftTableModel::tr("Min °"), DraftTableModel::tr("Max °")};
}

}  // namespace

HorizonModel::HorizonModel(ProfileDraft& draft, QObject* parent) : DraftTableModel(draft, horizonHeaders(), parent) {}

std::size_t HorizonModel::rowsOfDraft() const
{
    return edited().limits.horizon.size();
}

QString HorizonModel::text(int row, int column) const
{
    return cellText(profile::horizonSettings(), edited().limits.horizon.at(static_cast<std::size_t>(row)), column);
}

// The points stay sorted, each azimuth once.
Result<> HorizonModel::put(profile::Profile& profile, int row, int column, const QString& text) const
{
    std::vector<HorizonPoint>& horizon = profile.limits.horizon;
    HorizonPoint& point = horizon.at(static_cast<std::size_t>(row));
    const Result<> taken = putCell(profile::horizonSettings(), point, column, text);
    if (!taken) {
        return taken;
    }
    if (std::ranges::count(horizon, point.azimuth, &HorizonPoint::azimuth) > 1) {
        return failure(ErrorCode::InvalidInput, tr("There is already a point at this azimuth."));
    }
    std::ranges::sort(horizon, {}, &HorizonPoint::azimuth);
    return {};
}

std::string HorizonModel::key(int row) const
{
    return rowKey(profile::kHorizonKey, row);
}

KeepOutModel::KeepOutModel(ProfileDraft& draft, QObject* parent) : DraftTableModel(draft, keepOutHeaders(), parent) {}

std::size_t KeepOutModel::rowsOfDraft() const
{
    return edited().limits.keepOuts.size();
}

QString KeepOutModel::text(int row, int column) const
{
    return cellText(profile::keepOutSettings(), edited().limits.keepOuts.at(static_cast<std::size_t>(row)), column);
}

Result<> KeepOutModel::put(profile::Profile& profile, int row, int column, const QString& text) const
{
    return putCell(profile::keepOutSettings(), profile.limits.keepOuts.at(static_cast<std::size_t>(row)), column, text);
}

std::string KeepOutModel::key(int row) const
{
    return rowKey(profile::kKeepOutKey, row);
}

}  // namespace boresight::ui

#include "moc_region_models.cpp"
