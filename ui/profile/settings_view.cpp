// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/profile/settings_view.h"

#include "ui/kit/command_button.h"
#include "ui/kit/push_button.h"
#include "ui/kit/value_label.h"
#include "ui/profile/beam_box.h"
#include "ui/profile/setting_delegate.h"
#include "ui/profile/setting_filter.h"
#include "ui/profile/setting_picture.h"
#include "ui/profile/setting_tree.h"

#include <QComboBox>
#include <QEvent>
#include <QHeaderView>
#include <QLineEdit>
#include <QShortcut>
#include <QTreeView>
#include <QVBoxLayout>

#include <algorithm>

namespace boresight::ui {

namespace {
constexpr QSize kRowPicture{42, 28};
constexpr const char* kBeamWidth = "mount.beam_width_deg";
constexpr int kPictureFrom = 320;  // px of height: below it the rows need the room of the large picture
}  // namespace

SettingsView::SettingsView(ProfileDraft& draft, QWidget* parent)
    : QWidget(parent),
      m_model(new SettingTree(draft, this)),
      m_filter(new SettingFilter(this)),
      m_search(new QLineEdit(this)),
      m_shown(new QComboBox(this)),
      m_tree(new QTreeView(this)),
      m_picture(new SettingPictureView(this)),
      m_explanation(new ValueLabel(tr("What the selected setting means"), fonts::label(), {}, this)),
      m_beam(new BeamBox(draft, this)),
      m_antennas(makePushButton({.text = tr("Edit antennas"),
                                 .name = {},
                                 .help = tr("Add, name, measure and remove the antennas of the mount")},
                                this))
{
    m_filter->setSourceModel(m_model);
    buildTree();
    auto* const column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(4);
    column->addWidget(makeSearch());
    column->addWidget(m_tree, 1);
    auto* const meaning = new QHBoxLayout;
    meaning->setSpacing(kGrid);
    meaning->addWidget(m_picture);
    meaning->addWidget(m_explanation, 1);
    column->addLayout(meaning);
    column->addWidget(m_beam);
    column->addWidget(m_antennas);
    m_explanation->setStretching(true);
    m_explanation->setLines(3);
    m_explanation->setCollapsing(true);
    connect(m_antennas, &QPushButton::clicked, this, &SettingsView::antennasWanted);
    connect(m_model, &SettingTree::refused, this, [this](const QString& reason) {
        m_refusal = reason;
        explain();
    });
    connect(m_model, &QAbstractItemModel::dataChanged, this, &SettingsView::explain);
    connect(m_tree->selectionModel(), &QItemSelectionModel::currentChanged, this, [this] {
        m_refusal.clear();
        explain();
    });
    explain();
}

QWidget* SettingsView::makeSearch()
{
    auto* const row = new QWidget(this);
    auto* const line = new QHBoxLayout(row);
    line->setContentsMargins(0, 0, 0, 0);
    line->setSpacing(4);
    m_search->setAccessibleName(tr("Search the settings"));
    m_search->setToolTip(tr("Show the settings with these words in their name or meaning (Ctrl+F)"));
    m_search->setPlaceholderText(tr("Search, for example speed"));
    m_search->setClearButtonEnabled(true);
    m_shown->setAccessibleName(tr("Which settings are shown"));
    m_shown->addItems({tr("All settings"), tr("Changed or waiting")});
    for (QWidget* const control : {static_cast<QWidget*>(m_search), static_cast<QWidget*>(m_shown)}) {
        control->setFont(fonts::label());
        control->setMinimumHeight(kTouchSize);
    }
    line->addWidget(m_search, 1);
    line->addWidget(m_shown);
    connect(m_search, &QLineEdit::textChanged, this, &SettingsView::search);
    connect(m_shown, &QComboBox::currentIndexChanged, this, [this](int index) { showChangedOnly(index == 1); });
    auto* const find = new QShortcut(QKeySequence::Find, this);
    find->setContext(Qt::WindowShortcut);
    connect(find, &QShortcut::activated, m_search, qOverload<>(&QWidget::setFocus));
    return row;
}

void SettingsView::buildTree()
{
    m_tree->setModel(m_filter);
    m_tree->setFont(fonts::label());
    m_tree->setAccessibleName(tr("Settings of the mount"));
    m_tree->setToolTip(tr("Select a line to read its meaning. Press Enter to change its value."));
    m_tree->viewport()->installEventFilter(this);
    m_tree->setItemDelegate(new SettingDelegate(kRowHeight, m_tree));
    m_tree->setUniformRowHeights(true);
    m_tree->setIconSize(kRowPicture);
    m_tree->setAllColumnsShowFocus(true);
    m_tree->setIndentation(m_tree->fontMetrics().averageCharWidth() * 2);
    m_tree->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_tree->setExpandsOnDoubleClick(false);  // activation expands, by mouse and by Enter
    m_tree->setTabKeyNavigation(false);      // so that the Tab key can leave the tree
    m_tree->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_tree->setMinimumHeight(4 * m_tree->fontMetrics().lineSpacing());
    QHeaderView* const header = m_tree->header();
    header->setFont(fonts::label());
    header->setSectionsMovable(false);
    header->setStretchLastSection(false);
    header->setMinimumSectionSize(1);
    header->setSectionResizeMode(QHeaderView::Fixed);
    header->setSectionResizeMode(SettingTree::Value, QHeaderView::Stretch);
    header->resizeSection(SettingTree::Range, roomFor(QStringLiteral("-3600 ▬▬▬▬ 3600")));
    header->resizeSection(SettingTree::AppliesWhen, roomFor(tr("reconnect")));
    fitNames();
    spanSections();
    connect(m_tree, &QTreeView::activated, this, &SettingsView::openEditor);
    auto* const edit = new QShortcut(Qt::Key_F2, m_tree, nullptr, nullptr, Qt::WidgetShortcut);
    connect(edit, &QShortcut::activated, this, [this] { openEditor(m_tree->currentIndex()); });
}

int SettingsView::roomFor(const QString& widest) const
{
    return m_tree->fontMetrics().horizontalAdvance(widest) + 14;
}

// In a narrow window or a language of long words the names give way to the values.
void SettingsView::fitNames()
{
    QHeaderView* const header = m_tree->header();
    const int others = roomFor(QStringLiteral("-3600.0 °")) + header->sectionSize(SettingTree::Range) +
                       header->sectionSize(SettingTree::AppliesWhen);
    const int most = kRowPicture.width() + roomFor(tr("Direction of the X axis mm"));
    header->resizeSection(SettingTree::Name, std::clamp(m_tree->viewport()->width() - others, most / 2, most));
}

void SettingsView::openEditor(const QModelIndex& index)
{
    const QModelIndex first = index.siblingAtColumn(SettingTree::Name);
    if (m_filter->hasChildren(first)) {
        m_tree->setExpanded(first, !m_tree->isExpanded(first));
        return;
    }
    if (first.data(SettingTree::KeyRole).toString().toStdString() == profile::kAntennaKey) {
        Q_EMIT antennasWanted();
        return;
    }
    const QModelIndex value = index.siblingAtColumn(SettingTree::Value);
    if (value.flags().testFlag(Qt::ItemIsEditable)) {
        m_tree->setCurrentIndex(value);
        m_tree->edit(value);
    }
}

// No focus proxy, because then Tab would not reach the controls above the tree.
void SettingsView::focusTree()
{
    m_tree->setFocus();
}

void SettingsView::seek(const QString& words)
{
    m_shown->setCurrentIndex(0);
    m_search->setText(words);
    m_tree->setFocus();
}

void SettingsView::search(const QString& text)
{
    m_filter->setText(text);
    expandIfSought();
}

void SettingsView::showChangedOnly(bool on)
{
    m_filter->setChangedOnly(on);
    expandIfSought();
}

// A section has only its name, which may be longer than that of a setting.
void SettingsView::spanSections()
{
    for (int row = 0; row < m_filter->rowCount(); ++row) {
        m_tree->setFirstColumnSpanned(row, {}, true);
    }
}

void SettingsView::expandIfSought()
{
    spanSections();
    if (m_filter->isSelective()) {
        m_tree->expandAll();
    } else {
        m_tree->collapseAll();
    }
}

void SettingsView::explain()
{
    const bool isRoomy = height() >= kPictureFrom;
    m_explanation->setLines(isRoomy ? 3 : 2);
    m_explanation->updateGeometry();
    const std::string key = m_tree->currentIndex().data(SettingTree::KeyRole).toString().toStdString();
    m_picture->setKey(isRoomy ? key : std::string());
    m_beam->setVisible(key == kBeamWidth);
    m_antennas->setVisible(key == profile::kAntennaKey);
    if (!m_refusal.isEmpty()) {
        m_explanation->setValue(m_refusal, Tone::Warning, Symbol::Warning);
        return;
    }
    const QModelIndex current = m_tree->currentIndex();
    m_explanation->setValue(current.data(SettingTree::ExplanationRole).toString());
}

void SettingsView::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    explain();
}

// The line being read or changed stays visible when the lines below it appear or disappear.
bool SettingsView::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::Resize) {
        fitNames();
        if (m_tree->currentIndex().isValid()) {
            m_tree->scrollTo(m_tree->currentIndex());
        }
    }
    return QWidget::eventFilter(watched, event);
}

}  // namespace boresight::ui

#include "moc_settings_view.cpp"
