// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/north/point_model.h"

#include "ui/kit/format.h"
#include "ui/kit/theme.h"
#include "ui/north/calibration_words.h"

namespace boresight::ui {

namespace {

constexpr int kDecimals = 2;

QString size(const PointResidual& residual)
{
    return angleText(Angle::fromDegrees(onSky(residual)), kDecimals);
}

QString cell(const PointStatus& point, int column)
{
    switch (column) {
        case PointModel::Label:
            return point.isUsed ? point.label : QStringLiteral("○ ") + point.label;
        case PointModel::Time:
            return clockText(point.when).left(5);
        case PointModel::Sigma:
            return angleText(point.sigma, kDecimals);
        case PointModel::Before:
            return size(point.before);
        case PointModel::After:
            return point.after ? size(*point.after) : QString();
        default:
            return point.leftOut ? angleText(*point.leftOut, kDecimals) : QString();
    }
}

QString help(const PointStatus& point)
{
    const QString label = point.isUsed ? point.label : PointModel::tr("%1, not used").arg(point.label);
    QString text = PointModel::tr("%1, %2: true %3, axes %4, centred to ± %5")
                       .arg(label, minuteText(point.when), directionText(point.truth), axisText(point.axes),
                            angleText(point.sigma));
    const auto add = [&text](const QString& when, const PointResidual& residual) {
        text += QLatin1Char('\n') +
                PointModel::tr("%1: across %2, elevation %3")
                    .arg(when, signedAngleText(residual.across, 3), signedAngleText(residual.elevation, 3));
    };
    add(PointModel::tr("Now"), point.before);
    if (point.after) {
        add(PointModel::tr("With the fit"), *point.after);
    }
    return text;
}

}  // namespace

PointModel::PointModel(QObject* parent)
    : TableModel({tr("Point"), tr("UTC"), tr("Sigma"), tr("Now"), tr("Fit"), tr("Others")}, parent)
{}

void PointModel::show(const std::vector<PointStatus>& points)
{
    const bool sameRows = points.size() == m_points.size();
    if (!sameRows) {
        beginResetModel();
    }
    m_points = points;
    if (!sameRows) {
        endResetModel();
    } else {
        changeCells();
    }
}

QVariant PointModel::data(const QModelIndex& index, int role) const
{
    const PointStatus& one = point(index.row());
    switch (role) {
        case Qt::DisplayRole:
            return cell(one, index.column());
        case Qt::ToolTipRole:
            return help(one);
        case Qt::AccessibleTextRole:
            return index.column() == Label && !one.isUsed ? tr("%1, not used").arg(one.label) : QVariant();
        case Qt::TextAlignmentRole:
            return index.column() == Label ? QVariant() : QVariant(Qt::AlignRight | Qt::AlignVCenter);
        case Qt::ForegroundRole:
            return one.isUsed ? QVariant() : QVariant(currentTheme().secondary);
        default:
            return {};
    }
}

}  // namespace boresight::ui

#include "moc_point_model.cpp"
