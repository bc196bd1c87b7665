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

// A whole station on real CAN interfaces, each part a program of its own: `boresightctl simulate`, which also prints
// how its axes really stand, and `boresightd` with one rotctld client. Needs the right to make interfaces (User-Mode
// Linux).
namespace boresight::system_test {

// Of a shell command.
[[nodiscard]] bool run(const std::string& command);

// One line of `simulate --print-truth`, ten a second.
struct Truth
{
    double time = 0.0;  // s, of the simulated mount
    double azimuth = 0.0;
    double elevation = 0.0;
    double azimuthRate = 0.0;
    double elevationRate = 0.0;
};

struct Standstill
{
    double time = 0.0;       // s after the event, at most: the next line's interval is counted as moving
    double excursion = 0.0;  // ° of the worse axis since the last line before the event
};

class MountOnCan
{
public:
    // The drives on one interface, boresightd on the other or the same.
    MountOnCan(QString drivesInterface, QString programInterface)
        : m_drivesInterface(std::move(drivesInterface)), m_programInterface(std::move(programInterface))
    {}

    // False (with a failure of the test) if one of the programs does not start.
    [[nodiscard]] bool starts();
    // Waits until the journal says since when each drive's position is counted, which tells the turn after an outage.
    [[nodiscard]] bool notesProof();
    // One command of the client and the first line of its reply.
    [[nodiscard]] std::string ask(const std::string& command) { return m_client->ask(command + "\n"); }
    [[nodiscard]] bool reArms();  // asked again and again

    [[nodiscard]] const std::vector<Truth>& truths();
    [[nodiscard]] Truth truth() { return truths().empty() ? Truth{} : truths().back(); }
    [[nodiscard]] bool waitForTruths(std::size_t more);  // that many lines, a tenth of a second each
    // Sends the mount off and waits until it is fast (so far away that a slow machine sees it), or until it is there.
    // Where a busy machine starves it so that its drives stop themselves, it is re-armed and sent again, as often as
    // needed.
    [[nodiscard]] bool slews(const std::string& command);
    [[nodiscard]] bool comesTo(double azimuth, double elevation);
    // `before` is the number of lines when the event came.
    [[nodiscard]] std::optional<Standstill> standstillAfter(std::size_t before);
    [[nodiscard]] double largestMotion(std::size_t fromLine);  // ° of the worse axis

    // What boresightd wrote to its log, and how long the words take to come from now on.
    [[nodiscard]] const std::string& log();
    [[nodiscard]] std::optional<qint64> waitForWords(const std::string& words, std::size_t after = 0);

    [[nodiscard]] std::chrono::milliseconds starved() const { return m_starved.total(); }
    [[nodiscard]] bool endsWell();

private:
    [[nodiscard]] bool startPrograms();
    [[nodiscard]] bool reArm();  // lines of the log may still be on their way
    [[nodiscard]] bool wantsReArm() { return log().find("re-arm.", m_armed) != std::string::npos; }
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
    std::size_t m_armed = 0;  // what of the log is older than the last re-arm, or was seen to need none
    StarvedTime m_starved;
};

}  // namespace boresight::system_test
