// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/base/result.h"
#include "core/messages/request.h"
#include "core/targets/target.h"

#include <QObject>
#include <QString>
#include <QThreadPool>

#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>

// Reads the file of a table beside the station thread: a large one takes seconds, and a folder of another computer may
// keep a reader waiting. Station thread only.
namespace boresight {

class StationTables : public QObject
{
    Q_OBJECT

public:
    using Then = std::function<void(const Result<targets::Target>& table)>;

    // Nobody expects a motion later than this. A hung folder of another computer may take longer.
    static constexpr std::chrono::seconds kLongestReading{30};

    explicit StationTables(QObject* parent);

    // `then` gets what the file has, or the reason why not, once and from the event loop. `path` is absolute: the
    // station has its own folder.
    void read(const QString& path, Then then);
    // The mount was asked for something else meanwhile, which must not end when a file is read: who waits is refused.
    void noticed(const Request& request);
    // Each tick: whatever else moved the mount or stopped it meanwhile has another motion id.
    void tick(std::uint64_t motionId, SteadyTime now);
    // Who waits is refused.
    void forget();

private:
    struct Asked
    {
        std::uint64_t motionId = 0;
        SteadyTime when;
    };

    void take(std::uint64_t number, const Result<targets::Target>& table);
    void answer(const Result<targets::Target>& table);

    Then m_then;  // empty: nobody waits
    std::optional<Asked> m_asked;
    std::uint64_t m_last = 0;
    QThreadPool m_reader;  // last: it ends before what it tells
};

}  // namespace boresight
