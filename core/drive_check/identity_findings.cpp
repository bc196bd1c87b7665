// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/drive_check/identity_findings.h"

#include "core/base/text.h"
#include "core/drive_check/protections.h"
#include "core/moteus/describe.h"
#include "core/profile/further_boards.h"

#include <algorithm>
#include <set>

namespace boresight::drive_check {
namespace {

using moteus::Register;

struct IdentityJudge
{
    const profile::Profile& profile;
    const KnownBoards& known;
    std::span<const FoundController> found;
    AxisSet axes;
    std::vector<Finding> findings{};

    [[nodiscard]] int idOf(Axis axis) const { return profile.axis(axis).id; }
    [[nodiscard]] const QString& knownBoard(Axis axis) const { return known[axis == Axis::Azimuth ? 0 : 1]; }
    [[nodiscard]] bool isOurs(int id) const
    {
        return std::ranges::any_of(axes, [&](Axis axis) { return id == idOf(axis); });
    }
    [[nodiscard]] bool isFurther(int id) const { return profile::isFurtherBoard(profile, id); }
    [[nodiscard]] std::ptrdiff_t countOf(int id) const { return std::ranges::count(found, id, &FoundController::id); }

    void judgeShared();
    void judgeUnknownBoards();
    void judgeSwapped();
    void judgeAxis(Axis axis);
    void judgeMap(Axis axis, const FoundController& board);
};

Axis otherThan(Axis axis)
{
    return axis == Axis::Azimuth ? Axis::Elevation : Axis::Azimuth;
}

QString uuidOf(const FoundController& board)
{
    const auto uuid = board.known.uuid();
    return uuid ? QString::fromStdString(moteus::uuidText(*uuid)) : QString();
}

// Two boards with one id are found as two, or as one board whose long answers never arrive complete.
void IdentityJudge::judgeShared()
{
    std::set<int> ids;
    for (const FoundController& board : found) {
        if (board.isUnreadable() || countOf(board.id) > 1) {
            ids.insert(board.id);
        }
    }
    for (const int id : ids) {
        findings.push_back(
            {.kind = FindingKind::SharedId,
             .about = QString::number(id),
             .weight = isOurs(id) ? FindingWeight::Blocking : FindingWeight::Warning,
             .what = Text::tr("two boards have the id %1, so their answers collide").arg(id),
             .remedy = Text::tr("Open the guide (F3), step Connect. It sets the ids of the boards one after the other. "
                                "If there is only one board, check the plugs and the termination.")});
    }
}

void IdentityJudge::judgeUnknownBoards()
{
    std::set<int> ids;
    for (const FoundController& board : found) {
        if (!isOurs(board.id) && !isFurther(board.id) && ids.insert(board.id).second) {
            findings.push_back(
                {.kind = FindingKind::UnknownBoard,
                 .about = QString::number(board.id),
                 .weight = FindingWeight::Warning,
                 .what = Text::tr("a board with the id %1 (%2) is not in the profile")
                             .arg(board.id)
                             .arg(uuidOf(board).isEmpty() ? Text::tr("UUID unread") : uuidOf(board)),
                 .remedy = Text::tr("Take the board off the bus. If the board drives an axis, enter its id in the "
                                    "profile. If it does something else, name it in bus.watched.")});
        }
    }
}

void IdentityJudge::judgeSwapped()
{
    for (const Axis axis : axes) {
        const Axis other = otherThan(axis);
        const FoundController* board = onlyBoard(found, idOf(axis));
        if (board == nullptr || knownBoard(other).isEmpty() || uuidOf(*board) != knownBoard(other)) {
            continue;
        }
        findings.push_back(
            {.kind = FindingKind::Swapped,
             .weight = FindingWeight::Blocking,
             .what = Text::tr("the ids are swapped, and the board with the id %1 (%2) was the board of %3")
                         .arg(idOf(axis))
                         .arg(axisText(axis), axisText(other)),
             .remedy = Text::tr("Exchange the ids in the profile. If you exchanged the boards, end Boresight. Move the "
                                ".memory.json files of the mount out of the state folder. Start Boresight again.")});
        return;
    }
}

void IdentityJudge::judgeAxis(Axis axis)
{
    const int id = idOf(axis);
    if (countOf(id) == 0) {
        findings.push_back({.kind = FindingKind::Missing,
                            .about = axisName(axis),
                            .weight = FindingWeight::Blocking,
                            .what = Text::tr("the board of %1 (id %2) does not answer").arg(axisText(axis)).arg(id),
                            .remedy = Text::tr("Check the power and the plugs of the board, and the bus cable. If the "
                                               "board has another id, enter this id in the profile.")});
        return;
    }
    const FoundController* board = onlyBoard(found, id);
    if (board == nullptr) {
        return;  // reported already
    }
    judgeMap(axis, *board);
    const QString uuid = uuidOf(*board);
    const bool replaced =
        !knownBoard(axis).isEmpty() && uuid != knownBoard(axis) && uuid != knownBoard(otherThan(axis));
    if (replaced) {
        findings.push_back({.kind = FindingKind::OtherBoard,
                            .about = axisName(axis),
                            .weight = FindingWeight::Warning,
                            .what = Text::tr("%1 has another board than before (%2)").arg(axisText(axis), uuid),
                            .remedy = Text::tr("If you exchanged the board, check calibration and gains. If not, check "
                                               "whether another mount is connected.")});
    }
}

void IdentityJudge::judgeMap(Axis axis, const FoundController& board)
{
    const std::optional<double> map = board.known.value(Register::RegisterMapVersion);
    if (map && *map == moteus::kRegisterMapVersion) {
        return;
    }
    const QString ours = QString::number(moteus::kRegisterMapVersion);
    const QString what = map ? Text::tr("The board of %1 has the register map %2. Boresight supports only version %3")
                                   .arg(axisText(axis), QString::number(*map), ours)
                             : Text::tr("The board of %1 reports no register map. Boresight supports only version %2")
                                   .arg(axisText(axis), ours);
    findings.push_back(
        {.kind = FindingKind::RegisterMap,
         .about = axisName(axis),
         .weight = FindingWeight::Blocking,
         .what = what,
         .remedy =
             Text::tr(
                 "Install firmware with the register map %1 in the board (moteus_tool --flash), or a newer Boresight.")
                 .arg(moteus::kRegisterMapVersion)});
}

}  // namespace

const FoundController* onlyBoard(std::span<const FoundController> found, int id)
{
    const auto board = std::ranges::find(found, id, &FoundController::id);
    const bool only = std::ranges::count(found, id, &FoundController::id) == 1 && !board->isUnreadable();
    return only ? &*board : nullptr;
}

DriveIdentity identityOf(const FoundController& controller)
{
    const auto map = controller.known.value(Register::RegisterMapVersion);
    const std::uint32_t bits = moteus::toWire(map.value_or(0.0), moteus::Kind::Identity, moteus::Resolution::Int32);
    return {.uuid = uuidOf(controller),
            .firmware = QString::fromStdString(moteus::firmwareText(controller.known)),
            .registerMap = static_cast<int>(bits)};
}

std::vector<Finding> identityFindings(const profile::Profile& profile, const KnownBoards& known,
                                      std::span<const FoundController> found, AxisSet axes)
{
    if (found.empty()) {
        return {{.kind = FindingKind::NobodyAnswers,
                 .weight = FindingWeight::Blocking,
                 .what = Text::tr("no drive answers on the bus"),
                 .remedy = Text::tr("Check the power of the drives, the bus cable, and the 120 Ω at both ends.")}};
    }
    IdentityJudge judge{profile, known, found, axes};
    judge.judgeShared();
    judge.judgeSwapped();
    for (const Axis axis : axes) {
        judge.judgeAxis(axis);
    }
    judge.judgeUnknownBoards();
    return std::move(judge.findings);
}

}  // namespace boresight::drive_check
