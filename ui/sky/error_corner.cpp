// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/sky/error_corner.h"

#include "core/budget/budget_text.h"
#include "core/pointing/beam.h"
#include "ui/budget/budget_card.h"
#include "ui/budget/off_button.h"
#include "ui/kit/command_button.h"
#include "ui/kit/format.h"
#include "ui/kit/value_label.h"
#include "ui/sky/sky_frame.h"

#include <algorithm>
#include <array>
#include <utility>

namespace boresight::ui {

namespace {

constexpr std::array kOffSizes{26, 22, 18, 16};  // pt, the largest that fits beside the disc
constexpr std::chrono::milliseconds kBudgetPeriod{1000};
constexpr int kInside = 4;  // px between the frame of the button and its words

QFont offFont(int points)
{
    QFont font = fonts::actual(points);
    font.setBold(true);
    return font;
}

QString totalText(const budget::ErrorBudget& budget)
{
    return (budget.isWhole ? ErrorCorner::tr("total %1") : ErrorCorner::tr("total ≥%1")).arg(angleText(budget.sum));
}

// To the right edge of the plot. Returns the pixel below it.
int placeAtTheEdge(ValueLabel& label, int width, int top)
{
    const QSize size = label.sizeHint();
    label.setGeometry(width - size.width(), top, size.width(), size.height());
    return top + size.height();
}

}  // namespace

ErrorCorner::ErrorCorner(QWidget& plot)
    : QObject(&plot),
      m_plot(plot),
      m_caption(new ValueLabel(tr("Distance to the target"), fonts::label(), tr("off by"), &plot)),
      m_off(new ValueLabel(tr("Off by"), offFont(kOffSizes.back()), angleText(Angle::fromDegrees(888.88)), &plot)),
      m_loss(new ValueLabel(tr("Pointing loss"), fonts::label(), budget::lossText(12.0), &plot)),
      m_total(new ValueLabel(tr("Total of the error budget"), fonts::label(),
                             tr("total ≥%1").arg(angleText(Angle::fromDegrees(188.88))), &plot)),
      m_open(new OffButton(&plot)),
      m_card(new BudgetCard(&plot))
{
    for (ValueLabel* const label : {m_caption, m_off, m_loss, m_total}) {
        label->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
        label->setAutoFillBackground(true);  // over the sky of a magnified plot
    }
    m_loss->setToolTip(tr("Loss of power by the pointing error. It is shown up to one beam width."));
    m_open->raise();
    connect(m_open, &QToolButton::clicked, this, &ErrorCorner::openBudget);
}

QList<QWidget*> ErrorCorner::parts() const
{
    QList<QWidget*> all{m_caption, m_off, m_open, m_loss};
    if (m_totalFits) {
        all.append(m_total);
    }
    return all;
}

QList<const ValueLabel*> ErrorCorner::words() const
{
    return {m_caption, m_off};
}

bool ErrorCorner::isEmpty(const QWidget& part) const
{
    const auto* const label = &part == m_open ? m_off : qobject_cast<const ValueLabel*>(&part);
    return label != nullptr && label->text().isEmpty();
}

// The button is around the caption and the number.
void ErrorCorner::place(const SkyFrame& frame, int gap)
{
    const int right = m_plot.width() - gap - kInside;
    for (const int points : kOffSizes) {
        m_off->setFont(offFont(points));
        const int below = placeAtTheEdge(*m_off, right, placeAtTheEdge(*m_caption, right, gap + 1));
        const int left = std::min(m_off->x(), m_caption->x()) - kInside;
        m_open->setGeometry(left, gap, right + kInside - left, std::max(below + 1 - gap, kTouchSize));
        placeAtTheEdge(*m_total, right, placeAtTheEdge(*m_loss, right, gap + m_open->height()));
        if (frame.isFree(m_open->geometry()) && frame.isFree(m_loss->geometry())) {
            break;
        }
    }
    m_totalFits = frame.isFree(m_total->geometry());
    m_total->setVisible(m_totalFits);
}

bool ErrorCorner::showOffTarget(const std::optional<Angle>& error, Angle beamWidth, bool unplanned)
{
    const auto loss = error ? pointing::pointingLoss(*error, beamWidth) : std::nullopt;
    const auto isShown = [this] { return std::pair(!isEmpty(*m_off), !isEmpty(*m_loss)); };
    const auto before = isShown();
    m_caption->setValue(error ? tr("off by") : QString(), Tone::Secondary);
    m_off->setValue(error ? angleText(*error) : QString(), unplanned ? Tone::Warning : Tone::Normal);
    m_loss->setValue(budget::lossText(loss), unplanned ? Tone::Warning : Tone::Secondary);
    return before != isShown();
}

bool ErrorCorner::showBudget(const std::optional<budget::ErrorBudget>& budget, UtcTime utc)
{
    const bool isSame = budget.has_value() == m_budget.has_value();
    m_budget = budget;
    if (isSame && utc >= m_worded && utc < m_worded + kBudgetPeriod) {
        return false;
    }
    m_worded = utc;
    const bool was = isEmpty(*m_total);
    m_total->setValue(budget ? totalText(*budget) : QString(), Tone::Secondary);
    const QString angle = tr("The angle on the sky between the target and the direction of the mount");
    m_open->setToolTip(budget ? angle + QStringLiteral("\n\n") + budget::listText(*budget) : angle);
    m_open->setAccessibleDescription(budget ? budget::offByText(*budget) : QString());
    m_card->showBudget(budget);
    return was != isEmpty(*m_total);
}

void ErrorCorner::openBudget()
{
    m_card->showBudget(m_budget);
    m_card->show();
    m_card->activateWindow();
}

}  // namespace boresight::ui

#include "moc_error_corner.cpp"
