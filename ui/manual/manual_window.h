// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>
#include <QUrl>

class QLabel;
class QLineEdit;
class QListWidget;
class QTextBrowser;

// The user manual: its contents at the left, the text at the right, a search above. Not modal: STOP stays in reach. Gui
// thread.
namespace boresight::ui {

// Where the book is in the program's resources.
[[nodiscard]] QUrl manualAddress();

class ManualWindow : public QDialog
{
    Q_OBJECT

public:
    explicit ManualWindow(QWidget* parent = nullptr);

public Q_SLOTS:
    // The next place of what is typed in the search, from the beginning after the end.
    void findNext();

private:
    void listHeadings();
    void showHeading(int row);

    QLineEdit* m_search;
    QLabel* m_notice;  // that nothing was found
    QListWidget* m_contents;
    QTextBrowser* m_text;
};

}  // namespace boresight::ui
