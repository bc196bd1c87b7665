// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/station/station_elements.h"

#include "core/base/text.h"
#include "core/element_files/element_files.h"
#include "core/gpredict/gpredict_qth.h"

#include <QFileInfo>

#include <algorithm>
#include <iterator>
#include <utility>

namespace boresight {
namespace {

const QString kElementSource = QStringLiteral("satellites");
constexpr std::chrono::seconds kSettleTime{1};
constexpr std::chrono::seconds kLookAgain{30};
constexpr qsizetype kMostProblems = 10;

}  // namespace

StationElements::StationElements(const profile::InForce& profile, EventLog& log, QObject* parent)
    : QObject(parent), m_profile(profile), m_log(log)
{
    m_reader.setMaxThreadCount(1);
    m_settled.setSingleShot(true);
    m_settled.setInterval(kSettleTime);
    connect(&m_settled, &QTimer::timeout, this, &StationElements::read);
    m_again.setSingleShot(true);
    m_again.setInterval(kLookAgain);
    connect(&m_again, &QTimer::timeout, this, &StationElements::read);
    connect(&m_watcher, &QFileSystemWatcher::fileChanged, this, [this] { m_settled.start(); });
    connect(&m_watcher, &QFileSystemWatcher::directoryChanged, this, [this] { m_settled.start(); });
}

void StationElements::open()
{
    m_open = true;
    read();
}

void StationElements::profileChanged(const profile::Profile& before, const profile::Profile& after)
{
    if (m_open && (before.orbit.elements != after.orbit.elements || before.gpredict != after.gpredict)) {
        read();
    }
}

// A Gpredict that is not there is no mistake of anybody.
QStringList StationElements::paths() const
{
    QStringList all;
    for (const std::string& path : m_profile->orbit.elements) {
        all << toQString(path);
    }
    const QString gpredict = profile::gpredictFolder(m_profile->gpredict);
    if (all.isEmpty() && QFileInfo(gpredict + QStringLiteral("/satdata")).isDir()) {
        all << gpredict;
    }
    return all;
}

void StationElements::read()
{
    m_again.stop();
    watch();
    m_reader.start([this, paths = paths()] {
        orbit::ElementFiles files = orbit::readElementFiles(paths);
        Reading reading{.paths = paths, .sets = std::move(files.sets), .problems = std::move(files.problems)};
        QMetaObject::invokeMethod(
            this, [this, reading = std::move(reading)] { take(reading); }, Qt::QueuedConnection);
    });
}

void StationElements::take(const Reading& reading)
{
    std::vector<orbit::ElementSet> sets = reading.sets;
    if (!reading.problems.isEmpty() && reading.paths == m_paths) {
        sets.clear();
        std::ranges::set_union(reading.sets, *m_satellites, std::back_inserter(sets), {}, &orbit::ElementSet::number,
                               &orbit::ElementSet::number);
    }
    m_paths = reading.paths;
    tell(reading.problems, sets.size() - reading.sets.size());
    if (sets == *m_satellites) {
        return;
    }
    m_satellites = std::make_shared<const std::vector<orbit::ElementSet>>(std::move(sets));
    m_log.add(Severity::Advisory, kElementSource,
              Text::tr("the elements of %1 satellites are read").arg(m_satellites->size()));
    Q_EMIT changed();
}

void StationElements::tell(const QStringList& problems, std::size_t kept)
{
    if (problems == m_problems) {
        return;
    }
    m_problems = problems;
    for (const QString& problem : m_problems.mid(0, kMostProblems)) {
        m_log.add(Severity::Warning, kElementSource, problem);
    }
    if (m_problems.size() > kMostProblems) {
        m_log.add(Severity::Warning, kElementSource,
                  Text::tr("%1 further problems in the element files").arg(m_problems.size() - kMostProblems));
    }
    if (kept > 0) {
        m_log.add(
            Severity::Warning, kElementSource,
            Text::tr("satellites that are missing there, and keep the elements that were read before: %1").arg(kept));
    }
}

// A file that was replaced is watched anew: the watcher loses it.
void StationElements::watch()
{
    if (const QStringList watched = m_watcher.files() + m_watcher.directories(); !watched.isEmpty()) {
        m_watcher.removePaths(watched);
    }
    for (const QString& path : paths()) {
        const QString satdata = path + QStringLiteral("/satdata");
        if (!m_watcher.addPath(QFileInfo(satdata).isDir() ? satdata : path)) {
            m_again.start();
        }
    }
}

}  // namespace boresight

#include "moc_station_elements.cpp"
