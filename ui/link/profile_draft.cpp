// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/link/profile_draft.h"

#include "core/profile/commissioning.h"
#include "core/profile/profile_diff.h"
#include "ui/link/setting_words.h"

#include <QPointer>

#include <algorithm>
#include <utility>

namespace boresight::ui {

namespace {

constexpr std::size_t kHistory = 20;  // number of changes that can be undone one after the other

Error draftRefused(const QString& reason)
{
    return {ErrorCode::Refused, reason};
}

}  // namespace

ProfileDraft::ProfileDraft(RequestDesk& desk, QObject* parent)
    : QObject(parent), m_desk(desk), m_inForce(std::make_shared<const profile::Profile>())
{}

void ProfileDraft::showStatus(const StationStatus& status)
{
    const QString obstacle = status.permissions.reason(Action::Reconnect);
    if (std::exchange(m_reconnectObstacle, obstacle) != obstacle) {
        Q_EMIT permissionChanged();
    }
    if (status.profile == m_inForce && status.waitingKeys == m_waitingKeys) {
        return;
    }
    const bool same = *status.profile == *m_inForce && status.waitingKeys == m_waitingKeys;
    m_inForce = status.profile;
    m_waitingKeys = status.waitingKeys;
    if (same) {
        return;
    }
    profile::Profile applied = *m_inForce;
    profile::takeOver(applied, latestAsked(), m_waitingKeys);
    takeApplied(applied);
    Q_EMIT changed();
}

// The newest profile that this window has sent to the station. It includes the values that wait for a reconnect.
const profile::Profile& ProfileDraft::latestAsked() const
{
    return m_asked ? *m_asked : m_accepted ? *m_accepted : *m_inForce;
}

void ProfileDraft::takeApplied(const profile::Profile& applied)
{
    if (applied == m_applied) {
        return;
    }
    const bool ours = applied == latestAsked() && (m_asked || m_accepted);
    if (!ours) {
        m_history.clear();  // undoing would revert what somebody else has applied since
    }
    const bool hadEdits = hasEdits();
    m_applied = applied;
    if (!hadEdits) {
        m_base = applied;
        setEdited(applied);
    } else if (ours && m_alone == applied) {
        mergeEdits();
    } else if (ours || m_edited == applied) {
        m_base = applied;  // edits made while the answer was pending stay edits
    }
    m_problems = problemsOf(m_edited);  // some problems depend on the applied profile
}

// Puts the edits on top of the applied profile.
void ProfileDraft::mergeEdits()
{
    profile::Profile merged = m_applied;
    profile::takeOver(merged, m_edited, editedKeys());
    m_base = m_applied;
    setEdited(merged);
}

void ProfileDraft::setEdited(const profile::Profile& profile)
{
    m_edited = profile;
    m_problems = problemsOf(m_edited);
}

// A mount is simulated by the start of the program, or because its profile names no real bus.
std::vector<profile::Problem> ProfileDraft::problemsOf(const profile::Profile& wanted) const
{
    auto problems = simulates(wanted) ? profile::problemsOf(wanted) : profile::problemsOfReal(wanted);
    if (!simulates(m_applied) && simulates(wanted)) {
        problems.push_back(
            {"bus.name", tr("This is the profile of a real mount. To try it on the simulated mount, start Boresight "
                            "with --simulate")});
    } else if (m_keepsSimulated && wanted.bus != m_applied.bus) {
        problems.push_back(
            {"bus.name",
             tr("Boresight was started with --simulate, so every mount is simulated. To use this bus, start "
                "Boresight with --bus %1")
                 .arg(QString::fromStdString(wanted.bus))});
    }
    return problems;
}

bool ProfileDraft::simulates(const profile::Profile& wanted) const
{
    return m_keepsSimulated || profile::namesNoBus(wanted);
}

void ProfileDraft::edit(const std::function<void(profile::Profile&)>& change)
{
    profile::Profile profile = m_edited;
    change(profile);
    put(profile);
}

void ProfileDraft::takeOver(const profile::Profile& from, std::vector<std::string> keys)
{
    if (simulates(m_edited)) {
        std::erase(keys, "bus.name");  // this key is tried here
    } else if (profile::namesNoBus(from)) {
        std::erase_if(keys, profile::isOfOneMount);
        std::erase(keys, "sensor.source");
    }
    profile::Profile profile = m_edited;
    profile::takeOver(profile, from, keys);
    put(profile);
}

void ProfileDraft::put(const profile::Profile& edited)
{
    if (edited == m_edited) {
        return;
    }
    setEdited(edited);
    if (!hasEdits()) {
        m_base = m_applied;  // all edits were reverted by hand, so no change made elsewhere can conflict
        setEdited(m_applied);
    }
    Q_EMIT changed();
}

std::vector<std::string> ProfileDraft::editedKeys() const
{
    return profile::changedKeys(m_base, m_edited);
}

bool ProfileDraft::leavesSimulation() const
{
    return simulates(m_applied) && !simulates(m_edited);
}

QString ProfileDraft::problem(const std::string& key) const
{
    const auto found = std::ranges::find_if(m_problems, [&key](const profile::Problem& one) {
        return one.key == key || one.key.starts_with(key + '.') || one.key.starts_with(key + '[');
    });
    return found == m_problems.end() ? QString() : found->text;
}

std::vector<std::string> ProfileDraft::overtakenKeys() const
{
    return profile::changedKeys(m_base, m_applied);
}

void ProfileDraft::keepEdits()
{
    mergeEdits();
    Q_EMIT changed();
}

void ProfileDraft::revert()
{
    m_base = m_applied;
    setEdited(m_applied);
    Q_EMIT changed();
}

QString ProfileDraft::whyNoApply() const
{
    if (m_asked) {
        return tr("The station has not answered yet.");
    }
    if (!hasEdits()) {
        return tr("Nothing has been changed.");
    }
    if (m_base != m_applied) {
        return tr("The profile was changed elsewhere. Keep or revert these edits first.");
    }
    if (!m_problems.empty()) {
        return problemText(m_problems.front());
    }
    return leavesSimulation() ? m_reconnectObstacle : QString();
}

QString ProfileDraft::whyNoRevert() const
{
    return hasEdits() ? QString() : tr("Nothing has been changed.");
}

QString ProfileDraft::whyNoUndo() const
{
    if (m_asked) {
        return tr("The station has not answered yet.");
    }
    if (hasEdits()) {
        return tr("Apply or revert the edits first.");
    }
    return m_history.empty() ? tr("No change has been applied here.") : QString();
}

QString ProfileDraft::whyNoReconnect() const
{
    if (m_asked) {
        return tr("The station has not answered yet.");
    }
    return m_waitingKeys.empty() ? tr("Nothing waits for a reconnect.") : m_reconnectObstacle;
}

void ProfileDraft::apply(QObject* asker, const RequestDesk::Reply& reply)
{
    if (const QString reason = whyNoApply(); !reason.isEmpty()) {
        reply(draftRefused(reason));
        return;
    }
    m_alone.reset();
    if (leavesSimulation()) {
        connectReal(asker, reply);
    } else {
        send(m_edited, historyWithApplied(), asker, reply);
    }
}

void ProfileDraft::connectReal(QObject* asker, const RequestDesk::Reply& reply)
{
    const auto answered = [this, reply, to = QPointer<QObject>(asker)](const std::optional<Error>& error) {
        if (!error) {
            revert();  // the profile of the real mount comes with its status
        }
        if (to) {
            reply(error);
        }
    };
    m_desk.send(request::Reconnect{m_edited}, this, answered);
}

ProfileDraft::Profiles ProfileDraft::historyWithApplied() const
{
    Profiles history = m_history;
    if (history.size() >= kHistory) {
        history.erase(history.begin());
    }
    history.push_back(m_applied);
    return history;
}

bool ProfileDraft::isEdited(const std::vector<std::string>& keys) const
{
    const std::vector<std::string> edited = editedKeys();
    return std::ranges::find_first_of(edited, keys) != edited.end();
}

void ProfileDraft::applyAlone(const std::function<void(profile::Profile&)>& change, QObject* asker,
                              const RequestDesk::Reply& reply)
{
    profile::Profile changed = m_applied;
    change(changed);
    const auto problems = problemsOf(changed);
    if (m_asked) {
        reply(draftRefused(tr("The station has not answered yet.")));
    } else if (!problems.empty()) {
        reply(draftRefused(problemText(problems.front())));
    } else if (isEdited(profile::changedKeys(m_applied, changed))) {
        reply(draftRefused(
            tr("This list has edits on the page Profile that are not applied. Apply or revert them first.")));
    } else {
        m_alone = changed;
        send(changed, historyWithApplied(), asker, reply);
    }
}

void ProfileDraft::undo(QObject* asker, const RequestDesk::Reply& reply)
{
    if (const QString reason = whyNoUndo(); !reason.isEmpty()) {
        reply(draftRefused(reason));
        return;
    }
    m_alone.reset();
    send(m_history.back(), Profiles(m_history.begin(), m_history.end() - 1), asker, reply);
}

void ProfileDraft::reconnect(QObject* asker, const RequestDesk::Reply& reply)
{
    if (const QString reason = whyNoReconnect(); !reason.isEmpty()) {
        reply(draftRefused(reason));
        return;
    }
    m_desk.send(request::Reconnect{m_applied}, asker, reply);
}

void ProfileDraft::send(const profile::Profile& profile, Profiles historyThen, QObject* asker,
                        const RequestDesk::Reply& reply)
{
    m_asked = profile;
    Q_EMIT changed();
    const auto answered = [this, historyThen = std::move(historyThen), reply,
                           to = QPointer<QObject>(asker)](const std::optional<Error>& error) {
        if (!error) {
            m_accepted = m_asked;
            m_history = historyThen;
        }
        m_asked.reset();
        Q_EMIT changed();
        if (to) {
            reply(error);
        }
    };
    m_desk.send(request::ApplyProfile{profile}, this, answered);  // handled here even if the asker was deleted
}

}  // namespace boresight::ui

#include "moc_profile_draft.cpp"
