// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/clients/control_prompt.h"

#include "ui/kit/command_button.h"
#include "ui/kit/value_label.h"

#include <algorithm>

namespace boresight::ui {

namespace {

QString hostOf(const ClientStatus& client)
{
    return client.address.section(QLatin1Char(':'), 0, -2);
}

// The host, or the part that distinguishes it from another client on the same host.
QString shortName(const StationStatus& status, const ClientStatus& client)
{
    const auto sameHost = [&](const ClientStatus& one) { return hostOf(one) == hostOf(client); };
    return std::ranges::count_if(status.clients, sameHost) > 1 ? client.address : hostOf(client);
}

QString question(const QString& name)
{
    return ControlPrompt::tr("%1 asks for control").arg(name);
}

}  // namespace

ControlPrompt::ControlPrompt(RequestDesk& desk, QWidget* parent)
    // The host above the request, so that little of the sky is covered.
    : PromptBar(tr("A client asks for control"), {question(QStringLiteral("192.168.100.100"))}, 2, parent),
      m_give(new CommandButton(tr("Allow control"),
                               tr("This client moves the mount from now on (panel Clients, Ctrl+4)"), desk, notice(),
                               this))
{
    addButton(*m_give);
    QPushButton* const ignoring = addButton(tr("Ignore"));
    ignoring->setToolTip(tr("Boresight does not ask again while this client stays connected"));
    connect(m_give, &QPushButton::clicked, this, [this] {
        if (m_guard.isOver()) {
            m_give->ask(request::GiveControl{.clientId = m_asking});
        }
    });
    connect(ignoring, &QPushButton::clicked, this, &ControlPrompt::ignore);
}

void ControlPrompt::ignore()
{
    m_ignored.insert(m_asking);
    hide();
}

void ControlPrompt::showStatus(const StationStatus& status)
{
    const auto asks = [this](const ClientStatus& client) { return client.wanting && !m_ignored.contains(client.id); };
    // The client in the text does not change when others come, so that nobody allows the wrong one.
    auto found = std::ranges::find_if(status.clients, [&](const auto& one) { return one.id == m_asking && asks(one); });
    if (found == status.clients.end()) {
        found = std::ranges::find_if(status.clients, asks);
    }
    std::erase_if(m_ignored, [&](std::uint64_t id) {
        return std::ranges::find(status.clients, id, &ClientStatus::id) == status.clients.end();
    });
    if (found == status.clients.end()) {
        hide();
        return;
    }
    if (m_asking != found->id || isHidden()) {
        notice().setValue({});
    }
    if (isHidden() || m_asking != found->id) {
        m_guard.begin();  // the client that lost control asks at once
    }
    m_asking = found->id;
    m_give->setBlocked(found->controlObstacle);
    setText(question(shortName(status, *found)));
    show();
}

}  // namespace boresight::ui

#include "moc_control_prompt.cpp"
