// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/sky/plot_menu.h"

#include "core/profile/setting.h"
#include "ui/kit/format.h"
#include "ui/link/profile_draft.h"
#include "ui/sky/region_edit.h"

#include <QMenu>

namespace boresight::ui {

namespace {

constexpr std::chrono::milliseconds kMenuPatience{500};

QAction* addEntry(QMenu& menu, const QString& text, const QString& whyNot)
{
    QAction* const entry = menu.addAction(whyNot.isEmpty() ? text : PlotMenu::tr("%1 (%2)").arg(text, whyNot));
    entry->setEnabled(whyNot.isEmpty());
    entry->setToolTip(whyNot);
    return entry;
}

}  // namespace

PlotMenu::PlotMenu(const ProfileDraft& draft, RequestDesk& desk, QWidget* parent)
    : QObject(parent), m_draft(draft), m_plot(*parent), m_question(desk, this)
{
    m_patience.setSingleShot(true);
    m_patience.setInterval(kMenuPatience);
    connect(&m_question, &DirectionQuestion::answered, this, qOverload<>(&PlotMenu::show));
    connect(&m_patience, &QTimer::timeout, this, [this] { show(tr("The station does not answer."), std::nullopt); });
}

QString PlotMenu::whyNoPoint() const
{
    const std::size_t points = m_draft.edited().limits.horizon.size();
    return points + kPointsOfAHill <= profile::kMaxHorizonPoints
               ? QString()
               : tr("The horizon has %1 points. More are not possible.").arg(points);
}

QString PlotMenu::whyNoKeepOut() const
{
    const std::size_t keepOuts = m_draft.edited().limits.keepOuts.size();
    return keepOuts < profile::kMaxKeepOuts ? QString()
                                            : tr("There are %1 keep-outs. More are not possible.").arg(keepOuts);
}

void PlotMenu::open(const SkyPointing& place, const QPoint& globalPos)
{
    m_place = place;
    m_at = globalPos;
    if (m_whyNoMotion.isEmpty()) {
        m_patience.start();
        m_question.ask(place);
    } else {
        show(m_whyNoMotion, std::nullopt);
    }
}

void PlotMenu::show()
{
    show(m_question.whyNot(), m_question.nearest());
}

void PlotMenu::show(const QString& whyNot, const std::optional<SkyPointing>& nearest)
{
    m_patience.stop();
    m_question.drop();
    const SkyPointing place = m_place;
    auto* const menu = new QMenu(&m_plot);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    menu->setToolTipsVisible(true);
    menu->addSection(directionText(place));
    connect(addEntry(*menu, tr("Go here"), whyNot), &QAction::triggered, this,
            [this, place] { Q_EMIT goHereWanted(place); });
    if (nearest) {
        connect(addEntry(*menu, tr("Go to the nearest allowed: %1").arg(directionText(*nearest)), {}),
                &QAction::triggered, this, [this, there = *nearest] { Q_EMIT goHereWanted(there); });
    }
    connect(addEntry(*menu, tr("Add horizon point"), whyNoPoint()), &QAction::triggered, this,
            [this, place] { Q_EMIT horizonPointWanted(place); });
    connect(addEntry(*menu, tr("Keep-out here"), whyNoKeepOut()), &QAction::triggered, this,
            [this, place] { Q_EMIT keepOutWanted(place); });
    menu->popup(m_at);
}

}  // namespace boresight::ui

#include "moc_plot_menu.cpp"
