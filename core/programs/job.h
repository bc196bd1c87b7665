// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>

#include <chrono>
#include <utility>
#include <vector>

// A program to run, and how it ended. Plain values.
namespace boresight::programs {

using Environment = std::vector<std::pair<QString, QString>>;

struct Job
{
    QString path;  // absolute path of the program
    QStringList arguments;
    Environment environment;  // added to the environment of Boresight
};

struct Limits
{
    std::chrono::milliseconds longest{30'000};  // after this time the program is asked to end
    std::chrono::milliseconds patience{2'000};  // after this further time it is killed
    int most = 8;                               // programs at the same time
};

struct Ending
{
    bool good = false;  // exit status 0
    QString text;       // one line with the path and the first error line of the program
};

}  // namespace boresight::programs
