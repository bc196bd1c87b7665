// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/link/park_remedy.h"
#include "ui/link/profile_draft.h"

#include <QWidget>

#include <optional>

// Below every panel that edits the profile: what is not applied, wrong, overtaken or waiting, in one line, and the
// buttons that decide. Keep edits is there only after a change from elsewhere, Reconnect only while something waits,
// and "Move park" only while the edits leave the park position where the mount may not be.
namespace boresight::ui {

class CommandButton;
class ValueLabel;

class ProfileDraftBar : public QWidget
{
    Q_OBJECT

public:
    ProfileDraftBar(ProfileDraft& draft, RequestDesk& desk, QWidget* parent = nullptr);

    void setCollapsing(bool on);  // takes no room while there is nothing to apply, to take back or to be told

private:
    void showDraft();
    void showLine();
    void showRemedy();
    void showOrCollapse();

    ProfileDraft& m_draft;
    std::optional<ParkRemedy> m_remedy;
    bool m_collapsing = false;
    ValueLabel* m_line;
    ValueLabel* m_notice;
    CommandButton* m_apply;
    CommandButton* m_revert;
    CommandButton* m_undo;
    CommandButton* m_keep;
    CommandButton* m_movePark;
    CommandButton* m_reconnect;
};

}  // namespace boresight::ui
