// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/alarms/event_log.h"
#include "core/base/clock.h"
#include "core/base/edge_thread.h"
#include "core/element_web/element_web.h"
#include "core/elements/element_set.h"
#include "core/profile/in_force.h"

#include <QFileSystemWatcher>
#include <QObject>
#include <QStringList>
#include <QThreadPool>
#include <QTimer>

#include <memory>
#include <vector>

// The satellites that the station knows. They come from the element files and addresses that the profile names, else
// from the files of Gpredict. A thread of its own reads them at the start, with each change of the profile, and when a
// file changes. Another thread downloads addresses into the cache. Elements that cannot be used are in the log with
// file, line and reason. While a file is broken or gone, its satellites stay as they were read before, and the file is
// tried again. Station thread only.
//
// More than 15 members: the files, the downloads, and the problems already reported for both.
namespace boresight {

class StationElements : public QObject
{
    Q_OBJECT

public:
    using Satellites = std::shared_ptr<const std::vector<orbit::ElementSet>>;  // sorted by satellite number

    static constexpr qsizetype kMostProblems = 10;

    // Profile, log and clock outlive this. Any thread may read the clock.
    StationElements(const profile::InForce& profile, EventLog& log, const Clock& clock, QObject* parent);

    void open();
    void profileChanged(const profile::Profile& before, const profile::Profile& after);
    [[nodiscard]] const Satellites& satellites() const { return m_satellites; }
    // The first kMostProblems problems of the downloads and of the files. The same lines are in the log.
    [[nodiscard]] const QStringList& problems() const { return m_shownProblems; }

Q_SIGNALS:
    void changed();

private:
    struct Reading
    {
        QStringList paths;
        std::vector<orbit::ElementSet> sets;
        QStringList problems;
    };

    [[nodiscard]] QStringList paths() const;
    void read();
    void take(const Reading& reading);
    void watch();
    void download();
    void takeDownloadProblems(const QStringList& problems);
    void tell(const QStringList& problems, const QStringList& before);
    void tellKept(std::size_t count);

    const profile::InForce& m_profile;
    EventLog& m_log;
    const Clock& m_clock;
    orbit::ElementCache m_cache{orbit::ElementCache::userFolder()};
    Satellites m_satellites = std::make_shared<const std::vector<orbit::ElementSet>>();
    QStringList m_paths;     // the files that were read
    QStringList m_problems;  // of the files, as last reported
    QStringList m_downloadProblems;
    QStringList m_shownProblems;
    QFileSystemWatcher m_watcher{this};
    QTimer m_settled{this};                   // delays the reading: a file that is being written changes many times
    QTimer m_again{this};                     // reads again: the watcher does not report that a missing file is back
    orbit::ElementWeb* m_web = nullptr;       // owned by m_webThread and used there
    std::unique_ptr<EdgeThread> m_webThread;  // null while there is no address
    QThreadPool m_reader;                     // last member: its work ends before the other members are destroyed
    bool m_open = false;
};

}  // namespace boresight
