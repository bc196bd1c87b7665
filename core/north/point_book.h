// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/pointing_fit.h"
#include "core/messages/calibration_status.h"

#include <optional>
#include <vector>

// The points that were taken, where the axes stood and where the source was in truth, and the pointing model that they
// speak for. The axes' angles are mechanical, so points stay true whatever model comes into force. Pure.
namespace boresight {

// A point that is taken now.
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

    // It is not certain yet that they are of this mount: they are in the list, and say nothing. Ends with the last of
    // them.
    void setWaiting(bool waiting) { m_waiting = waiting; }
    [[nodiscard]] bool isWaiting() const { return m_waiting; }

    // Anew, against the model in force. What a swing has found out is known before the points.
    void fit(const pointing::PointingTerms& inForce, const calibration::TermKnowledge& known);

    [[nodiscard]] const std::vector<calibration::CalibrationPoint>& points() const { return m_points; }
    // Empty while there is no point that is used, or they wait.
    [[nodiscard]] const std::optional<calibration::PointingFit>& fitted() const { return m_fit; }
    // Why there is no fit; empty if there is one, or no point that is used.
    [[nodiscard]] const QString& problem() const { return m_problem; }

    [[nodiscard]] std::vector<PointStatus> status() const;
    // With those terms in place of the ones in force; empty without points that are used.
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
