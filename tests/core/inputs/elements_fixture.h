// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/inputs/station_elements.h"
#include "tests/fakes/manual_clock.h"
#include "tests/fakes/wait_until.h"

#include <QFile>
#include <QTemporaryDir>

#include <gtest/gtest.h>

namespace boresight {

// Invented elements.
inline const QByteArray kFirst =
    "FIRST\n"
    "1 90001U 26001A   26001.50000000  .00001000  00000-0  20000-4 0   104\n"
    "2 90001  51.6000 100.0000 0010000  90.0000 270.0000 15.50000000000016\n";
// The test has its own cache folder.
class StationElementsTest : public ::testing::Test
{
protected:
    StationElementsTest() { qputenv("XDG_CACHE_HOME", QFile::encodeName(m_folder.path())); }
    ~StationElementsTest() override { qputenv("XDG_CACHE_HOME", m_before); }
    StationElementsTest(const StationElementsTest&) = delete;
    StationElementsTest& operator=(const StationElementsTest&) = delete;

    void write(const QByteArray& text) const
    {
        QFile out(file());
        ASSERT_TRUE(out.open(QIODevice::WriteOnly));
        out.write(text);
    }
    [[nodiscard]] QString file() const { return m_folder.filePath(QStringLiteral("some.tle")); }
    [[nodiscard]] static profile::Profile naming(const QString& path) { return naming({path.toStdString()}); }
    [[nodiscard]] static profile::Profile naming(const std::vector<std::string>& entries)
    {
        profile::Profile profile;
        profile.orbit.elements = entries;
        return profile;
    }
    [[nodiscard]] std::vector<std::string> lines(Severity severity) const
    {
        std::vector<std::string> texts;
        for (const LogEntry& line : log.since(0, EventLog::kCapacity)) {
            if (line.severity == severity) {
                texts.push_back(line.text.toStdString());
            }
        }
        return texts;
    }
    [[nodiscard]] bool waitFor(const StationElements& elements, std::size_t count) const
    {
        return fakes::waitUntil([&] { return elements.satellites()->size() == count; });
    }

    fakes::ManualClock clock;
    EventLog log{clock};

private:
    QTemporaryDir m_folder;
    QByteArray m_before = qgetenv("XDG_CACHE_HOME");
};

}  // namespace boresight
