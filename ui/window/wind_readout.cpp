// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/wind_readout.h"

#include "ui/kit/format.h"
#include "ui/kit/value_label.h"

#include <QHBoxLayout>

namespace boresight::ui {

namespace {

bool isLive(const WindStatus& wind)
{
    return wind.speed && !wind.isSilent;
}

QString windText(const WindStatus& wind)
{
    return WindReadout::tr("Wind %1 m/s")
        .arg(isLive(wind) ? QString::number(*wind.speed, 'f', 1) : QStringLiteral("--.-"));
}

// The obstacle by the wind, or else the reason why there is no reading.
QString windDetail(const WindStatus& wind)
{
    if (!wind.obstacle.isEmpty()) {
        return WindReadout::tr("only Park moves the mount");
    }
    if (!wind.trouble.isEmpty()) {
        return wind.trouble;
    }
    return isLive(wind) ? QString() : wind.refusal;
}

}  // namespace

WindReadout::WindReadout(QWidget* parent)
    : QWidget(parent),
      m_speed(new ValueLabel(tr("Wind"), fonts::text(), tr("Wind %1 m/s").arg(QStringLiteral("000.0")), this)),
      m_detail(new ValueLabel(tr("What the wind forbids"), fonts::label(), {}, this)),
      m_age(new ValueLabel(tr("Age of the wind reading"), fonts::label(), tr("age %1").arg(QStringLiteral("000.0 s")),
                           this))
{
    auto* const row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(8);
    m_speed->setSymbolRoom(true);
    m_detail->setStretching(true);
    m_age->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    row->addWidget(m_speed);
    row->addWidget(m_detail, 1);
    row->addWidget(m_age);
    hide();
}

void WindReadout::showStatus(const WindStatus& wind)
{
    m_isConfigured = !wind.source.isEmpty();
    setVisible(m_isConfigured);
    if (!m_isConfigured) {
        return;
    }
    const bool isWell = isLive(wind) && wind.obstacle.isEmpty() && !wind.overriddenUntil;
    const auto age = std::chrono::duration_cast<std::chrono::milliseconds>(wind.age);
    m_speed->setValue(windText(wind), isWell ? Tone::Normal : Tone::Warning,
                      isLive(wind) ? Symbol::None : Symbol::Lost);
    m_detail->setValue(windDetail(wind), Tone::Warning);
    m_age->setValue(wind.speed ? tr("age %1").arg(ageText(age)) : QString(), isWell ? Tone::Secondary : Tone::Warning);
}

}  // namespace boresight::ui

#include "moc_wind_readout.cpp"
