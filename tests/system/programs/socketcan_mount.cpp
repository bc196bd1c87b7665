// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/system/programs/socketcan_mount.h"

#include "core/base/numbers.h"
#include "tests/fakes/real_mount.h"
#include "tests/fakes/wait_until.h"

#include <QDeadlineTimer>
#include <QDir>
#include <QElapsedTimer>
#include <QFile>
#include <QRegularExpression>
#include <QTest>

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace boresight::system_test {
namespace {

using namespace std::chrono_literals;

constexpr auto kPatience = 60s;  // for a guest system on a busy computer
// The noise of a simulated encoder moves the truth by less. The slowest commanded motion is a hundred times faster.
constexpr double kSocketcanMountStill = 0.02;  // °
constexpr std::size_t kLinesAtRest = 5;        // half a second
constexpr const char* kReArm = "R 1";
constexpr const char* kDone = "RPRT 0\n";

double farthest(const Truth& a, const Truth& b)
{
    return std::max(std::abs(a.azimuth - b.azimuth), std::abs(a.elevation - b.elevation));
}

std::optional<Truth> readTruth(const QString& line)
{
    static const QRegularExpression form(
        QStringLiteral("^t=([0-9.]+) az=([-0-9.]+) az_rate=([-0-9.]+) .*\\bel=([-0-9.]+) el_rate=([-0-9.]+) "));
    const auto match = form.match(line);
    if (!match.hasMatch()) {
        return std::nullopt;
    }
    const auto number = [&match](int group) { return match.captured(group).toDouble(); };
    return Truth{.time = number(1),
                 .azimuth = number(2),
                 .elevation = number(4),
                 .azimuthRate = number(3),
                 .elevationRate = number(5)};
}

// A guest is slower than a computer at a mast, although its clock is slowed (slow_clock.cpp). While a program starts,
// the guest does not interrupt it for another program. So this profile has half the tick rate, and the longest time-out
// that a profile may have.
profile::Profile forASlowMachine()
{
    profile::Profile slow;
    slow.control.tickHz = 25;
    slow.control.watchdog = Seconds(0.2);
    return slow;
}

}  // namespace

bool run(const std::string& command)
{
    return std::system(command.c_str()) == 0;
}

// Both have a higher priority than other programs. (The drives are independent in reality, and the service has it from
// its unit file.) The guest has one processor, and the start of a program alone takes 80 ms.
bool MountOnCan::starts()
{
    constexpr int kServiceNiceness = -10;
    setpriority(PRIO_PROCESS, 0, kServiceNiceness);
    const bool started = startPrograms();
    setpriority(PRIO_PROCESS, 0, 0);
    return started;
}

bool MountOnCan::startPrograms()
{
    m_drives = std::make_unique<fakes::Program>(QStringLiteral(BORESIGHTCTL),
                                                QStringList{QStringLiteral("simulate"), QStringLiteral("--can"),
                                                            m_drivesInterface, QStringLiteral("--print-truth")});
    if (!m_drives->waitForLine(QStringLiteral("ready"))) {
        ADD_FAILURE() << m_drives->errors().toStdString();
        return false;
    }
    m_boresightd = std::make_unique<BoresightdProcess>(
        fakes::confirmedMount(m_folder.path(), QStringLiteral("socketcan:") + m_programInterface, forASlowMachine()) +
        fakes::standingAt(QStringLiteral("0,10")));
    if (!m_boresightd->listens()) {
        ADD_FAILURE() << log();
        return false;
    }
    m_client = m_boresightd->connect();
    return true;
}

bool MountOnCan::notesProof()
{
    constexpr int kDrives = 2;
    const QDir folder(m_boresightd->stateFolder());
    return fakes::waitUntil(
        [&folder] {
            const QStringList journals = folder.entryList({QStringLiteral("*.memory.json")});
            if (journals.isEmpty()) {
                return false;
            }
            QFile journal(folder.filePath(journals.constFirst()));
            return journal.open(QIODevice::ReadOnly) && journal.readAll().count("origin_beginning") == kDrives;
        },
        kPatience);
}

bool MountOnCan::reArms()
{
    return QTest::qWaitFor([this] { return ask(kReArm) == kDone; },
                           static_cast<int>(std::chrono::milliseconds(kPatience).count()));
}

const std::vector<Truth>& MountOnCan::truths()
{
    const QStringList lines = m_drives->lines();
    for (; m_linesRead < lines.size(); ++m_linesRead) {
        if (const auto truth = readTruth(lines[m_linesRead])) {
            m_truths.push_back(*truth);
        }
    }
    return m_truths;
}

bool MountOnCan::waitForTruths(std::size_t more)
{
    const std::size_t wanted = truths().size() + more;
    return fakes::waitUntil([this, wanted] { return truths().size() >= wanted; }, kPatience);
}

bool MountOnCan::commandUntil(const std::string& command, const std::function<bool()>& reached)
{
    const QDeadlineTimer patience(kPatience);
    while (!reached() && !patience.hasExpired()) {
        static_cast<void>(ask(kReArm));  // refused if the drives have not stopped
        if (ask(command) == kDone) {
            const std::size_t before = truths().size();
            const auto stopped = [this, before] { return truths().size() > before + kLinesAtRest && rests(); };
            static_cast<void>(fakes::waitUntil([&] { return reached() || stopped(); }, kPatience));
        } else {  // the drives are searched, read and checked before anything may move
            QTest::qWait(200);
        }
    }
    return reached();
}

bool MountOnCan::slews(const std::string& command)
{
    constexpr double kFast = 5.0;  // °/s
    return commandUntil(command, [this] { return std::abs(truth().azimuthRate) >= kFast; });
}

bool MountOnCan::comesTo(double azimuth, double elevation)
{
    const Truth wanted{.azimuth = azimuth, .elevation = elevation};
    const std::string command = "P " + formatFixed(azimuth, 1) + ' ' + formatFixed(elevation, 1);
    return commandUntil(command, [this, &wanted] { return farthest(truth(), wanted) < 0.1; });
}

bool MountOnCan::rests()
{
    const auto& all = truths();
    return all.size() > kLinesAtRest && farthest(all.back(), all[all.size() - kLinesAtRest]) < kSocketcanMountStill;
}

std::optional<Standstill> MountOnCan::standstillAfter(std::size_t before)
{
    if (!waitForTruths(kLinesAtRest) || !fakes::waitUntil([this] { return rests(); }, kPatience)) {
        return std::nullopt;
    }
    const auto& all = truths();
    const auto event = all.begin() + static_cast<std::ptrdiff_t>(before) - 1;
    const auto rest = std::find_if(
        event, all.end(), [&all](const Truth& one) { return farthest(one, all.back()) < kSocketcanMountStill; });
    return Standstill{.time = rest->time - event->time, .excursion = farthest(*event, all.back())};
}

double MountOnCan::largestMotion(std::size_t fromLine)
{
    const auto& all = truths();
    double largest = 0.0;
    for (std::size_t i = fromLine; i < all.size(); ++i) {
        largest = std::max(largest, farthest(all[i], all[fromLine]));
    }
    return largest;
}

const std::string& MountOnCan::log()
{
    m_log += m_boresightd->complaints();
    return m_log;
}

std::optional<qint64> MountOnCan::waitForWords(const std::string& words, std::size_t after)
{
    QElapsedTimer timer;
    timer.start();
    if (!fakes::waitUntil([&] { return log().find(words, after) != std::string::npos; }, kPatience)) {
        return std::nullopt;
    }
    return timer.elapsed();
}

bool MountOnCan::endsWell()
{
    return m_boresightd->terminate() == 0;
}

}  // namespace boresight::system_test
