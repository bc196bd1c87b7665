// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/north/point_book.h"

#include "core/base/text.h"
#include "core/north/calibration_proposal.h"

#include <algorithm>
#include <cmath>

namespace boresight {
namespace {

PointResidual residualOf(const calibration::SkyOffset& offset)
{
    return {.across = offset.across, .elevation = offset.elevation};
}

double squared(Angle angle)
{
    return angle.radians() * angle.radians();
}

}  // namespace

Result<> PointBook::has(std::size_t index) const
{
    if (index >= m_points.size()) {
        return failure(ErrorCode::OutOfRange, Text::tr("There is no point %1.").arg(index + 1));
    }
    return {};
}

Result<> PointBook::drop(std::size_t index)
{
    return has(index).map([&] {
        m_points.erase(m_points.begin() + static_cast<std::ptrdiff_t>(index));
        m_waiting = m_waiting && !m_points.empty();
    });
}

void PointBook::clear()
{
    m_points.clear();
    m_waiting = false;
}

Result<> PointBook::use(std::size_t index, bool used)
{
    return has(index).map([&] { m_points[index].isUsed = used; });
}

void PointBook::fit(const pointing::PointingTerms& inForce, const calibration::TermKnowledge& known)
{
    m_before = inForce;
    m_fit.reset();
    m_problem.clear();
    if (std::ranges::none_of(m_points, &calibration::CalibrationPoint::isUsed)) {
        return;
    }
    if (m_waiting) {
        m_problem = Text::tr("These points wait until every drive has reported its identity.");
    } else if (auto fit = calibration::fitPointing(m_points, inForce, known)) {
        m_fit = std::move(*fit);
    } else {
        m_problem = fit.error().text;
    }
}

std::vector<PointStatus> PointBook::status() const
{
    std::vector<PointStatus> list;
    for (std::size_t i = 0; i < m_points.size(); ++i) {
        const calibration::CalibrationPoint& point = m_points[i];
        PointStatus status{.label = point.label,
                           .when = point.when,
                           .axes = point.axes,
                           .truth = point.truth,
                           .sigma = point.sigma,
                           .isUsed = point.isUsed,
                           .before = residualOf(calibration::offsetOf(point, pointing::PointingModel(m_before)))};
        if (m_fit) {
            const calibration::FittedPoint& fitted = m_fit->points[i];
            status.after = residualOf(fitted.after);
            status.leftOut = fitted.leftOut ? std::optional(fitted.leftOut->size()) : std::nullopt;
        }
        list.push_back(status);
    }
    return list;
}

std::optional<ProposalResiduals> PointBook::residuals(const pointing::PointingTerms& proposed) const
{
    const pointing::PointingModel present(m_before);
    const pointing::PointingModel then(proposed);
    double before = 0.0;
    double after = 0.0;
    std::size_t used = 0;
    for (const calibration::CalibrationPoint& point : m_points) {
        if (point.isUsed) {
            before += squared(calibration::offsetOf(point, present).size());
            after += squared(calibration::offsetOf(point, then).size());
            ++used;
        }
    }
    if (used == 0) {
        return std::nullopt;
    }
    const auto rms = [used](double sum) { return Angle::fromRadians(std::sqrt(sum / static_cast<double>(used))); };
    return ProposalResiduals{.before = rms(before), .after = rms(after), .points = used};
}

std::optional<PointFitStatus> PointBook::fitStatus(const pointing::PointingTerms& inForce) const
{
    if (!m_fit) {
        return std::nullopt;
    }
    PointFitStatus status{
        .terms = termsBeside(inForce, m_fit->terms), .before = m_fit->rmsBefore, .after = m_fit->rmsAfter};
    for (const calibration::Term term : calibration::kAllTerms) {
        const calibration::FittedTerm& fitted = m_fit->of(term);
        status.terms[calibration::indexOf(term)].sigma = fitted.estimate.sigma;
        status.terms[calibration::indexOf(term)].isOn = fitted.state == calibration::TermState::Fitted;
    }
    if (m_fit->degreesOfFreedom > 0.0) {
        status.reducedChiSquare = m_fit->chiSquare / m_fit->degreesOfFreedom;
    }
    status.remarks.insert(status.remarks.end(), m_fit->hints.begin(), m_fit->hints.end());
    return status;
}

}  // namespace boresight
