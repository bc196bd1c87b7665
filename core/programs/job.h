// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>

#include <chrono>
#include <utility>
#include <vector>

// A program to be run, and how it ended. Plain values.
namespace boresight::programs {

using Environment = std::vector<std::pair<QString, QString>>;

struct Job
{
    QString path;  // of the program, from / on
    QStringList arguments;
    Environment environment;  // besides that of Boresight
};

struct Limits
{
    std::chrono::milliseconds longest{30'000};  // then it is asked to end
    std::chrono::milliseconds patience{2'000};  // then it is killed
    int most = 8;                               // at the same time
};

struct Ending
{
    bool good = false;  // status 0
    QString text;       // one line, with the path and what the program said of its trouble
};

}  // namespace boresight::programs
