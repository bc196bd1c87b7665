// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/inputs/station_tables.h"

#include "core/base/text.h"
#include "core/night/night_desk.h"
#include "core/table_file/table_file.h"

#include <QFileInfo>

#include <utility>

namespace boresight {
namespace {

Result<targets::Target> readTarget(const QString& path)
{
    if (QFileInfo(path).isRelative()) {
        return failure(ErrorCode::InvalidInput,
                       Text::tr("\"%1\" is not the whole path of a file. It must begin with /.").arg(path));
    }
    return tables::readTableFile(path).map(&targets::tableTarget);
}

}  // namespace

StationTables::StationTables(QObject* parent) : QObject(parent)
{
    m_reader.setMaxThreadCount(1);
}

void StationTables::read(const QString& path, Then then)
{
    forget();
    m_reader.clear();
    m_then = std::move(then);
    m_asked.reset();
    ++m_last;
    m_reader.start([this, path, number = m_last] {
        QMetaObject::invokeMethod(
            this, [this, number, table = readTarget(path)] { take(number, table); }, Qt::QueuedConnection);
    });
}

void StationTables::noticed(const Request& request)
{
    if (!leavesTheMount(request)) {
        forget();
    }
}

void StationTables::tick(std::uint64_t motionId, SteadyTime now)
{
    if (!m_then) {
        return;
    }
    m_asked = m_asked.value_or(Asked{.motionId = motionId, .when = now});
    if (m_asked->motionId != motionId) {
        forget();
    } else if (now - m_asked->when >= kLongestTableReading) {
        answer(
            failure(ErrorCode::NoAnswer, Text::tr("The file was not read within %1 s. Nothing moves. Track it again.")
                                             .arg(kLongestTableReading.count())));
    }
}

void StationTables::forget()
{
    answer(failure(ErrorCode::Refused, Text::tr("Another command came before the file was read. Track it again.")));
}

void StationTables::take(std::uint64_t number, const Result<targets::Target>& table)
{
    if (number == m_last) {
        answer(table);
    }
}

// m_then is cleared first, because the callback may request the next table.
void StationTables::answer(const Result<targets::Target>& table)
{
    if (const Then then = std::exchange(m_then, {})) {
        then(table);
    }
}

}  // namespace boresight

#include "moc_station_tables.cpp"
