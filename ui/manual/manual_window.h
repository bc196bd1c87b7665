// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>
#include <QUrl>

class QLabel;
class QLineEdit;
class QListWidget;
class QTextBrowser;

// The user manual: its contents on the left, the text on the right, a search above. Not modal, so that STOP stays in
// reach. Gui thread.
namespace boresight::ui {

// The address of the manual in the program's resources.
[[nodiscard]] QUrl manualAddress();

class ManualWindow : public QDialog
{
    Q_OBJECT

public:
    explicit ManualWindow(QWidget* parent = nullptr);

public Q_SLOTS:
    // Finds the next match of the search, and starts again at the beginning after the last one.
    void findNext();

private:
    void listHeadings();
    void showHeading(int row);

    QLineEdit* m_search;
    QLabel* m_notice;  // shown when nothing was found
    QListWidget* m_contents;
    QTextBrowser* m_text;
};

}  // namespace boresight::ui
