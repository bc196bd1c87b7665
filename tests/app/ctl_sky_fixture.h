// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/app/ctl_outcome.h"

#include <QTemporaryDir>

#include <gtest/gtest.h>

#include <fstream>

namespace boresight {

inline const std::string kStation =
    "ISS (ZARYA)\n"
    "1 25544U 98067A   24130.36689744  .00016024  00000+0  27777-3 0  9992\n"
    "2 25544  51.6381 147.8590 0003466 150.4670 338.5502 15.51043222452521\n";
// boresightctl with the test's own files.
class CtlSkyFixture : public testing::Test
{
protected:
    QString write(const char* name, const std::string& text) const
    {
        const QString path = folder.filePath(QString::fromUtf8(name));
        std::ofstream(path.toStdString()) << text;
        return path;
    }

    Outcome passes(const QString& file, const char* more) const
    {
        const QStringList line{QStringLiteral("passes"), QStringLiteral("--elements"), file};
        return ctl(line + words("--site 38.757,-9.117,80") + words(more));
    }

    QTemporaryDir folder;
};

}  // namespace boresight
