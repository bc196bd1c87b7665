// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/north/declination_box.h"

#include "ui/kit/command_button.h"
#include "ui/kit/push_button.h"
#include "ui/kit/value_label.h"
#include "ui/link/profile_change.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>

namespace boresight::ui {

using geomagnetism::DeclinationBy;

namespace {

ProfileChange::Edit applyBy(DeclinationBy by)
{
    return [by](profile::Profile& profile) { profile.sensor.declinationBy = by; };
}

}  // namespace

DeclinationBox::DeclinationBox(RequestDesk& desk, ProfileChange& change, ValueLabel& notice, QWidget* parent)
    : QWidget(parent),
      m_change(change),
      m_yes(new CommandButton(tr("Yes"), tr("The headings stay as the sensor sends them"), desk, notice, this)),
      m_no(new CommandButton(tr("No"), tr("Boresight applies the declination of the site in place of the sensor's"),
                             desk, notice, this)),
      m_effect(new ValueLabel(tr("Where the declination is applied"), fonts::label(), {}, this))
{
    m_yes->setAccessibleName(tr("Yes, the sensor applies the declination"));
    m_no->setAccessibleName(tr("No, Boresight applies the declination"));
    build();
    connect(m_yes, &QPushButton::clicked, this, [this] { answer(*m_yes, DeclinationBy::Sensor); });
    connect(m_no, &QPushButton::clicked, this, [this] { answer(*m_no, DeclinationBy::Boresight); });
}

void DeclinationBox::build()
{
    auto* const question = new QLabel(tr("Does the sensor apply the declination of this site?"), this);
    question->setFont(fonts::label());
    question->setWordWrap(true);
    m_effect->setStretching(true);
    m_effect->setLines(3);
    auto* const settings = makePushButton({.text = tr("Change …"),
                                           .name = tr("Change the declination"),
                                           .help = tr("Open the settings of the declination on the page Profile")},
                                          this);
    connect(settings, &QPushButton::clicked, this, &DeclinationBox::settingsWanted);
    auto* const asked = new QHBoxLayout;
    asked->setSpacing(4);
    asked->addWidget(question, 1);
    for (CommandButton* const button : {m_yes, m_no}) {
        button->setCheckable(true);
        asked->addWidget(button);
    }
    auto* const shown = new QHBoxLayout;
    shown->setSpacing(4);
    shown->addWidget(m_effect, 1);
    shown->addWidget(settings);
    auto* const column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(4);
    column->addLayout(asked);
    column->addLayout(shown);
}

void DeclinationBox::showStatus(const StationStatus& status)
{
    showEffect(status.sensor);
    showAnswer(*m_yes, DeclinationBy::Sensor, status);
    showAnswer(*m_no, DeclinationBy::Boresight, status);
}

// The source of the declination with its value, the model that computes it, and a problem of the model.
void DeclinationBox::showEffect(const SensorStatus& sensor)
{
    QString text = sensor.declinationText;
    if (!sensor.declinationModel.isEmpty()) {
        text += QStringLiteral(" (%1)").arg(sensor.declinationModel);
    }
    if (sensor.declinationDoubt.isEmpty()) {
        m_effect->setValue(text, Tone::Secondary);
    } else {
        m_effect->setValue(QStringLiteral("%1 %2").arg(text, sensor.declinationDoubt), Tone::Warning, Symbol::Warning);
    }
}

// The profile in force decides which answer is marked, not the press.
void DeclinationBox::showAnswer(CommandButton& button, DeclinationBy by, const StationStatus& status)
{
    button.setChecked(status.profile->sensor.declinationBy == by);
    button.setBlocked(m_change.whyNot(status, applyBy(by)));
}

void DeclinationBox::answer(CommandButton& button, DeclinationBy by)
{
    m_change.ask(button, applyBy(by));
}

}  // namespace boresight::ui

#include "moc_declination_box.cpp"
