// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/boresightctl/local_client.h"
#include "app/boresightctl/sensor_option.h"
#include "app/boresightctl/simulate_options.h"
#include "app/boresightctl/station_help.h"
#include "app/unix_signals.h"
#include "core/base/numbers.h"
#include "core/can/socketcan_link.h"
#include "core/sim/injection_option.h"
#include "core/sim_bus/can_server.h"
#include "core/sim_bus/pty_server.h"
#include "core/sim_bus/running_faults.h"
#include "core/sim_sensor/sensor_port.h"
#include "core/sim_sensor/sensor_publisher.h"
#include "core/station/real_time.h"

#include <QCoreApplication>
#include <QTimer>

#include <chrono>
#include <cmath>
#include <cstdio>

namespace boresight::ctl {
namespace {

using namespace std::chrono_literals;

constexpr auto kTruthPeriod = 100ms;

void remark(Seconds time, const std::string& text)
{
    std::fputs(("t=" + formatFixed(time.count(), 3) + " s: " + text + '\n').c_str(), stderr);
}

std::string truthText(std::string_view name, const sim::AxisTruth& truth)
{
    const std::string key = ' ' + std::string(name);
    return key + '=' + formatFixed(truth.angle.degrees(), 4) + key + "_rate=" + formatFixed(truth.rate.degrees(), 4) +
           key + "_mode=" + std::to_string(static_cast<int>(truth.mode)) + key +
           "_fault=" + std::to_string(truth.faultCode);
}

// The simulated pair, with everything that makes it a device for other programs. The pair's time 0 is the time of its
// creation.
class SimulatedDevice
{
public:
    explicit SimulatedDevice(const SimulateOptions& options) : m_options(options), m_pair(options.pairSettings())
    {
        for (const sim::Injection& injection : options.injections) {
            m_pair.faults().add(injection);
        }
    }

    Result<> start();
    void announceInjections();
    void printTruth();

private:
    Result<> startOnPty();
    Result<> startOnCan();
    Result<> startSensor();
    Result<> startSensorPort();
    void startSensorPublisher();
    [[nodiscard]] Seconds now() const { return m_clock.now() - m_epoch; }

