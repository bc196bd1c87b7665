// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/passes/passes_panel.h"

#include "core/profile/clear_sky.h"
#include "core/targets/pass_way.h"
#include "ui/kit/read_table.h"
#include "ui/kit/value_label.h"
#include "ui/look/paint.h"
#include "ui/passes/elements_button.h"
#include "ui/passes/pass_columns.h"
#include "ui/passes/pass_filter.h"
#include "ui/passes/pass_table.h"
#include "ui/passes/pass_views.h"
#include "ui/passes/selected_pass.h"
#include "ui/plan/plan_view.h"

#include <QAction>
#include <QHBoxLayout>
#include <QTableView>
#include <QVBoxLayout>

#include <chrono>

namespace boresight::ui {

namespace {

constexpr std::chrono::hours kAhead{24};
constexpr std::chrono::hours kSearchAgain{6};
// The search begins this long ago, so that a present pass is found with its beginning.
constexpr std::chrono::minutes kBack{30};
constexpr int kProblemLines = 3;
constexpr int kProblemLinesIfLow = 2;  // the tooltip has the whole text
// px. In a lower panel all facts together would leave the table only one or two rows.
constexpr int kRoomForAllFacts = 400;

std::map<std::int64_t, pointing::Antenna> ownAntennas(const profile::Profile& profile)
{
    std::map<std::int64_t, pointing::Antenna> own;
    for (const orbit::SatelliteMark& mark : profile.satellites) {
        if (!mark.antenna.empty()) {
            own[mark.number] = profile.antenna(mark.antenna);
        }
    }
    return own;
}

PassAntenna judgedBy(const profile::Profile& profile, const pointing::Antenna& antenna)
{
    return {.beamWidth = antenna.beamWidth, .reach = targets::reachOf(profile, antenna)};
}

// The number of listed passes, and how many the filter hides.
QString countText(const PassCount& count)
{
    if (count.coming == 0) {
        return PassesPanel::tr("No satellite rises within a day.");
    }
    if (count.listed == count.coming) {
        return PassesPanel::tr("%1 passes of %2 satellites within a day").arg(count.listed).arg(count.satellites);
    }
    if (count.listed == 0) {
        return PassesPanel::tr("No pass matches the filter. The filter leaves out %1.").arg(count.coming);
    }
    return PassesPanel::tr("%1 of %2 passes within a day, of %3 satellites")
        .arg(count.listed)
        .arg(count.coming)
        .arg(count.satellites);
}

}  // namespace

PassesPanel::PassesPanel(ProfileDraft& draft, RequestDesk& desk, QWidget* parent)
    : QWidget(parent),
      m_searcher(new PassSearcher(this)),
      m_passes(new PassTable(this)),
      m_table(makeReadTable(tr("Coming passes"), *m_passes, this)),
      m_columns(new PassColumns(*m_passes, *m_table, this)),
      m_views(new PassViews(*m_passes, *m_table, this)),
      m_choices(m_views->makeChoices(this)),
      m_filter(new PassFilter(this)),
      m_note(new ValueLabel(tr("About the passes"), fonts::label(), {}, this)),
      m_problem(new ValueLabel(tr("Problems with the elements"), fonts::label(), {}, this)),
      m_elements(new ElementsButton(draft, this)),
      m_selection(new SelectedPass(draft, desk, this))
{
    build();
    connect(m_searcher, &PassSearcher::found, this, &PassesPanel::showBook);
    connect(m_searcher, &PassSearcher::progressed, this,
            [this](int percent) { m_note->setValue(tr("Searching for passes: %1 %").arg(percent), Tone::Secondary); });
    connect(m_filter, &PassFilter::changed, this, [this] {
        m_passes->setChoice(m_filter->choice());
        showRows();
    });
    connect(m_table->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
            [this](const QModelIndex& now) { select(now.isValid() ? now.row() : -1); });
    connect(m_table, &QTableView::clicked, this, [this](const QModelIndex& cell) {
        if (cell.column() == PassTable::Favourite) {
            toggleFavourite(cell.row());
        }
    });
    connect(m_views, &PassViews::viewChanged, this, [this] {
        fitHeight();
        tellPlan();
    });
    connect(m_views, &PassViews::planChanged, this, &PassesPanel::tellPlan);
    connect(m_elements, &ElementsButton::settingsWanted, this, [this] { Q_EMIT settingsWanted(tr("elements")); });
    connect(m_elements, &ElementsButton::siteWanted, this, &PassesPanel::siteWanted);
}

void PassesPanel::build()
{
    auto* const column = new QVBoxLayout(this);
    column->setContentsMargins(6, 6, 6, 6);
    column->setSpacing(4);
    m_note->setLines(2);
    m_note->setStretching(true);
    auto* const notes = new QHBoxLayout;
    notes->setSpacing(kGrid);
    notes->addWidget(m_choices);
    notes->addWidget(m_note, 1);
    notes->addWidget(m_elements);
    m_filter->layout()->addWidget(m_columns->makeButton(m_filter));
    column->addLayout(notes);
    column->addWidget(m_filter);
    m_problem->setStretching(true);
    m_problem->setCollapsing(true);
    column->addWidget(m_problem);
    column->addWidget(m_views, 1);
    column->addWidget(m_selection);
    addActions();
}

// In a low panel the room is given to the table or the picture. A picture of one pass needs no filter.
void PassesPanel::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    fitHeight();
}

