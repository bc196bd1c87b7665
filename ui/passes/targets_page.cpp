// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/passes/targets_page.h"

#include "ui/kit/command_button.h"
#include "ui/kit/file_dialog.h"
#include "ui/kit/push_button.h"
#include "ui/kit/read_table.h"
#include "ui/kit/value_label.h"
#include "ui/look/paint.h"
#include "ui/passes/azel_box.h"
#include "ui/passes/position_box.h"
#include "ui/passes/target_table.h"
#include "ui/passes/typed_target.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QLineEdit>
#include <QTableView>
#include <QVBoxLayout>

#include <chrono>
#include <utility>

namespace boresight::ui {

TargetsPage::TargetsPage(RequestDesk& desk, HostDesk& host, QWidget* parent)
    : QWidget(parent),
      m_targets(new TargetTable(this)),
      m_table(makeReadTable(tr("Targets in the sky"), *m_targets, this)),
      m_typed(new QLineEdit(this)),
      m_typedTarget(new TypedTarget(desk, host, this)),
      m_refused(new ValueLabel(tr("Refused"), fonts::label(), {}, this)),
      m_trackChosen(new CommandButton(tr("Track selected"), tr("Track the selected target until it sets"), desk,
                                      *m_refused, this)),
      m_trackTyped(new CommandButton(tr("Track"), tr("Track the typed target, or go there if it does not move"), desk,
                                     *m_refused, this)),
      m_chooseTable(makePushButton(
          {.text = tr("Choose file …"),
           .help = tr("Choose the path in a file: a table with a time, an azimuth and an elevation in each line, or a "
                      "CCSDS OEM. Track then tracks it")},
          this)),
      m_azel(new AzelBox(desk, this)),
      m_position(new PositionBox(desk, this))
{
    build();
    connect(m_trackChosen, &QPushButton::clicked, this, &TargetsPage::trackChosen);
    connect(m_trackTyped, &QPushButton::clicked, this, &TargetsPage::trackTyped);
    connect(m_chooseTable, &QPushButton::clicked, this, &TargetsPage::chooseTable);
    connect(m_typed, &QLineEdit::returnPressed, this, &TargetsPage::trackTyped);
    connect(m_typed, &QLineEdit::textEdited, this, &TargetsPage::clearNotice);
    connect(m_typed, &QLineEdit::textChanged, m_typedTarget, &TypedTarget::setText);
    connect(m_typedTarget, &TypedTarget::judged, this, &TargetsPage::showTyped);
}

void TargetsPage::build()
{
    auto* const column = new QVBoxLayout(this);
    column->setContentsMargins(6, 6, 6, 6);
    column->setSpacing(4);
    m_typed->setAccessibleName(tr("Another target"));
    m_typed->setPlaceholderText(tr("Locator, name of a satellite, azel 120,30"));
    m_typed->setToolTip(
        tr("A satellite: 25544, iss\n"
           "A locator, by the short or the long path: IM58kr, IM58kr long\n"
           "A direction: azel 120.5,30\n"
           "A place among the stars, J2000: radec 12:30:49.4,12:23:28\n"
           "A position, degrees and metres: place 38.757,-9.117,1200\n"
           "A file with a table, or with an OEM: table /home/me/pass.csv\n"
           "Where another rotator points, as its rotctld reports: rotctld:10.0.0.7:4533"));
    m_typed->setClearButtonEnabled(true);
    m_typed->setMinimumHeight(kRowHeight);
    m_refused->setLines(2);
    m_refused->setStretching(true);
    m_refused->setCollapsing(true);
    setEmphasis(*m_trackChosen, Emphasis::Primary);
    auto* const actions = new QHBoxLayout;
    actions->setSpacing(kGrid);
    actions->addWidget(m_typed, 1);
    actions->addWidget(m_chooseTable);
    actions->addWidget(m_trackTyped);
    actions->addWidget(m_trackChosen);
    column->addWidget(m_table, 1);
    column->addLayout(actions);
    column->addWidget(m_refused);
    column->addWidget(m_azel);
    column->addWidget(m_position);
    QHeaderView* const header = m_table->horizontalHeader();
    header->setSectionResizeMode(QHeaderView::ResizeToContents);
    header->setSectionResizeMode(TargetTable::Next, QHeaderView::Stretch);
    m_table->selectRow(1);  // the Moon: the Sun must not be the default
}

void TargetsPage::trackChosen()
{
    if (const QModelIndex chosen = m_table->currentIndex(); chosen.isValid()) {
        m_trackChosen->ask(request::Track{m_targets->target(chosen.row())});
    }
}

// Also by Enter in the field, which shows no tooltip.
void TargetsPage::trackTyped()
{
    if (const QString why = m_typedTarget->whyNot(); !why.isEmpty()) {
        m_refused->setValue(why, Tone::Warning, Symbol::Warning);
    } else if (m_trackTyped->isEnabled()) {
        m_trackTyped->ask(*m_typedTarget->request());
    }
}

// The tooltip of Track has the reason for each target. A table has it beside the field, too, because a mistake in a
// file is not visible in the text that was typed. It does not replace what the station refused.
void TargetsPage::showTyped()
{
    m_trackTyped->setBlocked(m_typedTarget->whyNot());
    const Sentence table = m_typedTarget->aboutTable();
    const QString before = std::exchange(m_aboutTable, table.text);
    if (before != table.text && (m_refused->text().isEmpty() || m_refused->text() == before)) {
        m_refused->setValue(table.text, table.tone, table.symbol);
    }
}

void TargetsPage::clearNotice()
{
    m_refused->setValue({});
    m_aboutTable.clear();
}

void TargetsPage::chooseTable()
{
    const QFileDialog* const dialog =
        askForFile(*this, tr("Choose the path in a file"), QFileDialog::AcceptOpen,
                   {tr("Tables and OEM (*.txt *.csv *.tsv *.dat *.oem *.kvn)"), tr("All files (*)")});
    connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& path) {
        clearNotice();
        m_typed->setText(QStringLiteral("table ") + path);
    });
}

void TargetsPage::showStatus(const StationStatus& status)
{
    const profile::SiteSettings& site = status.profile->site;
    m_targets->setSite(
        site.known ? std::optional(Site{
                         .latitude = site.latitude, .longitude = site.longitude, .heightMetres = site.heightMetres})
                   : std::nullopt);
    m_targets->setRefraction(status.profile->orbit.refraction);
    if (isVisible() && std::chrono::abs(status.utc - m_now) >= std::chrono::seconds(1)) {
        m_now = status.utc;
        m_targets->tick(status.utc);
    }
    m_trackChosen->setBlocked(whyNotTracked(status));
    if (isVisible()) {  // else the station would be asked each second for nothing
        m_typedTarget->showStatus(status);
        showTyped();
    }
    m_azel->showStatus(status);
    m_position->showStatus(status);
}

QString TargetsPage::whyNotTracked(const StationStatus& status) const
{
    if (!status.profile->site.known) {
        return tr("The site is not set. Enter it on the page Profile.");
    }
    const int row = m_table->currentIndex().row();
    if (row < 0) {
        return tr("Select a target first.");
    }
    const QString& why =
        status.permissions.reason(targets::isSun(m_targets->target(row)) ? Action::TrackSun : Action::Track);
    return why.isEmpty() ? m_targets->whyNotTracked(row) : why;
}

}  // namespace boresight::ui

#include "moc_targets_page.cpp"
