// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/term_model.h"

#include "ui/calibration_words.h"
#include "ui/format.h"
#include "ui/theme.h"

namespace boresight::ui {

namespace {

constexpr int kDecimals = 3;  // of a degree: six points of the Sun tell that much

struct InForce
{
    const char* key;
    Angle pointing::PointingTerms::*term;
};

constexpr InForce kInForce[] = {{"pointing.azimuth_offset_deg", &pointing::PointingTerms::azimuthOffset},
                                {"pointing.elevation_offset_deg", &pointing::PointingTerms::elevationOffset},
                                {"pointing.tilt_north_deg", &pointing::PointingTerms::tiltNorth},
                                {"pointing.tilt_east_deg", &pointing::PointingTerms::tiltEast},
                                {"pointing.collimation_deg", &pointing::PointingTerms::collimation},
                                {"pointing.non_perpendicularity_deg", &pointing::PointingTerms::nonPerpendicularity},
                                {"pointing.elevation_sag_deg", &pointing::PointingTerms::elevationSag}};

}  // namespace

std::vector<TermModel::Row> TermModel::rowsOf(const CalibrationStatus& calibration)
{
    std::vector<Row> rows;
    const bool fitted = calibration.fit && !calibration.fit->terms.empty();
    if (!calibration.proposal && !fitted) {
        for (const InForce& one : kInForce) {
            rows.push_back({.name = termName(one.key), .present = calibration.present.*one.term});
        }
        return rows;
    }
    for (const TermStatus& term : calibration.proposal ? calibration.proposal->terms : calibration.fit->terms) {
        rows.push_back({.name = termName(term.key),
                        .present = term.present,
                        .proposed = term.proposed,
                        .sigma = term.sigma,
                        .isOn = term.isOn});
    }
    return rows;
}

void TermModel::show(const CalibrationStatus& calibration)
{
    std::vector<Row> rows = rowsOf(calibration);
    if (rows == m_rows) {
        return;
    }
    if (rows.size() == m_rows.size()) {
        m_rows = std::move(rows);
        Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, ColumnCount - 1));
        return;
    }
    beginResetModel();
    m_rows = std::move(rows);
    endResetModel();
}

int TermModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_rows.size());
}

int TermModel::columnCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : ColumnCount;
}

QString TermModel::cell(const Row& row, int column)
{
    switch (column) {
        case Name:
            return row.name;
        case Present:
            return angleText(row.present, kDecimals);
        case Proposed:
            return row.proposed ? angleText(*row.proposed, kDecimals) : QString();
        case Sigma:
            return row.sigma ? QStringLiteral("± ") + angleText(*row.sigma, kDecimals) : QString();
        default:
            return !row.proposed ? QString()
                   : !row.isOn   ? tr("as it was")
                   : row.sigma   ? tr("● found")
                                 : tr("● given");  // what is found has a sigma
    }
}

QVariant TermModel::data(const QModelIndex& index, int role) const
{
    const Row& row = m_rows.at(static_cast<std::size_t>(index.row()));
    switch (role) {
        case Qt::DisplayRole:
            return cell(row, index.column());
        case Qt::TextAlignmentRole:
            return index.column() == Name || index.column() == On ? QVariant()
                                                                  : QVariant(Qt::AlignRight | Qt::AlignVCenter);
        case Qt::ForegroundRole:
            return row.proposed && !row.isOn ? QVariant(currentTheme().secondary) : QVariant();
        default:
            return {};
    }
}

QVariant TermModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole) {
        return {};
    }
    switch (section) {
        case Name:
            return tr("Term");
        case Present:
            return tr("In force");
        case Proposed:
            return tr("Proposed");
        case Sigma:
            return tr("Sigma");
        default:
            return tr("Fit");
    }
}

}  // namespace boresight::ui
