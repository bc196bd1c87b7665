// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plan/variant_table.h"

#include "core/plan/plan_words.h"
#include "ui/kit/format.h"
#include "ui/plan/variant_words.h"

namespace boresight::ui {

namespace {

// The time in which the beam leaves the target, because the azimuth is too slow or turns back.
Seconds timeApart(const plan::PlanVariant& variant)
{
    Seconds time{};
    for (const auto& span : {variant.ramp, variant.unwrap}) {
        time += span ? Seconds(span->to - span->from) : Seconds(0.0);
    }
    return time;
}

}  // namespace

VariantTable::VariantTable(QObject* parent)
    : TableModel(
          {tr("Plan"), tr("Error"), tr("Loss"), tr("Beyond"), tr("Start"), tr("Cable"), tr("Hidden"), tr("Apart")},
          parent)
{}

void VariantTable::show(const SharedAnswer& answer)
{
    beginResetModel();
    m_answer = answer;
    m_driven.reset();
    endResetModel();
}

void VariantTable::setDriven(const std::optional<int>& row)
{
    if (row != m_driven) {
        m_driven = row;
        changeCells();
    }
}

QString VariantTable::wayText(int row) const
{
    const QString way = plan::titleOf(variant(row).way);
    if (row == m_driven) {
        return tr("%1 (in use)").arg(way);
    }
    return row == 0 ? tr("%1 (best)").arg(way) : way;
}

QString VariantTable::text(int row, int column) const
{
    const plan::PlanVariant& one = variant(row);
    switch (column) {
        case Way:
            return wayText(row);
        case Error:
            return angleText(one.forecast.peak);
        case Loss:
            return lossText(one.forecast);
        case Beyond:
            return spentText(one.forecast.beyond);
        case Start:
            return angleText(one.start().azimuth, 0);
        case Hidden:
            return spentText(one.forecast.hidden);
        case Margin:
            return angleText(one.margin, 0);
        default:
            return spentText(timeApart(one));
    }
}

QString VariantTable::help(int column) const
{
    switch (column) {
        case Way:
            return tr("How the mount tracks the whole pass");
        case Error:
            return tr("The largest pointing error to expect");
        case Loss:
            return tr("The loss of the signal at the largest error, for the width of the beam");
        case Beyond:
            return m_answer ? tr("The time with an error of more than %1, half of the beam width")
                                  .arg(angleText(m_answer->plan.bound, 1))
                            : tr("The time with an error of more than half of the beam width");
        case Start:
            return tr("The azimuth of the axis at the start. It counts turns of the cable");
        case Hidden:
            return tr("The time in which limits, horizon or keep-outs hide the satellite. It is not in the error");
        case Margin:
            return tr("The room of the cable that is left at its nearer end");
        default:
            return tr("The time of a ramp or an unwrap, in which the azimuth leaves the satellite");
    }
}

QVariant VariantTable::data(const QModelIndex& index, int role) const
{
    switch (role) {
        case Qt::DisplayRole:
            return text(index.row(), index.column());
        case Qt::TextAlignmentRole:
            return index.column() == Way ? QVariant() : QVariant(Qt::AlignRight | Qt::AlignVCenter);
        case Qt::ToolTipRole:
            return describedVariant(variant(index.row()), m_answer->azimuths);
        default:
            return {};
    }
}

QVariant VariantTable::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation == Qt::Horizontal && role == Qt::ToolTipRole) {
        return help(section);
    }
    if (orientation == Qt::Horizontal && role == Qt::TextAlignmentRole && section != Way) {
        return QVariant(Qt::AlignRight | Qt::AlignVCenter);
    }
    return TableModel::headerData(section, orientation, role);
}

}  // namespace boresight::ui

#include "moc_variant_table.cpp"
