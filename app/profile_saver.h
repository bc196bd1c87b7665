// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/profile/profile.h"

#include <QObject>
#include <QString>
#include <QThreadPool>

#include <memory>

// Keeps what the operator has applied: in the file that the program was started with, else as a new mount of the store.
// Only the keys that the operator has changed are taken over, so that what the command line overrides is not written;
// and what was found of the simulated mount in place of a real one is not the real one's. What is found of a real mount
// in place of the simulated one, and another bus, makes the file the real one's.
// Lives on the main thread; one worker writes, in the order of the changes.
namespace boresight::app {

class ProfileSaver : public QObject
{
    Q_OBJECT

public:
    // `path` is empty before there is any file; `inForce` is what the station was started with.
    ProfileSaver(const QString& configDir, const QString& path, const profile::Profile& inForce,
                 QObject* parent = nullptr);
    ~ProfileSaver() override;  // after the last change is on the disk

    // The program was started for the simulated mount: no bus that a profile names is used until it ends.
    void keepSimulated() { m_keepsSimulated = true; }

public Q_SLOTS:
    void save(const boresight::profile::Profile& wanted);
    // Another mount was connected: what is applied from now on belongs to its file, and the next start begins with it.
    void follow(const boresight::profile::Profile& connected);

Q_SIGNALS:
    // Not saved, or not all of it, and why.
    void failed(const QString& reason);

private:
    QString m_configDir;
    std::shared_ptr<QString> m_path;  // the worker's, once it works
    profile::Profile m_last;
    bool m_keepsSimulated = false;
    QThreadPool m_writer;
};

}  // namespace boresight::app
