// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/rotctld_mount/hamlib_models.h"

#include "core/base/text.h"

#include <QProcess>
#include <QStandardPaths>

namespace boresight::rotctl {

QString hamlibIsMissing()
{
    return Text::tr(
        "rotctld is not installed. Install the programs of Hamlib: libhamlib-utils on Debian and Ubuntu, "
        "hamlib on Fedora and Arch Linux");
}

std::vector<RotatorModel> parseModels(const QString& listing)
{
    std::vector<RotatorModel> models;
    qsizetype maker = -1;
    qsizetype model = -1;
    qsizetype end = -1;
    for (const QString& line : listing.split(QLatin1Char('\n'))) {
        if (line.trimmed().startsWith(QLatin1String("Rot #"))) {
            maker = line.indexOf(QLatin1String("Mfg"));
            model = line.indexOf(QLatin1String("Model"));
            end = line.indexOf(QLatin1String("Version"));
        } else if (0 < maker && maker < model && model < end) {
            const int number = line.left(maker).trimmed().toInt();
            const QString name =
                line.mid(maker, model - maker).trimmed() + QLatin1Char(' ') + line.mid(model, end - model).trimmed();
            if (number > 0 && !name.trimmed().isEmpty()) {
                models.push_back({.number = number, .name = name.trimmed()});
            }
        }
    }
    return models;
}

RotatorModels hamlibModels(std::chrono::seconds patience)
{
    const QString path = QStandardPaths::findExecutable(QStringLiteral("rotctl"));
    if (path.isEmpty() || QStandardPaths::findExecutable(QStringLiteral("rotctld")).isEmpty()) {
        return {.problem = hamlibIsMissing()};
    }
    QProcess process;
    process.start(path, {QStringLiteral("-l")}, QIODevice::ReadOnly);
    if (!process.waitForFinished(static_cast<int>(std::chrono::milliseconds(patience).count()))) {
        return {.problem = Text::tr("Hamlib's rotctl did not answer within %1 s. Press Refresh to try again")
                               .arg(patience.count())};
    }
    RotatorModels models{.list = parseModels(QString::fromUtf8(process.readAllStandardOutput()))};
    if (models.list.empty()) {
        return {.problem = Text::tr("Hamlib lists no rotator. Type rotctl -l in a terminal to see why")};
    }
    return models;
}

}  // namespace boresight::rotctl