    const SimulateOptions& m_options;
    const SystemClock m_clock;
    sim::SimulatedPair m_pair;
    const SteadyTime m_epoch = m_clock.now();
    std::unique_ptr<sim::PtyServer> m_ptyServer;
    std::unique_ptr<SocketCanLink> m_canLink;
    std::unique_ptr<sim::CanServer> m_canServer;
    std::unique_ptr<sim::SensorBox> m_sensor;
    std::unique_ptr<sim::SensorPort> m_sensorPort;
    std::unique_ptr<sim::SensorPublisher> m_sensorPublisher;
    QTimer m_truthTimer;
};

Result<> SimulatedDevice::start()
{
    return (m_options.can.empty() ? startOnPty() : startOnCan()).and_then([this] { return startSensor(); });
}

// The same sensor box, connected by serial line or MQTT.
Result<> SimulatedDevice::startSensor()
{
    if (!m_options.hasSensor()) {
        return {};
    }
    m_sensor = std::make_unique<sim::SensorBox>(m_pair, m_clock, m_epoch, m_options.sensorTruth);
    m_sensor->start();
    if (m_options.sensorBroker) {
        startSensorPublisher();
    }
    return m_options.sensor.empty() ? Result<>() : startSensorPort();
}

Result<> SimulatedDevice::startSensorPort()
{
    return sim::SensorPort::create(QString::fromStdString(m_options.sensor), *m_sensor)
        .map([this](std::unique_ptr<sim::SensorPort> port) {
            m_sensorPort = std::move(port);
            print("sensor " + m_sensorPort->device().toStdString() + '\n');
        });
}

void SimulatedDevice::startSensorPublisher()
{
    const auto topics = m_options.orientationOnly ? sim::PublishedTopics::OrientationOnly : sim::PublishedTopics::All;
    m_sensorPublisher = std::make_unique<sim::SensorPublisher>(*m_sensor, m_clock,
                                                               QString::fromStdString(m_options.sensorTopics), topics);
    mqtt::BrokerClient& client = m_sensorPublisher->client();
    QObject::connect(&client, &mqtt::BrokerClient::connected, &client,
                     [this] { remark(now(), "the sensor publishes on " + m_options.sensorTopics); });
    QObject::connect(&client, &mqtt::BrokerClient::problemChanged, &client, [this](const QString& problem) {
        if (!problem.isEmpty()) {
            remark(now(), problem.toStdString());
        }
    });
    client.open(*m_options.sensorBroker);
}

Result<> SimulatedDevice::startOnPty()
{
    return sim::PtyServer::create(QString::fromStdString(m_options.pty), m_pair, m_clock)
        .map([this](std::unique_ptr<sim::PtyServer> server) { m_ptyServer = std::move(server); });
}

Result<> SimulatedDevice::startOnCan()
{
    m_canLink = std::make_unique<SocketCanLink>(QString::fromStdString(m_options.can), m_clock);
    QObject::connect(m_canLink.get(), &CanLink::statusChanged, m_canLink.get(), [this](const LinkStatus& status) {
        remark(now(), status.text.isEmpty() ? "the bus is in order" : status.text.toStdString());
    });
    if (const Result<> opened = m_canLink->open(); !opened) {
        return opened;
    }
    m_canServer = std::make_unique<sim::CanServer>(*m_canLink, m_pair, m_clock);
    return {};
}

// Uses the timers of the event loop. They agree with the pair's own clock within a millisecond or two.
void SimulatedDevice::announceInjections()
{
    const auto announceAt = [this](Seconds time, const std::string& text) {
        const auto wait = std::chrono::ceil<std::chrono::milliseconds>(std::max(time - now(), Seconds(0.0)));
        QTimer::singleShot(wait, Qt::PreciseTimer, &m_truthTimer, [this, text] { remark(now(), text); });
    };
    for (const sim::Injection& injection : m_options.injections) {
        announceAt(injection.at, "begins: " + sim::describe(injection));
        if (std::isfinite(injection.duration.count())) {
            announceAt(injection.at + injection.duration, "ends: " + sim::describe(injection));
        }
    }
}

void SimulatedDevice::printTruth()
{
    QObject::connect(&m_truthTimer, &QTimer::timeout, &m_truthTimer, [this] {
        m_pair.advanceTo(now());
        print("t=" + formatFixed(m_pair.now().count(), 3) + truthText("az", m_pair.truth(Axis::Azimuth)) +
              truthText("el", m_pair.truth(Axis::Elevation)) + '\n');
    });
    m_truthTimer.setTimerType(Qt::PreciseTimer);
    m_truthTimer.start(kTruthPeriod);
}

ExitStatus simulate(const SimulateOptions& options)
{
    app::UnixSignals signals;
    QObject::connect(&signals, &app::UnixSignals::endRequested, qApp, &QCoreApplication::quit);
    SimulatedDevice device(options);
    if (const Result<> started = device.start(); !started) {
        complain(kSimulateCommand, started.error().text);
        return kFoundWrong;
    }
    RealTime realTime;  // real-time priority: drives keep their time under any load of the computer
    realTime.ask();
    print("ready\n");
    device.announceInjections();
    if (options.printTruth) {
        device.printTruth();
    }
    QCoreApplication::exec();
    return kDone;
}

// One request after the other: a station takes one fault each time.
ExitStatus askStation(const SimulateOptions& options)
{
    std::vector<std::string> texts = options.faults;
    if (options.endFaults) {
        texts.insert(texts.begin(), std::string(kEndFaults));
    }
    for (const std::string& text : texts) {
        const auto answer = askLocally(
            *options.station, {.command = local::LocalCommand::Simulate, .target = QByteArray::fromStdString(text)});
        if (!answer) {
            return failedBy(kSimulateCommand, answer.error());
        }
        printLine(QString::fromUtf8(answer->trimmed()));
    }
    return kDone;
}

const std::string kDetails =
    R"(  --pty PATH      simulate an fdcanusb adapter on a pseudo-terminal. PATH becomes a link to it. Programs may connect and
                  disconnect
  --can IFACE     reply on a CAN interface that is up, for example vcan0
  --station HOST:PORT
                  start no mount: show the faults on the simulated mount of a running station of this user on this
                  computer, for example boresight --simulate. A START is then a time from now. A station with a real
                  mount refuses
  --end-faults    with --station: first end the faults that were asked for before
  --sensor PATH   simulate the orientation sensor, too, on a pseudo-terminal. PATH becomes a link to it. Set in the
                  profile sensor.source = "serial", sensor.port = "PATH"
  --sensor-mqtt HOST[:PORT]
                  publish the readings of the sensor at an MQTT broker, as its firmware does: without a user, and
                  nothing retained. Default port: 1883. Set in the profile sensor.source = "mqtt", mqtt.host = "HOST".
                  The topics are those of the real sensor, so every program that reads them at this broker uses the
                  simulated sensor. To separate the two, add --sensor-topics simulated/ and set in the profile
                  sensor.orientation_topic = "simulated/orientation", and the other two topics in the same way
  --az-id N       id of the azimuth drive, 1…126. Default: 1
  --el-id N       id of the elevation drive, 1…126. Default: 2
  --factory       boards as delivered: both with id 1, not referenced, bounds of ±0.01 turns. Default: two commissioned
                  drives
  --print-truth   print the true state of the axes ten times a second: seconds, degrees, °/s, mode and fault code of the
                  drive

With --pty or --can the program prints "ready" when it replies to commands, and ends at SIGTERM or Ctrl-C. The mount
starts at azimuth 0°, elevation 10°.

Errors of the sensor and the mount, for Boresight to find:
)" + sensorHelp() +
    R"(  --sensor-topics PREFIX
        topics PREFIXorientation, PREFIXcalibration and PREFIXstatus. Default: antenna/
  --sensor-orientation-only
        publish only PREFIXorientation, as firmware since March 2026 does

Faults to inject. Each option may be given several times. AXIS is az or el. Default: both axes. START and DURATION are
times after the start of the simulation, like 5, 5s or 500ms. Without START a fault begins at once. Without DURATION it
lasts until the end. Standard error shows when a fault begins and ends.
)" + sim::injectionHelp() +
    R"(
