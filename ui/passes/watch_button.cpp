// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/passes/watch_button.h"

#include "ui/link/profile_draft.h"

#include <algorithm>

namespace boresight::ui {

namespace {

bool isIn(const std::vector<schedule::WatchEntry>& watched, int satellite)
{
    return std::ranges::find(watched, satellite, &schedule::WatchEntry::number) != watched.end();
}

}  // namespace

WatchButton::WatchButton(ProfileDraft& draft, RequestDesk& desk, ValueLabel& notice, QWidget* parent)
    : CommandButton(tr("Add to schedule"), {}, desk, notice, parent), m_draft(draft)
{
    connect(this, &QPushButton::clicked, this, &WatchButton::watchOrNot);
}

void WatchButton::show(const std::optional<std::int64_t>& satellite, const std::vector<schedule::WatchEntry>& watched)
{
    m_satellite = satellite ? std::optional(static_cast<int>(*satellite)) : std::nullopt;
    const bool isWatched = m_satellite && isIn(watched, *m_satellite);
    setCommand(isWatched ? tr("Remove from schedule") : tr("Add to schedule"),
               isWatched ? tr("Remove this satellite from the schedule")
                         : tr("The armed schedule tracks each pass of this satellite"));
    setBlocked(m_satellite ? QString() : tr("Select a pass first."));
}

void WatchButton::watchOrNot()
{
    await([&](QObject* asker, const RequestDesk::Reply& reply) {
        m_draft.applyAlone(
            [satellite = *m_satellite](profile::Profile& profile) {
                std::vector<schedule::WatchEntry>& watched = profile.schedule.watch;
                if (isIn(watched, satellite)) {
                    std::erase_if(watched, [&](const schedule::WatchEntry& one) { return one.number == satellite; });
                } else {
                    watched.push_back({.number = satellite});
                }
            },
            asker, reply);
    });
}

}  // namespace boresight::ui

#include "moc_watch_button.cpp"
