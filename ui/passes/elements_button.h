// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"

#include <QPushButton>

// What the list of passes lacks: without elements a menu adds a file or a group of CelesTrak to the profile, without a
// site it leads to where the site is entered. Not there when nothing is lacking. Gui thread.
namespace boresight::ui {

class ProfileDraft;

class ElementsButton : public QPushButton
{
    Q_OBJECT

public:
    explicit ElementsButton(ProfileDraft& draft, QWidget* parent = nullptr);

    void showStatus(const StationStatus& status);
    // Why the station did not take the last entry; empty: it did.
    [[nodiscard]] const QString& refusal() const { return m_refusal; }

Q_SIGNALS:
    void settingsWanted();  // of the elements
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
