// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/limits/region_models.h"

#include "core/base/numbers.h"
#include "core/profile/setting.h"

#include <algorithm>

namespace boresight::ui {

namespace {

using pointing::HorizonPoint;
using pointing::KeepOut;
using profile::SettingOf;
using profile::SettingType;

constexpr int kRegionModelsDecimals = 1;  // of an angle, unless it has more

template <class Row>
QString cellText(std::span<const SettingOf<Row>> columns, const Row& row, int column)
{
    const profile::SettingValue value = columns[static_cast<std::size_t>(column)].get(row);
    if (const auto* const number = std::get_if<double>(&value)) {
        const bool round = std::abs(*number * 10.0 - std::round(*number * 10.0)) < 1e-6;
        return QString::fromStdString(formatFixed(*number, round ? kRegionModelsDecimals : 3));
    }
    const auto* const text = std::get_if<std::string>(&value);
    return text != nullptr ? QString::fromStdString(*text) : QString();
}

// Degrees may be written with their sign, as the table of another program has them.
template <class Row>
Result<> putCell(std::span<const SettingOf<Row>> columns, Row& row, int column, QString text)
{
    const SettingOf<Row>& setting = columns[static_cast<std::size_t>(column)];
    if (setting.type == SettingType::Text) {
        return setting.set(row, text.toStdString());
    }
    text.remove(QStringLiteral("°"));
    const auto number = parseFinite(text.trimmed().toStdString());
    if (!number) {
        return failure(ErrorCode::InvalidInput,
                       RegionTableModel::tr("\"%1\" is not a number (decimal point, e.g. 113.5)").arg(text));
    }
    return setting.set(row, *number);
}

QStringList horizonHeaders()
{
    return {RegionTableModel::tr("Az °"), RegionTableModel::tr("El °")};
}

QStringList keepOutHeaders()
{
    return {RegionTableModel::tr("Name"), RegionTableModel::tr("From °"), RegionTableModel::tr("To °"),
            RegionTableModel::tr("Min °"), RegionTableModel::tr("Max °")};
}

std::string rowKey(std::string_view list, int row)
{
    return std::string(list) + '[' + std::to_string(row + 1) + ']';
}

}  // namespace

HorizonModel::HorizonModel(ProfileDraft& draft, QObject* parent) : RegionTableModel(draft, horizonHeaders(), parent) {}

std::size_t HorizonModel::rowsOfDraft() const
{
    return region().horizon.size();
}

QString HorizonModel::text(int row, int column) const
{
    return cellText(profile::horizonSettings(), region().horizon.at(static_cast<std::size_t>(row)), column);
}

// The points stay in order, each azimuth once.
Result<> HorizonModel::put(pointing::Region& edited, int row, int column, const QString& text) const
{
    HorizonPoint& point = edited.horizon.at(static_cast<std::size_t>(row));
    const Result<> taken = putCell(profile::horizonSettings(), point, column, text);
    if (!taken) {
        return taken;
    }
    if (std::ranges::count(edited.horizon, point.azimuth, &HorizonPoint::azimuth) > 1) {
        return failure(ErrorCode::InvalidInput, tr("There is already a point at this azimuth."));
    }
    std::ranges::sort(edited.horizon, {}, &HorizonPoint::azimuth);
    return {};
}

std::string HorizonModel::key(int row) const
{
    return rowKey(profile::kHorizonKey, row);
}

KeepOutModel::KeepOutModel(ProfileDraft& draft, QObject* parent) : RegionTableModel(draft, keepOutHeaders(), parent) {}

std::size_t KeepOutModel::rowsOfDraft() const
{
    return region().keepOuts.size();
}

QString KeepOutModel::text(int row, int column) const
{
    return cellText(profile::keepOutSettings(), region().keepOuts.at(static_cast<std::size_t>(row)), column);
}

Result<> KeepOutModel::put(pointing::Region& edited, int row, int column, const QString& text) const
{
    return putCell(profile::keepOutSettings(), edited.keepOuts.at(static_cast<std::size_t>(row)), column, text);
}

std::string KeepOutModel::key(int row) const
{
    return rowKey(profile::kKeepOutKey, row);
}

}  // namespace boresight::ui

#include "moc_region_models.cpp"
