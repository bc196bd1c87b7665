// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/pointing_fit.h"
#include "core/messages/calibration_status.h"

#include <optional>
#include <vector>

// The points that were taken, with the angles of the axes and the true direction of the source, and the pointing model
// fitted to them. The angles of the axes are mechanical, so points stay true whatever model comes into force. Pure.
namespace boresight {

// A point to be taken now.
struct NewPoint
{
    AxisPosition axes;
    SkyPointing truth;
    Angle sigma;
    QString label;
};

class PointBook
{
public:
    void add(const calibration::CalibrationPoint& point) { m_points.push_back(point); }
    Result<> drop(std::size_t index);
    Result<> use(std::size_t index, bool used);
    void clear();

    // While it is uncertain whether the points are of this mount, they are in the list but do not count. Waiting ends
    // when the last point is dropped.
    void setWaiting(bool waiting) { m_waiting = waiting; }
    [[nodiscard]] bool isWaiting() const { return m_waiting; }

    // Fits against the model in force. `known`: what a swing found before the points.
    void fit(const pointing::PointingTerms& inForce, const calibration::TermKnowledge& known);

    [[nodiscard]] const std::vector<calibration::CalibrationPoint>& points() const { return m_points; }
    // Empty while no point is used, or while the points wait.
    [[nodiscard]] const std::optional<calibration::PointingFit>& fitted() const { return m_fit; }
    // Why there is no fit. Empty if there is a fit, or if no point is used.
    [[nodiscard]] const QString& problem() const { return m_problem; }

    [[nodiscard]] std::vector<PointStatus> status() const;
    // With the proposed terms instead of the terms in force. Empty if no point is used.
    [[nodiscard]] std::optional<ProposalResiduals> residuals(const pointing::PointingTerms& proposed) const;
    [[nodiscard]] std::optional<PointFitStatus> fitStatus(const pointing::PointingTerms& inForce) const;

private:
    [[nodiscard]] Result<> has(std::size_t index) const;

    std::vector<calibration::CalibrationPoint> m_points;
    bool m_waiting = false;
    pointing::PointingTerms m_before;
    std::optional<calibration::PointingFit> m_fit;
    QString m_problem;
};

}  // namespace boresight
