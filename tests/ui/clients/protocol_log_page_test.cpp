// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/clients/protocol_log_page.h"

#include "core/messages/protocol_line.h"
#include "tests/ui/window_fixture.h"
#include "ui/clients/clients_panel.h"
#include "ui/kit/theme.h"

#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QFile>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QTableView>
#include <QTemporaryDir>

namespace boresight::ui {
namespace {

ProtocolLine protocolLine(std::uint64_t number, std::uint64_t client = 1)
{
    return {.number = number,
            .utc = UtcTime(std::chrono::milliseconds(1795000000123)),
            .clientId = client,
            .client = QStringLiteral("rotctld 127.0.0.1:%1").arg(51233 + client),
            .line = protocolBytes("P 113 10"),
            .acts = {{.kind = ProtocolAct::Kind::Point, .azimuth = 113_deg, .elevation = 10_deg}},
            .answer = protocolBytes("RPRT 0\n")};
}

ProtocolLine oddLine(std::uint64_t number, std::uint64_t client)
{
    ProtocolLine line = protocolLine(number, client);
    line.line = protocolBytes("\x1b[A");
    line.acts.clear();
    line.outcome = ProtocolOutcome::NotUnderstood;
    line.answer = {};
    line.odd = true;
    return line;
}

// The page with the protocol log, opened with the mouse.
class ProtocolLogPageTest : public WindowFixture
{
protected:
    ProtocolLogPageTest()
    {
        openPanel('4');
        QTest::mouseClick(named<QPushButton>("Protocol log"), Qt::LeftButton);
    }
    void log(std::vector<ProtocolLine> lines, bool on = true)
    {
        StationStatus status = samples::fighting();
        status.isProtocolLogged = on;
        StationUpdate update = samples::update(status);
        update.protocol = std::make_shared<const std::vector<ProtocolLine>>(std::move(lines));
        give(update);
    }
    std::vector<ProtocolLine> numbered(std::uint64_t first, std::uint64_t last)
    {
        std::vector<ProtocolLine> lines;
        for (std::uint64_t number = first; number <= last; ++number) {
            lines.push_back(protocolLine(number));
        }
        return lines;
    }
    ProtocolLogPage& page() { return *window.findChild<ProtocolLogPage*>(); }
    ClientsPanel& clients() { return *window.findChild<ClientsPanel*>(); }
    int rows() { return page().shown().rowCount(); }
    QString cell(int row, int column, int role = Qt::DisplayRole)
    {
        return page().shown().index(row, column).data(role).toString();
    }
    QString state() { return text("State of the protocol log"); }
    QPushButton& button(const char* label)
    {
        for (QPushButton* const one : page().findChildren<QPushButton*>()) {
            if (one->text() == QString::fromUtf8(label)) {
                return *one;
            }
        }
        ADD_FAILURE() << "no button " << label;
        return *page().findChild<QPushButton*>();
    }
};

// REQ-UI-1810: The page Clients has a protocol log. It is off until the operator begins it, and shows that it is on
// only when the station says so.
TEST_F(ProtocolLogPageTest, BeginsAndEndsWithItsButton)
{
    ASSERT_TRUE(page().isVisible());
    EXPECT_FALSE(clients().isVisible());
    EXPECT_EQ(state().toStdString(), "Log off");
    QTest::mouseClick(&button("Begin log"), Qt::LeftButton);
    ASSERT_EQ(asked<request::LogProtocol>().size(), 1U);
    EXPECT_TRUE(asked<request::LogProtocol>().front().on);
    EXPECT_EQ(state().toStdString(), "Log off") << "the station has not answered yet";
    StationUpdate update = samples::update(samples::fighting());
    update.status.isProtocolLogged = true;
    update.answers = {{.requestId = requests.back().id}};
    give(update);
    EXPECT_EQ(state().toStdString(), "Log on, lines: 0, older lines dropped: 0");
    QTest::mouseClick(&button("End log"), Qt::LeftButton);
    ASSERT_EQ(asked<request::LogProtocol>().size(), 2U);
    EXPECT_FALSE(asked<request::LogProtocol>().back().on);
}

// REQ-UI-1811: The protocol log works by the keyboard alone: its button, the way back, and the choice of a client.
TEST_F(ProtocolLogPageTest, WorksByTheKeyboard)
{
    EXPECT_EQ(QApplication::focusWidget(), &button("Begin log"));
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Space);
    EXPECT_EQ(asked<request::LogProtocol>().size(), 1U);
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab, Qt::ShiftModifier);
    EXPECT_EQ(QApplication::focusWidget(), &button("Clients"));
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Space);
    EXPECT_TRUE(clients().isVisible());
    EXPECT_FALSE(page().isVisible());
    EXPECT_EQ(QApplication::focusWidget(), named<QPushButton>("Protocol log"));
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Space);
    EXPECT_TRUE(page().isVisible());
}

