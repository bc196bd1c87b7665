// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/jog/third_axis_row.h"

#include "ui/hold/jog_button.h"
#include "ui/kit/caption.h"
#include "ui/kit/format.h"
#include "ui/kit/request_desk.h"
#include "ui/kit/value_label.h"

#include <QGridLayout>
#include <QLabel>

namespace boresight::ui {
namespace {

struct StateWord
{
    QString text;
    Tone tone = Tone::Normal;
    Symbol symbol = Symbol::None;
};

StateWord wordOf(ThirdAxisStatus::State state)
{
    switch (state) {
        case ThirdAxisStatus::State::NoData:
            return {ThirdAxisRow::tr("NO DATA"), Tone::Warning, Symbol::Warning};
        case ThirdAxisStatus::State::Off:
            return {ThirdAxisRow::tr("OFF"), Tone::Secondary};
        case ThirdAxisStatus::State::Holding:
            return {ThirdAxisRow::tr("HOLDING")};
        case ThirdAxisStatus::State::Moving:
            return {ThirdAxisRow::tr("MOVING")};
        case ThirdAxisStatus::State::Fault:
            break;
    }
    return {ThirdAxisRow::tr("FAULT"), Tone::Alarm, Symbol::Alarm};
}

}  // namespace

ThirdAxisRow::ThirdAxisRow(RequestDesk& desk, ValueLabel& notice, QWidget* parent)
    : QWidget(parent),
      m_desk(desk),
      m_notice(notice),
      m_name(makeGroupCaption(tr("Third axis"), this)),
      m_place(new ValueLabel(tr("Angle of the third axis"), fonts::value(), QStringLiteral("−180.00°"), this)),
      m_report(new ValueLabel(tr("State of the third axis"), fonts::label(), {}, this)),
      m_lower(new JogButton(tr("− hold"), {}, this)),
      m_upper(new JogButton(tr("+ hold"), {}, this))
{
    build();
    connectButton(m_lower, -1.0);
    connectButton(m_upper, 1.0);
    m_repeat.setInterval(kJogRepeat);
    m_repeat.setTimerType(Qt::PreciseTimer);  // a coarse timer may be 5 % late
    connect(&m_repeat, &QTimer::timeout, this, [this] { send(m_sign); });
    hide();
}

void ThirdAxisRow::build()
{
    auto* const grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(kGrid);
    grid->setVerticalSpacing(2);
    grid->addWidget(m_name, 0, 0);
    grid->addWidget(m_place, 1, 0);
    grid->addWidget(m_report, 2, 0, 1, 3);
    grid->addWidget(m_lower, 0, 1, 2, 1);
    grid->addWidget(m_upper, 0, 2, 2, 1);
    grid->setColumnStretch(0, 1);
    m_name->setTextFormat(Qt::PlainText);  // a name of the profile
    m_report->setStretching(true);
    for (JogButton* const button : {m_lower, m_upper}) {
        button->setKeyHeld(true);
    }
}

void ThirdAxisRow::connectButton(JogButton* button, double sign)
{
    connect(button, &JogButton::holdBegan, this, [this, sign] {
        m_notice.setValue({});
        m_sign = sign;
        send(sign);
        m_repeat.start();
    });
    connect(button, &JogButton::holdEnded, this, [this, sign] {
        if (m_sign == sign) {
            m_sign = 0.0;
            m_repeat.stop();
            send(0.0);
        }
    });
}

void ThirdAxisRow::send(double sign)
{
    m_desk.send(request::JogThirdAxis{.rate = sign * m_rate}, this, [this, sign](const std::optional<Error>& error) {
        if (error && sign != 0.0) {
            letGoAll();
            m_notice.setValue(tr("Third axis: %1").arg(error->text), Tone::Warning, Symbol::Warning);
        }
    });
}

void ThirdAxisRow::letGoAll()
{
    m_lower->letGo();
    m_upper->letGo();
}

void ThirdAxisRow::showStatus(const StationStatus& status)
{
    setVisible(status.thirdAxis.has_value());
    // A disabled button releases.
    m_lower->setBlocked(status.permissions.reason(Action::JogThirdAxisDown));
    m_upper->setBlocked(status.permissions.reason(Action::JogThirdAxisUp));
    if (status.thirdAxis) {
        showReport(*status.thirdAxis);
    }
}

void ThirdAxisRow::showReport(const ThirdAxisStatus& axis)
{
    m_rate = axis.fastest;
    m_name->setText(axis.name);
    const QString help = tr("Turn the axis at %1 while held. No target moves this axis.").arg(rateText(axis.fastest));
    m_lower->setHelp(help);
    m_upper->setHelp(help);
    const Freshness fresh = freshness(axis.age);
    m_place->setValue(axis.place && fresh != Freshness::NoData ? signedAngleText(*axis.place) : noValue(),
                      axis.place && fresh == Freshness::Live ? Tone::Normal : Tone::Secondary);
    const StateWord word = wordOf(axis.state);
    QStringList parts{word.text};
    if (!axis.fault.isEmpty()) {
        parts << axis.fault;
    } else if (!axis.mode.isEmpty()) {
        parts << axis.mode;
    }
    if (axis.boardTemperature) {
        parts << tr("board %1 °C").arg(*axis.boardTemperature, 0, 'f', 0);
    }
    parts << tr("travel %1…%2").arg(angleText(axis.travel.min, 0), angleText(axis.travel.max, 0));
    m_report->setValue(parts.join(QStringLiteral(" · ")), word.tone, word.symbol);
}

}  // namespace boresight::ui

#include "moc_third_axis_row.cpp"
