// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/link/profile_draft.h"

#include <QCoreApplication>

#include <functional>
#include <string>

// One change of the profile by one press: put into the draft and applied, with a reconnect if it is needed. A refused
// change leaves no edit behind. Not possible while another panel has edits, because they would be applied along with
// it.
namespace boresight::ui {

class CommandButton;

class ProfileChange
{
    Q_DECLARE_TR_FUNCTIONS(ProfileChange)

public:
    using Edit = std::function<void(profile::Profile&)>;

    ProfileChange(ProfileDraft& draft, RequestDesk& desk) : m_draft(draft), m_desk(desk) {}

    // The button shows "requested" until the station has answered, and then the reason of a refusal.
    void ask(CommandButton& button, const Edit& edit);

    [[nodiscard]] bool isAlready(const Edit& edit) const;  // it would change nothing
    // The reason why it cannot be done now, for the tooltip. Empty if it can.
    [[nodiscard]] QString whyNot(const StationStatus& status, const Edit& edit) const;

    [[nodiscard]] const profile::Profile& applied() const { return m_draft.applied(); }

private:
    [[nodiscard]] profile::Profile changed(const Edit& edit) const;
    [[nodiscard]] bool needsReconnect(const profile::Profile& wanted) const;
    void send(const Edit& edit, QObject* asker, const RequestDesk::Reply& reply);

    ProfileDraft& m_draft;
    RequestDesk& m_desk;
};

}  // namespace boresight::ui
