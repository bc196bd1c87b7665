// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/passes/azel_box.h"

#include "core/units/direction_text.h"
#include "core/units/duration_text.h"
#include "ui/kit/command_button.h"
#include "ui/kit/format.h"
#include "ui/kit/value_label.h"

#include <QDir>
#include <QGridLayout>

namespace boresight::ui {

namespace {

// Shortens the folder of the user to "~".
QString shortPath(const QString& path)
{
    const QString home = QDir::homePath() + QLatin1Char('/');
    return path.startsWith(home) ? QStringLiteral("~/") + path.mid(home.size()) : path;
}

QString radioText(const std::optional<bool>& transmits)
{
    if (!transmits) {
        return AzelBox::tr("no R or T");
    }
    return *transmits ? AzelBox::tr("transmits") : AzelBox::tr("receives");
}

// "Moon by WSJT-X: 105.3° / 59.9°, 1 s old, receives"
QString moonText(const AzelStatus& azel)
{
    if (!azel.moon) {
        return AzelBox::tr("Moon by WSJT-X: %1").arg(shortPath(azel.path));
    }
    QStringList parts{AzelBox::tr("Moon by WSJT-X: %1").arg(beamText(*azel.moon))};
    if (azel.age) {
        parts << AzelBox::tr("%1 old").arg(durationText(*azel.age));
    }
    parts << radioText(azel.transmits);
    return parts.join(QStringLiteral(", "));
}

QString agreementText(const AzelStatus& azel)
{
    if (!azel.apart) {
        return AzelBox::tr("Not compared, because the site is not set.");
    }
    const QString apart = angleText(*azel.apart, 2);
    return azel.interpolates ? AzelBox::tr("Agrees with the Moon of Boresight (%1).").arg(apart)
                             : AzelBox::tr("Differs from the Moon of Boresight by %1.").arg(apart);
}

QString phaseText(const AzelStatus& azel)
{
    const auto withNext = [&](const QString& text, const QString& next) {
        return azel.next ? text + QLatin1Char(' ') + next.arg(minuteText(*azel.next)) : text;
    };
    switch (azel.phase) {
        case AzelPhase::Off:
            return {};
        case AzelPhase::Following:
            return withNext(AzelBox::tr("Tracked."), AzelBox::tr("Sets at %1 without refraction."));
        case AzelPhase::Transmitting:
            return AzelBox::tr("The mount stands still while WSJT-X transmits.");
        case AzelPhase::Stale:
            return AzelBox::tr("The mount waits for the file.");
        case AzelPhase::BelowHorizon:
            return withNext(AzelBox::tr("Moon below the horizon, parked."),
                            AzelBox::tr("Rises at %1 without refraction."));
    }
    return {};
}

}  // namespace

AzelBox::AzelBox(RequestDesk& desk, QWidget* parent)
    : QWidget(parent),
      m_file(new ValueLabel(tr("File of WSJT-X"), fonts::label(), {}, this)),
      m_state(new ValueLabel(tr("Moon by WSJT-X"), fonts::label(), {}, this)),
      m_refused(new ValueLabel(tr("Refused"), fonts::label(), {}, this)),
      m_follow(new CommandButton(tr("Track Moon"), {}, desk, *m_refused, this))
{
    build();
    connect(m_follow, &QPushButton::clicked, this, &AzelBox::followOrHold);
}

// The box is as low as its button, because a low window has no more room.
void AzelBox::build()
{
    for (ValueLabel* const line : {m_file, m_state, m_refused}) {
        line->setStretching(true);
    }
    m_refused->setCollapsing(true);
    auto* const grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(kGrid);
    grid->setVerticalSpacing(0);
    grid->addWidget(m_file, 0, 0);
    grid->addWidget(m_state, 1, 0);
    grid->addWidget(m_refused, 2, 0);
    grid->addWidget(m_follow, 0, 1, 3, 1, Qt::AlignBottom);
    grid->setColumnStretch(0, 1);
}

void AzelBox::followOrHold()
{
    if (m_isFollowed) {
        m_follow->ask(request::Hold{});
    } else {
        m_follow->ask(request::FollowAzel{});
    }
}

void AzelBox::showStatus(const StationStatus& status)
{
    const AzelStatus& azel = status.azel;
    m_isFollowed = azel.phase != AzelPhase::Off;
    m_follow->setCommand(m_isFollowed ? tr("Hold") : tr("Track Moon"),
                         m_isFollowed ? tr("End tracking. The mount holds")
                                      : tr("Track the Moon with the data of WSJT-X. Boresight parks the mount while "
                                           "the Moon is below the horizon"));
    m_follow->setAccessibleName(m_isFollowed ? tr("Hold and stop tracking the Moon of WSJT-X")
                                             : tr("Track the Moon of WSJT-X"));
    m_follow->setBlocked(m_isFollowed ? QString() : status.permissions.reason(Action::FollowAzel));
    m_file->setValue(moonText(azel));
    m_file->setToolTip(azel.path);
    if (!azel.problem.isEmpty()) {
        m_state->setValue(azel.problem.left(1).toUpper() + azel.problem.mid(1) + QLatin1Char('.'),
                          m_isFollowed ? Tone::Warning : Tone::Secondary,
                          m_isFollowed ? Symbol::Warning : Symbol::None);
        return;
    }
    // One line. The state of the tracking comes first. While the mount tracks, agreement of the directions is not
    // shown.
    const QString phase = phaseText(azel);
    QStringList parts{phase, phase.isEmpty() || !azel.interpolates ? agreementText(azel) : QString()};
    parts.removeAll(QString());
    m_state->setValue(parts.join(QLatin1Char(' ')), azel.apart && !azel.interpolates ? Tone::Warning : Tone::Secondary);
    m_state->setToolTip(agreementText(azel));
}

}  // namespace boresight::ui

#include "moc_azel_box.cpp"
