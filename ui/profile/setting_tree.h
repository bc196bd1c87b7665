// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/link/profile_draft.h"

#include <QAbstractItemModel>

#include <vector>

// Every setting of the draft by its name, in the groups of the file: picture, value with its unit, range, and when a
// change applies. The key of the file is in the tooltip. Values are edited in place. An invalid text is refused with
// the reason and changes nothing. A problem found by the live check marks its line. Each list of the profile has one
// line, which says where it is edited.
namespace boresight::ui {

class SettingTree : public QAbstractItemModel
{
    Q_OBJECT

public:
    enum Column
    {
        Name,
        Value,
        Range,
        AppliesWhen,
        ColumnCount
    };
    enum Role
    {
        SearchRole = Qt::UserRole,  // all the text that a search looks through
        ChangedRole,                // not applied yet, waiting for a reconnect, or wrong
        ChoicesRole,                // QStringList: words of the file; empty unless one of them must be chosen
        ChoiceNamesRole,            // QStringList: their names, in the same order
        ShareRole,                  // double: the place in the range, see shareOfRange()
        DefaultShareRole,           // the same for the default
        SecretRole,                 // hidden while it is typed
        ExplanationRole,            // some sentences about the line
        KeyRole                     // QString: the key in the file
    };

    SettingTree(ProfileDraft& draft, QObject* parent);

    [[nodiscard]] QModelIndex index(int row, int column, const QModelIndex& parent = {}) const override;
    [[nodiscard]] QModelIndex parent(const QModelIndex& child) const override;
    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
    [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override;
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;

Q_SIGNALS:
    void refused(const QString& reason);  // empty: the last text was accepted

private:
    struct Line
    {
        std::string key;                            // the key in the file
        std::string comparedAs;                     // the name in profile_diff: "site" for its three settings
        const profile::Setting* setting = nullptr;  // null: a list
    };
    struct Group
    {
        QString title;
        std::vector<Line> lines;
    };
    struct State  // the state of a line, or the number of such lines in a group
    {
        int wrong = 0;
        int edited = 0;
        int waiting = 0;
    };

    void addLine(const QString& table, const Line& line);
    void followDraft();
    [[nodiscard]] const Line* lineOf(const QModelIndex& index) const;
    [[nodiscard]] State stateOf(const Line& line) const;
    [[nodiscard]] State stateOf(const Group& group) const;
    [[nodiscard]] QVariant groupData(const QModelIndex& index, int role) const;
    [[nodiscard]] QVariant lineData(const Line& line, int column, int role) const;
    [[nodiscard]] QString text(const Line& line, int column) const;
    [[nodiscard]] QString heldText(const Line& line, const profile::Profile& profile) const;
    [[nodiscard]] QString valueColumn(const Line& line) const;
    [[nodiscard]] QStringList meaning(const Line& line) const;  // what the columns do not show
    [[nodiscard]] QString explanation(const Line& line) const;  // all of it

    ProfileDraft& m_draft;
    std::vector<Group> m_groups;
    std::vector<std::string> m_editedKeys;
};

}  // namespace boresight::ui
