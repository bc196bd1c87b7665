// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/profile/profile_store.h"
#include "core/station/adapters.h"
#include "tests/ui/window_fixture.h"
#include "ui/kit/asking_panel.h"
#include "ui/kit/command_button.h"

#include <QComboBox>
#include <QListWidget>
#include <QPlainTextEdit>
#include <QTemporaryDir>

// A window of a program that was started with --simulate: it says that no bus of another mount will be used.
namespace boresight::ui {
namespace {

struct TwoMounts
{
    TwoMounts()
    {
        real.mount.name = "Field";
        real.bus = "fdcanusb:/dev/field";
        (void)profile::ProfileStore(folder.path()).add(profile::Profile{});
        (void)profile::ProfileStore(folder.path()).add(real);
    }

    QTemporaryDir folder;
    profile::Profile real;
};

WindowSettings simulatedWith(const TwoMounts& mounts)
{
    WindowSettings settings;
    settings.configDir = mounts.folder.path();
    settings.onlySimulated = true;
    return settings;
}

class OnlySimulatedTest : public TwoMounts, public WindowFixture
{
protected:
    OnlySimulatedTest() : WindowFixture(simulatedWith(*this)) {}
};

// REQ-UI-38 (OnlySimulatedTest.*): Started with --simulate, the window says that no bus of another mount is used, and
// offers no adapter.
TEST_F(OnlySimulatedTest, TheQuestionBeforeASwitchSaysThatTheOtherBusIsNotUsed)
{
    openPanel('8');
    auto* const mounts = named<QComboBox>("Stored mounts");
    ASSERT_TRUE(comesTrue([&] { return mounts->count() == 2; }));
    mounts->setCurrentIndex(mounts->findText(QStringLiteral("Field")));
    QTest::mouseClick(named<CommandButton>("Switch …"), Qt::LeftButton);
    const QString says = QStringLiteral(
        "Bus: simulated, because Boresight was started with --simulate. "
        "The bus of this mount, fdcanusb:/dev/field, is not used.");
    const auto isAsked = [&] {
        for (const QPlainTextEdit* const one : window.findChildren<QPlainTextEdit*>()) {
            if (one->isVisible() && one->toPlainText().startsWith(says)) {
                return true;
            }
        }
        return false;
    };
    EXPECT_TRUE(comesTrue(isAsked));
}

TEST_F(OnlySimulatedTest, TheTagSaysHowLongAndTheGuideOffersNoAdapter)
{
    EXPECT_EQ(text("Simulated mount"), QStringLiteral("SIMULATED"));
    EXPECT_TRUE(named<ValueLabel>("Simulated mount")->toolTip().contains(QStringLiteral("--simulate")));
    QTest::keyClick(&window, Qt::Key_F3);
    Q_EMIT window.host().adaptersFound(adaptersOf({}, {{QStringLiteral("can0"), false}}));
    auto* const adapters = named<QListWidget>("Adapters of this computer");
    for (int row = 0; row < adapters->count(); ++row) {
        if (adapters->item(row)->toolTip() == QStringLiteral("socketcan:can0")) {
            adapters->setCurrentRow(row);
        }
    }
    const auto* const use = named<CommandButton>("Connect");
    EXPECT_FALSE(use->isEnabled());
    EXPECT_TRUE(use->toolTip().contains(QStringLiteral("start Boresight with --bus socketcan:can0")))
        << use->toolTip().toStdString();
}

}  // namespace
}  // namespace boresight::ui
