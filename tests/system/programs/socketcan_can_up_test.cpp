// SPDX-License-Identifier: GPL-3.0-or-later
// packaging/can-up with a stand-in for "ip" that answers like Debian 12's for a real adapter, which test computers
// seldom have. socketcan_system_test.cpp tests it on a virtual interface and on a real kernel.
#include "core/can/bit_timing.h"
#include "tests/fakes/program.h"

#include <QFile>
#include <QTemporaryDir>

#include <gmock/gmock.h>

namespace boresight::system_test {
namespace {

using testing::HasSubstr;
using testing::Not;

// Stores its arguments in $FAKE_IP/asked. "link set … down" fails if $FAKE_IP/denied exists. "… up type can" fails with
// the text in $FAKE_IP/refusal if there is one, or when dsjw is above $FAKE_IP/largest_dsjw.
constexpr const char* kFakeIp = R"(#!/usr/bin/env bash
case "$*" in
    "-details link show dev can0") cat "$FAKE_IP/details" ;;
    "-details link show dev"*) echo "Device \"$5\" does not exist." >&2; exit 1 ;;
    "link set can0 down") [[ ! -e $FAKE_IP/denied ]] || { echo "RTNETLINK answers: Operation not permitted" >&2; exit 2; } ;;
    "link set can0 up type can"*)
        echo "ip $*" >>"$FAKE_IP/asked"
        if [[ -e $FAKE_IP/refusal ]]; then cat "$FAKE_IP/refusal" >&2; exit 2; fi
        if [[ $* =~ \ dsjw\ ([0-9]+) && ${BASH_REMATCH[1]} -gt $(cat "$FAKE_IP/largest_dsjw") ]]; then
            echo "RTNETLINK answers: Invalid argument" >&2
            exit 2
        fi
        sed -i 's/<NOARP,ECHO>/<NOARP,UP,LOWER_UP,ECHO>/; s/mtu 16/mtu 72/; s/state STOPPED/state ERROR-ACTIVE/' \
            "$FAKE_IP/details" ;;
    *) echo "fake ip: $*" >&2; exit 9 ;;
esac
)";

constexpr const char* kDetails =
    R"(3: can0: <NOARP,ECHO> mtu 16 qdisc pfifo_fast state DOWN mode DEFAULT group default qlen 10
    link/can  promiscuity 0  allmulti 0 minmtu 0 maxmtu 0 
    can <FD> state STOPPED (berr-counter tx 0 rx 0) restart-ms 1000 
	  bitrate 1000000 sample-point 0.662 
	  tq 12 prop-seg 26 phase-seg1 26 phase-seg2 27 sjw 10 brp 1
	  gs_usb: tseg1 1..256 tseg2 1..128 sjw 1..128 brp 1..512 brp_inc 1
	  dbitrate 5000000 dsample-point 0.625 
	  dtq 12 dprop-seg 4 dphase-seg1 5 dphase-seg2 6 dsjw 5 dbrp 1
	  gs_usb: dtseg1 1..32 dtseg2 1..16 dsjw 1..16 dbrp 1..32 dbrp_inc 1
	  clock 80000000 numtxqueues 1 numrxqueues 1 gso_max_size 65536 gso_max_segs 65535 
)";

class CanUpTest : public testing::Test
{
protected:
    void SetUp() override
    {
        put("ip", kFakeIp);
        QFile::setPermissions(m_folder.filePath(QStringLiteral("ip")),
                              QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner);
        put("largest_dsjw", "16");
        details = kDetails;
    }
    void put(const char* name, const QByteArray& text) const
    {
        QFile file(m_folder.filePath(QString::fromLatin1(name)));
        ASSERT_TRUE(file.open(QIODevice::WriteOnly) && file.write(text) == text.size());
    }
    [[nodiscard]] QStringList asked() const
    {
        QFile file(m_folder.filePath(QStringLiteral("asked")));
        static_cast<void>(file.open(QIODevice::ReadOnly));
        return QString::fromUtf8(file.readAll()).split(QLatin1Char('\n'), Qt::SkipEmptyParts);
    }
    // The exit status and the output.
    std::pair<int, std::string> canUp(const QString& interface = QStringLiteral("can0")) const
    {
        put("details", details);
        const QString path = m_folder.path() + QLatin1Char(':') + qEnvironmentVariable("PATH");
        fakes::Program program(QStringLiteral("env"),
                               {QStringLiteral("PATH=") + path, QStringLiteral("FAKE_IP=") + m_folder.path(),
                                QStringLiteral(CAN_UP), interface});
        const int status = program.waitForEnd();
        return {status, program.errors().toStdString()};
    }

