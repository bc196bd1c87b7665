// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/profile/antenna_page.h"

#include "core/base/text.h"
#include "ui/kit/push_button.h"
#include "ui/kit/theme.h"
#include "ui/kit/value_label.h"
#include "ui/profile/antenna_model.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QShortcut>
#include <QTableView>

namespace boresight::ui {

AntennaPage::AntennaPage(ProfileDraft& draft, QWidget* parent)
    : QWidget(parent),
      m_draft(draft),
      m_model(new AntennaModel(draft, this)),
      m_table(new QTableView(this)),
      m_line(new ValueLabel(tr("About the antennas"), fonts::label(), {}, this))
{
    buildTable();
    auto* const column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(4);
    column->addLayout(makeButtons());
    column->addWidget(m_table, 1);
    column->addWidget(m_line);
    setFocusProxy(m_table);
    m_line->setStretching(true);
    m_line->setLines(2);
    m_line->setCollapsing(true);
    connect(m_model, &AntennaModel::refused, this, &AntennaPage::refuse);
    connect(m_table->selectionModel(), &QItemSelectionModel::currentChanged, this, &AntennaPage::explain);
    explain();
}

void AntennaPage::buildTable()
{
    m_table->setModel(m_model);
    m_table->setFont(fonts::label());
    m_table->setAccessibleName(tr("Antennas"));
    m_table->setToolTip(tr("Type into a cell to change it."));
    m_table->setSelectionMode(QAbstractItemView::SingleSelection);
    m_table->setTabKeyNavigation(false);  // so that the Tab key can leave the table
    m_table->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_table->setWordWrap(false);
    m_table->setMinimumHeight(3 * kRowHeight);
    m_table->verticalHeader()->hide();
    m_table->verticalHeader()->setDefaultSectionSize(kRowHeight);
    QHeaderView* const header = m_table->horizontalHeader();
    header->setFont(fonts::label());
    header->setHighlightSections(false);
    header->setMinimumSectionSize(1);
    header->setSectionResizeMode(QHeaderView::Fixed);
    header->setSectionResizeMode(AntennaModel::Name, QHeaderView::Stretch);
    for (const int column : {AntennaModel::BeamWidth, AntennaModel::Across, AntennaModel::Up}) {
        const QString name = m_model->headerData(column, Qt::Horizontal, Qt::DisplayRole).toString();
        header->resizeSection(column, m_table->fontMetrics().horizontalAdvance(name + QStringLiteral("mm")));
    }
    const auto* const remove = new QShortcut(Qt::Key_Delete, m_table, nullptr, nullptr, Qt::WidgetShortcut);
    connect(remove, &QShortcut::activated, this, &AntennaPage::removeCurrent);
}

QHBoxLayout* AntennaPage::makeButtons()
{
    QPushButton* const add =
        makePushButton({.text = tr("Add antenna"), .name = {}, .help = tr("Add an antenna to the mount")}, this);
    QPushButton* const take = makePushButton(
        {.text = tr("Remove"), .name = tr("Remove the antenna"), .help = tr("Remove the selected antenna (Del)")},
        this);
    QPushButton* const back =
        makePushButton({.text = tr("All settings"), .name = {}, .help = tr("Back to all settings of the mount")}, this);
    connect(back, &QPushButton::clicked, this, &AntennaPage::settingsWanted);
    connect(add, &QPushButton::clicked, this, &AntennaPage::add);
    connect(take, &QPushButton::clicked, this, &AntennaPage::removeCurrent);
    auto* const row = new QHBoxLayout;
    row->addWidget(add, 1);
    row->addWidget(take, 1);
    row->addWidget(back, 1);
    return row;
}

// The name is typed first.
void AntennaPage::add()
{
    if (m_draft.edited().antennas.size() >= profile::kMaxAntennas) {
        refuse(tr("The mount has the main antenna and %1 more. Boresight supports no more. Remove one first.")
                   .arg(profile::kMaxAntennas));
        return;
    }
    m_draft.edit(addAntenna);
    const QModelIndex name = m_model->index(m_model->rowCount() - 1, AntennaModel::Name);
    m_table->setFocus();
    m_table->setCurrentIndex(name);
    m_table->edit(name);
}

void AntennaPage::removeCurrent()
{
    const QModelIndex current = m_table->currentIndex();
    if (current.row() < 1) {  // the table has a current cell as soon as it has the focus
        refuse(tr("The main antenna cannot be removed. North is found with it."));
        return;
    }
    std::size_t satellites = 0;
    m_draft.edit([&](profile::Profile& profile) {
        satellites = removeAntenna(profile, static_cast<std::size_t>(current.row()) - 1);
    });
    if (satellites > 0) {
        m_line->setValue(tr("Satellites that had this antenna: %1. They now use the antenna that you choose by hand.")
                             .arg(satellites));
    }
}

void AntennaPage::explain()
{
    const QModelIndex current = m_table->currentIndex();
    m_line->setValue(
        current.isValid()
            ? Text::of(profile::antennaSettings()[static_cast<std::size_t>(current.column())].text)
            : tr("Each antenna has a name, a beam width, and two offsets from the beam of the main antenna."));
}

void AntennaPage::refuse(const QString& reason)
{
    if (reason.isEmpty()) {
        explain();
    } else {
        m_line->setValue(reason, Tone::Warning, Symbol::Warning);
    }
}

}  // namespace boresight::ui

#include "moc_antenna_page.cpp"
