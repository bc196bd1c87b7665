// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/link/profile_draft.h"

#include <QWidget>

class QHBoxLayout;
class QTableView;

// The page to add, name, measure and remove the antennas of the mount. Changes go to the draft, like all settings. Gui
// thread.
namespace boresight::ui {

class AntennaModel;
class ValueLabel;

class AntennaPage : public QWidget
{
    Q_OBJECT

public:
    explicit AntennaPage(ProfileDraft& draft, QWidget* parent = nullptr);

Q_SIGNALS:
    void settingsWanted();  // back to the settings

private:
    void buildTable();
    [[nodiscard]] QHBoxLayout* makeButtons();
    void add();
    void removeCurrent();
    void explain();
    void refuse(const QString& reason);

    ProfileDraft& m_draft;
    AntennaModel* m_model;
    QTableView* m_table;
    ValueLabel* m_line;  // the meaning of the current column, or the reason of a refusal
};

}  // namespace boresight::ui
