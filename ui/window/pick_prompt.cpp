// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/pick_prompt.h"

#include "ui/kit/command_button.h"
#include "ui/kit/format.h"
#include "ui/kit/value_label.h"

namespace boresight::ui {

PickPrompt::PickPrompt(RequestDesk& desk, QWidget* parent)
    : PromptBar(tr("Direction under the cursor"), {directionText({359.9_deg, -89.9_deg})}, 1, parent),
      m_goHere(new CommandButton(tr("Go here"), tr("Go to this direction by the shortest way"), desk, notice(), this)),
      m_question(desk, this)
{
    addButton(*m_goHere);
    connect(addButton(tr("Dismiss")), &QPushButton::clicked, this, &PickPrompt::withdraw);
    connect(m_goHere, &QPushButton::clicked, this, &PickPrompt::go);
    connect(m_goHere, &CommandButton::accepted, this, &PickPrompt::withdraw);
    connect(&m_question, &DirectionQuestion::answered, this, &PickPrompt::showVerdict);
}

void PickPrompt::pick(const SkyPointing& direction)
{
    m_picked = direction;
    m_question.ask(direction);
    m_forbidden.clear();
    notice().setValue({});
    setText(directionText(direction));
    showVerdict();  // for the same direction the verdict is already known
    show();
    takeFocus();
    Q_EMIT picked(direction);
}

void PickPrompt::withdraw()
{
    m_picked.reset();
    m_question.drop();
    hide();
    Q_EMIT picked(std::nullopt);
}

void PickPrompt::goTo(const SkyPointing& direction)
{
    pick(direction);
    go();
}

void PickPrompt::go()
{
    if (m_picked) {
        m_goHere->ask(request::PointSky{*m_picked});
    }
}

void PickPrompt::showStatus(const StationStatus& status)
{
    m_whyNoMotion = status.permissions.reason(Action::Point);
    m_question.showStatus(status);
    block();
}

// A refusal of Go here stays as long as the station's verdict about the direction does not change.
void PickPrompt::showVerdict()
{
    const QString forbidden = m_whyNoMotion.isEmpty() ? m_question.whyNot() : QString();
    if (forbidden != m_forbidden) {
        m_forbidden = forbidden;
        notice().setValue(forbidden, Tone::Warning, forbidden.isEmpty() ? Symbol::None : Symbol::Warning);
    }
    block();
}

void PickPrompt::block()
{
    m_goHere->setBlocked(m_whyNoMotion.isEmpty() ? m_question.whyNot() : m_whyNoMotion);
}

}  // namespace boresight::ui

#include "moc_pick_prompt.cpp"
