// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/clients/lock_prompt.h"

#include "ui/kit/command_button.h"
#include "ui/kit/value_label.h"

#include <algorithm>

namespace boresight::ui {
namespace {

QString question(const QString& client, const QString& target)
{
    return LockPrompt::tr("%1 is tracking %2. Track it from Boresight's own orbit?").arg(client, target);
}

// The program, or the address of a program that was not recognised.
QString nameOf(const StationStatus& status, std::uint64_t clientId)
{
    const auto found = std::ranges::find(status.clients, clientId, &ClientStatus::id);
    if (found == status.clients.end()) {
        return LockPrompt::tr("A client");
    }
    return found->program.isEmpty() ? found->address : found->program;
}

}  // namespace

LockPrompt::LockPrompt(RequestDesk& desk, QWidget* parent)
    : PromptBar(tr("Boresight knows the target of a client"),
                {question(QStringLiteral("Gpredict or SatDump"), QStringLiteral("METEOR-M2 4"))}, 2, parent),
      m_track(new CommandButton(tr("Track it"),
                                tr("Boresight computes the target itself, so the beam stays on it. The client keeps "
                                   "control"),
                                desk, notice(), this)),
      m_decline(new CommandButton(tr("Not now"),
                                  tr("The points of the client move the mount. Boresight does not ask again about this "
                                     "target"),
                                  desk, notice(), this))
{
    addButton(*m_track);
    addButton(*m_decline);
    const auto answer = [this](CommandButton* button, bool isWanted) {
        connect(button, &QPushButton::clicked, this, [this, button, isWanted] {
            if (m_guard.isOver()) {
                button->ask(request::TrackForClient{
                    .clientId = m_offered.clientId, .target = m_offered.name, .isWanted = isWanted});
            }
        });
    };
    answer(m_track, true);
    answer(m_decline, false);
}

void LockPrompt::showStatus(const StationStatus& status)
{
    if (!status.clientTarget || status.clientTarget->isLocked) {
        hide();
        return;
    }
    if (isHidden() || m_offered != *status.clientTarget) {
        notice().setValue({});
        m_guard.begin();
    }
    m_offered = *status.clientTarget;
    setText(question(nameOf(status, m_offered.clientId), m_offered.name));
    show();
}

}  // namespace boresight::ui

#include "moc_lock_prompt.cpp"
