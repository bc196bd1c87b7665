// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/replay/play_bar.h"

#include "ui/kit/choice_button.h"
#include "ui/kit/push_button.h"
#include "ui/kit/value_label.h"
#include "ui/look/paint.h"
#include "ui/look/segments.h"
#include "ui/replay/replay_player.h"
#include "ui/replay/time_slider.h"

#include <QButtonGroup>
#include <QHBoxLayout>
#include <QPushButton>

#include <algorithm>

namespace boresight::ui {

namespace {

// "04:10", or "1:04:10" of an hour or more.
QString lengthText(UtcTime::duration length)
{
    const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(length).count();
    const QString rest = QStringLiteral("%1:%2")
                             .arg(seconds / 60 % 60, 2, 10, QLatin1Char('0'))
                             .arg(seconds % 60, 2, 10, QLatin1Char('0'));
    return seconds < 3600 ? rest : QString::number(seconds / 3600) + QLatin1Char(':') + rest;
}

QString passedText(UtcTime::duration passed, UtcTime::duration length)
{
    return lengthText(passed) + QStringLiteral(" / ") + lengthText(length);
}

}  // namespace

PlayBar::PlayBar(ReplayPlayer& player, const std::vector<UtcTime>& marks, QWidget* parent)
    : QWidget(parent),
      m_player(player),
      m_play(makePushButton(
          {.text = tr("Pause"), .name = tr("Play"), .help = tr("Play or pause the recording (Space)")}, this)),
      m_slider(new TimeSlider(player.begin(), player.end(), marks, this)),
      m_passed(new ValueLabel(tr("Time since the start of the recording"), fonts::small(),
                              passedText(player.end() - player.begin(), player.end() - player.begin()), this)),
      m_speeds(new QButtonGroup(this))
{
    setEmphasis(*m_play, Emphasis::Primary);
    m_play->setFocusPolicy(Qt::TabFocus);
    m_play->setFixedWidth(m_play->sizeHint().width() + m_play->fontMetrics().horizontalAdvance(QStringLiteral("MM")));
    auto* const row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(m_play);
    row->addWidget(m_slider, 1);
    row->addWidget(m_passed);
    row->addWidget(makeSpeeds());
    connect(m_play, &QPushButton::clicked, &player, [this] { m_player.play(!m_player.isPlaying()); });
    connect(m_slider, &TimeSlider::momentChosen, &player, &ReplayPlayer::jumpTo);
    connect(&player, &ReplayPlayer::moved, this, &PlayBar::showMoment);
    connect(&player, &ReplayPlayer::changed, this, &PlayBar::showState);
    showMoment();
    showState();
}

QWidget* PlayBar::makeSpeeds()
{
    auto* const segments = new Segments(this);
    for (const int speed : ReplayPlayer::kSpeeds) {
        auto* const button = new ChoiceButton(QStringLiteral("%1×").arg(speed),
                                              tr("Play at %1 times the speed (+ and -)").arg(speed), segments);
        m_speeds->addButton(button, speed);
        connect(button, &QAbstractButton::clicked, &m_player, [this, speed] { m_player.setSpeed(speed); });
        segments->add(*button);
    }
    return segments;
}

void PlayBar::showMoment()
{
    m_slider->setMoment(m_player.moment());
    m_passed->setValue(passedText(m_player.moment() - m_player.begin(), m_player.end() - m_player.begin()),
                       Tone::Secondary);
}

void PlayBar::showState()
{
    const QString word = m_player.isPlaying() ? tr("Pause") : tr("Play");
    m_play->setText(word);
    m_play->setAccessibleName(word);
    m_speeds->button(m_player.speed())->setChecked(true);
}

}  // namespace boresight::ui

#include "moc_play_bar.cpp"
