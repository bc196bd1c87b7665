// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/profile/further_boards.h"

#include "core/base/numbers.h"
#include "core/base/text.h"
#include "core/profile/setting_groups.h"
#include "core/profile/setting_makers.h"
#include "core/units/degrees_text.h"

#include <algorithm>
#include <cmath>

namespace boresight::profile {
namespace {

using namespace makers;

constexpr std::int64_t kHighestId = 126;

bool turnsAnAxis(int id, const Profile& profile)
{
    return std::ranges::any_of(
        kAxes, [&](Axis axis) { return kindOf(profile.axis(axis).driver).hasId && profile.axis(axis).id == id; });
}

void checkWatched(std::vector<Problem>& problems, const Profile& profile)
{
    std::vector<int> ids;
    for (const std::string& text : profile.watchedBoards) {
        const auto board = parseWatchedBoard(text);
        if (!board) {
            continue;  // the check of the setting reports it
        }
        if (turnsAnAxis(board->id, profile)) {
            problems.push_back({"bus.watched", Text::tr("The board with the id %1 turns an axis").arg(board->id)});
        } else if (std::ranges::find(ids, board->id) != ids.end()) {
            problems.push_back({"bus.watched", Text::tr("names the id %1 twice").arg(board->id)});
        }
        ids.push_back(board->id);
    }
}

// After power-up a board counts from -0.5 to 0.5 turns. A place beyond that would be shown one turn away, so the limits
// would be false.
bool isWithinOneCount(const AxisSettings& axis)
{
    constexpr double kHalfTurn = 0.5 + 1e-9;
    const bool isCountedAnew = axis.powerUpPosition == PowerUpPosition::Trusted || axis.geometry.gearRatio == 1.0;
    const auto counts = [&](Angle end) { return std::abs(axis.geometry.toMotor(end).turns()) <= kHalfTurn; };
    return !isCountedAnew || (counts(axis.geometry.travel.min) && counts(axis.geometry.travel.max));
}

void checkThirdAxis(std::vector<Problem>& problems, const Profile& profile)
{
    const AxisSettings& axis = profile.thirdAxis.axis;
    const TravelRange& travel = axis.geometry.travel;
    if (!profile.thirdAxis.isUsed()) {
        return;
    }
    if (std::ranges::none_of(kAxes, [&](Axis one) { return profile.axis(one).driver == AxisDriver::Moteus; })) {
        problems.push_back(
            {"third_axis.id", Text::tr("needs an axis with the driver \"moteus\", whose bus it shares")});
    }
    if (turnsAnAxis(axis.id, profile)) {
        problems.push_back(
            {"third_axis.id", Text::tr("The board with the id %1 turns azimuth or elevation").arg(axis.id)});
    } else if (watches(profile, axis.id)) {
        problems.push_back({"third_axis.id", Text::tr("The board with the id %1 is in bus.watched, too").arg(axis.id)});
    }
    if (axis.geometry.sign == 0) {
        problems.push_back({"third_axis.sign", Text::tr("1 or -1 is expected")});
    }
    if (axis.limits.jerk.radians() < axis.limits.acceleration.radians()) {
        problems.push_back(
            {"third_axis.max_jerk_deg_s3", Text::tr("must be at least max_acceleration_deg_s2 per second, here %1")
                                               .arg(toQString(formatFixed(axis.limits.acceleration.degrees(), 2)))});
    }
    if (travel.min >= travel.max) {
        problems.push_back(
            {"third_axis.travel_max_deg",
             Text::tr("must be larger than third_axis.travel_min_deg (%1)").arg(degreesText(travel.min, 2))});
    } else if (!isWithinOneCount(axis)) {
        problems.push_back({"third_axis.travel_max_deg",
                            Text::tr("The travel must lie within half a turn of the controller to each side of its "
                                     "zero. After power-up the controller knows this turn only.")});
    }
}

void addBoard(std::vector<Setting>& list)
{
    constexpr auto kOnReconnect = Applies::OnReconnect;
    list.push_back(integer(
        "third_axis.id", "", {0, static_cast<double>(kHighestId)}, kOnReconnect,
        {QT_TRANSLATE_NOOP("Text", "CAN id"),
         QT_TRANSLATE_NOOP("Text",
                           "CAN id of the moteus controller of a further axis, such as the polarisation. Boresight "
                           "shows this axis and jogs it. No client and no target moves it. 0: there is none.")},
        [](auto& p) -> auto& { return p.thirdAxis.axis.id; }));
    list.push_back(name(
        "third_axis.name", Applies::Now,
        {QT_TRANSLATE_NOOP("Text", "Name"), QT_TRANSLATE_NOOP("Text", "The name of this axis in the window.")},
        [](auto& p) -> auto& { return p.thirdAxis.name; }));
    list.push_back(integer(
        "third_axis.sign", "", {-1, 1}, kOnReconnect,
        {QT_TRANSLATE_NOOP("Text", "Motor direction"),
         QT_TRANSLATE_NOOP("Text", "1, or -1 if the motor counts down while the axis angle grows. 0 is refused.")},
        [](auto& p) -> auto& { return p.thirdAxis.axis.geometry.sign; }));
    list.push_back(number(
        "third_axis.offset_deg", "°", {-3600.0, 3600.0}, kOnReconnect,
        {QT_TRANSLATE_NOOP("Text", "Axis zero offset"),
         QT_TRANSLATE_NOOP("Text", "motor turns = sign × (angle + offset) / 360 × gear ratio.")},
        [](auto& p) -> auto& { return p.thirdAxis.axis.geometry.offset; }));
    list.push_back(number(
        "third_axis.gear_ratio", "", {0.001, 10000.0}, kOnReconnect,
        {QT_TRANSLATE_NOOP("Text", "Gear ratio"),
         QT_TRANSLATE_NOOP("Text",
                           "Turns that the controller counts for one turn of the axis. 1: the controller has the gear "
                           "ratio itself, and counts turns of the axis.")},
        [](auto& p) -> auto& { return p.thirdAxis.axis.geometry.gearRatio; }));
    list.push_back(choice(
        "third_axis.power_up_position", powerUpChoices(), kOnReconnect,
        {QT_TRANSLATE_NOOP("Text", "Position after power-up"),
         QT_TRANSLATE_NOOP("Text",
                           "\"trusted\" if the position after power-up is always right: an encoder on the axis. "
                           "Otherwise the axis is jogged only while the controller reports a referenced output.")},
        [](auto& p) -> auto& { return p.thirdAxis.axis.powerUpPosition; }));
}

void addMotion(std::vector<Setting>& list)
{
    list.push_back(number(
        "third_axis.travel_min_deg", "°", {-3600.0, 3600.0}, Applies::Now,
        {QT_TRANSLATE_NOOP("Text", "Travel from"),
         QT_TRANSLATE_NOOP("Text", "Lower end of the permitted travel, as an axis angle.")},
        [](auto& p) -> auto& { return p.thirdAxis.axis.geometry.travel.min; }));
    list.push_back(number(
        "third_axis.travel_max_deg", "°", {-3600.0, 3600.0}, Applies::Now,
        {QT_TRANSLATE_NOOP("Text", "Travel to"),
         QT_TRANSLATE_NOOP("Text", "Upper end of the permitted travel, as an axis angle.")},
        [](auto& p) -> auto& { return p.thirdAxis.axis.geometry.travel.max; }));
    list.push_back(number(
        "third_axis.max_speed_deg_s", "°/s", {0.01, 360.0}, Applies::Now,
        {QT_TRANSLATE_NOOP("Text", "Jog rate"), QT_TRANSLATE_NOOP("Text", "The speed of a jog of this axis.")},
        [](auto& p) -> auto& { return p.thirdAxis.axis.limits.speed; }));
    list.push_back(number(
        "third_axis.max_acceleration_deg_s2", "°/s²", {0.01, 3600.0}, Applies::Now,
        {QT_TRANSLATE_NOOP("Text", "Acceleration"),
         QT_TRANSLATE_NOOP("Text", "Largest change of speed, also in a stop.")},
        [](auto& p) -> auto& { return p.thirdAxis.axis.limits.acceleration; }));
    list.push_back(number(
        "third_axis.max_jerk_deg_s3", "°/s³", {0.01, 360000.0}, Applies::Now,
        {QT_TRANSLATE_NOOP("Text", "Jerk"),
         QT_TRANSLATE_NOOP("Text",
                           "Largest jerk: how fast the acceleration may change. It makes every stop longer by "
                           "2 × acceleration / jerk seconds.")},
        [](auto& p) -> auto& { return p.thirdAxis.axis.limits.jerk; }));
    list.push_back(number(
        "third_axis.max_torque_nm", "Nm", {0.01, 10000.0}, Applies::Now,
        {QT_TRANSLATE_NOOP("Text", "Largest torque"),
         QT_TRANSLATE_NOOP("Text", "The largest torque that the drive uses, as its controller measures it.")},
        [](auto& p) -> auto& { return p.thirdAxis.axis.maxTorque; }));
}

}  // namespace

Result<WatchedBoard> parseWatchedBoard(std::string_view text)
{
    const auto space = text.find(' ');
    const auto id = parseInteger(text.substr(0, space));
    const std::string_view name = space == std::string_view::npos ? std::string_view() : text.substr(space + 1);
    if (!id || *id < 1 || *id > kHighestId || name.find_first_not_of(' ') == std::string_view::npos) {
        return failure(ErrorCode::InvalidInput,
                       Text::tr("the id of a board and its name are expected, like \"3 polarisation\""));
    }
    return WatchedBoard{.id = static_cast<int>(*id), .name = std::string(name)};
}

bool watches(const Profile& profile, int id)
{
    return std::ranges::any_of(profile.watchedBoards, [id](const std::string& text) {
        const auto board = parseWatchedBoard(text);
        return board && board->id == id;
    });
}

bool isFurtherBoard(const Profile& profile, int id)
{
    return watches(profile, id) || (profile.thirdAxis.isUsed() && profile.thirdAxis.axis.id == id);
}

void addThirdAxis(std::vector<Setting>& list)
{
    addBoard(list);
    addMotion(list);
}

void checkFurtherBoards(std::vector<Problem>& problems, const Profile& profile)
{
    checkWatched(problems, profile);
    checkThirdAxis(problems, profile);
}

}  // namespace boresight::profile
