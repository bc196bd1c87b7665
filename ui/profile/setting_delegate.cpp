// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/profile/setting_delegate.h"

#include "ui/kit/theme.h"
#include "ui/profile/setting_tree.h"

#include <QAbstractItemView>
#include <QApplication>
#include <QComboBox>
#include <QLineEdit>
#include <QPainter>

#include <algorithm>

namespace boresight::ui {

namespace {

constexpr double kSettingDelegateBar = 4.0;  // px, its height
constexpr double kSettingDelegateGap = 5.0;  // px, between the bar and the numbers at its ends
constexpr double kMark = 3.0;                // px, half the width of the mark at the value
constexpr double kLeastBar = 16;             // px: with less room the numbers alone are clearer

// From "-3600 … 3600 °": the numbers at the ends.
std::pair<QString, QString> endsOf(const QString& range)
{
    const QStringList ends = range.split(QStringLiteral(" … "));
    return {ends.value(0), ends.value(1).section(QLatin1Char(' '), 0, 0)};
}

void drawBar(QPainter& painter, const QRectF& bar, double share, const QVariant& defaultShare)
{
    const Theme& colours = currentTheme();
    const auto at = [&bar](double part) { return bar.left() + part * bar.width(); };
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(bar, colours.grid);
    painter.fillRect(QRectF(bar.topLeft(), QPointF(at(share), bar.bottom())), colours.secondary);
    if (defaultShare.isValid()) {
        painter.setPen(QPen(colours.secondary, 1.0));
        painter.drawLine(QPointF(at(defaultShare.toDouble()), bar.top() - kMark),
                         QPointF(at(defaultShare.toDouble()), bar.bottom() + kMark));
    }
    painter.setPen(Qt::NoPen);
    painter.setBrush(colours.text);
    painter.drawRect(QRectF(at(share) - kMark / 2.0, bar.top() - kMark, kMark, bar.height() + 2.0 * kMark));
}

}  // namespace

SettingDelegate::SettingDelegate(int rowHeight, QObject* parent) : QStyledItemDelegate(parent), m_rowHeight(rowHeight)
{}

QSize SettingDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const
{
    return {QStyledItemDelegate::sizeHint(option, index).width(), m_rowHeight};
}

void SettingDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const
{
    const QVariant share = index.data(SettingTree::ShareRole);
    if (index.column() != SettingTree::Range || !share.isValid()) {
        QStyledItemDelegate::paint(painter, option, index);
        return;
    }
    QStyleOptionViewItem ground = option;
    initStyleOption(&ground, index);
    ground.text.clear();
    QApplication::style()->drawControl(QStyle::CE_ItemViewItem, &ground, painter, option.widget);
    const auto [low, high] = endsOf(index.data().toString());
    const QRectF room = QRectF(option.rect).adjusted(3, 0, -3, 0);
    painter->save();
    const bool selected = option.state.testFlag(QStyle::State_Selected);
    painter->setFont(option.font);
    painter->setPen(selected ? option.palette.highlightedText().color() : currentTheme().secondary);
    painter->drawText(room, Qt::AlignLeft | Qt::AlignVCenter, low);
    painter->drawText(room, Qt::AlignRight | Qt::AlignVCenter, high);
    QRectF bar(0, room.center().y() - kSettingDelegateBar / 2.0, 0, kSettingDelegateBar);
    bar.setLeft(room.left() + option.fontMetrics.horizontalAdvance(low) + kSettingDelegateGap);
    bar.setRight(room.right() - option.fontMetrics.horizontalAdvance(high) - kSettingDelegateGap);
    if (bar.width() >= kLeastBar && !selected) {
        drawBar(*painter, bar, share.toDouble(), index.data(SettingTree::DefaultShareRole));
    }
    painter->restore();
}

QWidget* SettingDelegate::createEditor(QWidget* parent, const QStyleOptionViewItem& option,
                                       const QModelIndex& index) const
{
    const QStringList choices = index.data(SettingTree::ChoicesRole).toStringList();
    QWidget* editor = nullptr;
    if (choices.isEmpty()) {
        editor = QStyledItemDelegate::createEditor(parent, option, index);
        auto* const line = qobject_cast<QLineEdit*>(editor);
        if (line != nullptr && index.data(SettingTree::SecretRole).toBool()) {
            line->setEchoMode(QLineEdit::Password);
        }
    } else {
        auto* const list = new QComboBox(parent);
        const QStringList names = index.data(SettingTree::ChoiceNamesRole).toStringList();
        for (qsizetype i = 0; i < choices.size(); ++i) {
            list->addItem(names.value(i), choices[i]);
            list->setItemData(list->count() - 1, tr("In the file: %1").arg(choices[i]), Qt::ToolTipRole);
        }
        list->setFont(fonts::label());
        list->view()->setMinimumWidth(list->sizeHint().width());  // a name may be wider than the column
        editor = list;
    }
    editor->setFont(fonts::label());
    editor->setAccessibleName(index.siblingAtColumn(SettingTree::Name).data().toString());
    return editor;
}

void SettingDelegate::setEditorData(QWidget* editor, const QModelIndex& index) const
{
    if (auto* const list = qobject_cast<QComboBox*>(editor)) {
        list->setCurrentIndex(list->findData(index.data(Qt::EditRole)));
    } else {
        QStyledItemDelegate::setEditorData(editor, index);
    }
}

void SettingDelegate::setModelData(QWidget* editor, QAbstractItemModel* model, const QModelIndex& index) const
{
    if (const auto* const list = qobject_cast<QComboBox*>(editor)) {
        model->setData(index, list->currentData());
    } else {
        QStyledItemDelegate::setModelData(editor, model, index);
    }
}

// A list needs slightly more than the row's height for its text.
void SettingDelegate::updateEditorGeometry(QWidget* editor, const QStyleOptionViewItem& option,
                                           const QModelIndex&) const
{
    QRect room = option.rect;
    const int lacking = std::max(editor->sizeHint().height() - room.height(), 0);
    editor->setGeometry(room.adjusted(0, -lacking / 2, 0, lacking - lacking / 2));
}

}  // namespace boresight::ui

#include "moc_setting_delegate.cpp"
