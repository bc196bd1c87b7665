// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/passes/passes_panel.h"

#include "core/profile/clear_sky.h"
#include "core/targets/target.h"
#include "ui/kit/caption.h"
#include "ui/kit/command_button.h"
#include "ui/kit/decimal_box.h"
#include "ui/kit/push_button.h"
#include "ui/kit/read_table.h"
#include "ui/kit/value_label.h"
#include "ui/look/paint.h"
#include "ui/passes/pass_table.h"
#include "ui/passes/pass_way.h"
#include "ui/passes/pass_words.h"
#include "ui/passes/watch_button.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QLineEdit>
#include <QTableView>
#include <QVBoxLayout>

#include <chrono>

namespace boresight::ui {

namespace {

constexpr std::chrono::hours kAhead{24};
constexpr std::chrono::hours kSearchAgain{6};
// So far back that a pass that goes on now has its own beginning.
constexpr std::chrono::minutes kBack{30};
constexpr int kFactLines = 7;
constexpr int kProblemLines = 3;
constexpr int kBriefLines = 3;  // as high as the buttons beside them
// With less room than this the facts would leave the table a row or two.
constexpr int kRoomForAllFacts = 400;
constexpr double kHighestFilter = 89.0;  // °

}  // namespace

PassesPanel::PassesPanel(ProfileDraft& draft, RequestDesk& desk, QWidget* parent)
    : QWidget(parent),
      m_searcher(new PassSearcher(this)),
      m_passes(new PassTable(this)),
      m_table(makeReadTable(tr("Coming passes"), *m_passes, this)),
      m_words(new QLineEdit(this)),
      m_lowest(new DecimalBox(this)),
      m_note(new ValueLabel(tr("About the passes"), fonts::label(), {}, this)),
      m_openSetting(makePushButton({.text = tr("Open the setting"), .help = tr("The files with element sets")}, this)),
      m_problem(new ValueLabel(tr("Problems with the elements"), fonts::label(), {}, this)),
      m_facts(new ValueLabel(tr("The selected pass"), fonts::label(), {}, this)),
      m_refused(new ValueLabel(tr("Refused"), fonts::label(), {}, this)),
      m_buttons(new QBoxLayout(QBoxLayout::TopToBottom)),
      m_track(new CommandButton(tr("Track"),
                                tr("Go to where the satellite rises and follow it until it sets. Then the mount holds"),
                                desk, *m_refused, this)),
      m_watch(new WatchButton(draft, desk, *m_refused, this))
{
    build();
    connect(m_searcher, &PassSearcher::found, this, &PassesPanel::showBook);
    connect(m_searcher, &PassSearcher::progressed, this,
            [this](int percent) { m_note->setValue(tr("Searching for passes: %1 %").arg(percent), Tone::Secondary); });
    connect(m_words, &QLineEdit::textChanged, this, [this](const QString& words) {
        m_passes->setWords(words);
        showRows();
    });
    connect(m_lowest, &QDoubleSpinBox::valueChanged, this, [this](double degrees) {
        m_passes->setLowest(Angle::fromDegrees(degrees));
        showRows();
    });
    connect(m_table->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
            [this](const QModelIndex& now) { select(now.isValid() ? now.row() : -1); });
    connect(m_openSetting, &QPushButton::clicked, this, [this] { Q_EMIT settingsWanted(tr("elements")); });
    connect(m_track, &QPushButton::clicked, this, [this] {
        if (m_selected) {
            track();
        }
    });
}

void PassesPanel::build()
{
    auto* const column = new QVBoxLayout(this);
    column->setContentsMargins(6, 6, 6, 6);
    column->setSpacing(4);
    m_note->setLines(2);
    m_note->setStretching(true);
    column->addWidget(makeSearchLine());
    auto* const notes = new QHBoxLayout;
    notes->addWidget(m_note, 1);
    notes->addWidget(m_openSetting);
    column->addLayout(notes);
    m_problem->setLines(kProblemLines);
    m_problem->setStretching(true);
    m_problem->setCollapsing(true);
    column->addWidget(m_problem);
    column->addWidget(m_table, 1);
    column->addWidget(makeSelection());
    QHeaderView* const header = m_table->horizontalHeader();
    header->setSectionResizeMode(QHeaderView::Fixed);
    header->setSectionResizeMode(PassTable::Satellite, QHeaderView::Stretch);
    const QFontMetrics metrics(m_table->font());
    for (int section = PassTable::Rises; section <= PassTable::Lasts; ++section) {
        const QString heading = m_passes->headerData(section, Qt::Horizontal, Qt::DisplayRole).toString();
        const QString widest = section == PassTable::Highest ? QStringLiteral("90°") : QStringLiteral("00:00:00");
        header->resizeSection(section,
                              std::max(metrics.horizontalAdvance(heading), metrics.horizontalAdvance(widest)) + 14);
    }
}

QWidget* PassesPanel::makeSearchLine()
{
    auto* const box = new QWidget(this);
    auto* const row = new QHBoxLayout(box);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(kGrid);
    m_words->setAccessibleName(tr("Satellites to list"));
    m_words->setPlaceholderText(tr("Name or number"));
    m_words->setClearButtonEnabled(true);
    m_words->setMinimumHeight(kRowHeight);
    m_lowest->setRange(0.0, kHighestFilter);
    m_lowest->setDecimals(0);
    m_lowest->setSuffix(QStringLiteral("°"));
    m_lowest->setAccessibleName(tr("Least height of a listed pass"));
    m_lowest->setToolTip(tr("Passes that do not come higher are not listed"));
    m_lowest->setMinimumHeight(kRowHeight);
    row->addWidget(m_words, 1);
    row->addWidget(makeCaption(tr("at least"), *m_lowest));
    row->addWidget(m_lowest);
    return box;
}

QWidget* PassesPanel::makeSelection()
{
    auto* const box = new QWidget(this);
    auto* const row = new QHBoxLayout(box);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(kGrid);
    m_facts->setLines(kFactLines);
    m_facts->setStretching(true);
    m_facts->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    m_refused->setLines(2);
    m_refused->setStretching(true);
    m_refused->setCollapsing(true);
    setEmphasis(*m_track, Emphasis::Primary);
    auto* const words = new QVBoxLayout;
    words->setSpacing(4);
    words->addWidget(m_facts, 1);
    words->addWidget(m_refused);
    row->addLayout(words, 1);
    m_buttons->setSpacing(kGrid);
    m_buttons->addStretch(1);
    m_buttons->addWidget(m_watch);
    m_buttons->addWidget(m_track);
    row->addLayout(m_buttons);
    return box;
}

// In a low panel the table gets the room.
void PassesPanel::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    m_facts->setLines(isLow() ? kBriefLines : kFactLines);
    m_buttons->setDirection(isLow() ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
    showSelected();
}

bool PassesPanel::isLow() const
{
    return height() < kRoomForAllFacts;
}

void PassesPanel::showStatus(const StationStatus& status)
{
    const bool isNextSecond =
        std::chrono::floor<std::chrono::seconds>(status.utc) != std::chrono::floor<std::chrono::seconds>(m_now);
    m_now = status.utc;
    searchAgain(status);
    if (isNextSecond) {
        m_passes->tick(m_now);
        showSelected();
    }
    m_track->setBlocked(!m_selected ? tr("Select a pass first.") : status.permissions.reason(Action::Track));
    m_watch->show(m_selected ? std::optional(m_selected->number) : std::nullopt, status.profile->schedule.watch);
    if (!m_searcher->isSearching()) {
        showNote(status);
    }
    showProblems(status.elementProblems);
}

// The clock of the station may be set, also back.
void PassesPanel::searchAgain(const StationStatus& status)
{
    const profile::Profile& profile = *status.profile;
    const Basis basis{.satellites = status.satellites,
                      .site = profile.site,
                      .limits = profile.limits,
                      .pointing = profile.pointing,
                      .beamWidth = profile.mount.beamWidth};
    const bool isOld = m_now < m_last.begun || m_now - m_last.begun > kSearchAgain;
    if (!basis.satellites || basis.satellites->empty() || !basis.site.known || (basis == m_last.basis && !isOld)) {
        return;
    }
    m_last.basis = basis;
    m_last.begun = m_now - kBack;
    m_searcher->search({.satellites = basis.satellites,
                        .search = {.site = basis.site.place(),
                                   .from = m_last.begun,
                                   .to = m_now + kAhead,
                                   .isClear = clearSky(profile)},
                        .beamWidth = basis.beamWidth});
}

void PassesPanel::showBook(const std::shared_ptr<const PassBook>& book)
{
    m_passes->show(book, m_now);
    showRows();
}

// What was selected stays so, where it is listed still.
void PassesPanel::showRows()
{
    const auto row = m_selected ? m_passes->rowOf(m_selected->number, m_selected->highest) : std::nullopt;
    if (row) {
        m_table->selectRow(*row);
    } else if (m_passes->rowCount() > 0) {
        m_table->selectRow(0);
    } else {
        select(-1);
    }
}

void PassesPanel::select(int row)
{
    if (row < 0) {
        m_selected.reset();
    } else {
        const BookedPass& pass = m_passes->pass(row);
        const PassBook& book = *m_passes->book();
        m_selected = Selected{.number = book.elementsOf(pass).number,
                              .highest = pass.pass.tca.utc,
                              .way = wayOf(pass, book),
                              .light = lightText(passes::lightOf(pass.pass, book.elementsOf(pass), book.site))};
    }
    showSelected();
    if (isVisible()) {
        tellWay();
    }
}

void PassesPanel::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    tellWay();
}

