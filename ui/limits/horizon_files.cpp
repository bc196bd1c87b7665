// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/limits/horizon_files.h"

#include "core/profile/horizon_text.h"
#include "ui/kit/text_file.h"

#include <QCoreApplication>
#include <QFile>
#include <QFileInfo>

namespace boresight::ui {

namespace {

constexpr qint64 kLargest = 1'000'000;  // bytes: far more than a point for each tenth of a degree

class HorizonFiles
{
    Q_DECLARE_TR_FUNCTIONS(HorizonFiles)
};

}  // namespace

Result<QString> importHorizon(ProfileDraft& draft, const QString& path)
{
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly)) {
        return failure(ErrorCode::Io, file.errorString());
    }
    const QByteArray text = file.read(kLargest + 1);
    if (text.size() > kLargest) {
        return failure(ErrorCode::InvalidInput, HorizonFiles::tr("The file is too long for a horizon."));
    }
    const Result<profile::HorizonText> read = profile::parseHorizon(
        std::string_view(text.constData(), static_cast<std::size_t>(text.size())), QFileInfo(path).fileName());
    if (!read) {
        return tl::unexpected(read.error());
    }
    draft.edit([&read](profile::Profile& profile) { profile.limits.horizon = read->points; });
    return read->merged == 0 ? HorizonFiles::tr("%1 points read").arg(read->points.size())
                             : HorizonFiles::tr("%1 points read. %2 lower points at the same azimuth were left out")
                                   .arg(read->points.size())
                                   .arg(read->merged);
}

Result<> exportHorizon(const ProfileDraft& draft, const QString& path)
{
    const profile::Profile& profile = draft.edited();
    return saveText(path, QString::fromStdString(profile::toHorizonText(profile.limits.horizon, profile.mount.name)));
}

}  // namespace boresight::ui
