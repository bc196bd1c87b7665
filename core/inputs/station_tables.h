// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/base/result.h"
#include "core/messages/request.h"
#include "core/messages/table_content.h"
#include "core/targets/target.h"

#include <QObject>
#include <QString>
#include <QThreadPool>

#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>

// Reads the file of a table on a thread of its own: a large file takes seconds, and a folder of another computer may
// block a reader. Station thread only.
namespace boresight {

class StationTables : public QObject
{
    Q_OBJECT

public:
    using Then = std::function<void(const Result<targets::Target>& table)>;

    explicit StationTables(QObject* parent);

    // `then` is called once, from the event loop, with the table or the reason why there is none. `path` is absolute,
    // because the station has another working folder.
    void read(const QString& path, Then then);
    // The mount got another request. A file read later must not end it, so the request that waits is refused.
    void noticed(const Request& request);
    // Call each tick. Another motion id shows that the mount was moved or stopped meanwhile.
    void tick(std::uint64_t motionId, SteadyTime now);
    // Refuses the request that waits.
    void forget();

private:
    struct Asked
    {
        std::uint64_t motionId = 0;
        SteadyTime when;
    };

    void take(std::uint64_t number, const Result<targets::Target>& table);
    void answer(const Result<targets::Target>& table);

    Then m_then;  // empty: no request waits
    std::optional<Asked> m_asked;
    std::uint64_t m_last = 0;
    QThreadPool m_reader;  // last member: its work ends before the other members are destroyed
};

}  // namespace boresight
