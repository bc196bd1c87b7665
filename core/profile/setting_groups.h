// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/profile/setting.h"

#include <set>
#include <string>
#include <vector>

// The groups of settings that have a source file of their own, and the checks they need. setting.cpp joins the groups.
namespace boresight::profile {

void addThirdAxis(std::vector<Setting>& list);
void addMountGeometry(std::vector<Setting>& list);
void addPointing(std::vector<Setting>& list);
void addRegion(std::vector<Setting>& list);
void addSite(std::vector<Setting>& list);
void addGpredict(std::vector<Setting>& list);
void addOrbit(std::vector<Setting>& list);
void addAzel(std::vector<Setting>& list);
void addPosition(std::vector<Setting>& list);
void addSchedule(std::vector<Setting>& list);
void addRecord(std::vector<Setting>& list);
void addSun(std::vector<Setting>& list);
void addClientLock(std::vector<Setting>& list);
void addSupervision(std::vector<Setting>& list);
void addRecovery(std::vector<Setting>& list);
void addSensor(std::vector<Setting>& list);
void addBroker(std::vector<Setting>& list);
void addPower(std::vector<Setting>& list);
void addTransmit(std::vector<Setting>& list);
void addBrake(std::vector<Setting>& list);
void addEndSwitches(std::vector<Setting>& list);
void addWind(std::vector<Setting>& list);

// Checks the name or address of this computer or another: "shack.local", "127.0.0.1".
[[nodiscard]] Result<> checkHost(const std::string& text);
// Checks the address or the network of clients. Address: "192.168.1.7" or "fe80::1". Network: an address and the number
// of its leading bits, "10.0.0.0/8".
[[nodiscard]] Result<> checkAddress(const std::string& text);
[[nodiscard]] Result<> checkNetwork(const std::string& text);

// Checks rows that are identified by the number of a satellite: each row needs a number, and no number may be used
// twice.
template <class Row>
void checkNumbers(std::vector<Problem>& problems, std::string_view list, const std::vector<Row>& rows)
{
    std::set<int> seen;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const std::string key = std::string(list) + "[" + std::to_string(i + 1) + "].norad";
        if (rows[i].number == 0) {
            problems.push_back({key, Text::tr("is needed")});
        } else if (!seen.insert(rows[i].number).second) {
            problems.push_back({key, Text::tr("is in the list twice")});
        }
    }
}

// Whether the sensor, the positions, the wind or an end switch come from this topic of the broker.
[[nodiscard]] bool takesReadings(const Profile& profile, const std::string& topic);

// Check settings that depend on each other: broker; geometry of the mount; region, Sun, park position and presets;
// antennas; source of positions; satellites; watch list; sensor; received power; transmit output; brake; end switches;
// wind; boards beside those of the axes.
void checkBroker(std::vector<Problem>& problems, const Profile& profile);
void checkGeometry(std::vector<Problem>& problems, const Profile& profile);
void checkRegion(std::vector<Problem>& problems, const Profile& profile);
void checkAntennas(std::vector<Problem>& problems, const Profile& profile);
void checkPosition(std::vector<Problem>& problems, const Profile& profile);
void checkSatellites(std::vector<Problem>& problems, const Profile& profile);
void checkSchedule(std::vector<Problem>& problems, const Profile& profile);
void checkSensor(std::vector<Problem>& problems, const Profile& profile);
void checkPower(std::vector<Problem>& problems, const Profile& profile);
void checkTransmit(std::vector<Problem>& problems, const Profile& profile);
void checkBrake(std::vector<Problem>& problems, const Profile& profile);
void checkEndSwitches(std::vector<Problem>& problems, const Profile& profile);
void checkWind(std::vector<Problem>& problems, const Profile& profile);
void checkFurtherBoards(std::vector<Problem>& problems, const Profile& profile);

}  // namespace boresight::profile
