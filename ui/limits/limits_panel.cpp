// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/limits/limits_panel.h"

#include "ui/kit/caption.h"
#include "ui/kit/command_button.h"
#include "ui/kit/file_dialog.h"
#include "ui/kit/push_button.h"
#include "ui/kit/value_label.h"
#include "ui/limits/horizon_files.h"
#include "ui/limits/limit_row.h"
#include "ui/limits/region_models.h"
#include "ui/link/profile_draft_bar.h"

#include <QGridLayout>
#include <QHeaderView>
#include <QMenu>
#include <QShortcut>
#include <QTableView>

namespace boresight::ui {

namespace {

// The button acts on a row of this table. While the table has no row, the button is disabled, and `whyNot` replaces its
// help.
void needRows(QPushButton& button, const QAbstractItemModel& model, const QString& whyNot)
{
    const auto show = [&button, &model, whyNot, help = button.toolTip()] {
        const bool hasRows = model.rowCount() > 0;
        button.setEnabled(hasRows);
        button.setToolTip(hasRows ? help : whyNot);
    };
    QObject::connect(&model, &QAbstractItemModel::rowsInserted, &button, show);
    QObject::connect(&model, &QAbstractItemModel::rowsRemoved, &button, show);
    show();
}

}  // namespace

LimitsPanel::LimitsPanel(ProfileDraft& draft, RequestDesk& desk, QWidget* parent)
    : QWidget(parent),
      m_draft(draft),
      m_azimuth(new LimitRow(Axis::Azimuth, draft, *this)),
      m_elevation(new LimitRow(Axis::Elevation, draft, *this)),
      m_horizon(makeTable(*new HorizonModel(draft, this), tr("Horizon"))),
      m_keepOuts(makeTable(*new KeepOutModel(draft, this), tr("Keep-outs"))),
      m_notice(new ValueLabel(tr("Why the entry was refused"), fonts::label(), {}, this)),
      m_bar(new ProfileDraftBar(draft, desk, this))
{
    build();
}

void LimitsPanel::build()
{
    auto* const column = new QVBoxLayout(this);
    column->setContentsMargins(6, 6, 6, 6);
    column->setSpacing(4);
    auto* const limits = new QGridLayout;
    limits->setVerticalSpacing(2);
    m_azimuth->addTo(*limits, 0);
    m_elevation->addTo(*limits, 1);
    limits->setColumnStretch(2, 1);
    auto* const tables = new QHBoxLayout;
    tables->setSpacing(8);
    tables->addWidget(makeHorizonBox(), 1);
    tables->addWidget(makeKeepOutBox(), 2);
    m_notice->setStretching(true);
    m_notice->setCollapsing(true);
    column->addLayout(limits);
    column->addLayout(tables, 1);
    column->addWidget(m_notice);
    column->addWidget(m_bar);
}

QTableView* LimitsPanel::makeTable(DraftTableModel& model, const QString& name)
{
    auto* const table = new QTableView(this);
    table->setModel(&model);
    table->setFont(fonts::label());
    table->setAccessibleName(name);
    table->setToolTip(tr("%1: type into a cell, or drag on the plot (Edit, Ctrl+E)").arg(name));
    table->setSelectionMode(QAbstractItemView::SingleSelection);
    table->setTabKeyNavigation(false);  // so that the Tab key can leave the table
    table->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    table->setWordWrap(false);
    table->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Expanding);  // the plot gets the remaining room
    table->setMinimumHeight(4 * table->fontMetrics().lineSpacing());
    table->verticalHeader()->hide();
    table->verticalHeader()->setDefaultSectionSize(kRowHeight);
    QHeaderView* const header = table->horizontalHeader();
    header->setFont(fonts::label());
    header->setHighlightSections(false);
    header->setMinimumSectionSize(1);
    header->setSectionResizeMode(QHeaderView::Stretch);
    connect(&model, &DraftTableModel::refused, this, &LimitsPanel::say);
    return table;
}

QPushButton* LimitsPanel::makeButton(const QString& text, const QString& name)
{
    QPushButton* const button = makePushButton({.text = text, .name = name, .help = name}, this);
    button->setMinimumWidth(kTouchSize);
    button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    return button;
}

QWidget* LimitsPanel::makeHorizonBox()
{
    auto* const box = new QWidget(this);
    auto* const grid = new QGridLayout(box);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setSpacing(4);
    QPushButton* const add = makeButton(QStringLiteral("+"), tr("Add a point of the horizon"));
    QPushButton* const take = makeButton(QStringLiteral("−"), tr("Remove the current point of the horizon (Del)"));
    QPushButton* const files = makeButton(tr("File"), tr("Import or export the horizon (az el)"));
    auto* const menu = new QMenu(files);
    menu->addAction(tr("Import …"), this, &LimitsPanel::askForHorizon);
    menu->addAction(tr("Export …"), this, &LimitsPanel::askWhereToExport);
    files->setMenu(menu);
    grid->addWidget(makeCaption(tr("Horizon"), *m_horizon), 0, 0, 1, 3);
    grid->addWidget(m_horizon, 1, 0, 1, 3);
    grid->addWidget(files, 2, 2);
    grid->addWidget(add, 2, 0);
    grid->addWidget(take, 2, 1);
    connect(add, &QPushButton::clicked, this, &LimitsPanel::addPoint);
    const auto remove = [this] { removeCurrent(*m_horizon, RegionPart::HorizonPoint); };
    needRows(*take, *m_horizon->model(), tr("The horizon has no point."));
    connect(take, &QPushButton::clicked, this, remove);
    connect(new QShortcut(Qt::Key_Delete, m_horizon, nullptr, nullptr, Qt::WidgetShortcut), &QShortcut::activated, this,
            remove);
    return box;
}

