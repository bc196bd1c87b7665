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

// The satellites that the station knows: the element files and addresses that the profile names, or the files of
// Gpredict, read beside the station thread at the start, with each change of the profile, and when a file changes.
// Addresses are downloaded on a thread of their own, and read from the cache. What cannot be used is in the log with
// its file, line and reason. Satellites that are missing only because a file is broken or gone stay as they were read
// before, and the file is looked for again. Station thread only.
//
// More than 15 members: what it reads and downloads, and what it told of both.
namespace boresight {

class StationElements : public QObject
{
    Q_OBJECT

public:
    using Satellites = std::shared_ptr<const std::vector<orbit::ElementSet>>;  // in the order of the numbers

    static constexpr qsizetype kMostProblems = 10;

    // Profile, log and clock outlive this; any thread may read the clock.
    StationElements(const profile::InForce& profile, EventLog& log, const Clock& clock, QObject* parent);

    void open();
    void profileChanged(const profile::Profile& before, const profile::Profile& after);
    [[nodiscard]] const Satellites& satellites() const { return m_satellites; }
    // Of downloads and files, the first kMostProblems of each. The same lines are in the log.
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
    QStringList m_paths;     // where they were read
    QStringList m_problems;  // of the files, as told last
    QStringList m_downloadProblems;
    QStringList m_shownProblems;
    QFileSystemWatcher m_watcher{this};
    QTimer m_settled{this};                   // a file that is being written changes many times
    QTimer m_again{this};                     // nothing tells when a file that is gone comes back
    orbit::ElementWeb* m_web = nullptr;       // lives on m_webThread and belongs to it
    std::unique_ptr<EdgeThread> m_webThread;  // null while there is no address
    QThreadPool m_reader;                     // last: it ends before what it tells
    bool m_open = false;
};

}  // namespace boresight
