// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/picture_book.h"

#include "ui/window/axis_readout.h"
#include "ui/window/header_bar.h"

#include <QDir>
#include <QImage>
#include <QPushButton>
#include <QTabBar>
#include <QToolButton>

namespace boresight::ui {

namespace {

struct View
{
    const char* name;
    QSize size;
    int scale;
};

// The smallest window, the smallest one on a screen with twice the resolution, the usual one, and a wide one.
constexpr View kViews[] = {{"1024x700", {1024, 700}, 1},
                           {"200", {1024, 700}, 2},
                           {"1280x800", {1280, 800}, 1},
                           {"1920x1080", {1920, 1080}, 1}};

constexpr Seconds kPast{400.0};

QList<const ValueLabel*> headerAndAxes(const QWidget& window)
{
    QStringList sentences{HeaderBar::tr("Reason of the state"), HeaderBar::tr("Target and its source")};
    for (const char* const axis : {"azimuth", "elevation"}) {
        sentences << AxisReadout::tr("Detail of %1").arg(QCoreApplication::translate("Axes", axis));
    }
    QList<const ValueLabel*> labels;
    for (const QWidget* const part : {static_cast<QWidget*>(window.findChild<HeaderBar*>()),
                                      static_cast<QWidget*>(window.findChild<AxisReadout*>())}) {
        for (const ValueLabel* const label : part->findChildren<ValueLabel*>()) {
            if (!sentences.contains(label->accessibleName())) {
                labels << label;
            }
        }
    }
    return labels;
}

QImage drawn(QWidget& window, int scale)
{
    QImage image(window.size() * scale, QImage::Format_RGB32);
    image.setDevicePixelRatio(scale);
    window.render(&image);
    return image;
}

}  // namespace

void PrintTo(const Edition& edition, std::ostream* out)
{
    *out << edition.name;
}

std::string editionName(const ::testing::TestParamInfo<Edition>& test)
{
    return test.param.name;
}

InAnEdition::InAnEdition() : m_translation(QLatin1String(GetParam().language)) {}

// The window starts with the theme of its settings.
PictureBook::PictureBook() : mustBeWhole(headerAndAxes(window))
{
    applyTheme(GetParam().theme);
}

PictureBook::~PictureBook()
{
    applyTheme(ThemeKind::Day);
}

void PictureBook::show(const StationStatus& status, char panel)
{
    for (int second = 0; second < 330; second += 6) {
        give(samples::update(samples::tracking(second)));
    }
    StationUpdate update = samples::update(status);
    update.samples = samples::ticks(clock.now(), kPast.count());
    clock.advance(kPast);
    for (std::uint64_t number = 1; number < 12; ++number) {
        update.log.push_back(
            samples::logEntry(number, number % 5 == 0 ? Severity::Warning : Severity::Advisory,
                              number % 4 == 0 ? QStringLiteral("operator") : QStringLiteral("rotctld 127.0.0.1:51234"),
                              QStringLiteral("P 339.50 57.00: accepted")));
    }
    give(update);
    openPanel(panel);
}

QByteArray PictureBook::translated(const char* className, const char* english)
{
    return QCoreApplication::translate((QByteArray("boresight::ui::") + className).constData(), english).toUtf8();
}

void PictureBook::take(const QString& scene)
{
    const QString folder = qEnvironmentVariable("BORESIGHT_PICTURES");
    for (const View& view : kViews) {
        SCOPED_TRACE(scene.toStdString() + " " + view.name);
        resizeTo(view.size);
        // Buttons and labels have the room they need. Otherwise the window would have grown.
        EXPECT_EQ(window.width(), view.size.width());
        EXPECT_EQ(window.height(), view.size.height());
        judge();
        if (folder.isEmpty() && &view != kViews) {
            continue;  // nobody looks at the picture
        }
        const QImage image = drawn(window, view.scale);
        EXPECT_EQ(image.pixelColor(1, 1), theme(GetParam().theme).window);
        const QString file =
            QStringLiteral("%1-%2-%3.png").arg(scene, QLatin1String(GetParam().name), QLatin1String(view.name));
        EXPECT_TRUE(folder.isEmpty() || image.save(QDir(folder).filePath(file), "PNG", 80)) << file.toStdString();
    }
    resizeTo(kViews[0].size);
}

// A wide window has the charts beside the panels and is not as narrow as this at once.
void PictureBook::resizeTo(QSize size)
{
    for (int time = 0; time < 2; ++time) {
        window.resize(size);
        settle();  // laid out
    }
}

void PictureBook::judge()
{
    for (const ValueLabel* const label : mustBeWhole) {
        EXPECT_FALSE(label->isVisible() && label->isElided())
            << label->accessibleName().toStdString() << ": " << label->text().toStdString();
    }
    for (const QPushButton* const button : window.findChildren<QPushButton*>()) {
        EXPECT_TRUE(!button->isVisible() ||
                    button->fontMetrics().size(Qt::TextShowMnemonic, button->text()).width() <= button->width())
            << button->text().toStdString();
    }
    for (const QTabBar* const tabs : window.findChildren<QTabBar*>()) {
        for (const QToolButton* const arrow : tabs->findChildren<QToolButton*>()) {
            EXPECT_FALSE(arrow->isVisible()) << "tabs hide behind arrows";
        }
    }
}

}  // namespace boresight::ui
