// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/passes/target_table.h"

#include "ui/kit/format.h"

#include <chrono>

namespace boresight::ui {

namespace {

// The next rise of a satellite may be found later. The clock may also have been set.
constexpr std::chrono::minutes kLookAgain{10};

}  // namespace

TargetTable::TargetTable(QObject* parent)
    : TableModel({tr("Target"), tr("Azimuth"), tr("Elevation"), tr("Next (UTC)")}, parent),
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
            m_places.push_back({.path = targets::TargetPath(target, *site, m_refraction)});
        }
    }
    changeCells();
}

// Rises and sets are looked for again.
void TargetTable::setRefraction(ephemeris::RefractionRule rule)
{
    m_refraction = rule;
    for (Place& place : m_places) {
        if (place.path.rule() != rule) {
            place.path.setRule(rule);
            place.lookedForAt = {};
        }
    }
}

void TargetTable::look(Place& place, UtcTime now)
{
    const auto direction = place.path.at(now);
    place.direction = direction ? std::optional(*direction) : std::nullopt;
    const bool hasSet = place.up && place.up->sets && *place.up->sets <= now;
    if (hasSet || std::chrono::abs(now - place.lookedForAt) >= kLookAgain) {
        const auto up = place.path.nextUp(now);
        place.up = up ? std::optional(*up) : std::nullopt;
        place.lookedForAt = now;
    }
}

void TargetTable::tick(UtcTime now)
{
    m_now = now;
    for (Place& place : m_places) {
        look(place, now);
    }
    changeCells();
}

QString TargetTable::nextText(const Place& place) const
{
    if (!place.up) {
        return tr("not up within a day");
    }
    if (place.up->rises > m_now) {
        return tr("rises %1, in %2").arg(clockText(place.up->rises), waitText(place.up->rises - m_now));
    }
    return place.up->sets ? tr("sets %1, in %2").arg(clockText(*place.up->sets), waitText(*place.up->sets - m_now))
                          : tr("up all day");
}

QVariant TargetTable::data(const QModelIndex& index, int role) const
{
    const bool isNumber = index.column() == Azimuth || index.column() == Elevation;
    if (role == Qt::TextAlignmentRole && isNumber) {
        return QVariant(Qt::AlignRight | Qt::AlignVCenter);
    }
    if (role != Qt::DisplayRole) {
        return {};
    }
    if (index.column() == Name) {
        return target(index.row()).name;
    }
    if (m_places.empty()) {
        return {};
    }
    const Place& place = m_places[std::size_t(index.row())];
    if (index.column() == Next) {
        return nextText(place);
    }
    if (!place.direction) {
        return {};
    }
    return index.column() == Azimuth ? azimuthText(place.direction->azimuth, 1)
                                     : angleText(place.direction->elevation, 1);
}

}  // namespace boresight::ui

#include "moc_target_table.cpp"