Examples:
  boresightctl simulate --pty /tmp/mount --wind az:30Nm@5+3 --silence el@12s+500ms --fault az:38@20
  boresightd --profile mount.toml   (with bus.name = "fdcanusb:/tmp/mount", mount.directions = "confirmed")
  boresightctl simulate --pty /tmp/mount --sensor /tmp/sensor --sensor-north -12 --sensor-silence @60+20
  boresightctl simulate --pty /tmp/mount --sensor-mqtt 127.0.0.1 --sensor-deviation 0,0,0,0
  boresightctl simulate --station localhost:4533 --wind az:12Nm+3 --jam el:30@10
)";

ExitStatus runSimulate(Arguments arguments)
{
    const Result<SimulateOptions> options = parseSimulateOptions(arguments);
    if (options && options->station) {
        return askStation(*options);
    }
    return options ? simulate(*options) : usageError(kSimulateCommand, options.error().text);
}

}  // namespace

const Subcommand kSimulateCommand{.name = "simulate",
                                  .arguments = "--pty PATH | --can IFACE | --station HOST:PORT [OPTION …]",
                                  .summary = "Simulate a mount: two moteus controllers on a CAN bus, and faults of one",
                                  .details = kDetails,
                                  .run = runSimulate};

}  // namespace boresight::ctl