// REQ-UI-1812: Each line of the protocol log has its time to the millisecond, the client, the bytes as received, what
// Boresight understood, and the answer. Odd lines have a symbol and the colour of a warning. The selected line is shown
// complete below the list.
TEST_F(ProtocolLogPageTest, ShowsLineMeaningAndAnswer)
{
    log({protocolLine(1), oddLine(2, 2)});
    ASSERT_EQ(rows(), 2);
    EXPECT_EQ(cell(0, ProtocolLogModel::Time).toStdString(), "11:06:40.123");
    EXPECT_EQ(cell(0, ProtocolLogModel::Client).toStdString(), "rotctld :51234");
    EXPECT_EQ(cell(0, ProtocolLogModel::Line).toStdString(), "P 113 10");
    EXPECT_EQ(cell(0, ProtocolLogModel::Understood).toStdString(), "go to 113.0° / 10.0°");
    EXPECT_EQ(cell(0, ProtocolLogModel::Answer).toStdString(), "RPRT 0");
    EXPECT_EQ(cell(1, ProtocolLogModel::Line).toStdString(), "▲ \\x1b[A");
    EXPECT_EQ(cell(1, ProtocolLogModel::Understood).toStdString(), "not understood");
    EXPECT_EQ(page().shown().index(1, 0).data(Qt::ForegroundRole).value<QColor>(), currentTheme().warning);
    auto& table = *page().findChild<QTableView*>();
    QTest::mouseClick(table.viewport(), Qt::LeftButton, {}, table.visualRect(table.model()->index(1, 0)).center());
    EXPECT_EQ(
        page().findChild<QPlainTextEdit*>()->toPlainText().toStdString(),
        "11:06:40.123Z  rotctld 127.0.0.1:51235, odd command\nLine: \\x1b[A\nUnderstood: not understood\nAnswer: ");
}

// REQ-UI-1813: The lines of the protocol log can be filtered by client. The list offers the 20 newest clients, and
// keeps the chosen one.
TEST_F(ProtocolLogPageTest, FiltersByClient)
{
    log({protocolLine(1, 1), oddLine(2, 2), protocolLine(3, 1)});
    auto& choice = *named<QComboBox>("Filter by client");
    ASSERT_EQ(choice.count(), 3);
    EXPECT_EQ(choice.itemText(1).toStdString(), "rotctld 127.0.0.1:51235") << "the newest first";
    choice.setFocus();
    QTest::keyClick(&choice, Qt::Key_Down);
    EXPECT_EQ(rows(), 1);
    QTest::keyClick(&choice, Qt::Key_Down);
    EXPECT_EQ(rows(), 2);
    std::vector<ProtocolLine> many;
    for (std::uint64_t client = 10; client < 60; ++client) {
        many.push_back(protocolLine(client, client));
    }
    log(many);
    EXPECT_EQ(choice.count(), 21);
    EXPECT_EQ(choice.currentText().toStdString(), "rotctld 127.0.0.1:51234");
    EXPECT_EQ(rows(), 2);
    choice.setCurrentIndex(0);
    EXPECT_EQ(rows(), 53);
}

// REQ-UI-1814: The page keeps the newest 2000 lines of the protocol log and shows how many older ones were dropped,
// also after a stall. The lines of a new station replace those of the station before.
TEST_F(ProtocolLogPageTest, IsBounded)
{
    log(numbered(1, 1500));
    EXPECT_EQ(state().toStdString(), "Log on, lines: 1500, older lines dropped: 0");
    log(numbered(1501, 2600));
    EXPECT_EQ(rows(), 2000);
    EXPECT_EQ(state().toStdString(), "Log on, lines: 2000, older lines dropped: 600");
    log(numbered(8001, 10000));
    EXPECT_EQ(rows(), 2000);
    EXPECT_EQ(state().toStdString(), "Log on, lines: 2000, older lines dropped: 8000");
    log(numbered(1, 3), false);
    EXPECT_EQ(rows(), 3);
    EXPECT_EQ(state().toStdString(), "Log off, lines: 3, older lines dropped: 0");
}

// REQ-UI-1815: The lines of the protocol log can be copied, and saved to a text file.
TEST_F(ProtocolLogPageTest, IsCopiedAndSaved)
{
    log({protocolLine(1), oddLine(2, 2)});
    const std::string saved =
        "2026-11-18T11:06:40.123Z\trotctld 127.0.0.1:51234\t-\tP 113 10\tgo to 113.0° / 10.0°\tRPRT 0\n"
        "2026-11-18T11:06:40.123Z\trotctld 127.0.0.1:51235\todd\t\\x1b[A\tnot understood\t\n";
    QTest::mouseClick(&button("Copy"), Qt::LeftButton);
    EXPECT_EQ(QApplication::clipboard()->text().toStdString(), saved);
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("protocol.txt"));
    QTest::mouseClick(&button("File …"), Qt::LeftButton);
    chooseFile(path);
    QFile file(path);
    ASSERT_TRUE(file.open(QIODevice::ReadOnly));
    EXPECT_EQ(file.readAll().toStdString(), saved);
}

}  // namespace
}  // namespace boresight::ui
