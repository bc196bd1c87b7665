// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/link/profile_draft_bar.h"

#include "ui/kit/command_button.h"
#include "ui/kit/value_label.h"
#include "ui/link/setting_words.h"

#include <QVBoxLayout>

namespace boresight::ui {

namespace {

QString listed(const std::vector<std::string>& keys)
{
    QStringList names;
    for (const std::string& key : keys) {
        names << settingName(key);
    }
    return names.join(QStringLiteral(", "));
}

}  // namespace

ProfileDraftBar::ProfileDraftBar(ProfileDraft& draft, RequestDesk& desk, QWidget* parent)
    : QWidget(parent),
      m_draft(draft),
      m_line(new ValueLabel(tr("Changes of the profile"), fonts::label(), {}, this)),
      m_notice(new ValueLabel(tr("Refused"), fonts::label(), {}, this)),
      m_apply(new CommandButton(tr("Apply"), tr("Put the changes in force"), desk, *m_notice, this)),
      m_revert(new CommandButton(tr("Revert"), tr("Drop the changes that are not applied"), desk, *m_notice, this)),
      m_undo(
          new CommandButton(tr("Undo"), tr("Restore the profile from before the last change"), desk, *m_notice, this)),
      m_keep(new CommandButton(tr("Keep edits"), tr("Keep my edits and merge the changes made elsewhere"), desk,
                               *m_notice, this)),
      m_movePark(new CommandButton(tr("Move park"), tr("Move the park position to the nearest permitted place"), desk,
                                   *m_notice, this)),
      m_reconnect(new CommandButton(tr("Reconnect"), tr("Connect to the drives again. The mount must stand still"),
                                    desk, *m_notice, this))
{
    auto* const column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(4);
    column->addWidget(m_line);
    auto* const row = new QHBoxLayout;
    row->setSpacing(4);
    // Move park and Undo share a place, so Apply and Revert keep theirs under the hand of the operator.
    for (CommandButton* const button : {m_apply, m_revert, m_movePark, m_undo, m_keep, m_reconnect}) {
        button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
        row->addWidget(button);
    }
    column->addLayout(row);
    column->addWidget(m_notice);
    m_line->setStretching(true);
    m_notice->setStretching(true);
    m_notice->setCollapsing(true);
    connect(m_apply, &QPushButton::clicked, this,
            [this] { m_apply->await([this](auto* asker, const auto& reply) { m_draft.apply(asker, reply); }); });
    connect(m_undo, &QPushButton::clicked, this,
            [this] { m_undo->await([this](auto* asker, const auto& reply) { m_draft.undo(asker, reply); }); });
    connect(m_reconnect, &QPushButton::clicked, this, [this] {
        m_reconnect->await([this](auto* asker, const auto& reply) { m_draft.reconnect(asker, reply); });
    });
    connect(m_revert, &QPushButton::clicked, &m_draft, &ProfileDraft::revert);
    connect(m_movePark, &QPushButton::clicked, this, [this] {
        if (const auto remedy = m_remedy) {
            m_draft.edit([&remedy](profile::Profile& profile) { profile.park = remedy->place; });
        }
    });
    connect(m_keep, &QPushButton::clicked, &m_draft, &ProfileDraft::keepEdits);
    connect(&m_draft, &ProfileDraft::changed, this, &ProfileDraftBar::showDraft);
    connect(&m_draft, &ProfileDraft::permissionChanged, this, &ProfileDraftBar::showDraft);
    showDraft();
}

void ProfileDraftBar::showDraft()
{
    m_apply->setBlocked(m_draft.whyNoApply());
    m_revert->setBlocked(m_draft.whyNoRevert());
    m_undo->setBlocked(m_draft.whyNoUndo());
    m_reconnect->setBlocked(m_draft.whyNoReconnect());
    const bool overtaken = !m_draft.overtakenKeys().empty();
    m_keep->setVisible(overtaken);
    showRemedy();
    m_undo->setVisible(!overtaken && !m_remedy);
    m_reconnect->setVisible(!m_draft.waitingKeys().empty());
    showLine();
    showOrCollapse();
}

// Shown in place of Undo, which is not available while there are edits.
void ProfileDraftBar::showRemedy()
{
    const auto& problems = m_draft.problems();
    const bool aboutPark = !problems.empty() && problems.front().key.starts_with("park.") && m_draft.hasEdits();
    m_remedy = aboutPark ? parkRemedy(m_draft.edited()) : std::nullopt;
    m_movePark->setVisible(m_remedy.has_value());
    if (m_remedy) {
        m_movePark->setCommand(m_remedy->text, tr("Move the park position to the nearest permitted place"));
    }
}

void ProfileDraftBar::setCollapsing(bool on)
{
    m_collapsing = on;
    showOrCollapse();
}

void ProfileDraftBar::showOrCollapse()
{
    const bool idle = !m_draft.hasEdits() && m_draft.waitingKeys().empty() && m_draft.overtakenKeys().empty() &&
                      m_draft.problems().empty() && !m_draft.whyNoUndo().isEmpty();
    setVisible(!m_collapsing || !idle);
}

// The most important problem, in one line that does not scroll. The complete text is in its tooltip.
void ProfileDraftBar::showLine()
{
    if (const auto overtaken = m_draft.overtakenKeys(); !overtaken.empty()) {
        m_line->setValue(tr("Changed elsewhere: %1").arg(listed(overtaken)), Tone::Warning, Symbol::Warning);
    } else if (!m_draft.problems().empty()) {
        m_line->setValue(problemText(m_draft.problems().front()), Tone::Warning, Symbol::Warning);
    } else if (m_draft.leavesSimulation()) {
        m_line->setValue(tr("Apply ends the simulation. Only these changes reach the real mount: %1")
                             .arg(listed(m_draft.editedKeys())),
                         Tone::Advisory, Symbol::Advisory);
    } else if (m_draft.hasEdits()) {
        m_line->setValue(tr("Not applied: %1").arg(listed(m_draft.editedKeys())), Tone::Accent);
    } else if (!m_draft.waitingKeys().empty()) {
        m_line->setValue(tr("Waits for a reconnect: %1").arg(listed(m_draft.waitingKeys())), Tone::Advisory,
                         Symbol::Advisory);
    } else {
        m_line->setValue(tr("All changes are applied"), Tone::Secondary);
    }
}

}  // namespace boresight::ui

#include "moc_profile_draft_bar.cpp"
