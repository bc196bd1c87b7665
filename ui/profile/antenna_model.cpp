// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/profile/antenna_model.h"

#include <algorithm>

namespace boresight::ui {

namespace {

QStringList antennaHeaders()
{
    return {AntennaModel::tr("Name"), AntennaModel::tr("Beam °"), AntennaModel::tr("Across °"),
            AntennaModel::tr("Up °")};
}

bool isFixed(const QModelIndex& index)
{
    return index.row() == 0 && index.column() != AntennaModel::BeamWidth;
}

// When an antenna is renamed, its satellites keep it. Returns their number.
std::size_t giveSatellites(profile::Profile& profile, const std::string& from, const std::string& to)
{
    const orbit::SatelliteMarks before = profile.satellites;
    std::size_t given = 0;
    for (const orbit::SatelliteMark& one : before) {
        if (one.antenna == from) {
            orbit::setAntenna(profile.satellites, one.number, to);
            ++given;
        }
    }
    return given;
}

bool isTaken(const profile::Profile& profile, const std::string& name)
{
    const std::vector<pointing::Antenna> all = profile.allAntennas();
    return std::ranges::find(all, name, &pointing::Antenna::name) != all.end();
}

}  // namespace

AntennaModel::AntennaModel(ProfileDraft& draft, QObject* parent) : DraftTableModel(draft, antennaHeaders(), parent) {}

QVariant AntennaModel::data(const QModelIndex& index, int role) const
{
    const QVariant value = DraftTableModel::data(index, role);
    return role == Qt::ToolTipRole && index.isValid() && isFixed(index)
               ? tr("The offsets of the other antennas are measured from the main antenna.")
               : value;
}

Qt::ItemFlags AntennaModel::flags(const QModelIndex& index) const
{
    const Qt::ItemFlags usual = DraftTableModel::flags(index);
    return isFixed(index) ? usual & ~Qt::ItemFlags(Qt::ItemIsEditable) : usual;
}

std::size_t AntennaModel::rowsOfDraft() const
{
    return 1 + edited().antennas.size();
}

QString AntennaModel::text(int row, int column) const
{
    return cellText(profile::antennaSettings(), edited().allAntennas().at(static_cast<std::size_t>(row)), column);
}

// A name that is in use is refused here, because the antennas of satellites would be mixed up.
Result<> AntennaModel::put(profile::Profile& profile, int row, int column, const QString& text) const
{
    if (row == 0) {
        pointing::Antenna main = profile.allAntennas().front();
        return putCell(profile::antennaSettings(), main, column, text).map([&] {
            profile.mount.beamWidth = main.beamWidth;
        });
    }
    pointing::Antenna& antenna = profile.antennas.at(static_cast<std::size_t>(row) - 1);
    const pointing::Antenna before = antenna;
    if (column == Name && text.toStdString() != before.name && isTaken(profile, text.toStdString())) {
        return failure(ErrorCode::InvalidInput, tr("There is already an antenna \"%1\".").arg(text));
    }
    return putCell(profile::antennaSettings(), antenna, column, text).map([&] {
        giveSatellites(profile, before.name, antenna.name);
    });
}

std::string AntennaModel::key(int row) const
{
    return row == 0 ? std::string("mount.beam_width_deg") : rowKey(profile::kAntennaKey, row - 1);
}

void addAntenna(profile::Profile& profile)
{
    std::string name;
    for (std::size_t number = profile.antennas.size() + 2; name.empty() || isTaken(profile, name); ++number) {
        name = AntennaModel::tr("Antenna %1").arg(number).toStdString();
    }
    profile.antennas.push_back({.name = name, .beamWidth = profile.mount.beamWidth});
}

std::size_t removeAntenna(profile::Profile& profile, std::size_t index)
{
    const std::string name = profile.antennas.at(index).name;
    profile.antennas.erase(profile.antennas.begin() + static_cast<std::ptrdiff_t>(index));
    return giveSatellites(profile, name, {});
}

}  // namespace boresight::ui

#include "moc_antenna_model.cpp"
