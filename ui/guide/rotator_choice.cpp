// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/guide/rotator_choice.h"

#include "core/base/bus_name.h"
#include "core/base/text.h"
#include "core/profile/commissioning.h"
#include "ui/kit/axes.h"
#include "ui/kit/caption.h"
#include "ui/kit/command_button.h"
#include "ui/kit/format.h"
#include "ui/kit/theme.h"
#include "ui/kit/touch_combo.h"

#include <QLineEdit>
#include <QSpinBox>
#include <QVBoxLayout>

#include <algorithm>
#include <array>

namespace boresight::ui {

namespace {

using profile::AxisDriver;

constexpr int kRotctldPort = 4533;
constexpr std::array kSpeeds{1200, 4800, 9600, 19200, 38400, 57600, 115200};  // Bd
// In the order of the choices.
constexpr std::array kDrivers{AxisDriver::Moteus, AxisDriver::Gs232, AxisDriver::Rotctld};
const QString kFromBus = QStringLiteral("fdcanusb:");  // how a serial port is listed

AxisDriver driverOf(const profile::Profile& profile)
{
    return profile.azimuth.driver == AxisDriver::None ? profile.elevation.driver : profile.azimuth.driver;
}

// An IPv6 address is written in brackets before a port.
QString withPort(const QString& host, int port)
{
    const QString one =
        host.contains(QLatin1Char(':')) && !host.startsWith(QLatin1Char('[')) ? QStringLiteral("[%1]").arg(host) : host;
    return QStringLiteral("%1:%2").arg(one).arg(port);
}

QWidget* makeRow(QWidget* parent, const QString& first, QWidget& wide, const QString& second, QWidget& narrow)
{
    auto* const row = new QWidget(parent);
    auto* const line = new QHBoxLayout(row);
    line->setContentsMargins(0, 0, 0, 0);
    line->setSpacing(6);
    for (QWidget* const field : {&wide, &narrow}) {
        field->setParent(row);
        field->setFont(fonts::label());
        field->setMinimumHeight(kTouchSize);
    }
    line->addWidget(makeCaption(first, wide));
    line->addWidget(&wide, 1);
    line->addWidget(makeCaption(second, narrow));
    line->addWidget(&narrow);
    return row;
}

// Texts of alarms stand without their last full stop.
QString sentence(const QString& text)
{
    return text.endsWith(QLatin1Char('.')) ? text : text + QLatin1Char('.');
}

QStringList explanation(AxisDriver driver)
{
    if (driver == AxisDriver::Rotctld) {
        return {RotatorChoice::tr("rotctld runs on the computer that has the cable of the rotator. "
                                  "Example: rotctld -m 901 -r /dev/ttyUSB0"),
                RotatorChoice::tr("Connect asks rotctld for the limits and for the position. Nothing moves."),
                RotatorChoice::tr("A server of another kind is asked one question and left alone.")};
    }
    return {RotatorChoice::tr("The box is a GS-232A, a GS-232B, or one that speaks as they do."),
            RotatorChoice::tr("Connect asks for the position. Nothing moves."),
            RotatorChoice::tr("A device of another kind is left alone.")};
}

QStringList whatToCheck(AxisDriver driver)
{
    if (driver == AxisDriver::Rotctld) {
        return {RotatorChoice::tr("1. Check that rotctld runs on that computer, and that its rotator has power."),
                RotatorChoice::tr("2. Compare the port with the option -t of rotctld. Without -t it is %1.")
                    .arg(kRotctldPort),
                RotatorChoice::tr("3. From another computer: start rotctld with -T 0.0.0.0, and open its port in the "
                                  "firewall.")};
    }
    return {RotatorChoice::tr("1. Check the power of the box, and the cable."),
            RotatorChoice::tr("2. Compare the speed with the switches of the box."),
            RotatorChoice::tr("3. End other programs that use the port.")};
}

}  // namespace

RotatorChoice::RotatorChoice(QWidget* parent)
    : QWidget(parent),
      m_kind(new TouchCombo(tr("What turns the mount"), tr("How the motors of the mount are commanded"), this)),
      m_network(nullptr),
      m_serial(nullptr),
      m_host(new QLineEdit(this)),
      m_port(new QSpinBox(this)),
      m_line(new TouchCombo(tr("Port of the rotator"),
                            tr("A serial port such as /dev/ttyUSB0, or HOST:PORT of a serial server"), this)),
      m_baud(new TouchCombo(tr("Speed of the serial port"), tr("As the switches of the box are set"), this))
{
    m_kind->setLines({tr("moteus drives on a CAN bus, or the simulated mount"),
                      tr("GS-232 rotator on a serial port or in the network"), tr("Rotator of Hamlib, by a rotctld")});
    m_kind->setCurrentIndex(0);
    build();
    connect(m_kind, &QComboBox::currentIndexChanged, this, &RotatorChoice::showFields);
    connect(m_host, &QLineEdit::textChanged, this, &RotatorChoice::changed);
    connect(m_port, &QSpinBox::valueChanged, this, &RotatorChoice::changed);
    connect(m_line, &QComboBox::currentTextChanged, this, &RotatorChoice::changed);
    connect(m_baud, &QComboBox::currentIndexChanged, this, &RotatorChoice::changed);
}

void RotatorChoice::build()
{
    m_host->setAccessibleName(tr("Host of rotctld"));
    m_host->setToolTip(tr("Name or address of the computer where rotctld runs. 127.0.0.1 is this computer"));
    m_host->setPlaceholderText(QStringLiteral("192.168.1.20"));
    m_port->setAccessibleName(tr("Port of rotctld"));
    m_port->setToolTip(tr("As in the option -t of rotctld"));
    m_port->setRange(1, 65535);
    m_port->setValue(kRotctldPort);
    m_line->setEditable(true);
    m_line->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    QStringList speeds;
    for (const int speed : kSpeeds) {
        speeds << QStringLiteral("%1 Bd").arg(speed);
    }
    m_baud->setLines(speeds);
    m_baud->setMinimumContentsLength(9);
    m_baud->setCurrentIndex(static_cast<int>(std::ranges::find(kSpeeds, profile::Profile().baud) - kSpeeds.begin()));
    m_network = makeRow(this, tr("Host"), *m_host, tr("Port"), *m_port);
    m_serial = makeRow(this, tr("Port"), *m_line, tr("Speed"), *m_baud);
    auto* const column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(4);
    column->addWidget(m_kind);
    column->addWidget(m_network);
    column->addWidget(m_serial);
    showFields();
}

void RotatorChoice::showFields()
{
    m_network->setVisible(driver() == AxisDriver::Rotctld);
    m_serial->setVisible(driver() == AxisDriver::Gs232);
    Q_EMIT changed();
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

// What the operator enters stays until another mount is in force.
void RotatorChoice::takeFrom(const profile::Profile& profile)
{
    const auto at = std::ranges::find(kDrivers, driverOf(profile));
    m_kind->setCurrentIndex(at == kDrivers.end() ? 0 : static_cast<int>(at - kDrivers.begin()));
    const auto bus = parseBusName(profile.bus);
    if (bus && bus->kind == BusKind::Rotctld) {
        m_host->setText(toQString(bus->target));
        m_port->setValue(bus->port);
    } else if (bus && (bus->kind == BusKind::Serial || bus->kind == BusKind::Tcp)) {
        m_line->setEditText(toQString(profile.bus).section(QLatin1Char(':'), 1));
        const auto speed = std::ranges::find(kSpeeds, profile.baud);
        m_baud->setCurrentIndex(speed == kSpeeds.end() ? -1 : static_cast<int>(speed - kSpeeds.begin()));
    }
}

void RotatorChoice::showAdapters(const std::vector<Adapter>& adapters)
{
    QStringList ports;
    for (const Adapter& adapter : adapters) {
        if (adapter.bus.startsWith(kFromBus) && !adapter.recognised) {
            ports << adapter.bus.sliced(kFromBus.size());
        }
    }
    m_line->setLines(ports);
    if (m_line->currentText().isEmpty() && ports.size() == 1) {
        m_line->setEditText(ports.front());
    }
}

AxisDriver RotatorChoice::driver() const
{
    return kDrivers.at(static_cast<std::size_t>(std::max(0, m_kind->currentIndex())));
}

bool RotatorChoice::isRotator() const
{
    return profile::kindOf(driver()).countsItself;
}

bool RotatorChoice::needsPorts() const
{
    return driver() == AxisDriver::Gs232;
}

Result<std::string> RotatorChoice::bus() const
{
    QString name;
    if (driver() == AxisDriver::Rotctld) {
        const QString host = m_host->text().trimmed();
        if (host.isEmpty()) {
            return failure(ErrorCode::InvalidInput, tr("Enter the host: the computer where rotctld runs."));
        }
        name = QStringLiteral("rotctld:") + withPort(host, m_port->value());
    } else {
        const QString line = m_line->currentText().trimmed();
        if (line.isEmpty()) {
            return failure(ErrorCode::InvalidInput, tr("Enter the serial port, or HOST:PORT of a serial server."));
        }
        name = (line.startsWith(QLatin1Char('/')) ? QStringLiteral("serial:") : QStringLiteral("tcp:")) + line;
    }
    return parseBusName(name.toStdString()).map([](const BusName& bus) { return toString(bus); });
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
        .driver = driver(),
        .bus = bus().value_or(m_status.profile->bus),
        .baud = needsPorts() && at >= 0 ? kSpeeds.at(static_cast<std::size_t>(at)) : m_status.profile->baud};
    return [line](profile::Profile& profile) { profile::useRotator(profile, line); };
}

bool RotatorChoice::isInUse() const
{
    const profile::Profile& profile = *m_status.profile;
    const auto entered = bus();
    return !m_status.simulated && driverOf(profile) == driver() && entered && *entered == profile.bus;
}

QStringList RotatorChoice::words() const
{
    return isInUse() ? wordsInUse() : explanation(driver());
}

QStringList RotatorChoice::wordsInUse() const
{
    QStringList lines;
    for (const Alarm& alarm : m_status.alarms) {
        if (alarm.active && alarm.name.startsWith(QLatin1String("rotator."))) {
            lines << sentence(alarm.what) + QLatin1Char(' ') + sentence(alarm.remedy);
        }
    }
    if (m_status.state == StationState::Disconnected) {
        lines.prepend(tr("In use. No answer yet."));
        return lines + whatToCheck(driver());
    }
    lines.prepend(tr("In use. It answers as: %1.").arg(m_status.line.kind));
    for (const Axis axis : kAxes) {
        if (const auto& actual = axisOf(m_status, axis).actual; actual && m_status.capabilities.has(axis)) {
            lines << QStringLiteral("%1: %2").arg(name(axis), angleText(*actual, 1));
        }
    }
    if (const QString obstacle = m_status.permissions.reason(Action::Move); !obstacle.isEmpty()) {
        lines << tr("It must not move yet: %1").arg(obstacle);
    }
    return lines;
}

}  // namespace boresight::ui

#include "moc_rotator_choice.cpp"
