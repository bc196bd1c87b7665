// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/element_files/gpredict_module.h"

#include "core/base/numbers.h"
#include "core/base/text.h"
#include "core/elements/element_check.h"
#include "core/gpredict/key_file.h"
#include "core/profile/small_file.h"

#include <QDir>
#include <QFileInfo>

namespace boresight::orbit {

namespace {

constexpr int kMostProblems = 100;

// satdata is beside the folder of the modules, or beside the module itself as in the package of Gpredict.
QDir satdataOf(const QString& module)
{
    const QDir own = QFileInfo(module).absoluteDir();
    const QString name = QStringLiteral("satdata");
    return own.exists(name) ? QDir(own.filePath(name))
                            : QDir(QDir::cleanPath(own.filePath(QStringLiteral("../") + name)));
}

}  // namespace

GpredictModule readGpredictModule(const QString& path)
{
    GpredictModule module;
    const Result<QByteArray> text = profile::readFile(path);
    if (!text) {
        module.problems.append(text.error().text);
        return module;
    }
    const auto satellites =
        profile::keyFileValue(*text, QStringLiteral("GLOBAL"), QStringLiteral("SATELLITES")).value_or(QString());
    const QDir satdata = satdataOf(path);
    int further = 0;
    for (const QString& entry : satellites.split(QLatin1Char(';'), Qt::SkipEmptyParts)) {
        if (module.problems.size() >= kMostProblems) {
            ++further;
            continue;
        }
        const auto number = parseInteger(entry.trimmed().toStdString());
        const QString file = satdata.filePath(QStringLiteral("%1.sat").arg(number.value_or(0)));
        if (!number) {
            module.problems.append(
                Text::tr("%1: \"%2\" is not a catalogue number.").arg(path, orbit::quoted(entry.toStdString())));
        } else if (QFileInfo(file).isFile()) {
            module.files.append(file);
        } else {
            module.problems.append(Text::tr("%1: There are no elements of satellite %2 in %3. Update them in Gpredict.")
                                       .arg(path, QString::number(*number), satdata.path()));
        }
    }
    if (further > 0) {
        module.problems.append(Text::tr("%1: %2 further problems are not listed.").arg(path).arg(further));
    }
    if (module.files.isEmpty() && module.problems.isEmpty()) {
        module.problems.append(Text::tr("%1: The module names no satellite.").arg(path));
    }
    return module;
}

}  // namespace boresight::orbit
