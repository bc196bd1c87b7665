// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/passes/selected_pass.h"

#include "core/passes/pass_light.h"
#include "core/plan/plan_words.h"
#include "core/targets/target.h"
#include "core/targets/track_rules.h"
#include "ui/kit/command_button.h"
#include "ui/kit/value_label.h"
#include "ui/look/paint.h"
#include "ui/passes/driven_plan.h"
#include "ui/passes/favourite_button.h"
#include "ui/passes/note_line.h"
#include "ui/passes/pass_details.h"
#include "ui/passes/pass_words.h"
#include "ui/passes/satellite_antenna.h"
#include "ui/passes/watch_button.h"
#include "ui/sky/range_words.h"

#include <QHBoxLayout>
#include <QVBoxLayout>

#include <algorithm>
#include <chrono>

namespace boresight::ui {

namespace {

constexpr int kFactLines = 10;
constexpr int kBriefLines = 4;
constexpr int kPlanLines = 3;  // the plan needs the room

// Empty if the whole pass needs no turn back.
QString cableLine(const targets::CableTurns& cable)
{
    return cable.turns == 0 ? QString() : QLatin1Char('\n') + cableFact(cable);
}

// A plan that only follows the satellite is not worth a line.
QString drivenText(const plan::SharedVariant& plan)
{
    return plan && !plan::isPlain(*plan) ? SelectedPass::tr("Plan in use: %1").arg(plan::summaryText(*plan))
                                         : QString();
}

}  // namespace

SelectedPass::SelectedPass(ProfileDraft& draft, RequestDesk& desk, QWidget* parent)
    : QWidget(parent),
      m_facts(new ValueLabel(tr("The selected pass"), fonts::label(), {}, this)),
      m_refused(new ValueLabel(tr("Refused"), fonts::label(), {}, this)),
      m_buttons(new QBoxLayout(QBoxLayout::TopToBottom)),
      m_track(new CommandButton(
          tr("Track"),
          tr("Go to the place where the satellite rises. Track the satellite until it sets. Then the mount holds"),
          desk, *m_refused, this)),
      m_trackThisWay(new CommandButton(tr("Track this way"),
                                       tr("Track the satellite by the plan that is selected above, and not by the best "
                                          "one"),
                                       desk, *m_refused, this)),
      m_watch(new WatchButton(draft, desk, *m_refused, this)),
      m_favourite(new FavouriteButton(draft, desk, *m_refused, this)),
      m_note(new NoteLine(draft, *m_refused, this)),
      m_antenna(new SatelliteAntenna(draft, *m_refused, this))
{
    build();
    connect(m_track, &QPushButton::clicked, this, [this] { track({}); });
    connect(m_trackThisWay, &QPushButton::clicked, this, [this] {
        if (m_plan && m_plan->variant) {
            track(plan::choiceFor(*m_plan->variant));
        }
    });
    connect(m_note, &NoteLine::left, this, [this] { setNoteShown(m_isNoteShown); });
}

void SelectedPass::build()
{
    m_facts->setStretching(true);
    m_facts->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    m_refused->setLines(2);
    m_refused->setStretching(true);
    m_refused->setCollapsing(true);
    setEmphasis(*m_track, Emphasis::Primary);
    m_buttons->setSpacing(kGrid);
    m_buttons->addStretch(1);
    m_buttons->addWidget(m_favourite);
    m_buttons->addWidget(m_watch);
    m_buttons->addWidget(m_trackThisWay);
    m_buttons->addWidget(m_track);
    auto* const words = new QVBoxLayout;
    words->setSpacing(4);
    words->addWidget(m_facts, 1);
    words->addWidget(m_refused);
    auto* const row = new QHBoxLayout;
    row->setSpacing(kGrid);
    row->addLayout(words, 1);
    row->addLayout(m_buttons);
    auto* const column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(4);
    auto* const kept = new QHBoxLayout;
    kept->setSpacing(kGrid);
    kept->addWidget(m_note, 1);
    kept->addWidget(m_antenna);
    column->addLayout(kept);
    column->addLayout(row);
    setBrief(false, true);
}

void SelectedPass::setBrief(bool on, bool isNamed)
{
    m_isBrief = on;
    m_isNamed = isNamed;
    m_buttons->setDirection(on ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
    showButtons();
    showFacts();
}

// In little room the star in the table does the same as the button, and another view has the schedule.
void SelectedPass::showButtons()
{
    m_facts->setLines(!m_isBrief ? kFactLines : m_plan ? kPlanLines : kBriefLines);
    m_favourite->setHidden(m_isBrief);
    m_watch->setHidden(m_isBrief && m_plan);
    m_trackThisWay->setVisible(m_plan.has_value());
}

void SelectedPass::showPlan(const std::optional<ShownPlan>& plan)
{
    m_plan = plan;
    showButtons();
    showFacts();
}

void SelectedPass::setNoteShown(bool on)
{
    m_isNoteShown = on;
    m_note->setVisible(on || m_note->hasFocus());
    m_antenna->setRoom(on || m_note->hasFocus());
    showFacts();
}

std::optional<int> SelectedPass::satellite() const
{
    return m_pass ? std::optional(static_cast<int>(m_book->elementsOf(*m_pass).number)) : std::nullopt;
}

void SelectedPass::select(const std::shared_ptr<const PassBook>& book, const std::optional<BookedPass>& pass)
{
    const std::optional<int> before = satellite();
    m_book = book;
    m_pass = pass;
    if (satellite() != before) {
        m_refused->setValue({});  // the refusal was about the other satellite
    }
    m_cable = pass ? cableLine(cableOf(*pass, *book)) : QString();
    m_light = pass ? lightText(passes::lightOf(pass->pass, book->elementsOf(*pass), book->site)) : QString();
    showFacts();
}

void SelectedPass::showStatus(const StationStatus& status)
{
    const orbit::SatelliteMarks& marks = status.profile->satellites;
    m_satellites = status.satellites;
    const QString why = whyNotTracked(status);
    m_track->setBlocked(why);
    const bool hasPlan = m_plan && m_plan->variant;
    m_trackThisWay->setBlocked(why.isEmpty() && !hasPlan ? tr("There is no plan to choose.") : why);
    m_watch->show(satellite(), status.profile->schedule.watch);
    m_favourite->show(satellite(), marks);
    m_note->show(satellite(), marks);
    m_antenna->show(satellite(), *status.profile);
    const QString note = m_pass ? QString::fromStdString(orbit::noteOf(marks, *satellite())) : QString();
    const UtcTime second = std::chrono::floor<std::chrono::seconds>(status.utc);
    const QString driven = m_pass ? drivenText(drivenPlan(status.tracked, *m_book, *m_pass)) : QString();
    if (second != m_now || note != m_noteText || driven != m_driven) {
        m_now = second;
        m_noteText = note;
        m_driven = driven;
        showFacts();
    }
}

const orbit::ElementSet* SelectedPass::elements() const
{
    const auto found = std::ranges::find(*m_satellites, *satellite(), &orbit::ElementSet::number);
    return found == m_satellites->end() ? nullptr : &*found;
}

// The station always tracks the next pass of a satellite. So the selected pass itself must come soon. An earlier pass
// of the satellite that comes soon is not enough.
QString SelectedPass::whyNotTracked(const StationStatus& status) const
{
    if (!m_pass) {
        return tr("Select a pass first.");
    }
    if (!status.permissions.allows(Action::Track)) {
        return status.permissions.reason(Action::Track);
    }
    if (elements() == nullptr) {
        return tr("The station has no elements of this satellite any more.");
    }
    const targets::Target target = targets::satelliteTarget(*elements());
    const Result<> may = targets::isFresh(target, status.utc, status.profile->orbit.oldestDays).and_then([&] {
        return targets::isSoon(target.name, m_pass->pass.aos.utc, status.utc);
    });
    return may ? QString() : may.error().text;
}

void SelectedPass::track(const std::optional<plan::ChosenWay>& way)
{
    if (const orbit::ElementSet* const set = elements()) {
        (way ? m_trackThisWay : m_track)->ask(request::Track{.target = targets::satelliteTarget(*set), .way = way});
    }
}

void SelectedPass::toggleFavourite(int satellite)
{
    m_favourite->toggle(satellite);
}

void SelectedPass::editNote()
{
    m_note->setVisible(true);
    m_antenna->setRoom(true);
    showFacts();
    m_note->setFocus(Qt::ShortcutFocusReason);
}

void SelectedPass::showFacts()
{
    if (!m_pass) {
        m_facts->setValue({});
        m_facts->setToolTip({});
        return;
    }
    const QString range = rangeText(m_book->elementsOf(*m_pass), m_book->site, m_now);
    const QString now = range.isEmpty() ? QString() : QLatin1Char('\n') + tr("now %1").arg(range);
    const QString light = QLatin1Char('\n') + m_light;
    const QString note = m_noteText.isEmpty() ? QString() : m_noteText + QLatin1Char('\n');
    const QString driven = m_driven.isEmpty() ? QString() : QLatin1Char('\n') + m_driven;
    const QString sentence = m_plan ? QLatin1Char('\n') + m_plan->sentence : QString();
    QString all = factsOf(*m_pass, *m_book, m_now) + driven + light + m_cable;
    all.insert(all.indexOf(QLatin1Char('\n')),
               sentence + now);  // near the top, because the last lines are cut off first
    if (m_isBrief && m_plan) {
        m_facts->setValue(tr("%1. %2").arg(targets::satelliteName(m_book->elementsOf(*m_pass)), m_plan->sentence));
        m_facts->setToolTip(note + all);
        return;
    }
    QString brief = briefFactsOf(*m_pass, *m_book, m_now, m_isNamed);
    brief.insert(brief.lastIndexOf(QLatin1Char('\n')), now);  // before the line with the age of the elements
    const auto hasRoom = [&brief] { return brief.count(QLatin1Char('\n')) + 2 <= kBriefLines; };
    if (m_note->isHidden() && (!m_isNamed || hasRoom())) {
        brief.prepend(note);
    }
    if (hasRoom()) {
        brief += m_driven.isEmpty() ? light : driven;
    }
    m_facts->setValue(m_isBrief ? brief : all);
    m_facts->setToolTip(m_isBrief ? note + all : QString());
}

}  // namespace boresight::ui

#include "moc_selected_pass.cpp"
