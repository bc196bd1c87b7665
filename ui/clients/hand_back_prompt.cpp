// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/clients/hand_back_prompt.h"

#include "ui/kit/command_button.h"
#include "ui/kit/value_label.h"

namespace boresight::ui {

HandBackPrompt::HandBackPrompt(RequestDesk& desk, QWidget* parent)
    : PromptBar(tr("Clients are waiting"), {tr("Clients are waiting. Hand back?")}, 1, parent),
      m_handBack(new CommandButton(tr("Hand back"), tr("Clients move the mount from now on"), desk, notice(), this))
{
    setText(tr("Clients are waiting. Hand back?"));
    addButton(*m_handBack);
    QPushButton* const dismissing = addButton(tr("Keep control"));
    dismissing->setToolTip(tr("Boresight still refuses clients. Hand over later on the Clients page"));
    connect(m_handBack, &QPushButton::clicked, this, [this] { m_handBack->ask(request::GiveAuthority{}); });
    connect(dismissing, &QPushButton::clicked, this, &HandBackPrompt::dismiss);
}

void HandBackPrompt::dismiss()
{
    m_dismissed = true;
    hide();
}

void HandBackPrompt::showStatus(const StationStatus& status)
{
    m_dismissed = m_dismissed && status.tookControl;
    const QString obstacle = status.permissions.reason(Action::GiveAuthority);
    const bool wanted = status.tookControl && !m_dismissed && obstacle.isEmpty();
    if (wanted && isHidden()) {
        notice().setValue({});
    }
    setVisible(wanted);
}

}  // namespace boresight::ui

#include "moc_hand_back_prompt.cpp"