QWidget* LimitsPanel::makeKeepOutBox()
{
    auto* const box = new QWidget(this);
    auto* const grid = new QGridLayout(box);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setSpacing(4);
    QPushButton* const add =
        makeButton(tr("Add keep-out"), tr("Add a keep-out around the present direction of the mount"));
    QPushButton* const take = makeButton(tr("Remove"), tr("Remove the current keep-out (Del)"));
    grid->addWidget(makeCaption(tr("Keep-outs, clockwise from … to"), *m_keepOuts), 0, 0, 1, 2);
    grid->addWidget(m_keepOuts, 1, 0, 1, 2);
    grid->addWidget(add, 2, 0);
    grid->addWidget(take, 2, 1);
    m_keepOuts->horizontalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    m_keepOuts->horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
    const int number = m_keepOuts->fontMetrics().horizontalAdvance(QStringLiteral("From ° ")) + 12;
    for (int column = 1; column < 5; ++column) {
        m_keepOuts->horizontalHeader()->resizeSection(column, number);
    }
    connect(add, &QPushButton::clicked, this, &LimitsPanel::addSector);
    const auto remove = [this] { removeCurrent(*m_keepOuts, RegionPart::KeepOut); };
    needRows(*take, *m_keepOuts->model(), tr("There is no keep-out."));
    connect(take, &QPushButton::clicked, this, remove);
    connect(new QShortcut(Qt::Key_Delete, m_keepOuts, nullptr, nullptr, Qt::WidgetShortcut), &QShortcut::activated,
            this, remove);
    return box;
}

void LimitsPanel::showStatus(const StationStatus& status)
{
    m_azimuth->showStatus(status);
    m_elevation->showStatus(status);
    m_place = status.actual.value_or(m_place);
}

// The new point follows the current one and has its elevation, ready to be corrected. The first point is where the
// mount points.
void LimitsPanel::addPoint()
{
    const std::vector<pointing::HorizonPoint>& points = m_draft.edited().limits.horizon;
    SkyPointing at = m_place;
    if (!points.empty()) {
        const auto row = static_cast<std::size_t>(std::max(m_horizon->currentIndex().row(), 0));
        const pointing::HorizonPoint& one = points[std::min(row, points.size() - 1)];
        at = {one.azimuth + 10_deg, one.elevation};
    }
    std::size_t index = 0;
    m_draft.edit([&](profile::Profile& profile) { index = addHorizonPoint(profile.limits, travelOf(profile), at); });
    m_horizon->setCurrentIndex(m_horizon->model()->index(static_cast<int>(index), 0));
    m_horizon->setFocus();
}

void LimitsPanel::addSector()
{
    std::size_t index = 0;
    m_draft.edit([&](profile::Profile& profile) { index = addKeepOut(profile.limits, m_place); });
    m_keepOuts->setCurrentIndex(m_keepOuts->model()->index(static_cast<int>(index), 0));
    m_keepOuts->setFocus();
}

void LimitsPanel::removeCurrent(const QTableView& table, RegionPart part)
{
    const QModelIndex current = table.currentIndex();
    if (!current.isValid()) {
        say(tr("Select a row first."));
        return;
    }
    const Grip grip{.part = part, .index = static_cast<std::size_t>(current.row())};
    m_draft.edit([&grip](profile::Profile& profile) { remove(profile.limits, grip); });
    say({});
}

void LimitsPanel::askForHorizon()
{
    const QFileDialog* const dialog = askForFile(*this, tr("Import a horizon"), QFileDialog::AcceptOpen,
                                                 {tr("Horizon (*.txt *.hrz *.hzn *.csv)"), tr("All files (*)")});
    connect(dialog, &QFileDialog::fileSelected, this, &LimitsPanel::importHorizon);
}

void LimitsPanel::askWhereToExport()
{
    const QFileDialog* const dialog =
        askForFile(*this, tr("Export the horizon"), QFileDialog::AcceptSave, {tr("Horizon (*.txt)")});
    connect(dialog, &QFileDialog::fileSelected, this, &LimitsPanel::exportHorizon);
}

void LimitsPanel::importHorizon(const QString& path)
{
    const Result<QString> taken = ui::importHorizon(m_draft, path);
    if (taken) {
        tell(*taken);
    } else {
        say(taken.error().text);
    }
}

void LimitsPanel::exportHorizon(const QString& path)
{
    if (const Result<> written = ui::exportHorizon(m_draft, path); written) {
        tell(tr("written"));
    } else {
        say(written.error().text);
    }
}

void LimitsPanel::tell(const QString& text)
{
    m_notice->setValue(text, Tone::Secondary);
}

void LimitsPanel::say(const QString& reason)
{
    m_notice->setValue(reason, Tone::Warning, reason.isEmpty() ? Symbol::None : Symbol::Warning);
}

}  // namespace boresight::ui

#include "moc_limits_panel.cpp"
