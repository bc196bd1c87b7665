// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/fakes/program.h"

#include <string>

// The result of boresightctl started as from a shell: its standard output, its errors and its exit status.
namespace boresight {

struct Outcome
{
    int status = -1;
    std::string output;
    std::string errors;
};

[[nodiscard]] inline Outcome ctl(const QStringList& arguments, const QByteArray& input = {})
{
    fakes::Program program(QStringLiteral(BORESIGHTCTL), arguments);
    if (!input.isEmpty()) {
        program.type(input);
    }
    const int status = program.waitForEnd();
    return {status, program.output().toStdString(), program.errors().toStdString()};
}

[[nodiscard]] inline QStringList words(const char* text)
{
    return QString::fromUtf8(text).split(QLatin1Char(' '));
}

}  // namespace boresight
