// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/authority_button.h"

namespace boresight::ui {

AuthorityButton::AuthorityButton(RequestDesk& desk, ValueLabel& notice, QWidget* parent)
    : CommandButton(tr("Hand over"), {}, desk, notice, parent)
{
    connect(this, &QPushButton::clicked, this, [this] {
        ask(m_control == Authority::Operator ? Request(request::GiveAuthority{}) : Request(request::TakeAuthority{}));
    });
}

void AuthorityButton::showStatus(const StationStatus& status)
{
    m_control = status.authority;
    const bool ours = m_control == Authority::Operator;
    setCommand(ours ? tr("Hand over") : tr("Take control"),
               ours ? tr("Let rotctld clients move the mount again")
                    : tr("Keep control for the operator. Boresight refuses motion commands of clients"));
    setBlocked(status.permissions.reason(ours ? Action::GiveAuthority : Action::TakeAuthority));
}

}  // namespace boresight::ui

#include "moc_authority_button.cpp"
