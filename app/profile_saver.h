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

// Keeps what the operator applies, and finds what each station begins with, without ever making the window wait. Lives
// on the main thread. One worker reads and writes, in the order of the calls: what the next station begins with is
// found after the last change is written. Each answer is a signal.
namespace boresight::app {

class ProfileSaver : public QObject
{
    Q_OBJECT

public:
    // Reads the files: before there is a window.
    explicit ProfileSaver(const Options& options, QObject* parent = nullptr);
    ~ProfileSaver() override;  // after the last change is on the disk

    // What the first station begins with.
    [[nodiscard]] const profile::Profile& first() const { return m_first; }

public Q_SLOTS:
    void save(const boresight::profile::Profile& wanted);
    // What the next station begins with (next_profile.h). Each call is answered by one nextFound().
    void findNext(const boresight::profile::Profile& wanted);

Q_SIGNALS:
    void nextFound(const boresight::profile::Profile& profile);
    void failed(const QString& reason);  // not saved, or not what was wanted

private:
    void report(const QStringList& problems);

    // The worker's.
    KeptProfile m_kept;
    NextProfile m_next;

    profile::Profile m_first;  // no profile is in force yet when it is read
    QThreadPool m_worker;
};

}  // namespace boresight::app
