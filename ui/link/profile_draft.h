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

// The profile with the operator's edits, one for the whole window: plot, tables and guide edit it together. There are
// three profiles: the one in effect (which the station obeys), the applied one (the same, with changes that wait for a
// reconnect), and the edited one (applied, plus edits that are not applied yet). The station decides: the profile in
// effect is only read from its status. If it changes while there are edits, both are kept, and the operator chooses.
// Gui thread.
namespace boresight::ui {

class ProfileDraft : public QObject
{
    Q_OBJECT

public:
    explicit ProfileDraft(RequestDesk& desk, QObject* parent = nullptr);

    void showStatus(const StationStatus& status);

    // The program was started for the simulated mount: until it ends no bus named by a profile is used.
    void keepSimulated() { m_keepsSimulated = true; }
    [[nodiscard]] bool keepsSimulated() const { return m_keepsSimulated; }

    [[nodiscard]] const profile::Profile& inForce() const { return *m_inForce; }
    [[nodiscard]] const profile::Profile& applied() const { return m_applied; }
    [[nodiscard]] const profile::Profile& edited() const { return m_edited; }
    [[nodiscard]] const std::vector<std::string>& waitingKeys() const { return m_waitingKeys; }

    void edit(const std::function<void(profile::Profile&)>& change);
    // Takes settings from a whole profile, such as a file or an older version. In a simulation the bus stays. A real
    // mount takes no settings that are specific to one mount from a profile that names no real bus.
    void takeOver(const profile::Profile& from, std::vector<std::string> keys);
    [[nodiscard]] bool hasEdits() const { return m_edited != m_base; }
    [[nodiscard]] std::vector<std::string> editedKeys() const;
    // The edits name a real bus while the mount is simulated. Applying them leaves the simulation: the real mount is
    // connected, with these edits on top of its own profile.
    [[nodiscard]] bool leavesSimulation() const;

    // The live check of the edited profile.
    [[nodiscard]] const std::vector<profile::Problem>& problems() const { return m_problems; }
    // The problems of this profile if it replaced the applied one.
    [[nodiscard]] std::vector<profile::Problem> problemsOf(const profile::Profile& wanted) const;
    // The problem of this setting, or of a part of it: "keep_out[2]" also finds "keep_out[2].name". Empty: none.
    [[nodiscard]] QString problem(const std::string& key) const;

    // The settings that were applied from elsewhere since the first edit, usually none. keepEdits() puts the edits on
    // top of them (if both changed the same setting, the edit counts), revert() drops the edits.
    [[nodiscard]] std::vector<std::string> overtakenKeys() const;
    void keepEdits();
    void revert();

    // The reason why it cannot be done now, for the operator. Empty if it can.
    [[nodiscard]] QString whyNoApply() const;
    [[nodiscard]] QString whyNoRevert() const;
    [[nodiscard]] QString whyNoUndo() const;
    [[nodiscard]] QString whyNoReconnect() const;

    // Each asks the station and passes its answer to the asker, or the reason why the station was not asked.
    void apply(QObject* asker, const RequestDesk::Reply& reply);
    // Applies this change alone. Edits that are not applied yet stay edits. Refused if one of them changes the same
    // setting, because applying it would revert the change.
    void applyAlone(const std::function<void(profile::Profile&)>& change, QObject* asker,
                    const RequestDesk::Reply& reply);
    void undo(QObject* asker, const RequestDesk::Reply& reply);       // applies the profile before the last change
    void reconnect(QObject* asker, const RequestDesk::Reply& reply);  // starts again with the applied profile

Q_SIGNALS:
    void changed();
    void permissionChanged();  // whether the station permits a reconnect

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
    profile::Profile m_base;  // the profile on which the edits are based
    profile::Profile m_edited;
    std::vector<profile::Problem> m_problems;
    std::vector<std::string> m_waitingKeys;
    QString m_reconnectObstacle = Permissions().reason(Action::Reconnect);
    std::optional<profile::Profile> m_asked;     // sent, not answered
    std::optional<profile::Profile> m_alone;     // sent by applyAlone(), not yet in effect
    std::optional<profile::Profile> m_accepted;  // the last one that the station accepted
    Profiles m_history;                          // applied earlier, the newest last
};

}  // namespace boresight::ui
