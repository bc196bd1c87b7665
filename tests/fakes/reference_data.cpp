// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fakes/reference_data.h"

#include <QFile>

#include <fstream>
#include <sstream>

namespace boresight::fakes {

std::string referencePath(const std::string& name)
{
    const QString folder =
        qEnvironmentVariable("BORESIGHT_REFERENCE_DATA", QStringLiteral(BORESIGHT_REFERENCE_DATA_BESIDE));
    const std::string there = folder.toStdString() + "/" + name;
    return QFile::exists(QString::fromStdString(there)) ? there : BORESIGHT_TEST_DATA "/" + name;
}

bool hasReference(const std::string& name)
{
    return QFile::exists(QString::fromStdString(referencePath(name)));
}

std::string referenceText(const std::string& name)
{
    std::ifstream file(referencePath(name));
    return {std::istreambuf_iterator<char>(file), {}};
}

std::vector<std::vector<std::string>> referenceRows(const std::string& name)
{
    std::vector<std::vector<std::string>> rows;
    std::ifstream file(referencePath(name));
    for (std::string line; std::getline(file, line);) {
        if (line.starts_with('#')) {
            continue;
        }
        std::istringstream stream(line);
        auto& row = rows.emplace_back();
        for (std::string value; std::getline(stream, value, ',');) {
            row.push_back(value);
        }
    }
    return rows;
}

}  // namespace boresight::fakes
