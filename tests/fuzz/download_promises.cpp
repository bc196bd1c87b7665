// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fuzz/download_promises.h"

#include "core/base/control_characters.h"
#include "core/elements/element_reader.h"
#include "tests/fuzz/harness.h"

#include <QFile>

namespace boresight::fuzz {
namespace {

bool hasSets(const QByteArray& bytes)
{
    return !orbit::readElements({bytes.data(), static_cast<std::size_t>(bytes.size())}).sets.empty();
}

}  // namespace

void DownloadPromises::check(bool isStored, const QStringList& problems, const std::optional<UtcTime>& asked)
{
    checkProblems(isStored, problems);
    const QByteArray after = cached();
    require(isStored || after == m_before, "what is not told as stored is not stored");
    require(after == m_before || hasSets(after), "what is stored has element sets");
    const orbit::CacheState state = m_cache.state(m_address);
    require(state.lastTry == (asked ? asked : m_lastTry), "it is kept when the server was asked");
    require(!state.etag.contains('\n') && !state.lastModified.contains('\n'), "a header is one line");
    m_before = after;
    m_lastTry = state.lastTry;
    if (isStored) {
        accept();
    }
}

QByteArray DownloadPromises::cached() const
{
    QFile file(m_cache.fileOf(m_address));
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

void DownloadPromises::checkProblems(bool isStored, const QStringList& problems) const
{
    require(!isStored || problems.isEmpty(), "what is stored is no problem");
    require(problems.size() <= 1, "an address has one problem");
    for (const QString& problem : problems) {
        require(problem.startsWith(m_address.name), "a problem names the address");
        require(problem.size() < 800, "a problem is short");
        require(!hasControlCharacters(problem.toStdString()), "a problem is one printable line");
    }
}

}  // namespace boresight::fuzz
