// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/replay/replay_window.h"

#include "ui/kit/format.h"
#include "ui/kit/push_button.h"
#include "ui/kit/read_table.h"
#include "ui/kit/value_label.h"
#include "ui/replay/moment_numbers.h"
#include "ui/replay/play_bar.h"
#include "ui/replay/recorded_status.h"
#include "ui/replay/recording_band.h"
#include "ui/replay/replay_charts.h"
#include "ui/replay/time_slider.h"
#include "ui/sky/plot_tools.h"
#include "ui/sky/polar_plot.h"

#include <QGridLayout>
#include <QHeaderView>
#include <QIcon>
#include <QKeyEvent>
#include <QPushButton>
#include <QTableView>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace boresight::ui {

namespace {

constexpr QSize kReplaySize{1180, 720};
constexpr std::chrono::seconds kKeyStep{1};
// A longer step would leave corners, or a gap, in the trail.
constexpr UtcTime::duration kTrailJump = std::chrono::milliseconds(500);

}  // namespace

ReplayWindow::ReplayWindow(const Clock& clock, SharedTape tape, QWidget* parent)
    : QWidget(parent, Qt::Window),
      m_tape(std::move(tape)),
      m_profile(recordedProfile(m_tape->header())),
      m_player(clock, m_tape->begin(), m_tape->end(), this),
      m_events(m_tape),
      m_plot(new PolarPlot(m_draft, m_desk, this)),
      m_numbers(new MomentNumbers(this)),
      m_charts(new ReplayCharts(m_tape, this)),
      m_table(makeReadTable(tr("Events of the recording"), m_events, this)),
      m_why(new ValueLabel(tr("Why the mount moved"), fonts::label(), {}, this)),
      m_bar(new PlayBar(m_player, motionStarts(), this))
{
    setAttribute(Qt::WA_DeleteOnClose);
    setWindowTitle(title());
    setWindowIcon(QIcon(QStringLiteral(":/boresight/icons/boresight.svg")));
    build();
    connect(&m_player, &ReplayPlayer::moved, this, &ReplayWindow::showMoment);
    connect(&m_player, &ReplayPlayer::changed, this, &ReplayWindow::showMoment);
    resize(kReplaySize);
    m_bar->slider().setFocus();
}

ReplayWindow::~ReplayWindow() = default;

QString ReplayWindow::title() const
{
    const recording::Header& header = m_tape->header();
    const QString of = header.target.isEmpty() ? tr("the mount") : header.target;
    return tr("Recording of %1, %2").arg(of, minuteText(m_tape->begin()));
}

QString ReplayWindow::detail() const
{
    const recording::Header& header = m_tape->header();
    QString text = header.isSimulated ? tr("%1, simulated").arg(header.mount) : header.mount;
    if (header.part > 1) {
        text += QStringLiteral(", ") + tr("part %1").arg(header.part);
    }
    return text;
}

std::vector<UtcTime> ReplayWindow::motionStarts() const
{
    std::vector<UtcTime> starts;
    for (const recording::Event& event : m_tape->events()) {
        if (event.kind == recording::EventKind::MotionStart) {
            starts.push_back(std::clamp(event.utc, m_tape->begin(), m_tape->end()));
        }
    }
    return starts;
}

void ReplayWindow::build()
{
    auto* const grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 8);
    grid->setSpacing(4);
    grid->addWidget(new RecordingBand(title(), detail(), this), 0, 0, 1, 2);
    auto* const remarks = new ValueLabel(tr("What is missing in the recording"), fonts::label(), {}, this);
    remarks->setWrapping(true);
    remarks->setCollapsing(true);
    remarks->setStretching(true);
    remarks->setValue(m_tape->remarks().join(QLatin1Char(' ')), Tone::Warning,
                      m_tape->remarks().isEmpty() ? Symbol::None : Symbol::Warning);
    grid->addWidget(remarks, 1, 0, 1, 2);
    grid->addWidget(makeSky(), 2, 0);
    grid->addWidget(makeEvents(), 2, 1);
    m_bar->setContentsMargins(8, 0, 8, 0);
    grid->addWidget(m_bar, 3, 0, 1, 2);
    grid->setRowStretch(2, 1);
    grid->setColumnStretch(0, 5);
    grid->setColumnStretch(1, 6);
}

QWidget* ReplayWindow::makeSky()
{
    m_plot->tools().hideEditing();
    m_plot->setContextMenuPolicy(Qt::NoContextMenu);  // its commands are for the station
    m_plot->markers().setToolTip(tr("North is up, east is right, the zenith is in the centre."));
    m_plot->markers().unsetCursor();
    auto* const box = new QWidget(this);
    auto* const column = new QVBoxLayout(box);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(m_plot, 1);
    column->addWidget(m_numbers);
    return box;
}

