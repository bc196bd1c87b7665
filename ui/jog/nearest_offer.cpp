// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/jog/nearest_offer.h"

#include "ui/kit/format.h"

namespace boresight::ui {

NearestOffer::NearestOffer(RequestDesk& desk, ValueLabel& notice, QWidget* parent)
    : CommandButton(tr("Go there"), {}, desk, notice, parent), m_question(desk)
{
    hide();
    connect(&m_question, &DirectionQuestion::answered, this, &NearestOffer::show);
    connect(this, &QPushButton::clicked, this, [this] {
        if (const auto nearest = m_question.nearest()) {
            ask(request::PointSky{*nearest});
        }
    });
    connect(this, &CommandButton::accepted, this, &NearestOffer::drop);
}

void NearestOffer::offerFor(const SkyPointing& refusedDirection)
{
    m_question.ask(refusedDirection);
}

void NearestOffer::drop()
{
    m_question.drop();
    hide();
}

void NearestOffer::show()
{
    const auto nearest = m_question.nearest();
    if (nearest) {
        const QString there = directionText(*nearest);
        setCommand(tr("Go to %1").arg(there), tr("Go to %1, the nearest allowed direction").arg(there));
    }
    setVisible(nearest.has_value());
}

}  // namespace boresight::ui

#include "moc_nearest_offer.cpp"
