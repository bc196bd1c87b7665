// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/sky/plot_editor.h"

#include "ui/kit/format.h"
#include "ui/sky/region_marks.h"

#include <QContextMenuEvent>
#include <QKeyEvent>
#include <QMenu>
#include <QMouseEvent>
#include <QPainter>

namespace boresight::ui {

namespace {

constexpr double kReach = 8.0;  // px: how near a click must be to a line or point
constexpr Angle kSnap = 0.5_deg;
constexpr Angle kFineSnap = 0.1_deg;

Qt::CursorShape cursorFor(const std::optional<Grip>& grip)
{
    if (!grip) {
        return Qt::CrossCursor;
    }
    return grip->part == RegionPart::KeepOut || grip->part == RegionPart::HorizonPoint ? Qt::SizeAllCursor
                                                                                       : Qt::PointingHandCursor;
}

}  // namespace

PlotEditor::PlotEditor(ProfileDraft& draft, QWidget* parent) : QWidget(parent), m_draft(draft)
{
    setAccessibleName(tr("Limits on the plot"));
    setAccessibleDescription(tr("The Limits panel changes the same limits by keyboard"));
    setMouseTracking(true);
    setEditing(false);
    connect(&m_draft, &ProfileDraft::changed, this, &PlotEditor::followDraft);
}

void PlotEditor::setEditing(bool on)
{
    cancelDrag();
    m_editing = on;
    setAttribute(Qt::WA_TransparentForMouseEvents, !on);
    setFocusPolicy(on ? Qt::StrongFocus : Qt::NoFocus);
    setToolTip(on ? tr("Drag an edge, a corner, a point or a whole keep-out (Shift: 0.1°). Double click or +: point of "
                       "the horizon. Del: remove")
                  : QString());
    select(std::nullopt);
    Q_EMIT readout({});
    update();
}

void PlotEditor::setSky(const SkyProjection& sky)
{
    m_sky = sky;
    update();
}

void PlotEditor::setTravel(const Travel& travel)
{
    m_travel = travel;
    update();
}

bool PlotEditor::cancelDrag()
{
    if (!m_drag) {
        return false;
    }
    const pointing::Region before = m_drag->start();
    m_drag.reset();
    change([&before](pointing::Region& region) { region = before; });
    showReadout();
    return true;
}

bool PlotEditor::leave()
{
    if (m_editing) {
        Q_EMIT leaveWanted();
        return true;
    }
    return false;
}

// The tables and Revert also change the draft, so the selected or dragged part may be gone.
void PlotEditor::followDraft()
{
    const auto gone = [this](const Grip& grip) {
        return (grip.part == RegionPart::HorizonPoint && grip.index >= edited().horizon.size()) ||
               (grip.part == RegionPart::KeepOut && grip.index >= edited().keepOuts.size());
    };
    if (m_drag && gone(m_drag->grip())) {
        m_drag.reset();
    }
    if (m_selected && gone(*m_selected)) {
        m_selected.reset();
    }
    update();
}

void PlotEditor::change(const std::function<void(pointing::Region&)>& change)
{
    m_draft.edit([&change](profile::Profile& profile) { change(profile.limits); });
}

std::optional<Grip> PlotEditor::under(QPointF pixel) const
{
    return gripAt(edited(), m_travel, m_sky, pixel, kReach);
}

void PlotEditor::select(const std::optional<Grip>& grip)
{
    m_selected = grip;
    update();
}

void PlotEditor::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    paint(painter);
}

void PlotEditor::paint(QPainter& painter) const
{
    painter.setRenderHint(QPainter::Antialiasing);
    const RegionMarks marks(edited(), m_travel, m_sky);
    marks.paintChanges(painter, m_draft.inForce().limits);
    if (m_editing) {
        marks.paintGrips(painter, m_selected);
    }
}

void PlotEditor::mousePressEvent(QMouseEvent* event)
{
    m_cursor = event->position();
    if (event->button() == Qt::LeftButton) {
        select(under(m_cursor));
        if (m_selected) {
            m_drag.emplace(edited(), m_travel, *m_selected, m_sky.toSky(m_cursor));
        }
    }
    showReadout();
}

