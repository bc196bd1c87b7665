// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/kit/focus_frame.h"

#include "ui/kit/theme.h"

#include <QAbstractScrollArea>
#include <QApplication>
#include <QEvent>
#include <QPainter>

namespace boresight::ui {

namespace {

constexpr int kFocusFrameWidth = 2;  // px

class Frame : public QWidget
{
public:
    explicit Frame(QWidget* around) : QWidget(around)
    {
        setAttribute(Qt::WA_TransparentForMouseEvents);
        around->installEventFilter(this);
        fit();
        raise();
        show();
    }

protected:
    bool eventFilter(QObject* watched, QEvent* event) override
    {
        if (event->type() == QEvent::Resize) {
            fit();
        }
        return QWidget::eventFilter(watched, event);
    }
    void paintEvent(QPaintEvent*) override { QPainter(this).fillRect(rect(), currentTheme().accent); }

private:
    void fit()
    {
        setGeometry(parentWidget()->rect());
        setMask(QRegion(rect()) -
                rect().adjusted(kFocusFrameWidth, kFocusFrameWidth, -kFocusFrameWidth, -kFocusFrameWidth));
    }
};

}  // namespace

FocusFrame::FocusFrame(QObject* parent) : QObject(parent)
{
    connect(qApp, &QApplication::focusChanged, this, [this](QWidget*, QWidget* now) { follow(now); });
}

void FocusFrame::follow(QWidget* focused)
{
    if (m_frame != nullptr) {
        m_frame->hide();
        m_frame->deleteLater();
    }
    auto* const area = qobject_cast<QAbstractScrollArea*>(focused);
    m_frame = area != nullptr ? new Frame(area) : nullptr;
}

}  // namespace boresight::ui

#include "moc_focus_frame.cpp"
