// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/start_problem.h"

#include "ui/kit/file_dialog.h"
#include "ui/kit/push_button.h"
#include "ui/kit/symbol.h"
#include "ui/kit/theme.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QVBoxLayout>

namespace boresight::ui {

namespace {

constexpr int kTextWidth = 440;  // px
constexpr int kProblemMargin = 16;
constexpr int kProblemSymbol = 22;

QString asSentence(const QString& reason)
{
    const QString text = reason.trimmed();
    return text.endsWith(QLatin1Char('.')) || text.endsWith(QLatin1Char('?')) ? text : text + QLatin1Char('.');
}

}  // namespace

StartProblem::StartProblem(const QString& reason, QWidget* parent) : QDialog(parent)
{
    setWindowTitle(tr("Boresight cannot start"));
    setWindowIcon(QIcon(QStringLiteral(":/boresight/icons/boresight.svg")));
    build(reason);
}

void StartProblem::build(const QString& reason)
{
    auto* const column = new QVBoxLayout(this);
    column->setContentsMargins(2 * kProblemMargin + kProblemSymbol, kProblemMargin, kProblemMargin, kProblemMargin);
    column->setSpacing(8);
    const auto add = [this, column](const QString& name, const QString& text, const QFont& font) {
        auto* const label = new QLabel(text, this);
        label->setObjectName(name);
        label->setFont(font);
        label->setTextFormat(Qt::PlainText);  // it contains text from a file
        label->setWordWrap(true);
        label->setMinimumWidth(kTextWidth);
        label->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
        column->addWidget(label);
    };
    QFont bold = fonts::text();
    bold.setBold(true);
    add(QStringLiteral("title"), tr("Boresight cannot start."), bold);
    add(QStringLiteral("reason"), asSentence(reason), fonts::text());
    add(QStringLiteral("action"), tr("Boresight moved nothing and changed no file."), fonts::label());
    add(QStringLiteral("remedy"), tr("Remove the cause and start Boresight again, or choose another profile."),
        fonts::label());
    auto* const buttons = new QHBoxLayout;
    QPushButton* const choose = makePushButton(
        {.text = tr("Choose another profile …"), .help = tr("Start with the profile of another mount")}, this);
    QPushButton* const quit = makePushButton({.text = tr("Quit"), .help = tr("End Boresight")}, this);
    choose->setMinimumWidth(choose->sizeHint().width() + 2 * kProblemMargin);
    connect(choose, &QPushButton::clicked, this, &StartProblem::chooseProfile);
    connect(quit, &QPushButton::clicked, this, &QDialog::reject);
    buttons->addStretch();
    buttons->addWidget(choose);
    buttons->addWidget(quit);
    column->addSpacing(8);
    column->addLayout(buttons);
    quit->setFocus();
}

void StartProblem::chooseProfile()
{
    QFileDialog* const dialog = askForFile(*this, tr("Choose another profile"), QFileDialog::AcceptOpen,
                                           {tr("Profiles (*.toml)"), tr("All files (*)")});
    connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& path) {
        m_chosen = path;
        accept();
    });
}

void StartProblem::paintEvent(QPaintEvent* event)
{
    QDialog::paintEvent(event);
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    drawSymbol(painter, Symbol::Alarm, QRectF(kProblemMargin, kProblemMargin, kProblemSymbol, kProblemSymbol),
               currentTheme().alarm);
}

}  // namespace boresight::ui

#include "moc_start_problem.cpp"
