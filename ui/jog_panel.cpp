// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/jog_panel.h"

#include "core/base/numbers.h"
#include "ui/axes.h"
#include "ui/choice_button.h"
#include "ui/command_button.h"
#include "ui/format.h"
#include "ui/motion_permission.h"
#include "ui/value_label.h"

#include <QButtonGroup>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>

namespace boresight::ui {

namespace {

QLabel* caption(const QString& text, QWidget* parent)
{
    auto* const label = new QLabel(text, parent);
    label->setFont(fonts::label());
    return label;
}

QLineEdit* angleField(const QString& name, QWidget* parent)
{
    auto* const field = new QLineEdit(parent);
    field->setFont(fonts::text());
    field->setAccessibleName(name);
    field->setToolTip(JogPanel::tr("%1 in degrees, e.g. 113.5 (Ctrl+G; Enter = Go)").arg(name));
    field->setAlignment(Qt::AlignRight);
    field->setMaxLength(12);
    field->setMinimumHeight(kTouchSize);
    field->setFixedWidth(field->fontMetrics().horizontalAdvance(QStringLiteral("-000.00")) + 20);
    return field;
}

}  // namespace

JogPanel::JogPanel(const Clock& clock, RequestDesk& desk, const WindowSettings& settings, QWidget* parent)
    : QWidget(parent),
      m_notice(new ValueLabel(tr("Refused"), fonts::label(), {}, this)),
      m_pad(new JogPad(clock, desk, *m_notice, settings, this)),
      m_azimuth(angleField(tr("Azimuth"), this)),
      m_elevation(angleField(tr("Elevation"), this)),
      m_go(new CommandButton(tr("Go"), tr("Go to this direction by the nearest turn (Enter)"), desk, *m_notice, this)),
      m_home(new CommandButton(tr("Home"), tr("Go to azimuth 0° and the lowest elevation"), desk, *m_notice, this)),
      m_park(new CommandButton(tr("Park"), tr("Go to the park position %1 (Ctrl+P)").arg(axisText(settings.park)), desk,
                               *m_notice, this)),
      m_choices(makeChoices(settings))
{
    m_notice->setStretching(true);
    m_notice->setLines(2);
    build();
    connect(m_go, &QPushButton::clicked, this, &JogPanel::go);
    connect(m_azimuth, &QLineEdit::returnPressed, this, &JogPanel::go);
    connect(m_elevation, &QLineEdit::returnPressed, this, &JogPanel::go);
    connect(m_home, &QPushButton::clicked, this, [this] { m_home->ask(request::Home{}); });
    connect(m_park, &QPushButton::clicked, this, &JogPanel::park);
}

void JogPanel::build()
{
    auto* const grid = new QGridLayout(this);
    grid->setContentsMargins(6, 6, 6, 6);
    grid->setSpacing(8);
    grid->addWidget(m_pad, 0, 0);
    grid->addWidget(m_choices, 0, 1);
    grid->addWidget(makeGoTo(), 1, 0, 1, 2);
    grid->addWidget(m_notice, 2, 0, 1, 2);
    grid->setRowStretch(0, 1);
    grid->setColumnStretch(0, 1);
}

QWidget* JogPanel::makeChoices(const WindowSettings& settings)
{
    auto* const box = new QWidget(this);
    auto* const grid = new QGridLayout(box);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setSpacing(4);
    grid->addWidget(caption(tr("Rate while held"), box), 0, 0, 1, 3);
    grid->addWidget(caption(tr("Step"), box), 2, 0, 1, 3);

    auto* const rates = new QButtonGroup(box);
    const std::tuple<JogRate, QString, AngularRate> speeds[] = {{JogRate::Slow, tr("Slow"), settings.slow},
                                                                {JogRate::Normal, tr("Normal"), settings.normal},
                                                                {JogRate::Fast, tr("Fast"), settings.fast}};
    int column = 0;
    for (const auto& [rate, text, speed] : speeds) {
        auto* const button = new ChoiceButton(text + QLatin1Char('\n') + rateText(speed),
                                              tr("%1: jog at %2").arg(text, rateText(speed)), box);
        rates->addButton(button);
        m_rates[rate] = button;
        grid->addWidget(button, 1, column++);
        connect(button, &QToolButton::clicked, this, [this, rate = rate] {
            m_rate = rate;
            m_pad->setRate(rate);
        });
    }
    auto* const steps = new QButtonGroup(box);
    column = 0;
    for (const Angle step : settings.steps) {
        const QString size = angleText(step, 1);
        auto* const button = new ChoiceButton(size, tr("One step is %1 (Ctrl + arrow)").arg(size), box);
        steps->addButton(button);
        button->setChecked(step == settings.steps.front());
        grid->addWidget(button, 3, column++);
        connect(button, &QToolButton::clicked, this, [this, step] { m_pad->setStep(step); });
    }
    auto* const mode = new ChoiceButton(tr("Step mode"), tr("Step mode: a press moves one step only"), box);
    grid->addWidget(mode, 4, 0, 1, 3);
    grid->setRowStretch(5, 1);
    connect(mode, &QToolButton::toggled, m_pad, &JogPad::setStepMode);
    return box;
}

QWidget* JogPanel::makeGoTo()
{
    auto* const box = new QWidget(this);
    auto* const row = new QHBoxLayout(box);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(4);
    for (const auto& [text, field] : {std::pair(tr("Az"), m_azimuth), std::pair(tr("El"), m_elevation)}) {
        QLabel* const label = caption(text, box);
        label->setBuddy(field);
        row->addWidget(label);
        row->addWidget(field);
        row->addWidget(caption(QStringLiteral("°"), box));
    }
    row->addStretch(1);
    for (CommandButton* const button : {m_go, m_home, m_park}) {
        row->addWidget(button);
    }
    return box;
}

void JogPanel::showStatus(const StationStatus& status)
{
    m_pad->showStatus(status);
    const QString reason = whyNoPointing(status);
    for (CommandButton* const button : {m_go, m_home, m_park}) {
        button->setBlocked(reason);
    }
    showRates(areTurnsKnown(status));
}

// What the pad does by itself: on an unknown turn only the slow rate.
void JogPanel::showRates(bool turnsKnown)
{
    for (const auto& [rate, button] : m_rates) {
        const bool usable = turnsKnown || rate == JogRate::Slow;
        button->setEnabled(usable);
        button->setToolTip(usable ? button->accessibleName()
                                  : tr("%1: only slow until the turn is known").arg(button->accessibleName()));
    }
    m_rates.at(turnsKnown ? m_rate : JogRate::Slow)->setChecked(true);
}

void JogPanel::focusGoTo()
{
    m_azimuth->setFocus(Qt::ShortcutFocusReason);
    m_azimuth->selectAll();
}

void JogPanel::complain(QLineEdit& field, const QString& text)
{
    m_notice->setValue(text, Tone::Warning, Symbol::Warning);
    field.setFocus();
    field.selectAll();
}

void JogPanel::go()
{
    if (!m_go->isEnabled()) {
        m_notice->setValue(m_go->toolTip(), Tone::Warning, Symbol::Warning);
        return;
    }
    const auto azimuth = parseFinite(m_azimuth->text().trimmed().toStdString());
    if (!azimuth) {
        complain(*m_azimuth, tr("Go: the azimuth is not a number (decimal point, e.g. 113.5)"));
        return;
    }
    const auto elevation = parseFinite(m_elevation->text().trimmed().toStdString());
    if (!elevation) {
        complain(*m_elevation, tr("Go: the elevation is not a number (decimal point, e.g. 10.5)"));
        return;
    }
    m_go->ask(request::PointSky{{Angle::fromDegrees(*azimuth), Angle::fromDegrees(*elevation)}});
}

void JogPanel::park()
{
    if (m_park->isEnabled()) {
        m_park->ask(request::Park{});
    } else {
        m_notice->setValue(m_park->toolTip(), Tone::Warning, Symbol::Warning);
    }
}

void JogPanel::hold()
{
    m_pad->hold();
}

void JogPanel::beat()
{
    m_pad->disarmWhenUnused();
}

}  // namespace boresight::ui
