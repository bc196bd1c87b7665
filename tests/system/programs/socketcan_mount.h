// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/fakes/program.h"
#include "tests/system/programs/boresightd_process.h"
#include "tests/system/programs/starved_time.h"

#include <QString>
#include <QTemporaryDir>

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

// A whole station on real CAN interfaces, each part a separate program: `boresightctl simulate`, which also prints the
// true positions of its axes, and `boresightd` with one rotctld client. Needs the right to create interfaces (User-Mode
// Linux).
namespace boresight::system_test {

// Whether the shell command succeeded.
[[nodiscard]] bool run(const std::string& command);

// One line of `simulate --print-truth`. There are ten a second.
struct Truth
{
    double time = 0.0;  // s, time of the simulated mount
    double azimuth = 0.0;
    double elevation = 0.0;
    double azimuthRate = 0.0;
    double elevationRate = 0.0;
};

struct Standstill
{
    // s after the event; an upper limit, because the interval of the next line counts as motion
    double time = 0.0;
    double excursion = 0.0;  // ° of the worse axis since the last line before the event
};

class MountOnCan
{
public:
    // The drives are on one interface, boresightd on the other or the same.
    MountOnCan(QString drivesInterface, QString programInterface)
        : m_drivesInterface(std::move(drivesInterface)), m_programInterface(std::move(programInterface))
    {}

    // Returns false (with a failure of the test) if one of the programs does not start.
    [[nodiscard]] bool starts();
    // Waits until the journal contains the origin of each drive's position, which proves the wrap after an outage.
    [[nodiscard]] bool notesProof();
    // One command of the client and the first line of its reply.
    [[nodiscard]] std::string ask(const std::string& command) { return m_client->ask(command + "\n"); }
    [[nodiscard]] bool reArms();  // repeats the request

    [[nodiscard]] const std::vector<Truth>& truths();
    [[nodiscard]] Truth truth() { return truths().empty() ? Truth{} : truths().back(); }
    [[nodiscard]] bool waitForTruths(std::size_t more);  // waits for this number of lines, a tenth of a second each
    // Starts a motion and waits until it is fast, or until the mount has arrived. The target is far enough for a slow
    // computer to see the motion. If a busy computer starves the drives so that they stop, they are re-armed and
    // commanded again, as often as needed.
    [[nodiscard]] bool slews(const std::string& command);
    [[nodiscard]] bool comesTo(double azimuth, double elevation);
    // `before` is the number of lines at the time of the event.
    [[nodiscard]] std::optional<Standstill> standstillAfter(std::size_t before);
    [[nodiscard]] double largestMotion(std::size_t fromLine);  // ° of the worse axis

    // The log of boresightd, and the time until the words appear in it from now on.
    [[nodiscard]] const std::string& log();
    [[nodiscard]] std::optional<qint64> waitForWords(const std::string& words, std::size_t after = 0);

    [[nodiscard]] std::chrono::milliseconds starved() const { return m_starved.total(); }
    [[nodiscard]] bool endsWell();

private:
    [[nodiscard]] bool startPrograms();
    [[nodiscard]] bool rests();
    [[nodiscard]] bool commandUntil(const std::string& command, const std::function<bool()>& reached);

    QString m_drivesInterface;
    QString m_programInterface;
    QTemporaryDir m_folder;
    std::unique_ptr<fakes::Program> m_drives;
    std::unique_ptr<BoresightdProcess> m_boresightd;
    std::unique_ptr<fakes::TcpPeer> m_client;
    std::vector<Truth> m_truths;
    qsizetype m_linesRead = 0;
    std::string m_log;
    StarvedTime m_starved;
};

}  // namespace boresight::system_test
