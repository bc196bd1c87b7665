// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/passes/position_box.h"

#include "core/units/direction_text.h"
#include "core/units/duration_text.h"
#include "ui/kit/command_button.h"
#include "ui/kit/format.h"
#include "ui/kit/value_label.h"

#include <QGridLayout>

namespace boresight::ui {

namespace {

// "V2850795: 105.3° / 9.9°, 41.2 km, 12400 m high, 1 s old"
QString placeText(const PositionStatus& position)
{
    if (!position.place) {
        return PositionBox::tr("Balloon or rocket: %1").arg(position.source);
    }
    QStringList parts;
    if (position.direction && position.kilometres) {
        parts << beamText(*position.direction) << PositionBox::tr("%1 km").arg(*position.kilometres, 0, 'f', 1);
    }
    parts << PositionBox::tr("%1 m high").arg(position.place->heightMetres, 0, 'f', 0);
    if (position.age) {
        parts << PositionBox::tr("%1 old").arg(durationText(*position.age));
    }
    const QString name = position.name.isEmpty() ? PositionBox::tr("Balloon or rocket") : position.name;
    return name + QStringLiteral(": ") + parts.join(QStringLiteral(", "));
}

QString sentence(const QString& text)
{
    return text.left(1).toUpper() + text.mid(1) + QLatin1Char('.');
}

QString countText(const PositionStatus& position)
{
    return PositionBox::tr("%1 positions received, %2 refused.").arg(position.accepted).arg(position.refused);
}

QString phaseText(const PositionStatus& position)
{
    switch (position.phase) {
        case PositionPhase::Off:
            break;
        case PositionPhase::Following:
            return PositionBox::tr("Tracked.") + QLatin1Char(' ');
        case PositionPhase::Stale:
            return PositionBox::tr("The mount waits for a position.") + QLatin1Char(' ');
    }
    return {};
}

}  // namespace

PositionBox::PositionBox(RequestDesk& desk, QWidget* parent)
    : QWidget(parent),
      m_place(new ValueLabel(tr("Position that arrives"), fonts::label(), {}, this)),
      m_state(new ValueLabel(tr("State of the positions"), fonts::label(), {}, this)),
      m_refused(new ValueLabel(tr("Refused"), fonts::label(), {}, this)),
      m_follow(new CommandButton(tr("Track position"), {}, desk, *m_refused, this))
{
    build();
    hide();
    connect(m_follow, &QPushButton::clicked, this, &PositionBox::followOrHold);
}

// The box is as low as its button, because a low window has no more room.
void PositionBox::build()
{
    for (ValueLabel* const line : {m_place, m_state, m_refused}) {
        line->setStretching(true);
    }
    m_refused->setCollapsing(true);
    auto* const grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(kGrid);
    grid->setVerticalSpacing(0);
    grid->addWidget(m_place, 0, 0);
    grid->addWidget(m_state, 1, 0);
    grid->addWidget(m_refused, 2, 0);
    grid->addWidget(m_follow, 0, 1, 3, 1, Qt::AlignBottom);
    grid->setColumnStretch(0, 1);
}

void PositionBox::followOrHold()
{
    if (m_isFollowed) {
        m_follow->ask(request::Hold{});
    } else {
        m_follow->ask(request::FollowPosition{});
    }
}

void PositionBox::showStatus(const StationStatus& status)
{
    const PositionStatus& position = status.position;
    setVisible(!position.source.isEmpty());
    m_isFollowed = position.phase != PositionPhase::Off;
    m_follow->setCommand(m_isFollowed ? tr("Hold") : tr("Track position"),
                         m_isFollowed ? tr("End tracking. The mount holds")
                                      : tr("Track the balloon or rocket that reports its position"));
    m_follow->setAccessibleName(m_isFollowed ? tr("Hold and stop tracking the position")
                                             : tr("Track the position that arrives"));
    m_follow->setBlocked(m_isFollowed ? QString() : status.permissions.reason(Action::FollowPosition));
    m_place->setValue(placeText(position));
    m_place->setToolTip(position.refusal.isEmpty()
                            ? position.source
                            : position.source + QLatin1Char('\n') + tr("Last refusal: %1").arg(position.refusal));
    const QString& wrong = position.trouble.isEmpty() ? position.problem : position.trouble;
    const bool isWrong = !wrong.isEmpty();
    m_state->setValue(phaseText(position) + (isWrong ? sentence(wrong) : countText(position)),
                      isWrong && m_isFollowed ? Tone::Warning : Tone::Secondary,
                      isWrong && m_isFollowed ? Symbol::Warning : Symbol::None);
}

}  // namespace boresight::ui

#include "moc_position_box.cpp"
