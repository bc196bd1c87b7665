// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/passes/target_table.h"

#include "ui/kit/format.h"

namespace boresight::ui {

namespace {

QVariant alignmentOf(int column)
{
    return column == TargetTable::Azimuth || column == TargetTable::Elevation
               ? QVariant(Qt::AlignRight | Qt::AlignVCenter)
               : QVariant();
}

QString refractionText(ephemeris::Refraction kind)
{
    switch (kind) {
        case ephemeris::Refraction::Light:
            return TargetTable::tr("optical");
        case ephemeris::Refraction::Radio:
            return TargetTable::tr("radio");
        case ephemeris::Refraction::None:
            break;
    }
    return TargetTable::tr("off");
}

}  // namespace

TargetTable::TargetTable(QObject* parent)
    : TableModel({tr("Target"), tr("Azimuth"), tr("Elevation"), tr("Refraction"), tr("Next (UTC)")}, parent),
      m_targets(targets::objectTargets())
{}

void TargetTable::setSite(const std::optional<Site>& site)
{
    if (site == m_site) {
        return;
    }
    m_site = site;
    m_places.clear();
    if (site) {
        for (const targets::Target& target : m_targets) {
            m_places.emplace_back(target, *site, m_refraction);
        }
    }
    changeCells();
}

void TargetTable::setRefraction(ephemeris::RefractionRule rule)
{
    m_refraction = rule;
    for (targets::TargetPlace& place : m_places) {
        place.setRule(rule);
    }
}

void TargetTable::tick(UtcTime now)
{
    m_now = now;
    for (targets::TargetPlace& place : m_places) {
        place.look(now);
    }
    changeCells();
}

QString TargetTable::nextText(const targets::TargetPlace& place) const
{
    if (!place.up()) {
        return tr("not up within a day");
    }
    if (place.up()->rises > m_now) {
        return tr("rises %1, in %2").arg(clockText(place.up()->rises), waitText(place.up()->rises - m_now));
    }
    return place.up()->sets
               ? tr("sets %1, in %2").arg(clockText(*place.up()->sets), waitText(*place.up()->sets - m_now))
               : tr("up all day");
}

// WSJT-X and many tables show rises and sets without refraction. They differ from these by minutes.
QString TargetTable::help(const targets::TargetPlace& place) const
{
    const ephemeris::Refraction kind = place.path().refractionOfRise();
    if (kind == ephemeris::Refraction::None) {
        return tr("Without refraction, as in WSJT-X.");
    }
    const QString with = kind == ephemeris::Refraction::Light ? tr("The mount tracks with optical refraction.")
                                                              : tr("The mount tracks with radio refraction.");
    targets::TargetPath path = place.path();
    path.setRule(ephemeris::RefractionRule::None);
    const auto up = path.nextUp(m_now);
    if (!up) {
        return with + QLatin1Char('\n') +
               tr("Without refraction (as in WSJT-X) the target does not rise within a day.");
    }
    const bool isUp = up->rises <= m_now;
    if (isUp && !up->sets) {
        return with;
    }
    const QString without = isUp ? tr("Without refraction (as in WSJT-X) the target sets at %1Z.")
                                 : tr("Without refraction (as in WSJT-X) the target rises at %1Z.");
    return with + QLatin1Char('\n') + without.arg(clockText(isUp ? *up->sets : up->rises));
}

QString TargetTable::whyNotTracked(int row) const
{
    if (m_places.empty()) {
        return {};
    }
    const Result<> soon = m_places[std::size_t(row)].isSoon(m_now);
    return soon ? QString() : soon.error().text;
}

QString TargetTable::text(int row, int column) const
{
    if (column == Name) {
        return target(row).name;
    }
    if (m_places.empty()) {
        return {};
    }
    const targets::TargetPlace& place = m_places[std::size_t(row)];
    switch (column) {
        case Next:
            return nextText(place);
        case Refraction:
            return refractionText(place.path().refractionOfRise());
        case Azimuth:
            return place.direction() ? azimuthText(place.direction()->azimuth, 1) : QString();
        default:
            return place.direction() ? angleText(place.direction()->elevation, 1) : QString();
    }
}

QVariant TargetTable::data(const QModelIndex& index, int role) const
{
    const int column = index.column();
    switch (role) {
        case Qt::DisplayRole:
            return text(index.row(), column);
        case Qt::TextAlignmentRole:
            return alignmentOf(column);
        case Qt::ToolTipRole:
            return (column == Refraction || column == Next) && !m_places.empty()
                       ? QVariant(help(m_places[std::size_t(index.row())]))
                       : QVariant();
        default:
            return {};
    }
}

QVariant TargetTable::headerData(int section, Qt::Orientation orientation, int role) const
{
    return orientation == Qt::Horizontal && role == Qt::TextAlignmentRole
               ? alignmentOf(section)
               : TableModel::headerData(section, orientation, role);
}

}  // namespace boresight::ui

#include "moc_target_table.cpp"
