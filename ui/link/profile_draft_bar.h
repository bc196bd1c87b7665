// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/link/park_remedy.h"
#include "ui/link/profile_draft.h"

#include <QWidget>

#include <optional>

// The bar below every panel that edits the profile: one line about edits that are not applied, wrong, in conflict or
// waiting, and the buttons for them. Keep edits is shown only after a change made elsewhere, Reconnect only while
// something waits, and "Move park" only while the edits make the park position forbidden.
namespace boresight::ui {

class CommandButton;
class ValueLabel;

class ProfileDraftBar : public QWidget
{
    Q_OBJECT

public:
    ProfileDraftBar(ProfileDraft& draft, RequestDesk& desk, QWidget* parent = nullptr);

    void setCollapsing(bool on);  // takes no room while there is nothing to apply, to undo or to report

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
