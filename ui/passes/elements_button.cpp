// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/passes/elements_button.h"

#include "ui/kit/file_dialog.h"
#include "ui/kit/theme.h"
#include "ui/link/profile_draft.h"

#include <QMenu>

#include <algorithm>

namespace boresight::ui {

ElementsButton::ElementsButton(ProfileDraft& draft, QWidget* parent)
    : QPushButton(parent), m_draft(draft), m_menu(makeMenu())
{
    setFont(fonts::label());
    setAutoDefault(false);
    setMinimumHeight(kTouchSize);
    connect(this, &QPushButton::clicked, this, [this] {
        if (!m_lacksElements) {  // otherwise the menu opens
            Q_EMIT siteWanted();
        }
    });
    hide();
}

QMenu* ElementsButton::makeMenu()
{
    auto* const menu = new QMenu(this);
    menu->addAction(tr("File …"), this, &ElementsButton::askForElements);
    menu->addSeparator();
    const std::pair<QString, QString> groups[] = {
        {tr("Amateur radio (CelesTrak)"), QStringLiteral("celestrak:amateur")},
        {tr("Space stations (CelesTrak)"), QStringLiteral("celestrak:stations")},
        {tr("Weather (CelesTrak)"), QStringLiteral("celestrak:weather")},
        {tr("Cubesats (CelesTrak)"), QStringLiteral("celestrak:cubesat")}};
    for (const auto& [text, entry] : groups) {
        menu->addAction(text, this, [this, entry] { add(entry); });
    }
    menu->addSeparator();
    menu->addAction(tr("Another address …"), this, &ElementsButton::settingsWanted);
    return menu;
}

void ElementsButton::showStatus(const StationStatus& status)
{
    const bool lacksElements = !status.satellites || status.satellites->empty();
    if (!lacksElements) {
        m_refusal.clear();
    }
    setVisible(lacksElements || !status.profile->site.known);
    if (lacksElements == m_lacksElements && !text().isEmpty()) {
        return;
    }
    m_lacksElements = lacksElements;
    setText(lacksElements ? tr("Add elements") : tr("Enter the site"));
    setAccessibleName(text());
    setToolTip(lacksElements ? tr("Add a file, or a group of CelesTrak") : tr("Open the step Site of the guide"));
    setMinimumWidth(fontMetrics().horizontalAdvance(text()) + kTouchSize);  // with room for the arrow of the menu
    setMenu(lacksElements ? m_menu : nullptr);
}

void ElementsButton::askForElements()
{
    const QFileDialog* const dialog = askForFile(
        *this, tr("Choose a file with orbital elements"), QFileDialog::AcceptOpen,
        {tr("Elements (*.tle *.3le *.txt *.omm *.json *.csv *.xml *.kvn *.sat *.mod)"), tr("All files (*)")});
    connect(dialog, &QFileDialog::fileSelected, this, &ElementsButton::add);
}

void ElementsButton::add(const QString& entry)
{
    m_draft.applyAlone(
        [wanted = entry.toStdString()](profile::Profile& profile) {
            std::vector<std::string>& elements = profile.orbit.elements;
            if (std::ranges::find(elements, wanted) == elements.end()) {
                elements.push_back(wanted);
            }
        },
        this,
        [this](const std::optional<Error>& error) {
            m_refusal = error ? tr("Elements: %1").arg(error->text) : QString();
        });
}

}  // namespace boresight::ui

#include "moc_elements_button.cpp"