QWidget* ReplayWindow::makeEvents()
{
    m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_table->horizontalHeader()->setStretchLastSection(true);
    m_table->setToolTip(tr("A click, or Enter, jumps to the event"));
    m_table->installEventFilter(this);
    const auto jump = [this](const QModelIndex& index) { jumpTo(static_cast<std::size_t>(index.row())); };
    connect(m_table, &QTableView::clicked, this, jump);
    auto* const why = makePushButton(
        {.text = tr("Why did it move?"),
         .name = {},
         .help = tr("Jump to the last start of a motion before this moment. Press again for the one before (W)")},
        this);
    why->setFocusPolicy(Qt::TabFocus);
    connect(why, &QPushButton::clicked, this, &ReplayWindow::showWhyItMoved);
    m_why->setStretching(true);
    m_why->setLines(2);
    auto* const row = new QHBoxLayout;
    row->addWidget(why);
    row->addWidget(m_why, 1);
    auto* const box = new QWidget(this);
    auto* const column = new QVBoxLayout(box);
    column->setContentsMargins(0, 0, 8, 0);
    column->addWidget(m_charts, 3);
    column->addLayout(row);
    column->addWidget(m_table, 2);
    return box;
}

// Keys that the focused widget has not used.
void ReplayWindow::keyPressEvent(QKeyEvent* event)
{
    if (!act(event->key())) {
        QWidget::keyPressEvent(event);
    }
}

// The table would use these keys for its cells.
bool ReplayWindow::eventFilter(QObject* watched, QEvent* event)
{
    if (watched != m_table || event->type() != QEvent::KeyPress) {
        return QWidget::eventFilter(watched, event);
    }
    const int key = static_cast<QKeyEvent*>(event)->key();
    if ((key == Qt::Key_Return || key == Qt::Key_Enter) && m_table->currentIndex().isValid()) {
        jumpTo(static_cast<std::size_t>(m_table->currentIndex().row()));
        return true;
    }
    return act(key);
}

// The first moment, too, is shown here: sky and charts are drawn for their size, which they have after the layout.
// While the replay pauses, nobody else draws them again.
void ReplayWindow::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    QMetaObject::invokeMethod(this, &ReplayWindow::showMoment, Qt::QueuedConnection);
}

// True if the key does something.
bool ReplayWindow::act(int key)
{
    switch (key) {
        case Qt::Key_Space:
            m_player.play(!m_player.isPlaying());
            return true;
        case Qt::Key_Left:
            m_player.step(-kKeyStep);
            return true;
        case Qt::Key_Right:
            m_player.step(kKeyStep);
            return true;
        case Qt::Key_Home:
            m_player.jumpTo(m_player.begin());
            return true;
        case Qt::Key_End:
            m_player.jumpTo(m_player.end());
            return true;
        case Qt::Key_Plus:
        case Qt::Key_Equal:  // the same key without Shift
            m_player.changeSpeed(1);
            return true;
        case Qt::Key_Minus:
            m_player.changeSpeed(-1);
            return true;
        case Qt::Key_W:
            showWhyItMoved();
            return true;
        case Qt::Key_Escape:
            close();
            return true;
        default:
            return false;
    }
}

// An event before the first tick is shown at the first tick.
UtcTime ReplayWindow::momentOf(std::size_t event) const
{
    return std::clamp(m_tape->events()[event].utc, m_tape->begin(), m_tape->end());
}

void ReplayWindow::jumpTo(std::size_t event)
{
    m_player.play(false);
    m_player.jumpTo(momentOf(event));
    m_table->selectRow(static_cast<int>(event));  // several events may have the same time
}

void ReplayWindow::showWhyItMoved()
{
    const bool isShown = m_answer && momentOf(*m_answer) == m_player.moment();
    const auto found = m_tape->motionStartAt(m_player.moment(), isShown ? m_answer : std::nullopt);
    if (!found) {
        m_player.play(false);
        m_why->setValue(isShown ? tr("This is the first motion of the recording. %1")
                                      .arg(RecordedEventModel::sentence(m_tape->events()[*m_answer]))
                                : tr("No motion began before this moment of the recording."),
                        Tone::Secondary);
        return;
    }
    jumpTo(*found);
    m_answer = found;
    m_why->setValue(RecordedEventModel::sentence(m_tape->events()[*found]), Tone::Accent);
}

void ReplayWindow::showMoment()
{
    const UtcTime moment = m_player.moment();
    const StationStatus status = recordedStatus(*m_tape, m_profile, moment);
    const recording::Tick* const tick = m_tape->tickAt(moment);
    showSky(status);
    m_charts->show(status);
    m_numbers->show(status, tick != nullptr ? m_tape->header().stateWord(tick->state) : QString(),
                    tick != nullptr ? tick->error : std::nullopt);
    selectEvent(moment);
}

// The plot adds the place of the beam to its trail. After a jump, and between the pictures of a fast replay, it needs
// the places before.
void ReplayWindow::showSky(const StationStatus& status)
{
    m_plot->showStatus(status);
    if (!m_trailUntil || status.utc < *m_trailUntil || status.utc - *m_trailUntil > kTrailJump) {
        m_plot->markers().setTrail(recordedTrail(*m_tape, status.utc), status.utc);
    }
    m_trailUntil = status.utc;
    if (!m_player.isPlaying()) {
        m_plot->describe(status);  // a screen reader does not follow a running replay
    }
}

// The newest event at this moment is selected.
void ReplayWindow::selectEvent(UtcTime moment)
{
    const auto event = m_tape->eventAt(moment);
    if (!event) {
        m_table->clearSelection();
    } else if (m_table->currentIndex().row() != static_cast<int>(*event) ||
               !m_table->selectionModel()->hasSelection()) {
        m_table->selectRow(static_cast<int>(*event));
        m_table->scrollTo(m_events.index(static_cast<int>(*event), 0));
    }
}

}  // namespace boresight::ui

#include "moc_replay_window.cpp"