void PassesPanel::fitHeight()
{
    m_problem->setLines(kProblemLines);
    const bool isLow = height() < kRoomForAllFacts + m_problem->sizeHint().height();
    m_problem->setLines(isLow ? kProblemLinesIfLow : kProblemLines);
    const PassViews::View view = m_views->view();
    m_selection->setBrief(isLow, view != PassViews::List);
    m_selection->setNoteShown(!isLow);
    const bool isOfOnePass = view == PassViews::Elevation || view == PassViews::Map || view == PassViews::Plan;
    m_filter->setHidden(isLow && isOfOnePass);
}

PassesLayout PassesPanel::arrangement() const
{
    return {
        .view = m_views->view(), .onlyFavourites = m_filter->choice().onlyFavourites, .columns = m_columns->chosen()};
}

// A settings file that was edited by hand may contain an unknown view.
void PassesPanel::arrange(const PassesLayout& layout)
{
    const bool isThere = layout.view >= 0 && layout.view < m_views->count();
    m_views->showView(isThere ? static_cast<PassViews::View>(layout.view) : PassViews::List);
    m_filter->setOnlyFavourites(layout.onlyFavourites);
    m_columns->choose(layout.columns);
}

// The actions of the right-click menu, with their keys: Space for the star, F2 to edit.
void PassesPanel::addActions()
{
    m_table->setContextMenuPolicy(Qt::ActionsContextMenu);
    const auto add = [this](const QString& text, Qt::Key key, auto act) {
        auto* const action = new QAction(text, m_table);
        action->setShortcut(key);
        action->setShortcutContext(Qt::WidgetShortcut);
        m_table->addAction(action);
        connect(action, &QAction::triggered, this, [this, act] {
            if (m_table->currentIndex().isValid()) {
                act();
            }
        });
    };
    add(tr("Favourite, or not"), Qt::Key_Space, [this] { toggleFavourite(m_table->currentIndex().row()); });
    add(tr("Edit the note"), Qt::Key_F2, [this] { m_selection->editNote(); });
}

void PassesPanel::toggleFavourite(int row)
{
    m_selection->toggleFavourite(static_cast<int>(m_passes->book()->elementsOf(m_passes->pass(row)).number));
}

// When the selected pass is over, the next one of its satellite is selected. Track never changes to another satellite
// by itself.
void PassesPanel::dropPassesThatAreOver()
{
    const auto number = m_selected ? std::optional(m_selected->number) : std::nullopt;
    m_passes->tick(m_now);
    if (!number || (m_selected && m_selected->number == *number)) {
        return;
    }
    if (const auto row = m_passes->nextOf(*number)) {
        m_table->selectRow(*row);
    } else {
        m_table->setCurrentIndex({});
        m_table->clearSelection();
    }
}

void PassesPanel::showStatus(const StationStatus& status)
{
    const bool isNextSecond =
        std::chrono::floor<std::chrono::seconds>(status.utc) != std::chrono::floor<std::chrono::seconds>(m_now);
    m_now = status.utc;
    searchAgain(status);
    if (isNextSecond) {
        dropPassesThatAreOver();
        m_views->showStatus(status);
        showFavourites(status);
    }
    if (status.profile->satellites != m_passes->marks()) {
        m_passes->setMarks(status.profile->satellites);
        if (m_filter->choice().onlyFavourites) {
            showRows();
        }
    }
    m_selection->showStatus(status);
    m_elements->showStatus(status);
    if (!m_searcher->isSearching()) {
        showNote(status);
    }
    showProblems(status.elementProblems);
}

