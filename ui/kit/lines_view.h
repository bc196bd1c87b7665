// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QModelIndex>
#include <QWidget>

class QAbstractItemModel;
class QHBoxLayout;
class QPlainTextEdit;
class QTableView;

// A list of lines, with the complete text of the current line below it. Lines can be copied or saved as text. Works
// with any table model that supports the two roles. Gui thread.
namespace boresight::ui {

class ValueLabel;

enum LineRole
{
    WholeTextRole = Qt::UserRole,  // the text below the list
    FileLineRole                   // one line with its date, for the clipboard and for a file
};

class LinesView : public QWidget
{
    Q_OBJECT

public:
    // `lines` must outlive the view. `fileName` is the proposed name of a file.
    LinesView(const QString& name, const QString& fileName, QAbstractItemModel& lines, QWidget* parent = nullptr);

    void addControl(QWidget& control, int stretch = 0);  // above the list, before Copy and File
    void setColumnRoom(int column, const QString& widest);
    void setFollowing();  // The newest line is last, and stays visible while the list is scrolled to its end.
    void select(int row);

    [[nodiscard]] QModelIndex current() const;
    [[nodiscard]] ValueLabel& notice() { return *m_notice; }

Q_SIGNALS:
    void currentChanged();  // another line is current, or the same line has another text

private:
    void buildTable();
    void buildReading();
    void addButtons(const QString& fileName);
    void addCopyKey();
    void showWhole();
    void copy() const;
    void askForName(const QString& proposed);
    void save(const QString& path);
    [[nodiscard]] QString text(QModelIndexList rows) const;
    [[nodiscard]] QModelIndexList allRows() const;

    QAbstractItemModel& m_lines;
    QHBoxLayout* m_controls;
    QTableView* m_table;
    QPlainTextEdit* m_whole;
    ValueLabel* m_notice;
    bool m_atEnd = true;
};

}  // namespace boresight::ui
