// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/north/calibration_file.h"
#include "core/north/calibration_proposal.h"
#include "core/north/mount_identity.h"

// The pointing model in force by the history: which entry brought it, how exactly its terms are known, and for which
// mount it was found. Reads only. Station thread.
namespace boresight {

class ModelInForce
{
public:
    // All arguments must outlive this object.
    ModelInForce(const CalibrationFile& file, const profile::InForce& profile, const MountIdentity& mount,
                 const Clock& clock)
        : m_file(file), m_profile(profile), m_mount(mount), m_clock(clock)
    {}

    [[nodiscard]] const pointing::PointingTerms& terms() const { return m_profile->pointing; }
    // The terms, with the sigmas that the history has for their values.
    [[nodiscard]] calibration::TermSheet sheet() const;
    // The knowledge from a swing, independent of any point.
    [[nodiscard]] calibration::TermKnowledge known() const { return knownBy(m_file.history().inForce()); }
    // How exactly Sun, Moon or landmarks gave the terms in force.
    [[nodiscard]] TermSigmas toldByPoints() const;
    // The changes made in another way since the last applied entry. Empty: none.
    [[nodiscard]] QString changedSince() const;
    // Says that the entry in force was applied with another drive or at another site. Empty: it was not.
    [[nodiscard]] QString otherMount() const;

private:
    [[nodiscard]] calibration::TermKnowledge knownBy(std::size_t entries) const;
    [[nodiscard]] const calibration::CalibrationRecord* entry() const;

    const CalibrationFile& m_file;
    const profile::InForce& m_profile;
    const MountIdentity& m_mount;
    const Clock& m_clock;
};

}  // namespace boresight
