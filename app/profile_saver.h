// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/kept_profile.h"
#include "app/next_profile.h"
#include "app/options.h"
#include "core/profile/profile.h"

#include <QObject>
#include <QString>
#include <QStringList>
#include <QThreadPool>

// Saves what the operator applies, and finds the profile of each station, without delaying the window. Lives on the
// main thread. One worker reads and writes in the order of the calls, so the profile of the next station is found after
// the last change is written. Each answer is a signal.
namespace boresight::app {

class ProfileSaver : public QObject
{
    Q_OBJECT

public:
    // Reads the files, so create it before the window.
    explicit ProfileSaver(const Options& options, QObject* parent = nullptr);
    ~ProfileSaver() override;  // waits until the last change is on the disk

    // The profile of the first station.
    [[nodiscard]] const profile::Profile& first() const { return m_first; }

public Q_SLOTS:
    void save(const boresight::profile::Profile& wanted);
    // Finds the profile of the next station (next_profile.h). Each call is answered by one nextFound().
    void findNext(const boresight::profile::Profile& wanted);

Q_SIGNALS:
    void nextFound(const boresight::profile::Profile& profile);
    void failed(const QString& reason);  // the change was not saved, or the wanted profile is not in use

private:
    void report(const QStringList& problems);

    // Used by the worker.
    KeptProfile m_kept;
    NextProfile m_next;

    profile::Profile m_first;  // read before any profile is in force
    QThreadPool m_worker;
};

}  // namespace boresight::app
