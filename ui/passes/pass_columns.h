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

// Which columns the list of the passes has, and how wide they are. Star and name are always there. By itself it has as
// many as the panel has room for, the most wanted first. Columns that the operator chose stay, and the list is scrolled
// sideways where they need more room: no number is cut. A column is as wide as what is seen of it, and gets no narrower
// until the list is another one. The name has the rest. Gui thread.
namespace boresight::ui {

class PassTable;

class PassColumns : public QObject
{
    Q_OBJECT

public:
    PassColumns(const PassTable& passes, QTableView& table, QWidget* panel);

    [[nodiscard]] QToolButton* makeButton(QWidget* parent);  // to choose them; so does the right button on a heading

    // For people who read the file and for other programs: "rises", "hidden". Empty: as many as there is room for.
    [[nodiscard]] QStringList chosen() const;
    void choose(const QStringList& names);  // names of no column are left out

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
