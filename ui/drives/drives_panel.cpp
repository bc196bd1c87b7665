// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/drives/drives_panel.h"

#include "ui/kit/axes.h"
#include "ui/kit/caption.h"
#include "ui/kit/command_button.h"
#include "ui/kit/decimal_box.h"
#include "ui/kit/format.h"
#include "ui/kit/value_label.h"
#include "ui/link/drive_check_words.h"

#include <QGridLayout>

namespace boresight::ui {

namespace {

// Slow enough to be safe by hand, fast enough to measure.
constexpr AngularRate kSlowestProof = 0.5_deg_s;
constexpr AngularRate kFastestProof = 5_deg_s;
constexpr AngularRate kUsualProof = 2_deg_s;

QFrame* rule(QWidget* parent)
{
    auto* const line = new QFrame(parent);
    line->setFrameStyle(QFrame::HLine | QFrame::Sunken);
    return line;
}

QString known(const QString& text)
{
    return text.isEmpty() ? QStringLiteral("---") : text;
}

// The first and last digits distinguish two drives. The complete number is in the tooltip.
QString shortened(const QString& uuid)
{
    return uuid.size() > 12 ? uuid.left(8) + QStringLiteral("…") + uuid.right(4) : known(uuid);
}

QDoubleSpinBox* makeRate(QWidget* parent)
{
    auto* const rate = new DecimalBox(parent);
    rate->setFont(fonts::text());
    rate->setDecimals(1);
    rate->setSingleStep(0.5);
    rate->setRange(kSlowestProof.degrees(), kFastestProof.degrees());
    rate->setValue(kUsualProof.degrees());
    rate->setSuffix(QStringLiteral(" °/s"));
    rate->setMinimumHeight(kTouchSize);
    rate->setAccessibleName(DrivesPanel::tr("Rate of the test"));
    rate->setToolTip(DrivesPanel::tr("Speed of each axis when the commands stop"));
    return rate;
}

// "Also on the bus, not in the profile: id 5 (3f2a9c1d…e811, 1.1.0)".
QString unknownBoardsText(const std::vector<UnknownBoard>& unknownBoards)
{
    QStringList boards;
    for (const UnknownBoard& one : unknownBoards) {
        boards << DrivesPanel::tr("id %1 (%2, %3)")
                      .arg(one.id)
                      .arg(shortened(one.identity.uuid), known(one.identity.firmware));
    }
    return boards.isEmpty()
               ? QString()
               : DrivesPanel::tr("Also on the bus, not in the profile: %1").arg(boards.join(QStringLiteral(", ")));
}

Sentence crashStopSentence(const DriveStatus& drive)
{
    if (!drive.present) {
        return {known({})};
    }
    if (!drive.crashStop) {
        return {DrivesPanel::tr("not tested yet")};
    }
    const CrashStop& stop = *drive.crashStop;
    const QString text = DrivesPanel::tr("%1: stopped after %2 in %3 s, %4")
                             .arg(rateText(stop.rate), angleText(stop.angle))
                             .arg(Seconds(stop.time).count(), 0, 'f', 2)
                             .arg(minuteText(stop.when));
    if (!drive.identity.uuid.isEmpty() && stop.drive != drive.identity.uuid) {
        return {DrivesPanel::tr("another drive, %1").arg(text), Tone::Warning, Symbol::Warning};
    }
    return {text, Tone::Normal};
}

}  // namespace

DrivesPanel::DrivesPanel(RequestDesk& desk, QWidget* parent)
    : AskingPanel(desk, parent),
      m_unknownBoards(new ValueLabel(tr("Unknown boards on the bus"), fonts::label(), {}, this)),
      m_driveCheck(new ValueLabel(tr("Drive check"), fonts::label(), {}, this)),
      m_arming(new ValueLabel(tr("May the mount move"), fonts::label(), {}, this)),
      m_proof(new ValueLabel(tr("Crash-stop test"), fonts::label(), {}, this)),
      m_notice(new ValueLabel(tr("Refused"), fonts::label(), {}, this)),
      m_rate(makeRate(this)),
      m_release(new CommandButton(tr("Release bus"), {}, desk, *m_notice, this)),
      m_run(new CommandButton(tr("Run (both axes) …"), {}, desk, *m_notice, this))
{
    build();
    connect(m_release, &QPushButton::clicked, this, &DrivesPanel::release);
    connect(m_run, &QPushButton::clicked, this, &DrivesPanel::prove);
}

void DrivesPanel::build()
{
    auto* const column = new QVBoxLayout(&controls());
    column->setContentsMargins(6, 6, 6, 6);
    column->setSpacing(6);
    for (ValueLabel* const line : {m_driveCheck, m_arming, m_proof, m_notice}) {
        line->setStretching(true);
    }
    m_arming->setLines(3);
    m_proof->setLines(2);
    auto* const state = new QGridLayout;
    state->addWidget(m_driveCheck, 0, 0);
    state->addWidget(m_arming, 1, 0);
    state->addWidget(m_release, 0, 1, 2, 1);
    state->setColumnStretch(0, 1);
    column->addWidget(makeIdentities());
    column->addStretch(1);
    column->addWidget(rule(&controls()));
    column->addLayout(state);
    column->addStretch(1);
    column->addWidget(rule(&controls()));
    column->addWidget(makeProof());
    column->addStretch(2);
    column->addWidget(m_notice);
}

QWidget* DrivesPanel::makeIdentities()
{
    auto* const box = new QWidget(&controls());
    auto* const grid = new QGridLayout(box);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setVerticalSpacing(2);
    grid->setHorizontalSpacing(12);
    int column = 1;
    for (const QString& heading : {tr("ID"), tr("UUID"), tr("FIRMWARE"), tr("REGISTER MAP"), tr("WRAP")}) {
        grid->addWidget(makeCaption(heading, box), 0, column++);
    }
    for (const Axis axis : kAxes) {
        const auto value = [&](const QString& what, const QString& widest) {
            return new ValueLabel(tr("%1 of the %2 drive").arg(what, name(axis)), fonts::small(), widest, box);
        };
        Identity& row = m_identities[axisIndex(axis)];
        row = {.id = value(tr("Id"), QStringLiteral("126")),
               .uuid = value(tr("UUID"), QStringLiteral("00000000…0000")),
               .firmware = value(tr("Firmware"), QStringLiteral("00.00.00")),
               .registerMap = value(tr("Register map"), QStringLiteral("---")),
               .turn = value(tr("Cable wrap"), tr("unknown"))};
        row.turn->setFont(fonts::label());
        row.turn->setSymbolRoom(true);
        const int line = static_cast<int>(axisIndex(axis)) + 1;
        grid->addWidget(makeCaption(shortName(axis), box), line, 0);
        column = 1;
        for (ValueLabel* const label : {row.id, row.uuid, row.firmware, row.registerMap, row.turn}) {
            grid->addWidget(label, line, column++, Qt::AlignVCenter);
        }
    }
    grid->setColumnStretch(column, 1);
    m_unknownBoards->setStretching(true);
    grid->addWidget(m_unknownBoards, 3, 0, 1, column + 1);
    return box;
}

QWidget* DrivesPanel::makeProof()
{
    auto* const box = new QWidget(&controls());
    auto* const grid = new QGridLayout(box);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setVerticalSpacing(4);
    const QString what = tr("Crash-stop test: cut the commands, measure the stop");
    grid->addWidget(makeCaption(what, box), 0, 0, 1, 4);
    grid->addWidget(makeCaption(tr("Rate"), *m_rate), 1, 0);
    grid->addWidget(m_rate, 1, 1);
    grid->addWidget(m_run, 1, 2);
    grid->addWidget(m_proof, 1, 3, Qt::AlignVCenter);
    grid->setColumnStretch(3, 1);
    for (const Axis axis : kAxes) {
        auto* const result = new ValueLabel(tr("Crash stop of the %1").arg(name(axis)), fonts::label(), {}, box);
        result->setStretching(true);
        m_crashStops[axisIndex(axis)] = result;
        const int line = static_cast<int>(axisIndex(axis)) + 2;
        grid->addWidget(makeCaption(shortName(axis), box), line, 0);
        grid->addWidget(result, line, 1, 1, 3, Qt::AlignVCenter);
    }
    return box;
}

void DrivesPanel::showStatus(const StationStatus& status)
{
    m_status = status;
    for (const Axis axis : kAxes) {
        showDrive(axis);
    }
    const QString unknownBoards = unknownBoardsText(drivesOf(status).unknownBoards);
    m_unknownBoards->setValue(unknownBoards, Tone::Warning, unknownBoards.isEmpty() ? Symbol::None : Symbol::Warning);
    const Sentence driveCheck = driveCheckSentence(drivesOf(status));
    m_driveCheck->setValue(driveCheck.text, driveCheck.tone, driveCheck.symbol);
    const Sentence arming = armingSentence(status);
    m_arming->setValue(arming.text, arming.tone, arming.symbol);
    const bool released = drivesOf(status).released;
    m_release->setCommand(
        released ? tr("Take bus back") : tr("Release bus"),
        released
            ? tr("Open the adapter again and read the drives again")
            : tr("Leave the adapter to other tools (tview, moteus_tool). Nothing moves until you take the bus back."));
    m_release->setBlocked(status.permissions.reason(released ? Action::TakeBus : Action::ReleaseBus));
    showProof();
    showWhetherPossible(status);
}

void DrivesPanel::showDrive(Axis axis)
{
    const DriveStatus& drive = driveOf(m_status, axis);
    const Identity& row = m_identities[axisIndex(axis)];
    const auto number = [](int value) { return value > 0 ? QString::number(value) : known({}); };
    row.id->setValue(number(drive.id));
    row.uuid->setValue(shortened(drive.identity.uuid));
    row.uuid->setToolTip(drive.identity.uuid);
    row.firmware->setValue(known(drive.identity.firmware));
    row.registerMap->setValue(number(drive.identity.registerMap));
    if (drive.present) {
        const bool turnKnown = isTurnKnown(m_status, axis);
        row.turn->setValue(turnKnown ? tr("known") : tr("unknown"), turnKnown ? Tone::Normal : Tone::Warning,
                           turnKnown ? Symbol::None : Symbol::Warning);
    } else {
        row.turn->setValue(known({}));
    }
    const Sentence stop = crashStopSentence(drive);
    m_crashStops[axisIndex(axis)]->setValue(stop.text, stop.tone, stop.symbol);
}

void DrivesPanel::showProof()
{
    const DrivesStatus& drives = drivesOf(m_status);
    const bool running = drives.proofRunning;
    const bool both = drives.azimuth.present && drives.elevation.present;
    m_run->setCommand(running ? tr("End test")
                      : both  ? tr("Run (both axes) …")
                              : tr("Run …"),
                      running
                          ? tr("Send commands to the drives again and hold")
                          : tr("Move each axis, stop the commands to its drive, and measure. Boresight asks first."));
    m_run->setBlocked(m_status.permissions.reason(running ? Action::EndProof : Action::ProveCrashStop));
    m_rate->setEnabled(!running);
    m_proof->setValue(drives.proofText, running ? Tone::Advisory : Tone::Secondary,
                      running ? Symbol::Advisory : Symbol::None);
}

void DrivesPanel::release()
{
    if (drivesOf(m_status).released || !drivesOf(m_status).switchedOn) {
        m_release->ask(drivesOf(m_status).released ? Request(request::TakeBus{}) : Request(request::ReleaseBus{}));
        return;
    }
    askFirst(
        {.title = tr("Leave the bus while the drives are switched on?"),
         .text = tr("The drives get no more commands. Each drive follows its setting \"If commands stop\" (page "
                    "Protection). With the factory setting an unbalanced elevation sinks slowly.\n\nA drive gives no "
                    "torque for 53 ms when it is switched on again. An unbalanced elevation then drops a little."),
         .act = tr("Leave the bus"),
         .request = request::ReleaseBus{},
         .action = Action::ReleaseBus},
        m_status);
}

void DrivesPanel::prove()
{
    if (drivesOf(m_status).proofRunning) {
        m_run->ask(request::EndProof{});
        return;
    }
    const AngularRate rate = Angle::fromDegrees(m_rate->value()) / Seconds(1.0);
    askFirst(
        {.title = tr("Move the mount at %1 and stop the commands?").arg(rateText(rate)),
         .text = tr("Boresight moves one axis after the other at %1. It stops the commands to the drive, as if "
                    "the cable were cut. It measures how far and how long the axis still moves.\n\nA drive gives no "
                    "torque for 53 ms when it is switched on again. An unbalanced elevation then drops a "
                    "little.\n\nKeep people and ropes clear of the antenna. STOP ends the test.")
                     .arg(rateText(rate)),
         .act = tr("Move the mount"),
         .request = request::ProveCrashStop{rate},
         .action = Action::ProveCrashStop},
        m_status);
}

}  // namespace boresight::ui

#include "moc_drives_panel.cpp"
