// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/alarms/event_log.h"
#include "core/elements/element_set.h"
#include "core/profile/in_force.h"

#include <QFileSystemWatcher>
#include <QObject>
#include <QStringList>
#include <QThreadPool>
#include <QTimer>

#include <memory>
#include <vector>

// The satellites that the station knows: the element files that the profile names, or those of Gpredict, read beside
// the station thread at the start, with each change of the profile, and when a file changes. What cannot be used is in
// the log with its file, line and reason. Satellites that are missing only because a file is broken or gone stay as
// they were read before, and the file is looked for again. Station thread only.
namespace boresight {

class StationElements : public QObject
{
    Q_OBJECT

public:
    using Satellites = std::shared_ptr<const std::vector<orbit::ElementSet>>;  // in the order of the numbers

    // Profile and log outlive this.
    StationElements(const profile::InForce& profile, EventLog& log, QObject* parent);

    void open();
    void profileChanged(const profile::Profile& before, const profile::Profile& after);
    [[nodiscard]] const Satellites& satellites() const { return m_satellites; }

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
    void tell(const QStringList& problems, std::size_t kept);
    void watch();

    const profile::InForce& m_profile;
    EventLog& m_log;
    Satellites m_satellites = std::make_shared<const std::vector<orbit::ElementSet>>();
    QStringList m_paths;     // where they were read
    QStringList m_problems;  // as told last
    QFileSystemWatcher m_watcher{this};
    QTimer m_settled{this};  // a file that is being written changes many times
    QTimer m_again{this};    // nothing tells when a file that is gone comes back
    QThreadPool m_reader;    // last: it ends before what it tells
    bool m_open = false;
};

}  // namespace boresight
