// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/numbers.h"
#include "core/orbit/vector.h"

#include <QDateTime>

#include <gtest/gtest.h>

#include <chrono>
#include <string>
#include <utility>
#include <vector>

namespace boresight::tables {

struct OemSample
{
    std::string time;
    orbit::Vector position;
    orbit::Vector velocity;
};

// The form is "2026-12-24T00:00:00.125".
inline std::string isoText(std::chrono::milliseconds sinceUnixEpoch)
{
    return QDateTime::fromMSecsSinceEpoch(sinceUnixEpoch.count(), Qt::UTC)
        .toString(QStringLiteral("yyyy-MM-ddTHH:mm:ss.zzz"))
        .toStdString();
}

inline std::string headText()
{
    return "CCSDS_OEM_VERS = 2.0\nCREATION_DATE = 2026-12-23T12:00:00\nORIGINATOR = TEST\n\n";
}

inline std::string rowText(const OemSample& sample)
{
    std::string text = sample.time;
    for (const orbit::Vector& vector : {sample.position, sample.velocity}) {
        for (const double number : {vector.x, vector.y, vector.z}) {
            text += ' ' + formatFixed(number, 9);
        }
    }
    return text + '\n';
}

// A block and its rows. `more` are further lines of the block.
inline std::string segmentText(const std::string& frame, const std::string& system,
                               const std::vector<OemSample>& samples, const std::string& more = {})
{
    std::string text =
        "META_START\nOBJECT_NAME = TEST ONE\nOBJECT_ID = 1998-067A\nCENTER_NAME = EARTH\nREF_FRAME = " + frame +
        "\nTIME_SYSTEM = " + system + "\nSTART_TIME = " + samples.front().time +
        "\nSTOP_TIME = " + samples.back().time + "\n" + more + "META_STOP\n";
    for (const OemSample& sample : samples) {
        text += rowText(sample);
    }
    return text;
}

// The text with the first `from` replaced by `to`.
inline std::string changed(std::string text, const std::string& from, const std::string& to)
{
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return text.replace(at, from.size(), to);
}

}  // namespace boresight::tables
