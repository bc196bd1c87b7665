// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"
#include "core/profile/profile.h"
#include "core/profile/setting.h"
#include "ui/kit/request_desk.h"

#include <QObject>

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

// The profile as the operator is about to change it, one for the whole window: plot, tables and guide edit it together.
// Three profiles are told apart: in force (what the station obeys), applied (the same, with what waits for a
// reconnect), and edited (applied, with the edits nobody has applied yet). The station decides: what is in force is
// only ever read from its status. When that changes under unapplied edits, both stay, and the operator says which
// counts. Gui thread.
namespace boresight::ui {

class ProfileDraft : public QObject
{
    Q_OBJECT

public:
    explicit ProfileDraft(RequestDesk& desk, QObject* parent = nullptr);

    void showStatus(const StationStatus& status);

    // The program was started for the simulated mount: no bus that a profile names is used until it ends.
    void keepSimulated() { m_keepsSimulated = true; }
    [[nodiscard]] bool keepsSimulated() const { return m_keepsSimulated; }

    [[nodiscard]] const profile::Profile& inForce() const { return *m_inForce; }
    [[nodiscard]] const profile::Profile& applied() const { return m_applied; }
    [[nodiscard]] const profile::Profile& edited() const { return m_edited; }
    [[nodiscard]] const std::vector<std::string>& waitingKeys() const { return m_waitingKeys; }

    void edit(const std::function<void(profile::Profile&)>& change);
    // From a whole profile, such as a file or a version. In a simulation the bus stays. A real mount takes nothing that
    // belongs to one mount alone from a profile that names no real bus.
    void takeOver(const profile::Profile& from, std::vector<std::string> keys);
    [[nodiscard]] bool hasEdits() const { return m_edited != m_base; }
    [[nodiscard]] std::vector<std::string> editedKeys() const;
    // The edits name the bus of a real mount while this one is simulated. To apply them leaves the simulation: the real
    // mount is connected, with these edits on top of its own profile.
    [[nodiscard]] bool leavesSimulation() const;

    // The live check of the edited profile.
    [[nodiscard]] const std::vector<profile::Problem>& problems() const { return m_problems; }
    // What speaks against this one in the place of the applied one.
    [[nodiscard]] std::vector<profile::Problem> problemsOf(const profile::Profile& wanted) const;
    // Of this setting, or of a part of it: "keep_out[2]" also finds "keep_out[2].name". Empty: none.
    [[nodiscard]] QString problem(const std::string& key) const;

    // What was applied from elsewhere since the first edit; empty mostly. Then keepEdits() puts the edits upon it
    // (where both changed the same setting, the edit counts), revert() drops them.
    [[nodiscard]] std::vector<std::string> overtakenKeys() const;
    void keepEdits();
    void revert();

    // Why it can not be done now, for the operator; empty: it can.
    [[nodiscard]] QString whyNoApply() const;
    [[nodiscard]] QString whyNoRevert() const;
    [[nodiscard]] QString whyNoUndo() const;
    [[nodiscard]] QString whyNoReconnect() const;

    // Each asks the station and brings its answer to the asker, or why it was not asked.
    void apply(QObject* asker, const RequestDesk::Reply& reply);
    // Applies this change alone; edits that are not applied yet stay edits. Refused while one of them is an edit of the
    // same: it would take the change back when it is applied.
    void applyAlone(const std::function<void(profile::Profile&)>& change, QObject* asker,
                    const RequestDesk::Reply& reply);
    void undo(QObject* asker, const RequestDesk::Reply& reply);       // applies what was applied before the last change
    void reconnect(QObject* asker, const RequestDesk::Reply& reply);  // begins again with what is applied

Q_SIGNALS:
    void changed();
    void permissionChanged();  // whether the station lets it reconnect

private:
    using Profiles = std::vector<profile::Profile>;

    [[nodiscard]] bool isEdited(const std::vector<std::string>& keys) const;

    [[nodiscard]] bool simulates(const profile::Profile& wanted) const;
    void put(const profile::Profile& edited);
    void setEdited(const profile::Profile& profile);
    void takeApplied(const profile::Profile& applied);
    void mergeEdits();
    [[nodiscard]] Profiles historyWithApplied() const;
    [[nodiscard]] const profile::Profile& latestAsked() const;
    void connectReal(QObject* asker, const RequestDesk::Reply& reply);
    void send(const profile::Profile& profile, Profiles historyThen, QObject* asker, const RequestDesk::Reply& reply);

    RequestDesk& m_desk;
    bool m_keepsSimulated = false;
    std::shared_ptr<const profile::Profile> m_inForce;
    profile::Profile m_applied;
    profile::Profile m_base;  // what the edits were made upon
    profile::Profile m_edited;
    std::vector<profile::Problem> m_problems;
    std::vector<std::string> m_waitingKeys;
    QString m_reconnectObstacle = Permissions().reason(Action::Reconnect);
    std::optional<profile::Profile> m_asked;     // sent, not answered
    std::optional<profile::Profile> m_alone;     // sent by applyAlone(), and not seen in force yet
    std::optional<profile::Profile> m_accepted;  // the last one that the station took
    Profiles m_history;                          // applied before, the newest last
};

}  // namespace boresight::ui
