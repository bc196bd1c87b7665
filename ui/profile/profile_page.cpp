// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/profile/profile_page.h"

#include "ui/kit/command_button.h"
#include "ui/kit/file_dialog.h"
#include "ui/kit/push_button.h"
#include "ui/kit/value_label.h"
#include "ui/link/profile_draft_bar.h"
#include "ui/profile/antenna_page.h"
#include "ui/profile/settings_view.h"

#include <QComboBox>
#include <QMenu>
#include <QVBoxLayout>

#include <algorithm>

namespace boresight::ui {

ProfilePage::ProfilePage(ProfileDraft& draft, RequestDesk& desk, const QString& configDir, QWidget* parent)
    : AskingPanel(desk, parent),
      m_draft(draft),
      m_mounts(draft, configDir),
      m_choice(new QComboBox(this)),
      m_menuButton(
          makePushButton({.text = tr("Mounts"),
                          .name = tr("Duplicate, rename, import, export the chosen mount"),
                          .help = tr("Duplicate, rename, remove, import or export a mount, or undo the last change")},
                         this)),
      m_menu(new QMenu(m_menuButton)),
      m_settings(new SettingsView(draft, this)),
      m_antennas(new AntennaPage(draft, this)),
      m_notice(new ValueLabel(tr("Outcome"), fonts::label(), {}, this)),
      m_switch(
          new CommandButton(tr("Switch …"), tr("Connect to the chosen mount (asks first)"), desk, *m_notice, this)),
      m_bar(new ProfileDraftBar(draft, desk, this))
{
    build();
    connect(m_switch, &QPushButton::clicked, this, [this] { m_mounts.switchTo(chosen()); });
    connect(m_settings, &SettingsView::antennasWanted, this, &ProfilePage::showAntennas);
    connect(m_antennas, &AntennaPage::settingsWanted, this, &ProfilePage::showSettings);
    connect(m_choice, &QComboBox::currentIndexChanged, this, &ProfilePage::showChoice);
    connect(&m_draft, &ProfileDraft::changed, this, &ProfilePage::showChoice);
    connect(&m_mounts, &StoredMounts::listed, this, &ProfilePage::showMounts);
    connect(&m_mounts, &StoredMounts::asked, this, [this](const Question& question) { askFirst(question, m_status); });
    connect(&m_mounts, &StoredMounts::done, this, &ProfilePage::tell);
    connect(&m_mounts, &StoredMounts::failed, this, &ProfilePage::warn);
    showMounts();
}

void ProfilePage::build()
{
    auto* const column = new QVBoxLayout(&controls());
    column->setContentsMargins(6, 6, 6, 6);
    column->setSpacing(4);
    m_mountRow = makeMountRow();
    column->addWidget(m_mountRow);
    column->addWidget(m_notice);
    column->addWidget(m_settings, 1);
    column->addWidget(m_antennas, 1);
    m_antennas->hide();
    column->addWidget(m_bar);
    m_bar->setCollapsing(true);  // the settings get its room
    m_notice->setStretching(true);
    m_notice->setCollapsing(true);
}

QWidget* ProfilePage::makeMountRow()
{
    auto* const row = new QWidget(this);
    auto* const line = new QHBoxLayout(row);
    line->setContentsMargins(0, 0, 0, 0);
    line->setSpacing(4);
    m_choice->setFont(fonts::label());
    m_choice->setMinimumHeight(kTouchSize);
    m_choice->setMinimumContentsLength(12);
    m_choice->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_choice->setAccessibleName(tr("Stored mounts"));
    m_choice->setToolTip(tr("The mounts of this computer. Choosing one does nothing yet."));
    m_menuButton->setMinimumSize(m_switch->minimumSizeHint());
    m_menuButton->setMenu(m_menu);
    addAction(tr("Duplicate …"), [this] { m_mounts.duplicate(chosen()); });
    addAction(tr("Rename …"), [this] { m_mounts.rename(chosen()); });
    addAction(tr("Undo the last saved change …"), [this] { m_mounts.takeBack(chosen()); });
    m_menu->addSeparator();
    addAction(tr("Import …"), [this] { chooseImport(); });
    addAction(tr("Export …"), [this] { chooseExport(); });
    m_menu->addSeparator();
    addAction(tr("Remove …"), [this] { m_mounts.remove(chosen()); });
    line->addWidget(m_choice, 1);
    line->addWidget(m_switch);
    line->addWidget(m_menuButton);
    return row;
}

void ProfilePage::addAction(const QString& text, const std::function<void()>& act)
{
    m_menu->addAction(text, this, [this, act] {
        tell({});
        act();
    });
}

void ProfilePage::showAntennas()
{
    m_settings->hide();
    m_antennas->show();
    showChoice();
    m_antennas->setFocus();
}

void ProfilePage::showSettings()
{
    m_antennas->hide();
    m_settings->show();
    showChoice();
    m_settings->focusTree();
}

void ProfilePage::seek(const QString& words)
{
    showSettings();
    m_settings->seek(words);
}

void ProfilePage::showStatus(const StationStatus& status)
{
    const bool otherMount = status.profile->mount.name != m_status.profile->mount.name;
    m_status = status;
    if (otherMount) {
        m_choice->setCurrentIndex(-1);  // the new mount is shown
    }
    m_mounts.showStatus(status);
    m_switch->setBlocked(whyNoSwitch());
    showWhetherPossible(status);
}

void ProfilePage::showEvent(QShowEvent* event)
{
    m_mounts.refresh();
    AskingPanel::showEvent(event);
}

// The present selection is kept.
void ProfilePage::showMounts()
{
    const QString before = m_choice->currentData().toString();
    const std::vector<profile::StoredProfile>& mounts = m_mounts.list();
    const QSignalBlocker quiet(m_choice);
    m_choice->clear();
    for (const profile::StoredProfile& mount : mounts) {
        const QString text = m_mounts.isInForce(mount)  ? tr("%1 (in use)").arg(mount.mountName)
                             : !mount.problem.isEmpty() ? tr("▲ %1").arg(mount.mountName)
                                                        : mount.mountName;
        m_choice->addItem(text, mount.mountName);
    }
    auto found = std::ranges::find(mounts, before, &profile::StoredProfile::mountName);
    if (found == mounts.end()) {
        found = std::ranges::find_if(mounts, [this](const auto& one) { return m_mounts.isInForce(one); });
    }
    m_choice->setCurrentIndex(static_cast<int>(found - mounts.begin()));
    showChoice();
}

void ProfilePage::showChoice()
{
    m_switch->setBlocked(whyNoSwitch());
    // Mounts cannot be switched while there are edits. The buttons of the edits, or the antennas, need the room.
    m_mountRow->setVisible(!m_draft.hasEdits() && m_antennas->isHidden());
    if (const QString problem = chosen().problem; !problem.isEmpty()) {
        warn(problem);
    }
}

profile::StoredProfile ProfilePage::chosen() const
{
    const int index = m_choice->currentIndex();
    return index < 0 ? profile::StoredProfile() : m_mounts.list()[static_cast<std::size_t>(index)];
}

void ProfilePage::chooseImport()
{
    const QFileDialog* const dialog = askForFile(*this, tr("Import the profile of a mount"), QFileDialog::AcceptOpen,
                                                 {tr("Profile (*.toml)"), tr("All files (*)")});
    connect(dialog, &QFileDialog::fileSelected, &m_mounts, &StoredMounts::importFile);
}

void ProfilePage::chooseExport()
{
    QFileDialog* const dialog = askForFile(*this, tr("Export the profile of \"%1\"").arg(chosen().mountName),
                                           QFileDialog::AcceptSave, {tr("Profile (*.toml)")});
    dialog->selectFile(chosen().mountName + QStringLiteral(".toml"));
    connect(dialog, &QFileDialog::fileSelected, this,
            [this](const QString& file) { m_mounts.exportTo(file, chosen()); });
}

QString ProfilePage::whyNoSwitch() const
{
    const profile::StoredProfile mount = chosen();
    if (m_mounts.isInForce(mount)) {
        return tr("This mount is in use.");
    }
    if (!mount.problem.isEmpty()) {
        return tr("The file of this mount cannot be read.");
    }
    if (m_draft.hasEdits()) {
        return tr("Apply or revert the edits first.");
    }
    return m_status.permissions.reason(Action::Reconnect);
}

void ProfilePage::tell(const QString& text)
{
    m_notice->setValue(text, Tone::Secondary);
}

void ProfilePage::warn(const QString& reason)
{
    m_notice->setValue(reason, Tone::Warning, Symbol::Warning);
}

}  // namespace boresight::ui

#include "moc_profile_page.cpp"