    QByteArray details;

private:
    QTemporaryDir m_folder;
};

TEST_F(CanUpTest, SetsWhatTheProgramAsksForAndChecksIt)
{
    const auto [status, words] = canUp();
    EXPECT_EQ(status, 0) << words;
    EXPECT_EQ(asked(), QStringList{socketcan::bringUpCommand(QStringLiteral("can0"), false)});
    EXPECT_THAT(words, HasSubstr("right: bit rate 1000000"));
    EXPECT_THAT(words, HasSubstr("right: data sample point 0.625 (wanted 0.666)"));
    EXPECT_THAT(words, HasSubstr("can0 is ready: --bus socketcan:can0"));
    EXPECT_THAT(words, Not(HasSubstr("WRONG")));
}

// With an adapter of 40 MHz a fast bit has 8 time quanta, and 3 of them are after the sample point.
TEST_F(CanUpTest, TakesTheLargestJumpWidthThatIsNotRefused)
{
    put("largest_dsjw", "3");
    const auto [status, words] = canUp();
    EXPECT_EQ(status, 0) << words;
    EXPECT_THAT(words, HasSubstr("refuses the jump widths 10 and 5. It accepted 10 and 3"));
    EXPECT_THAT(asked().last().toStdString(), HasSubstr(" sjw 10 dsjw 3 sample-point 0.666 "));
}

TEST_F(CanUpTest, AsksForNoMoreThanTheAdapterTells)
{
    details.replace("sjw 1..128", "sjw 1..4").replace("dsjw 1..16", "dsjw 1..2");
    put("largest_dsjw", "2");
    const auto [status, words] = canUp();
    EXPECT_EQ(status, 0) << words;
    ASSERT_EQ(asked().size(), 2);
    EXPECT_THAT(asked().last().toStdString(), HasSubstr(" sjw 4 dsjw 2 "));
}

TEST_F(CanUpTest, SaysWhatTheKernelMadeOfItOtherwise)
{
    details.replace("dsample-point 0.625", "dsample-point 0.750").replace("bitrate 1000000", "bitrate 500000");
    const auto [status, words] = canUp();
    EXPECT_EQ(status, 1);
    EXPECT_THAT(words, HasSubstr("WRONG: data sample point 0.750 (wanted 0.666)"));
    EXPECT_THAT(words, HasSubstr("WRONG: bit rate 500000 (wanted 1000000)"));
    EXPECT_THAT(words, HasSubstr("can0 is up, but 2 of its settings are wrong"));
}

TEST_F(CanUpTest, BusOffAndClassicModeAreWrong)
{
    details.replace("can <FD> state STOPPED", "can state BUS-OFF");
    const auto [status, words] = canUp();
    EXPECT_EQ(status, 1);
    EXPECT_THAT(words, HasSubstr("WRONG: CAN-FD is on"));
    EXPECT_THAT(words, HasSubstr("WRONG: controller BUS-OFF"));
}

TEST_F(CanUpTest, AdapterThatRefusesEverythingIsToldWithTheKernelsWords)
{
    put("refusal", "RTNETLINK answers: Operation not supported\n");
    const auto [status, words] = canUp();
    EXPECT_EQ(status, 1);
    EXPECT_THAT(words, HasSubstr("can0: RTNETLINK answers: Operation not supported"));
    EXPECT_THAT(words, HasSubstr("without CAN-FD"));
}

TEST_F(CanUpTest, NeedsRootAndAnInterface)
{
    put("denied", "");
    EXPECT_THAT(canUp().second, HasSubstr("Run as root: sudo packaging/can-up can0"));
    const auto [status, words] = canUp(QStringLiteral("can7"));
    EXPECT_EQ(status, 1);
    EXPECT_THAT(words, HasSubstr("there is no interface can7. Is the adapter plugged in"));
}

}  // namespace
}  // namespace boresight::system_test
