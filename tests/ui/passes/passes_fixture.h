// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/fakes/low_orbit.h"
#include "tests/fakes/wait_until.h"
#include "tests/ui/window_fixture.h"
#include "ui/passes/pass_table.h"

#include <QTableView>

#include <algorithm>
#include <string>
#include <vector>

// The window with the page of the coming passes in front, and three satellites.
namespace boresight::ui {

inline orbit::ElementSet satellite(const char* name, std::int64_t number, Angle node, UtcTime epoch)
{
    orbit::ElementSet elements = fakes::lowOrbit(epoch, node);
    elements.name = name;
    elements.number = number;
    return elements;
}

class PassesFixture : public WindowFixture
{
protected:
    PassesFixture() { openPanel('T'); }

    StationStatus withSatellites()
    {
        StationStatus status = samples::idle();
        profile::Profile profile = *status.profile;
        profile.site = {.known = true, .latitude = 38.757_deg, .longitude = -9.117_deg, .heightMetres = 80.0};
        status.profile = std::make_shared<const profile::Profile>(profile);
        status.satellites = std::make_shared<const std::vector<orbit::ElementSet>>(std::vector{
            satellite("ALPHA ONE", 25544, 10_deg, status.utc), satellite("BETA", 40069, 130_deg, status.utc),
            satellite("ALPHA TWO", 43013, 250_deg, status.utc)});
        return status;
    }
    void giveFound(const StationStatus& status)
    {
        give(samples::update(status));
        ASSERT_TRUE(fakes::waitUntil([this] { return rows() > 0; }));
        give(samples::update(status));
    }
    [[nodiscard]] int rows() { return table().model()->rowCount(); }
    QTableView& table() { return *named<QTableView>("Coming passes"); }
    QString cell(int row, PassTable::Column column) { return table().model()->index(row, column).data().toString(); }
    [[nodiscard]] std::vector<std::string> names()
    {
        std::vector<std::string> all;
        for (int row = 0; row < rows(); ++row) {
            all.push_back(cell(row, PassTable::Satellite).toStdString());
        }
        std::ranges::sort(all);
        all.erase(std::ranges::unique(all).begin(), all.end());
        return all;
    }
};

}  // namespace boresight::ui
