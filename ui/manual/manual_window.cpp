// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/manual/manual_window.h"

#include "ui/kit/theme.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QScrollBar>
#include <QShortcut>
#include <QTextBlock>
#include <QTextBrowser>
#include <QTextDocument>
#include <QVBoxLayout>

namespace boresight::ui {

namespace {

constexpr int kDeepestHeading = 2;  // levels of headings in the contents
constexpr int kContentsWidth = 220;
constexpr QSize kSize{920, 560};
constexpr int kBlock = Qt::UserRole;  // the block where a heading of the contents begins

}  // namespace

QUrl manualAddress()
{
    return QUrl(QStringLiteral("qrc:/boresight/manual/manual.md"));
}

ManualWindow::ManualWindow(QWidget* parent)
    : QDialog(parent),
      m_search(new QLineEdit(this)),
      m_notice(new QLabel(this)),
      m_contents(new QListWidget(this)),
      m_text(new QTextBrowser(this))
{
    setWindowTitle(tr("Boresight manual"));
    m_search->setPlaceholderText(tr("Search the manual"));
    m_search->setAccessibleName(tr("Search the manual"));
    m_search->setClearButtonEnabled(true);
    m_contents->setAccessibleName(tr("Contents"));
    m_contents->setFixedWidth(kContentsWidth);
    m_text->setAccessibleName(tr("Text of the manual"));
    m_text->setOpenExternalLinks(true);
    for (QWidget* const part : QList<QWidget*>{m_search, m_notice, m_contents, m_text}) {
        part->setFont(fonts::label());
    }
    auto* const next = new QPushButton(tr("Find next"), this);
    next->setDefault(true);
    auto* const back = new QPushButton(tr("Back"), this);
    back->setToolTip(tr("Go back to the previous page"));
    back->setAutoDefault(false);
    back->setEnabled(false);
    auto* const above = new QHBoxLayout;
    above->addWidget(back);
    above->addWidget(m_search, 1);
    above->addWidget(next);
    above->addWidget(m_notice);
    auto* const below = new QHBoxLayout;
    below->addWidget(m_contents);
    below->addWidget(m_text, 1);
    auto* const all = new QVBoxLayout(this);
    all->addLayout(above);
    all->addLayout(below, 1);

    connect(next, &QPushButton::clicked, this, &ManualWindow::findNext);
    connect(m_search, &QLineEdit::textChanged, m_notice, &QLabel::clear);
    connect(back, &QPushButton::clicked, m_text, &QTextBrowser::backward);
    connect(m_text, &QTextBrowser::backwardAvailable, back, &QPushButton::setEnabled);
    connect(m_text, &QTextBrowser::sourceChanged, this, &ManualWindow::listHeadings);
    connect(m_contents, &QListWidget::currentRowChanged, this, &ManualWindow::showHeading);
    connect(new QShortcut(QKeySequence::Find, this), &QShortcut::activated, m_search, [this] {
        m_search->setFocus(Qt::ShortcutFocusReason);
        m_search->selectAll();
    });
    m_text->setSource(manualAddress());
    resize(kSize);
    m_search->setFocus();
}

void ManualWindow::listHeadings()
{
    const QSignalBlocker silent(m_contents);
    m_contents->clear();
    for (QTextBlock block = m_text->document()->begin(); block.isValid(); block = block.next()) {
        const int level = block.blockFormat().headingLevel();
        if (level >= 1 && level <= kDeepestHeading) {
            auto* const line =
                new QListWidgetItem(QString((level - 1) * 3, QLatin1Char(' ')) + block.text(), m_contents);
            line->setData(kBlock, block.position());
        }
    }
}

void ManualWindow::showHeading(int row)
{
    const QListWidgetItem* const line = m_contents->item(row);
    if (line == nullptr) {
        return;
    }
    QTextCursor there(m_text->document());
    there.movePosition(QTextCursor::End);  // so that the heading appears at the top
    m_text->setTextCursor(there);
    there.setPosition(line->data(kBlock).toInt());
    m_text->setTextCursor(there);
    m_text->verticalScrollBar()->setValue(m_text->verticalScrollBar()->value() + m_text->cursorRect(there).top());
}

void ManualWindow::findNext()
{
    const QString wanted = m_search->text();
    if (wanted.isEmpty()) {
        return;
    }
    bool found = m_text->find(wanted);
    if (!found) {
        const QTextCursor here = m_text->textCursor();
        m_text->moveCursor(QTextCursor::Start);
        found = m_text->find(wanted);
        if (!found) {
            m_text->setTextCursor(here);
        }
    }
    m_notice->setText(found ? QString() : tr("Not in this page"));
}

}  // namespace boresight::ui

#include "moc_manual_window.cpp"
