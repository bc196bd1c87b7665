// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/north/term_model.h"

#include "ui/kit/format.h"
#include "ui/kit/theme.h"
#include "ui/north/calibration_words.h"

namespace boresight::ui {

namespace {

constexpr int kTermModelDecimals = 3;  // of a degree: the accuracy of six points of the Sun

struct PresentTerm
{
    const char* key;
    Angle pointing::PointingTerms::*term;
};

constexpr PresentTerm kPresentTerms[] = {
    {"pointing.azimuth_offset_deg", &pointing::PointingTerms::azimuthOffset},
    {"pointing.elevation_offset_deg", &pointing::PointingTerms::elevationOffset},
    {"pointing.tilt_north_deg", &pointing::PointingTerms::tiltNorth},
    {"pointing.tilt_east_deg", &pointing::PointingTerms::tiltEast},
    {"pointing.collimation_deg", &pointing::PointingTerms::collimation},
    {"pointing.non_perpendicularity_deg", &pointing::PointingTerms::nonPerpendicularity},
    {"pointing.elevation_sag_deg", &pointing::PointingTerms::elevationSag}};

}  // namespace

TermModel::TermModel(QObject* parent)
    : TableModel({tr("Term"), tr("In force"), tr("Proposed"), tr("Sigma"), tr("Fit")}, parent)
{}

std::vector<TermModel::Row> TermModel::rowsOf(const CalibrationStatus& calibration)
{
    std::vector<Row> rows;
    if (!calibration.proposal) {
        for (const PresentTerm& one : kPresentTerms) {
            rows.push_back({.name = termName(one.key), .present = calibration.present.*one.term});
        }
        return rows;
    }
    for (const TermStatus& term : calibration.proposal->terms) {
        rows.push_back({.name = termName(term.key),
                        .present = term.present,
                        .proposed = term.proposed,
                        .sigma = term.sigma,
                        .fit = fitWord(term, calibration),
                        .stays = !term.isOn && term.proposed == term.present});
    }
    return rows;
}

// A term that the points have not determined has changed within what was known before, or to the value of a swing. For
// every other term the proposal names the source: "typed", "compass swing".
QString TermModel::fitWord(const TermStatus& term, const CalibrationStatus& calibration)
{
    if (term.isOn) {
        return proposesFit(calibration) ? tr("● found") : QStringLiteral("● ") + calibration.proposal->reason;
    }
    if (term.proposed == term.present) {
        return tr("unchanged");
    }
    return term.sigma ? tr("◐ held") : tr("◐ as measured");
}

void TermModel::show(const CalibrationStatus& calibration)
{
    std::vector<Row> rows = rowsOf(calibration);
    if (rows == m_rows) {
        return;
    }
    if (rows.size() == m_rows.size()) {
        m_rows = std::move(rows);
        changeCells();
        return;
    }
    beginResetModel();
    m_rows = std::move(rows);
    endResetModel();
}

QString TermModel::cell(const Row& row, int column)
{
    switch (column) {
        case Name:
            return row.name;
        case Present:
            return angleText(row.present, kTermModelDecimals);
        case Proposed:
            return row.proposed ? angleText(*row.proposed, kTermModelDecimals) : QString();
        case Sigma:
            return row.sigma ? QStringLiteral("± ") + angleText(*row.sigma, kTermModelDecimals) : QString();
        default:
            return row.fit;
    }
}

QVariant TermModel::data(const QModelIndex& index, int role) const
{
    const Row& row = m_rows.at(static_cast<std::size_t>(index.row()));
    switch (role) {
        case Qt::DisplayRole:
            return cell(row, index.column());
        case Qt::TextAlignmentRole:
            return index.column() == Name || index.column() == Fit ? QVariant()
                                                                   : QVariant(Qt::AlignRight | Qt::AlignVCenter);
        case Qt::ForegroundRole:
            return row.stays ? QVariant(currentTheme().secondary) : QVariant();
        default:
            return {};
    }
}

}  // namespace boresight::ui

#include "moc_term_model.cpp"
