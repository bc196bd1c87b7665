// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/targets/target_place.h"
#include "ui/kit/table_model.h"

#include <optional>
#include <vector>

// Sun, Moon, planets and radio sources: the present direction of each, and when it rises or sets. Gui thread.
namespace boresight::ui {

class TargetTable : public TableModel
{
    Q_OBJECT

public:
    enum Column
    {
        Name,
        Azimuth,
        Elevation,
        Refraction,
        Next
    };

    explicit TargetTable(QObject* parent = nullptr);

    // Empty: the site is unknown, so only the names are shown.
    void setSite(const std::optional<Site>& site);
    void setRefraction(ephemeris::RefractionRule rule);
    void tick(UtcTime now);

    [[nodiscard]] const targets::Target& target(int row) const { return m_targets.at(std::size_t(row)); }
    // Why the station would not track this target now, judged only by its rise and set. Empty: it would.
    [[nodiscard]] QString whyNotTracked(int row) const;

    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

protected:
    [[nodiscard]] std::size_t rows() const override { return m_targets.size(); }

private:
    [[nodiscard]] QString text(int row, int column) const;
    [[nodiscard]] QString nextText(const targets::TargetPlace& place) const;
    [[nodiscard]] QString help(const targets::TargetPlace& place) const;

    std::vector<targets::Target> m_targets;
    std::optional<Site> m_site;
    ephemeris::RefractionRule m_refraction = ephemeris::RefractionRule::ByKind;
    std::vector<targets::TargetPlace> m_places;  // one for each target, or empty
    UtcTime m_now{};
};

}  // namespace boresight::ui
