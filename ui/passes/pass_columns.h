// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QStringList>

#include <map>
#include <optional>

class QHeaderView;
class QMenu;
class QTableView;
class QToolButton;

// The columns of the list of passes, and their widths. Star and name are always shown. Without a choice of the operator
// the list has as many columns as the panel has room for, the most important first. Chosen columns always stay. If they
// need more room the list scrolls sideways, so no number is cut off. A column is as wide as its widest visible cell,
// and gets no narrower before the list changes. The name has the rest. Gui thread.
namespace boresight::ui {

class PassTable;

class PassColumns : public QObject
{
    Q_OBJECT

public:
    PassColumns(const PassTable& passes, QTableView& table, QWidget* panel);

    [[nodiscard]] QToolButton* makeButton(
        QWidget* parent);  // opens the menu of the columns; so does a right click on a heading

    // Names for the settings file: "rises", "hidden". Empty: as many columns as fit.
    [[nodiscard]] QStringList chosen() const;
    void choose(const QStringList& names);  // unknown names are ignored

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void makeMenu();
    void keepOffHeader();
    void toggle(int column, bool on);
    void beginAgain();
    void look();
    void fit();
    void tick();
    [[nodiscard]] int widthOf(int column) const;
    [[nodiscard]] int leastWidthOf(int column) const;
    [[nodiscard]] int wholeName() const;
    [[nodiscard]] QList<int> roomyColumns() const;
    [[nodiscard]] QHeaderView& header() const;

    const PassTable& m_passes;
    QTableView& m_table;
    QMenu* m_menu;
    std::optional<QList<int>> m_chosen;
    std::map<int, int> m_seen;  // column, the width of its widest cell that was seen
    int m_longestName = 0;      // px
};

}  // namespace boresight::ui