// The clock of the station may be changed in both directions.
void PassesPanel::searchAgain(const StationStatus& status)
{
    const profile::Profile& profile = *status.profile;
    const Basis basis{.satellites = status.satellites,
                      .site = profile.site,
                      .limits = profile.limits,
                      .pointing = profile.pointing,
                      .antenna = profile.antenna(status.chosenAntenna),
                      .reach = targets::reachOf(profile, profile.antenna(status.chosenAntenna)),
                      .own = ownAntennas(profile)};
    const bool isOld = m_now < m_last.begun || m_now - m_last.begun > kSearchAgain;
    if (!basis.satellites || basis.satellites->empty() || !basis.site.known || (basis == m_last.basis && !isOld)) {
        return;
    }
    m_last.basis = basis;
    m_last.begun = m_now - kBack;
    std::map<std::int64_t, OwnAntenna> own;
    for (const auto& [number, antenna] : basis.own) {
        own[number] = {.antenna = judgedBy(profile, antenna), .isClear = clearSky(profile, antenna)};
    }
    m_searcher->search({.satellites = basis.satellites,
                        .search = {.site = basis.site.place(),
                                   .from = m_last.begun,
                                   .to = m_now + kAhead,
                                   .isClear = clearSky(profile, basis.antenna)},
                        .antenna = judgedBy(profile, basis.antenna),
                        .own = own});
}

void PassesPanel::showBook(const std::shared_ptr<const PassBook>& book)
{
    m_passes->show(book, m_now);
    showRows();
}

// The same pass stays selected while it is listed.
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
        m_selection->select(nullptr, std::nullopt);
        m_views->select(nullptr, std::nullopt, nullptr);
    } else {
        const BookedPass& pass = m_passes->pass(row);
        const PassBook& book = *m_passes->book();
        const orbit::ElementSet& elements = book.elementsOf(pass);
        m_selected = Selected{.number = elements.number,
                              .highest = pass.pass.tca.utc,
                              .way = targets::wayOf(pass.pass, elements, book.site)};
        m_selection->select(m_passes->book(), pass);
        m_views->select(m_passes->book(), pass, m_selected->way);
    }
    if (isVisible()) {
        tellWay();
    }
}

void PassesPanel::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    tellWay();
    tellPlan();
}

void PassesPanel::tellWay()
{
    Q_EMIT wayChosen(m_selected ? m_selected->way : nullptr);
}

void PassesPanel::tellPlan()
{
    const PlanView& plan = m_views->plan();
    const bool isShown = m_views->view() == PassViews::Plan;
    m_selection->showPlan(isShown ? std::optional(ShownPlan{.variant = plan.variant(), .sentence = plan.sentence()})
                                  : std::nullopt);
    Q_EMIT beamChosen(isShown && isVisible() ? plan.beam() : nullptr);
}

void PassesPanel::hideEvent(QHideEvent* event)
{
    QWidget::hideEvent(event);
    Q_EMIT wayChosen({});
    Q_EMIT beamChosen({});
}

// Also while this panel is hidden, because the plot is always visible.
void PassesPanel::showFavourites(const StationStatus& status)
{
    const profile::SiteSettings& site = status.profile->site;
    m_favourites.setBasis(status.satellites, status.profile->satellites,
                          site.known ? std::optional(site.place()) : std::nullopt);
    m_favourites.setRefraction(status.profile->orbit.refraction);
    Q_EMIT favouritesMoved(
        m_favourites.at(status.utc, status.tracked ? status.tracked->number : std::optional<std::int64_t>()));
}

// The reason why the list is empty, and what to do.
void PassesPanel::showNote(const StationStatus& status)
{
    const bool areKnown = status.satellites && !status.satellites->empty();
    m_choices->setVisible(areKnown && status.profile->site.known);
    if (!m_elements->refusal().isEmpty()) {
        m_note->setValue(m_elements->refusal(), Tone::Warning, Symbol::Warning);
    } else if (!areKnown) {
        m_note->setValue(tr("Boresight knows no satellites. Add their elements."), Tone::Warning, Symbol::Warning);
    } else if (!status.profile->site.known) {
        m_note->setValue(tr("The site is not set. Passes depend on it."), Tone::Warning, Symbol::Warning);
    } else if (m_passes->rowCount() == 0 && m_filter->choice().onlyFavourites) {
        m_note->setValue(tr("No favourite passes within a day. Click the star of a row to add one."), Tone::Secondary);
    } else {
        m_note->setValue(countText(m_passes->count()), Tone::Secondary);
    }
}

// Satellites without a problem are listed all the same.
void PassesPanel::showProblems(const QStringList& problems)
{
    const bool hadProblem = !m_problem->text().isEmpty();
    if (problems.isEmpty()) {
        m_problem->setValue({});
    } else {
        const QString further = problems.size() > 1 ? QLatin1Char(' ') + tr("The log has more problems.") : QString();
        m_problem->setValue(problems.constFirst() + further, Tone::Warning, Symbol::Warning);
    }
    if (hadProblem == problems.isEmpty()) {
        fitHeight();
    }
}

}  // namespace boresight::ui

#include "moc_passes_panel.cpp"
