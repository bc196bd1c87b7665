// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/drives/protection_panel.h"

#include "ui/drives/protection_model.h"
#include "ui/kit/axes.h"
#include "ui/kit/command_button.h"
#include "ui/kit/read_table.h"
#include "ui/kit/value_label.h"
#include "ui/link/drive_check_words.h"
#include "ui/link/end_switch_words.h"

#include <QHeaderView>
#include <QTableView>
#include <QVBoxLayout>

#include <algorithm>

namespace boresight::ui {

namespace {

std::optional<Axis> axisOfWrongGear(const DrivesStatus& drives)
{
    return drives.azimuth.gear     ? std::optional(Axis::Azimuth)
           : drives.elevation.gear ? std::optional(Axis::Elevation)
                                   : std::nullopt;
}

}  // namespace

ProtectionPanel::ProtectionPanel(RequestDesk& desk, QWidget* parent)
    : AskingPanel(desk, parent),
      m_model(new ProtectionModel(this)),
      m_table(makeTable()),
      m_driveCheck(new ValueLabel(tr("Drive check"), fonts::label(), {}, this)),
      m_reason(new ValueLabel(tr("Why the selected setting matters"), fonts::label(), {}, this)),
      m_switches(new ValueLabel(tr("End switches"), fonts::label(), {}, this)),
      m_notice(new ValueLabel(tr("Refused"), fonts::label(), {}, this)),
      m_read(new CommandButton(tr("Read again"), tr("Find the boards on the bus and read all settings again"), desk,
                               *m_notice, this)),
      m_fix(new CommandButton(tr("Fix …"), tr("Write the settings that differ. Boresight asks first."), desk, *m_notice,
                              this)),
      m_gear(new CommandButton(tr("Set gear …"), tr("Write the gear ratio of the profile. Asks first"), desk, *m_notice,
                               this)),
      m_switchOff(new CommandButton(tr("Switch drives off …"), tr("Switch the drives off. Boresight asks first."), desk,
                                    *m_notice, this)),
      m_switchAxisOff{new CommandButton(tr("Azimuth off …"),
                                        tr("Switch off the azimuth alone. The elevation stays as it is. Asks first"),
                                        desk, *m_notice, this),
                      new CommandButton(tr("Elevation off …"),
                                        tr("Switch off the elevation alone. The azimuth stays as it is. Asks first"),
                                        desk, *m_notice, this)}
{
    build();
    connect(m_read, &QPushButton::clicked, this, [this] { m_read->ask(request::ReadDrives{}); });
    connect(m_fix, &QPushButton::clicked, this, &ProtectionPanel::fix);
    connect(m_gear, &QPushButton::clicked, this, &ProtectionPanel::setGear);
    connect(m_switchOff, &QPushButton::clicked, this, qOverload<>(&ProtectionPanel::switchOff));
    for (const Axis axis : kAxes) {
        connect(m_switchAxisOff[axisIndex(axis)], &QPushButton::clicked, this, [this, axis] { switchOff(axis); });
    }
    connect(m_table->selectionModel(), &QItemSelectionModel::currentChanged, this, &ProtectionPanel::showReason);
    connect(m_model, &QAbstractItemModel::layoutChanged, this, &ProtectionPanel::showReason);
    connect(m_model, &QAbstractItemModel::modelReset, this, &ProtectionPanel::showReason);
    showReason();
}

void ProtectionPanel::build()
{
    auto* const column = new QVBoxLayout(&controls());
    column->setContentsMargins(0, 6, 0, 6);  // the table needs the width
    column->setSpacing(6);
    const auto rowOf = [](std::initializer_list<CommandButton*> buttons) {
        auto* const row = new QHBoxLayout;
        row->setSpacing(4);
        for (CommandButton* const button : buttons) {
            button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
            row->addWidget(button);
        }
        return row;
    };
    for (ValueLabel* const line : {m_driveCheck, m_reason, m_switches, m_notice}) {
        line->setStretching(true);
    }
    m_driveCheck->setLines(2);
    m_reason->setLines(4);
    m_switches->setWrapping(true);
    m_switches->setCollapsing(true);
    m_notice->setCollapsing(true);
    column->addWidget(m_driveCheck);
    column->addWidget(m_table, 1);
    column->addWidget(m_reason);
    column->addWidget(m_switches);
    column->addLayout(rowOf({m_read, m_gear, m_fix}));
    column->addLayout(rowOf({m_switchAxisOff[0], m_switchAxisOff[1], m_switchOff}));
    column->addWidget(m_notice);
}

void ProtectionPanel::hideSwitches()
{
    for (CommandButton* const button : {m_switchAxisOff[0], m_switchAxisOff[1], m_switchOff}) {
        button->hide();
    }
    m_reason->setLines(3);
    m_switches->hide();
}

QTableView* ProtectionPanel::makeTable()
{
    QTableView* const table = makeReadTable(tr("Protection"), *m_model, this);
    table->setIconSize({12, 12});
    QHeaderView* const header = table->horizontalHeader();
    header->setSectionResizeMode(ProtectionModel::Wanted, QHeaderView::Stretch);
    // room for symbol and gaps
    const int found = table->fontMetrics().horizontalAdvance(QStringLiteral("00000°/s²")) + 28;
    for (const int column : {ProtectionModel::FoundAzimuth, ProtectionModel::FoundElevation}) {
        header->setSectionResizeMode(column, QHeaderView::Fixed);
        header->resizeSection(column, found);
    }
    return table;
}

void ProtectionPanel::showStatus(const StationStatus& status)
{
    m_status = status;
    m_model->show(drivesOf(status));
    showDriveCheck(status);
    m_read->setBlocked(status.permissions.reason(Action::ReadDrives));
    m_fix->setBlocked(status.permissions.reason(Action::FixDrives));
    const std::optional<Axis> wrong = axisOfWrongGear(drivesOf(status));
    m_gear->setVisible(wrong.has_value());
    m_gear->setBlocked(status.permissions.reason(setGearAction(wrong.value_or(Axis::Azimuth))));
    m_switchOff->setBlocked(status.permissions.reason(Action::SwitchOff));
    for (const Axis axis : kAxes) {
        m_switchAxisOff[axisIndex(axis)]->setBlocked(status.permissions.reason(switchOffAction(axis)));
    }
    showSwitches();
    showWhetherPossible(status);
}

void ProtectionPanel::showSwitches()
{
    QStringList lines;
    for (const EndSwitchStatus& one : m_status.endSwitches) {
        lines << endSwitchLine(one);
    }
    const bool isFree = std::ranges::all_of(
        m_status.endSwitches, [](const EndSwitchStatus& one) { return one.state == end_switches::SwitchState::Free; });
    m_switches->setValue(lines.isEmpty() ? QString() : tr("End switches: %1").arg(lines.join(QStringLiteral(" · "))),
                         isFree ? Tone::Normal : Tone::Warning, isFree ? Symbol::None : Symbol::Warning);
}

// The line shows either an obstacle to motion or the progress of the reading. The obstacle has priority.
void ProtectionPanel::showDriveCheck(const StationStatus& status)
{
    const DrivesStatus& drives = drivesOf(status);
    const BoardWork& work = drives.gearWork;
    if (work.running || (work.failed && axisOfWrongGear(drives))) {
        m_driveCheck->setValue(work.text, work.failed ? Tone::Warning : Tone::Advisory,
                               work.failed ? Symbol::Warning : Symbol::Advisory);
        return;
    }
    const bool busy = drives.driveCheck == DriveCheckState::Running || drives.driveCheck == DriveCheckState::Fixing;
    const Sentence line = !busy && !drives.released && !drives.armingObstacle.isEmpty() ? armingSentence(status)
                                                                                        : driveCheckSentence(drives);
    m_driveCheck->setValue(line.text, line.tone, line.symbol);
}

void ProtectionPanel::showReason()
{
    const QModelIndex current = m_table->currentIndex();
    if (current.isValid()) {
        m_reason->setValue(m_model->explanation(current.row()));
        return;
    }
    const int dangerous = m_model->count(Verdict::Dangerous);
    const int advised = m_model->count(Verdict::Advised);
    m_reason->setValue(
        dangerous + advised == 0
            ? tr("Select a line to read why it matters")
            : tr("%1 unsafe, %2 advised. Select a line to read why it matters").arg(dangerous).arg(advised),
        Tone::Secondary);
}

void ProtectionPanel::fix()
{
    const QStringList changes = m_model->changes();
    QString text =
        changes.isEmpty()
            ? tr("The drives store the settings that are already in force. Nothing moves.")
            : changes.join(QLatin1Char('\n')) +
                  tr("\n\nBoresight writes them, reads them back and stores them in the drives. Nothing moves.");
    if (const QStringList left = m_model->leftAlone(); !left.isEmpty()) {
        text += tr("\n\nSet these yourself, because only the builder of the mount knows the values:\n") +
                left.join(QLatin1Char('\n'));
    }
    askFirst({.title = tr("Write these settings into the drives?"),
              .text = text,
              .act = tr("Write"),
              .request = request::FixDrives{},
              .action = Action::FixDrives},
             m_status);
}

void ProtectionPanel::setGear()
{
    const std::optional<Axis> axis = axisOfWrongGear(drivesOf(m_status));
    if (!axis) {
        return;
    }
    const GearCorrection& gear = *driveOf(m_status, *axis).gear;
    askFirst({.title = tr("Write the gear ratio into the %1 drive?").arg(name(*axis)),
              .text = tr("Gear ratio in the drive: %1. Gear ratio in the profile: %2. The gear ratio is the number of "
                         "axis turns for one motor turn.\n\nIf the profile is wrong, press Cancel and correct it on "
                         "the page Profile.\n\n%3\n\nBoresight writes the ratio, reads it back and stores it in the "
                         "drive. Nothing moves.")
                          .arg(gear.found, gear.wanted, gear.effect),
              .act = tr("Write"),
              .request = request::SetGear{.axis = *axis},
              .action = setGearAction(*axis)},
             m_status);
}

void ProtectionPanel::switchOff()
{
    askFirst({.title = tr("Switch the drives off?"),
              .text = tr("Nothing holds the mount afterwards. An unbalanced elevation falls. Wind may turn the "
                         "azimuth. Keep people away from the antenna, or support it first."),
              .act = tr("Switch off"),
              .request = request::SwitchOff{},
              .action = Action::SwitchOff},
             m_status);
}

void ProtectionPanel::switchOff(Axis axis)
{
    const bool azimuth = axis == Axis::Azimuth;
    askFirst(
        {.title = azimuth ? tr("Switch the azimuth drive off?") : tr("Switch the elevation drive off?"),
         .text = azimuth ? tr("Nothing holds the azimuth from then on. Wind may turn it. The elevation stays as it is.")
                         : tr("Nothing holds the elevation from then on. If it is unbalanced, it falls. Keep people "
                              "away from the antenna, or support it first. The azimuth stays as it is."),
         .act = tr("Switch off"),
         .request = request::SwitchOff{axis},
         .action = switchOffAction(axis)},
        m_status);
}

}  // namespace boresight::ui

#include "moc_protection_panel.cpp"
