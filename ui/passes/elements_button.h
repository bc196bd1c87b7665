// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"

#include <QPushButton>

// A button for data that the list of passes needs. Without elements its menu adds a file or a group of CelesTrak to the
// profile. Without a site it opens the page where the site is entered. Hidden if nothing is missing. Gui thread.
namespace boresight::ui {

class ProfileDraft;

class ElementsButton : public QPushButton
{
    Q_OBJECT

public:
    explicit ElementsButton(ProfileDraft& draft, QWidget* parent = nullptr);

    void showStatus(const StationStatus& status);
    // The reason why the station refused the last entry. Empty: it was accepted.
    [[nodiscard]] const QString& refusal() const { return m_refusal; }

Q_SIGNALS:
    void settingsWanted();  // the settings of the elements
    void siteWanted();

private:
    [[nodiscard]] QMenu* makeMenu();
    void askForElements();
    void add(const QString& entry);

    ProfileDraft& m_draft;
    QMenu* m_menu;
    bool m_lacksElements = false;
    QString m_refusal;
};

}  // namespace boresight::ui
