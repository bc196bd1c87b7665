// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/inputs/station_elements.h"

#include "core/base/text.h"
#include "core/element_files/element_files.h"
#include "core/elements/element_address.h"
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

}  // namespace

StationElements::StationElements(const profile::InForce& profile, EventLog& log, const Clock& clock, QObject* parent)
    : QObject(parent), m_profile(profile), m_log(log), m_clock(clock)
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
    download();
    read();
}

void StationElements::profileChanged(const profile::Profile& before, const profile::Profile& after)
{
    if (m_open && (before.orbit.elements != after.orbit.elements || before.gpredict != after.gpredict)) {
        download();
        read();
    }
}

// The files to read. A missing Gpredict is not a problem. A file that is not downloaded yet is reported by the
// download.
QStringList StationElements::paths() const
{
    QStringList all;
    for (const std::string& path : m_profile->orbit.elements) {
        if (!orbit::isElementAddress(path)) {
            all << toQString(path);
        }
    }
    for (const orbit::ElementAddress& address : orbit::elementAddresses(m_profile->orbit.elements)) {
        if (const QString file = m_cache.fileOf(address); QFileInfo::exists(file)) {
            all << file;
        }
    }
    const QString gpredict = profile::gpredictFolder(m_profile->gpredict);
    if (m_profile->orbit.elements.empty() && QFileInfo(gpredict + QStringLiteral("/satdata")).isDir()) {
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
    if (reading.problems != m_problems) {
        m_problems = reading.problems;
        tell(m_problems, {});
        tellKept(sets.size() - reading.sets.size());
    }
    if (sets == *m_satellites) {
        return;
    }
    m_satellites = std::make_shared<const std::vector<orbit::ElementSet>>(std::move(sets));
    m_log.add(Severity::Advisory, kElementSource,
              Text::tr("the elements of %1 satellites are read").arg(m_satellites->size()));
    Q_EMIT changed();
}

// The download thread starts with the first address.
void StationElements::download()
{
    const auto addresses = orbit::elementAddresses(m_profile->orbit.elements);
    if (addresses.empty() && !m_webThread) {
        return;
    }
    if (!m_webThread) {
        auto web = std::make_unique<orbit::ElementWeb>(m_clock, orbit::ElementCache::userFolder());
        m_web = web.get();
        connect(m_web, &orbit::ElementWeb::stored, this, [this] { m_settled.start(); });
        connect(m_web, &orbit::ElementWeb::problemsChanged, this, &StationElements::takeDownloadProblems);
        m_webThread = std::make_unique<EdgeThread>(QStringLiteral("elements"), std::move(web));
    }
    m_webThread->post([web = m_web, addresses] { web->setAddresses(addresses); });
}

void StationElements::takeDownloadProblems(const QStringList& problems)
{
    tell(problems, std::exchange(m_downloadProblems, problems));
}

// Logs the problems that were not reported before.
void StationElements::tell(const QStringList& problems, const QStringList& before)
{
    for (const QString& problem : problems.mid(0, kMostProblems)) {
        if (!before.contains(problem)) {
            m_log.add(Severity::Warning, kElementSource, problem);
        }
    }
    if (problems.size() > kMostProblems) {
        m_log.add(Severity::Warning, kElementSource,
                  Text::tr("%1 further problems with the elements of satellites").arg(problems.size() - kMostProblems));
    }
    m_shownProblems = m_downloadProblems.mid(0, kMostProblems) + m_problems.mid(0, kMostProblems);
}

void StationElements::tellKept(std::size_t count)
{
    if (count > 0) {
        m_log.add(
            Severity::Warning, kElementSource,
            Text::tr("%1 satellites are missing there. They keep the elements that were read before.").arg(count));
    }
}

// Called before each reading, because the watcher loses a file that is replaced.
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
