// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/link/profile_change.h"

#include "core/profile/profile_diff.h"
#include "ui/kit/command_button.h"
#include "ui/link/setting_words.h"

namespace boresight::ui {

namespace {

Error refused(const QString& reason)
{
    return {ErrorCode::Refused, reason};
}

}  // namespace

void ProfileChange::ask(CommandButton& button, const Edit& edit)
{
    button.await([&](QObject* asker, const RequestDesk::Reply& reply) { send(edit, asker, reply); });
}

profile::Profile ProfileChange::changed(const Edit& edit) const
{
    profile::Profile profile = m_draft.applied();
    edit(profile);
    return profile;
}

bool ProfileChange::isAlready(const Edit& edit) const
{
    return changed(edit) == m_draft.applied();
}

QString ProfileChange::whyNot(const StationStatus& status, const Edit& edit) const
{
    if (m_draft.hasEdits()) {
        return tr("Another panel has changes that are not applied. Apply or revert them first.");
    }
    const profile::Profile wanted = changed(edit);
    if (wanted.bus == m_draft.applied().bus && wanted.bus != m_draft.inForce().bus) {
        return tr("The change to the bus %1 is not in force yet. Press Reconnect first (tab Mount, Profile).")
            .arg(QString::fromStdString(wanted.bus));
    }
    if (const auto problems = m_draft.problemsOf(wanted); !problems.empty()) {
        return problemText(problems.front());
    }
    return needsReconnect(wanted) ? status.permissions.reason(Action::Reconnect) : QString();
}

bool ProfileChange::needsReconnect(const profile::Profile& wanted) const
{
    return !profile::applied(m_draft.inForce(), wanted).waitingKeys.empty();
}

void ProfileChange::send(const Edit& edit, QObject* asker, const RequestDesk::Reply& reply)
{
    if (m_draft.hasEdits()) {
        reply(refused(tr("Another panel has changes that are not applied. Apply or revert them first.")));
        return;
    }
    m_draft.edit(edit);
    if (!m_draft.hasEdits()) {
        reply({});  // the profile already has this value
        return;
    }
    if (const QString reason = m_draft.whyNoApply(); !reason.isEmpty()) {
        m_draft.revert();
        reply(refused(reason));
        return;
    }
    const profile::Profile wanted = m_draft.edited();
    const bool anew = !m_draft.leavesSimulation() && needsReconnect(wanted);
    m_draft.apply(asker, [this, wanted, anew, asker, reply](const std::optional<Error>& error) {
        if (error) {
            m_draft.revert();
        }
        if (error || !anew) {
            reply(error);
        } else {
            m_desk.send(request::Reconnect{wanted}, asker, reply);
        }
    });
}

}  // namespace boresight::ui
