// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/link/profile_draft.h"

#include <QWidget>

class QComboBox;
class QLineEdit;
class QModelIndex;
class QPushButton;
class QTreeView;

// The settings of the draft to read and to edit: a search, a choice of what is shown, the groups, and the meaning of
// the selected line. Enter edits the selected value. A choice opens its list.
namespace boresight::ui {

class BeamBox;
class SettingFilter;
class SettingPictureView;
class SettingTree;
class ValueLabel;

class SettingsView : public QWidget
{
    Q_OBJECT

public:
    explicit SettingsView(ProfileDraft& draft, QWidget* parent = nullptr);

    void focusTree();
    void seek(const QString& words);  // as if typed into the search

Q_SIGNALS:
    void antennasWanted();  // the table of the antennas, which have more than one value

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void buildTree();
    [[nodiscard]] int roomFor(const QString& widest) const;
    void fitNames();
    QWidget* makeSearch();
    void search(const QString& text);
    void showChangedOnly(bool on);
    void spanSections();
    void expandIfSought();
    void openEditor(const QModelIndex& index);
    void explain();

    SettingTree* m_model;
    SettingFilter* m_filter;
    QLineEdit* m_search;
    QComboBox* m_shown;
    QTreeView* m_tree;
    SettingPictureView* m_picture;
    ValueLabel* m_explanation;
    BeamBox* m_beam;          // below the explanation of the beam width
    QPushButton* m_antennas;  // below the explanation of the antennas
    QString m_refusal;
};

}  // namespace boresight::ui
