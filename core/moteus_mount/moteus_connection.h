// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/can/can_link.h"
#include "core/journal/journal_file.h"
#include "core/moteus_mount/board_output.h"
#include "core/moteus_mount/board_pins.h"
#include "core/moteus_mount/drive_care.h"
#include "core/moteus_mount/moteus_mount.h"
#include "core/mount/mount_connection.h"
#include "core/mount/mount_kind.h"

#include <QPointer>

#include <memory>
#include <optional>
#include <vector>

// One or two moteus with their CAN bus, their drive check and their position journal on disk. Station thread only.
namespace boresight {

class MoteusConnection final : public MountConnection
{
    Q_OBJECT

public:
    MoteusConnection(std::unique_ptr<CanLink> link, const MountStart& start, const profile::InForce& profile,
                     const Clock& clock, EventLog& log, AlarmBoard& alarms);
    ~MoteusConnection() override;

    [[nodiscard]] MountDriver& driver() override { return m_mount; }
    [[nodiscard]] const MountDriver& driver() const override { return m_mount; }
    [[nodiscard]] bool simulated() const override { return m_simulated; }
    [[nodiscard]] const Result<>& mine() const override { return m_claim; }
    void open() override;
    void close() override;
    void send() override;
    [[nodiscard]] Result<> admits(const Request& request) const override { return m_care.admits(request); }
    [[nodiscard]] Result<> carryOut(const Request& request) override;
    void profileChanged(const profile::Profile& before, const profile::Profile& after) override
    {
        m_care.profileChanged(before, after);
    }
    void setCourse(const std::optional<SensorCourse>& course) override { m_mount.setCourse(course); }
    [[nodiscard]] contacts::InputReading pin(const contacts::BoardPin& pin) const override
    {
        return m_pins.read(pin, m_clock.now());
    }
    [[nodiscard]] std::unique_ptr<outputs::Output> pinOutput(const contacts::BoardPin& pin) override;
    void describe(StationStatus& status) const override;

private:
    [[nodiscard]] TurnKeeper::Start remembered(const MountStart& start);
    void showBus(const LinkStatus& status);
    void watchJournal();
    [[nodiscard]] bool isLineOpen() const;
    void addOutputs(std::vector<CanFrame>& frames);

    const Clock& m_clock;
    EventLog& m_log;
    AlarmBoard& m_alarms;
    // A simulated mount starts with the program and is where its drives report it. So it needs no position journal.
    const bool m_simulated;
    journal::JournalFile m_journalFile;
    Result<> m_claim;  // of the position journal
    MoteusMount m_mount;
    DriveCare m_care;
    BoardPins m_pins;
    std::vector<QPointer<BoardOutput>> m_outputs;  // the station owns them
    std::unique_ptr<CanLink> m_link;
    bool m_closed = false;  // and not opened again
};

// The moteus drives of the axes in `start` behind `link`.
[[nodiscard]] MountMaker moteusRotator(std::unique_ptr<CanLink> link, const MountStart& start);

}  // namespace boresight
