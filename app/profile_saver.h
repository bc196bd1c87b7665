// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/options.h"
#include "app/simulated_profiles.h"
#include "core/profile/profile.h"

#include <QObject>
#include <QString>
#include <QThreadPool>

#include <memory>
#include <string>
#include <vector>

// Which profile each station begins with, and where the changes that the operator applies are kept: in the file that
// the program was started with, else as a new mount of the store. While a mount is simulated they are kept in the
// simulation's own file of this mount. Only the keys that the operator has changed are written, so that what the
// command line overrides is not. Lives on the main thread. One worker writes, in the order of the changes; between two
// stations the main thread waits for it.
namespace boresight::app {

class ProfileSaver : public QObject
{
    Q_OBJECT

public:
    explicit ProfileSaver(const Options& options, QObject* parent = nullptr);
    ~ProfileSaver() override;  // after the last change is on the disk

    // What the first station begins with.
    [[nodiscard]] const profile::Profile& first() const { return m_last; }
    // What the next station begins with, when a reconnect with `wanted` was asked for: the profile of another mount,
    // the one that was applied last, or a simulated one with a real bus. The latter leaves the simulation: the real
    // mount gets its own profile with what was changed together with the bus. Its directions are to be confirmed.
    // Where that cannot be, failed() says why, and it is the mount of before.
    [[nodiscard]] profile::Profile next(const profile::Profile& wanted);

public Q_SLOTS:
    void save(const boresight::profile::Profile& wanted);

Q_SIGNALS:
    void failed(const QString& reason);  // not saved

private:
    [[nodiscard]] profile::Profile simulate(const profile::Profile& own, const profile::Profile& fresh);
    [[nodiscard]] bool isListed(const profile::Profile& wanted) const;
    [[nodiscard]] Result<> switchTo(const profile::Profile& wanted);
    [[nodiscard]] Result<> leaveSimulation(const profile::Profile& wanted);
    [[nodiscard]] bool simulates(const profile::Profile& of) const;
    void report(const Result<>& done);

    QString m_configDir;
    SimulatedProfiles m_simulated;
    Simulation m_asked;                     // by the command line
    std::vector<std::string> m_overridden;  // by the command line: never written
    QString m_ownPath;                      // of the mount's own profile; empty: no file yet
    std::shared_ptr<QString> m_path;        // of the file that is written; the worker's while it works
    profile::Profile m_last;
    QThreadPool m_writer;
};

}  // namespace boresight::app
