// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/guide/rotator_choice.h"

#include "core/base/bus_name.h"
#include "core/base/text.h"
#include "core/profile/commissioning.h"
#include "ui/guide/model_choice.h"
#include "ui/kit/axes.h"
#include "ui/kit/caption.h"
#include "ui/kit/format.h"
#include "ui/kit/theme.h"
#include "ui/kit/touch_combo.h"

#include <QLabel>
#include <QLineEdit>
#include <QVBoxLayout>

#include <algorithm>
#include <array>

namespace boresight::ui {

namespace {

using profile::AxisDriver;

constexpr std::array kSpeeds{600, 1200, 4800, 9600, 19200, 38400, 57600, 115200};  // Bd

// Without any offer the only kind is the listed adapters.
std::vector<RotatorOffer> atLeastOne(const std::vector<RotatorOffer>& offers)
{
    return offers.empty() ? std::vector{RotatorOffer{.isListed = true}} : offers;
}

AxisDriver driverOf(const profile::Profile& profile)
{
    return profile.azimuth.driver == AxisDriver::None ? profile.elevation.driver : profile.azimuth.driver;
}

// A host without a port gets the usual port. An IPv6 address with a port is in brackets. Without a port it needs no
// brackets.
QString withPort(const QString& place, int usualPort)
{
    const auto colons = place.count(QLatin1Char(':'));
    const bool bracketed = place.startsWith(QLatin1Char('['));
    const bool alone = bracketed ? place.endsWith(QLatin1Char(']')) : colons != 1;
    if (usualPort == 0 || !alone) {
        return place;
    }
    const QString host = colons > 1 && !bracketed ? QStringLiteral("[%1]").arg(place) : place;
    return QStringLiteral("%1:%2").arg(host).arg(usualPort);
}

// The texts of alarms have no full stop at the end.
QString sentence(const QString& text)
{
    return text.endsWith(QLatin1Char('.')) ? text : text + QLatin1Char('.');
}

QStringList numbered(const QStringList& lines)
{
    QStringList all;
    for (const QString& line : lines) {
        all << QStringLiteral("%1. %2").arg(all.size() + 1).arg(line);
    }
    return all;
}

}  // namespace

RotatorChoice::RotatorChoice(const std::vector<RotatorOffer>& offers, QWidget* parent)
    : QWidget(parent),
      m_offers(atLeastOne(offers)),
      m_entered(m_offers.size()),
      m_kinds(new TouchCombo(tr("What turns the mount"), tr("How the motors of the mount are commanded"), this)),
      m_model(new ModelChoice(this)),
      m_fields(new QWidget(this)),
      m_place(new TouchCombo(tr("Port or address of the rotator"), {}, m_fields)),
      m_baud(new TouchCombo(tr("Speed of the serial port"), tr("The speed to which the switches of the box are set"),
                            m_fields))
{
    build();
    choose(0);
    connect(m_kinds, &QComboBox::currentIndexChanged, this, &RotatorChoice::choose);
    connect(m_place, &QComboBox::currentTextChanged, this, [this](const QString& place) {
        m_entered.at(m_kind) = place;
        Q_EMIT changed();
    });
    connect(m_model, &QComboBox::currentTextChanged, this, &RotatorChoice::changed);
    connect(m_baud, &QComboBox::currentIndexChanged, this, &RotatorChoice::changed);
}

void RotatorChoice::build()
{
    QStringList names;
    std::ranges::transform(m_offers, std::back_inserter(names), &RotatorOffer::name);
    m_kinds->setLines(names);
    m_kinds->setCurrentIndex(0);
    m_kinds->setVisible(m_offers.size() > 1);
    m_place->setEditable(true);
    m_place->setCompleter(nullptr);  // Qt must not complete the typed text
    m_place->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    QStringList speeds;
    for (const int speed : kSpeeds) {
        speeds << QStringLiteral("%1 Bd").arg(speed);
    }
    m_baud->setLines(speeds);
    m_baud->setMinimumContentsLength(9);
    m_baud->setCurrentIndex(static_cast<int>(std::ranges::find(kSpeeds, profile::Profile().baud) - kSpeeds.begin()));
    auto* const fields = new QHBoxLayout(m_fields);
    fields->setContentsMargins(0, 0, 0, 0);
    fields->setSpacing(6);
    fields->addWidget(m_place, 1);
    fields->addWidget(m_baud);
    auto* const column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(4);
    column->addWidget(m_kinds);
    column->addWidget(m_model);
    column->addWidget(m_fields);
}

void RotatorChoice::choose(int kind)
{
    m_kind = static_cast<std::size_t>(std::max(0, kind));
    m_fields->setVisible(!offer().isListed);
    m_model->setVisible(offer().hasModels);
    refreshModels();
    m_place->setToolTip(offer().placeHelp);
    m_place->lineEdit()->setPlaceholderText(tr("%1, for example %2").arg(offer().place, offer().example));
    m_place->setEditText(m_entered.at(m_kind));
    m_baud->setVisible(offer().onSerialPort);
    offerPorts();
    Q_EMIT changed();
}

void RotatorChoice::offerPorts()
{
    m_place->setLines((offer().onSerialPort ? m_ports : QStringList()) + offer().usualPlaces);
    if (offer().onSerialPort && m_place->currentText().isEmpty() && m_ports.size() == 1) {
        m_place->setEditText(m_ports.front());
    }
}

void RotatorChoice::showStatus(const StationStatus& status)
{
    m_status = status;
    const profile::Profile& profile = *status.profile;
    if (const auto now = std::pair(driverOf(profile), profile.bus); now != m_taken) {
        m_taken = now;
        takeFrom(profile);
    }
}

// Shows the rotator of the profile. Called only for another mount or bus, because it replaces the operator's input.
void RotatorChoice::takeFrom(const profile::Profile& profile)
{
    const BusName bus = parseBusName(profile.bus).value_or(BusName{});
    const auto at = std::ranges::find_if(m_offers, [&](const RotatorOffer& offer) {
        return offer.driver == driverOf(profile) && offer.hasModels == (bus.model > 0);
    });
    m_kinds->setCurrentIndex(at == m_offers.end() ? 0 : static_cast<int>(at - m_offers.begin()));
    if (at != m_offers.end() && !at->isListed && !profile::namesNoBus(profile)) {
        m_model->choose(bus.model);
        m_place->setEditText(toQString(profile.bus).section(QLatin1Char(':'), at->hasModels ? 2 : 1));
        const auto speed = std::ranges::find(kSpeeds, profile.baud);
        m_baud->setCurrentIndex(speed == kSpeeds.end() ? -1 : static_cast<int>(speed - kSpeeds.begin()));
    }
}

void RotatorChoice::showAdapters(const std::vector<Adapter>& adapters)
{
    m_ports.clear();
    std::ranges::transform(adapters, std::back_inserter(m_ports), &Adapter::serialPort);
    m_ports.removeAll(QString());
    offerPorts();
}

void RotatorChoice::refreshModels()
{
    if (offer().hasModels && m_model->isEmpty()) {
        Q_EMIT modelsWanted();
    }
}

void RotatorChoice::showModels(const RotatorModels& models)
{
    m_model->showModels(models);
    Q_EMIT changed();
}

bool RotatorChoice::isListed() const
{
    return offer().isListed;
}

bool RotatorChoice::onSerialPort() const
{
    return offer().onSerialPort;
}

Result<std::string> RotatorChoice::bus() const
{
    const QString place = m_place->currentText().trimmed();
    if (offer().hasModels && !m_model->whyNone().isEmpty()) {
        return failure(ErrorCode::InvalidInput, m_model->whyNone());
    }
    if (place.isEmpty()) {
        return failure(ErrorCode::InvalidInput,
                       tr("Enter the port or the address of the rotator, for example %1.").arg(offer().example));
    }
    return parseBusName(busText(place).toStdString()).map([](const BusName& bus) { return toString(bus); });
}

QString RotatorChoice::busText(const QString& place) const
{
    const QString network = toQString(offer().network);
    if (offer().hasModels) {
        return QStringLiteral("%1:%2:%3").arg(network).arg(m_model->number()).arg(place);
    }
    const bool isPath = offer().onSerialPort && place.startsWith(QLatin1Char('/'));
    return isPath ? QStringLiteral("serial:%1").arg(place)
                  : QStringLiteral("%1:%2").arg(network, withPort(place, offer().usualPort));
}

QString RotatorChoice::whyIncomplete() const
{
    const auto entered = bus();
    return entered ? QString() : entered.error().text;
}

ProfileChange::Edit RotatorChoice::edit() const
{
    const int at = m_baud->currentIndex();
    const profile::RotatorLine line{
        .driver = offer().driver,
        .bus = bus().value_or(m_status.profile->bus),
        .baud = onSerialPort() && at >= 0 ? kSpeeds.at(static_cast<std::size_t>(at)) : m_status.profile->baud};
    return [line](profile::Profile& profile) { profile::useRotator(profile, line); };
}

bool RotatorChoice::isInUse() const
{
    const profile::Profile& profile = *m_status.profile;
    const auto entered = bus();
    return !m_status.simulated && driverOf(profile) == offer().driver && entered && *entered == profile.bus;
}

// The obstacle is shown here, so that the operator need not point at the button to read it.
QStringList RotatorChoice::words(const QString& obstacle) const
{
    if (isInUse()) {
        return wordsInUse();
    }
    QStringList lines = offer().promise;
    if (profile::losesAMount(*m_status.profile, offer().driver)) {
        lines.prepend(
            tr("Connect replaces the zeros, the travel and north in the profile of this mount. To keep them, "
               "duplicate the mount first (tab Mount, Profile)."));
    }
    const bool isHopeless = offer().hasModels && !m_model->problem().isEmpty();
    if (!obstacle.isEmpty() && (isHopeless || !m_place->currentText().isEmpty())) {
        lines.prepend(sentence(obstacle));
    }
    return lines;
}

QStringList RotatorChoice::wordsInUse() const
{
    QStringList lines;
    bool isForeign = false;
    bool isDown = false;
    for (const Alarm& alarm : m_status.alarms) {
        if (alarm.active && alarm.name.startsWith(QLatin1String("rotator."))) {
            lines << sentence(alarm.what) + QLatin1Char(' ') + sentence(alarm.remedy);
            isForeign = isForeign || alarm.name == QLatin1String("rotator.foreign");
            isDown = isDown || alarm.name == QLatin1String("rotator.line-down");
        }
    }
    if (m_status.state == StationState::Disconnected && isForeign) {
        lines.prepend(tr("Not connected. Something else answers there."));
        return lines;
    }
    if (m_status.state == StationState::Disconnected) {
        lines.prepend(isDown ? tr("Not connected. Boresight tries again each second.") : tr("In use. No answer yet."));
        // A serial port that does not open has nothing to do with the box behind it: the alarm gives the remedy.
        const auto bus = parseBusName(m_status.profile->bus);
        const bool isPort = isDown && bus && bus->kind == BusKind::Serial;
        return isPort ? lines : lines + numbered(offer().checks);
    }
    lines.prepend(tr("In use. It answers as: %1.").arg(m_status.line.kind));
    if (!m_status.line.condition.isEmpty()) {
        lines << m_status.line.condition;
    }
    for (const Axis axis : kAxes) {
        if (const auto& actual = axisOf(m_status, axis).actual; actual && m_status.capabilities.has(axis)) {
            lines << QStringLiteral("%1: %2").arg(name(axis), angleText(*actual, 1));
        }
    }
    if (const QString obstacle = m_status.permissions.reason(Action::Move); !obstacle.isEmpty()) {
        lines << tr("The mount must not move yet: %1").arg(obstacle);
    }
    return lines;
}

}  // namespace boresight::ui

#include "moc_rotator_choice.cpp"