void PlotEditor::mouseMoveEvent(QMouseEvent* event)
{
    m_cursor = event->position();
    if (m_drag) {
        const Angle snap = event->modifiers().testFlag(Qt::ShiftModifier) ? kFineSnap : kSnap;
        const pointing::Region dragged = m_drag->to(m_sky.toSky(m_cursor), snap);
        m_selected = m_drag->grip();
        change([&dragged](pointing::Region& region) { region = dragged; });
    }
    showReadout();
}

void PlotEditor::mouseReleaseEvent(QMouseEvent* event)
{
    if (event->button() == Qt::LeftButton) {
        m_drag.reset();
        showReadout();
    }
}

void PlotEditor::mouseDoubleClickEvent(QMouseEvent* event)
{
    m_cursor = event->position();
    const std::optional<Grip> there = under(m_cursor);
    const bool onPoint = there && there->part == RegionPart::HorizonPoint;
    if (event->button() == Qt::LeftButton && m_sky.contains(m_cursor) && !onPoint) {
        addPoint(m_sky.toSky(m_cursor));
    }
}

void PlotEditor::keyPressEvent(QKeyEvent* event)
{
    const bool inside = rect().contains(m_cursor.toPoint()) && m_sky.contains(m_cursor);
    if (event->key() == Qt::Key_Delete && m_selected && !m_drag) {
        removeSelected();
    } else if (event->key() == Qt::Key_Plus && inside && !m_drag) {
        addPoint(m_sky.toSky(m_cursor));
    } else {
        QWidget::keyPressEvent(event);
    }
}

void PlotEditor::contextMenuEvent(QContextMenuEvent* event)
{
    if (m_drag) {
        return;
    }
    select(under(event->pos()));
    const SkyPointing at = m_sky.toSky(event->pos());
    auto* const menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    if (m_selected && m_selected->part == RegionPart::HorizonPoint) {
        menu->addAction(tr("Remove this point of the horizon (Del)"), this, &PlotEditor::removeSelected);
    }
    if (m_selected && m_selected->part == RegionPart::KeepOut) {
        menu->addAction(tr("Remove %1 (Del)").arg(QString::fromStdString(edited().keepOuts.at(m_selected->index).name)),
                        this, &PlotEditor::removeSelected);
    }
    menu->addAction(tr("Add a point of the horizon here (+)"), this, [this, at] { addPoint(at); });
    menu->addAction(tr("Add a keep-out here"), this, [this, at] { addSector(at); });
    menu->popup(event->globalPos());
}

void PlotEditor::leaveEvent(QEvent*)
{
    if (!m_drag) {
        Q_EMIT readout({});
    }
}

void PlotEditor::addPoint(const SkyPointing& at)
{
    std::size_t index = 0;
    change([&](pointing::Region& region) { index = addHorizonPoint(region, m_travel, at); });
    select(Grip{.part = RegionPart::HorizonPoint, .index = index});
    showReadout();
}

void PlotEditor::addSector(const SkyPointing& centre)
{
    std::size_t index = 0;
    change([&](pointing::Region& region) { index = addKeepOut(region, centre); });
    select(Grip{.part = RegionPart::KeepOut, .index = index, .sides = {true, true, true, true}});
    showReadout();
}

void PlotEditor::removeSelected()
{
    if (!m_selected) {
        return;
    }
    const Grip gone = *m_selected;
    m_selected.reset();
    change([&gone](pointing::Region& region) { remove(region, gone); });
    showReadout();
}

void PlotEditor::showReadout()
{
    const std::optional<Grip> grip = m_drag ? std::optional(m_drag->grip()) : under(m_cursor);
    setCursor(cursorFor(grip));
    if (!m_editing) {
        return;
    }
    const SkyPointing place = m_sky.toSky(m_cursor);
    const QString here = tr("az %1\nel %2").arg(azimuthText(place.azimuth, 1), angleText(place.elevation, 1));
    Q_EMIT readout(grip ? describe(edited(), m_travel, *grip) : m_sky.contains(m_cursor) ? here : QString());
}

}  // namespace boresight::ui

#include "moc_plot_editor.cpp"
