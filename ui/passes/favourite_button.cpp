// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/passes/favourite_button.h"

#include "ui/link/profile_draft.h"

namespace boresight::ui {

FavouriteButton::FavouriteButton(ProfileDraft& draft, RequestDesk& desk, ValueLabel& notice, QWidget* parent)
    : CommandButton(tr("Add to favourites"), {}, desk, notice, parent), m_draft(draft)
{
    connect(this, &QPushButton::clicked, this, [this] { toggle(*m_satellite); });
}

void FavouriteButton::show(const std::optional<int>& satellite, const orbit::SatelliteMarks& marks)
{
    m_satellite = satellite;
    const bool isOne = satellite && orbit::isFavourite(marks, *satellite);
    setCommand(isOne ? tr("Remove from favourites") : tr("Add to favourites"),
               isOne ? tr("Remove the star of this satellite (Space in the table)")
                     : tr("Give this satellite a star and a place in the timeline (Space in the table)"));
    setBlocked(satellite ? QString() : tr("Select a pass first."));
}

void FavouriteButton::toggle(int satellite)
{
    await([&](QObject* asker, const RequestDesk::Reply& reply) {
        m_draft.applyAlone(
            [satellite](profile::Profile& profile) {
                orbit::setFavourite(profile.satellites, satellite, !orbit::isFavourite(profile.satellites, satellite));
            },
            asker, reply);
    });
}

}  // namespace boresight::ui

#include "moc_favourite_button.cpp"