void PassesPanel::tellWay()
{
    Q_EMIT wayChosen(m_selected ? m_selected->way : nullptr);
}

void PassesPanel::hideEvent(QHideEvent* event)
{
    QWidget::hideEvent(event);
    Q_EMIT wayChosen({});
}

void PassesPanel::track()
{
    for (const orbit::ElementSet& elements : *m_last.basis.satellites) {
        if (elements.number == m_selected->number) {
            m_track->ask(request::Track{targets::satelliteTarget(elements)});
        }
    }
}

void PassesPanel::showSelected()
{
    const auto row = m_selected ? m_passes->rowOf(m_selected->number, m_selected->highest) : std::nullopt;
    if (!row) {
        m_facts->setValue({});
        m_facts->setToolTip({});
        return;
    }
    const BookedPass& pass = m_passes->pass(*row);
    const PassBook& book = *m_passes->book();
    const QString light = QLatin1Char('\n') + m_selected->light;
    const QString all = factsOf(pass, book, m_now) + light;
    m_facts->setValue(isLow() ? briefFactsOf(pass, book) + light : all);
    m_facts->setToolTip(isLow() ? all : QString());
}

// Why there is nothing to see, and what to do.
void PassesPanel::showNote(const StationStatus& status)
{
    const bool areKnown = status.satellites && !status.satellites->empty();
    m_openSetting->setVisible(!areKnown);
    if (!areKnown) {
        m_note->setValue(
            tr("Boresight knows no satellites. Open the setting and name a file or address with their elements."),
            Tone::Warning, Symbol::Warning);
    } else if (!status.profile->site.known) {
        m_note->setValue(tr("The site is not set. Enter it on the page Profile, or in the guide."), Tone::Warning,
                         Symbol::Warning);
    } else {
        m_note->setValue(
            tr("%1 passes of %2 satellites within a day").arg(m_passes->rowCount()).arg(status.satellites->size()),
            Tone::Secondary);
    }
}

// The satellites that are known are listed all the same.
void PassesPanel::showProblems(const QStringList& problems)
{
    if (problems.isEmpty()) {
        m_problem->setValue({});
        return;
    }
    const QString further = problems.size() > 1 ? QLatin1Char(' ') + tr("The log has more problems.") : QString();
    m_problem->setValue(problems.constFirst() + further, Tone::Warning, Symbol::Warning);
}

}  // namespace boresight::ui

#include "moc_passes_panel.cpp"
