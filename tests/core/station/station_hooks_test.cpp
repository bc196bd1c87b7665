// SPDX-License-Identifier: GPL-3.0-or-later
// The hooks start real programs.
#include "core/station/station_hooks.h"

#include "tests/fakes/manual_clock.h"
#include "tests/fakes/wait_until.h"

#include <QFile>
#include <QTemporaryDir>

#include <gmock/gmock.h>

#include <algorithm>

namespace boresight {
namespace {

using testing::HasSubstr;

profile::Profile running(const profile::PassHooks& hooks)
{
    profile::Profile profile;
    profile.mount.name = "roof";
    profile.schedule.hooks = hooks;
    return profile;
}

struct HooksRig
{
    explicit HooksRig(const profile::PassHooks& wanted) : inForce(running(wanted)) {}
    // Reports the moment, and returns the log line about the end of the program.
    std::string tell(const schedule::PassMoment& moment)
    {
        const std::uint64_t before = log.lastNumber();
        hooks.tell(moment);
        EXPECT_TRUE(fakes::waitUntil([&] { return log.lastNumber() > before; }));
        const LogEntry line = log.since(before, 1).back();
        warned = line.severity == Severity::Warning;
        return line.text.toStdString();
    }

    profile::InForce inForce;
    fakes::ManualClock clock;
    EventLog log{clock};
    StationBroker broker{inForce, log, clock, nullptr};
    StationHooks hooks{inForce, false, log, broker, nullptr};
    bool warned = false;
};

// REQ-HOOKS-14: The program of a moment receives the facts in variables such as BORESIGHT_EVENT. A fact that does not
// apply is empty. The end of the program is one line in the log, as a warning if the program failed. Without a program
// nothing is started.
TEST(StationHooks, RunTheProgramOfTheMoment)
{
    const QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("facts"));
    HooksRig rig({.aos = {"/bin/sh", "-c", "env | grep ^BORESIGHT_ | sort >\"$0\"", file.toStdString()},
                  .los = {"/no/such/program"}});
    schedule::WatchedPass pass{.number = 25544, .priority = 2, .name = QStringLiteral("ISS (ZARYA)")};
    pass.pass.tca.direction.elevation = 45.2_deg;
    rig.hooks.tell({.moment = schedule::Moment::BeforeAos, .pass = pass});
    rig.hooks.tell({.moment = schedule::Moment::Fault});
    EXPECT_THAT(rig.tell({.moment = schedule::Moment::Aos, .utc = rig.clock.utc(), .pass = pass}),
                HasSubstr("/bin/sh ended after "));
    EXPECT_FALSE(rig.warned);
    QFile facts(file);
    ASSERT_TRUE(facts.open(QIODevice::ReadOnly));
    const std::string read = facts.readAll().toStdString();
    for (const char* const line :
         {"BORESIGHT_EVENT=aos\n", "BORESIGHT_SATELLITE=ISS (ZARYA)\n", "BORESIGHT_NORAD=25544\n",
          "BORESIGHT_PRIORITY=2\n", "BORESIGHT_MAX_EL=45.2\n", "BORESIGHT_MOUNT=roof\n", "BORESIGHT_SIMULATED=false\n",
          "BORESIGHT_UTC=2026-11-21T00:00:00Z\n", "BORESIGHT_END=\n", "BORESIGHT_WHY=\n"}) {
        EXPECT_THAT(read, HasSubstr(line));
    }
    EXPECT_EQ(rig.tell({.moment = schedule::Moment::Los, .pass = pass}),
              "/no/such/program could not be started: No such file or directory");
    EXPECT_TRUE(rig.warned);
}

}  // namespace
}  // namespace boresight
