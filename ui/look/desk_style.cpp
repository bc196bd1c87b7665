// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/look/desk_style.h"

#include "ui/kit/theme.h"
#include "ui/look/paint.h"

#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QFrame>
#include <QPainter>
#include <QStyleOption>
#include <QTabBar>
#include <QVariant>

#include <algorithm>

namespace boresight::ui {

namespace {

constexpr int kSpinButton = 30;  // px, the width of each of the two
constexpr int kComboArrow = 24;
constexpr int kFieldHeight = 30;
constexpr int kFieldMargin = 3;
constexpr int kIndicator = 20;
constexpr int kScrollBar = 12;
constexpr int kLeastHandle = 28;
constexpr const char* kTabSpaceKey = "tabSpace";

int tabSpaceOf(const QWidget* tabs)
{
    const QVariant space = tabs == nullptr ? QVariant() : tabs->property(kTabSpaceKey);
    return space.isValid() ? space.toInt() : kTabSpace;
}

// One of the two buttons of a number field. The other one is beside it.
QRect spinButton(const QRect& box, QStyle::SubControl part)
{
    const int width = std::min(kSpinButton, box.width() / 4);
    const int right = part == QStyle::SC_SpinBoxUp ? box.right() - width + 1 : box.right() - 2 * width + 1;
    return {right, box.top(), width, box.height()};
}

QRect partOfSpinBox(const QStyleOptionSpinBox& option, QStyle::SubControl part)
{
    const bool hasButtons = option.buttonSymbols != QAbstractSpinBox::NoButtons;
    switch (part) {
        case QStyle::SC_SpinBoxUp:
        case QStyle::SC_SpinBoxDown:
            return hasButtons ? spinButton(option.rect, part) : QRect();
        case QStyle::SC_SpinBoxEditField: {
            const int end = hasButtons ? spinButton(option.rect, QStyle::SC_SpinBoxDown).left() : option.rect.right();
            return QRect(option.rect.topLeft(), QPoint(end, option.rect.bottom())).adjusted(4, 2, -2, -2);
        }
        default:
            return option.rect;
    }
}

// The start and the length of the handle along the bar.
std::pair<int, int> handleOf(const QStyleOptionSlider& option, int length)
{
    const qint64 range = option.maximum - option.minimum;
    const qint64 natural = range > 0 ? qint64{option.pageStep} * length / (range + option.pageStep) : length;
    const int handle = std::clamp(static_cast<int>(natural), std::min(kLeastHandle, length), length);
    return {QStyle::sliderPositionFromValue(option.minimum, option.maximum, option.sliderPosition, length - handle,
                                            option.upsideDown),
            handle};
}

// A scroll bar without buttons at its ends, because they are too small for a finger.
QRect partOfScrollBar(const QStyleOptionSlider& option, QStyle::SubControl part)
{
    const QRect& box = option.rect;
    const bool lies = option.orientation == Qt::Horizontal;
    const int length = lies ? box.width() : box.height();
    const auto [begin, handle] = handleOf(option, length);
    const auto along = [&](int from, int to) {
        return lies ? QRect(box.left() + from, box.top(), to - from, box.height())
                    : QRect(box.left(), box.top() + from, box.width(), to - from);
    };
    switch (part) {
        case QStyle::SC_ScrollBarSlider:
            return along(begin, begin + handle);
        case QStyle::SC_ScrollBarSubPage:
            return along(0, begin);
        case QStyle::SC_ScrollBarAddPage:
            return along(begin + handle, length);
        case QStyle::SC_ScrollBarGroove:
            return box;
        default:
            return {};
    }
}

void drawScrollBar(QPainter& painter, const QStyleOptionSlider& option)
{
    if (option.maximum <= option.minimum) {
        return;
    }
    const QRectF handle = QRectF(partOfScrollBar(option, QStyle::SC_ScrollBarSlider)).adjusted(3, 3, -3, -3);
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush((option.state & (QStyle::State_MouseOver | QStyle::State_Sunken)).toInt() != 0
                         ? currentTheme().secondary
                         : currentTheme().hairline);
    const double rounding = std::min(handle.width(), handle.height()) / 2.0;
    painter.drawRoundedRect(handle, rounding, rounding);
    painter.restore();
}

void drawSpinBox(QPainter& painter, const QStyleOptionSpinBox& option)
{
    paintField(painter, option);
    if (option.buttonSymbols == QAbstractSpinBox::NoButtons) {
        return;
    }
    painter.setPen(currentTheme().hairline);
    for (const auto& [part, stroke, step] :
         {std::tuple(QStyle::SC_SpinBoxDown, Stroke::Minus, QAbstractSpinBox::StepDownEnabled),
          std::tuple(QStyle::SC_SpinBoxUp, Stroke::Plus, QAbstractSpinBox::StepUpEnabled)}) {
        const QRect button = partOfSpinBox(option, part);
        const bool enabled = option.stepEnabled.testFlag(step) && option.state.testFlag(QStyle::State_Enabled);
        if (option.activeSubControls == part && option.state.testFlag(QStyle::State_Sunken)) {
            painter.fillRect(button.adjusted(1, 2, -2, -2), currentTheme().accentSoft);
        }
        painter.drawLine(button.left(), button.top() + 6, button.left(), button.bottom() - 6);
        paintStroke(painter, stroke, button, enabled);
    }
}

void drawComboBox(QPainter& painter, const QStyleOptionComboBox& option)
{
    if (option.editable) {
        paintField(painter, option);
    } else {
        QStyleOption ground = option;
        ground.state.setFlag(QStyle::State_On, false);
        paintButton(painter, ground, Emphasis::Normal);
        if (option.state.testFlag(QStyle::State_HasFocus)) {
            paintFocus(painter, option.rect);
        }
    }
    const QRect arrow(option.rect.right() - kComboArrow + 1, option.rect.top(), kComboArrow, option.rect.height());
    paintStroke(painter, Stroke::Down, arrow, option.state.testFlag(QStyle::State_Enabled));
}

void drawHeader(QPainter& painter, const QRect& box)
{
    painter.fillRect(box, currentTheme().card);
    painter.setPen(currentTheme().hairline);
    painter.drawLine(box.bottomLeft(), box.bottomRight());
}

// A field inside another field uses the background of that field.
bool isWithinAField(const QWidget* widget)
{
    const QObject* const parent = widget != nullptr ? widget->parent() : nullptr;
    return qobject_cast<const QAbstractSpinBox*>(parent) != nullptr ||
           qobject_cast<const QComboBox*>(parent) != nullptr;
}

}  // namespace

void setTabSpace(QTabBar& tabs, int space)
{
    tabs.setProperty(kTabSpaceKey, space);
}

DeskStyle::DeskStyle() : QProxyStyle(QStringLiteral("Fusion")) {}

void DeskStyle::install()
{
    if (qobject_cast<const DeskStyle*>(QApplication::style()) == nullptr) {
        QApplication::setStyle(new DeskStyle);  // the application owns it
    }
}

void DeskStyle::polish(QWidget* widget)
{
    QProxyStyle::polish(widget);
    m_wheel.watch(*widget);
}

int DeskStyle::pixelMetric(PixelMetric metric, const QStyleOption* option, const QWidget* widget) const
{
    switch (metric) {
        case PM_TabBarTabHSpace:
            return tabSpaceOf(widget);
        case PM_TabBarTabVSpace:
            return 10;
        case PM_TabBarBaseOverlap:
        case PM_TabBarTabOverlap:
        case PM_ButtonShiftHorizontal:
        case PM_ButtonShiftVertical:
            return 0;
        case PM_TabBarIconSize:
            return 16;
        case PM_ScrollBarExtent:
            return kScrollBar;
        case PM_ScrollBarSliderMin:
            return kLeastHandle;
        case PM_IndicatorWidth:
        case PM_IndicatorHeight:
        case PM_ExclusiveIndicatorWidth:
        case PM_ExclusiveIndicatorHeight:
            return kIndicator;
        default:
            return QProxyStyle::pixelMetric(metric, option, widget);
    }
}

int DeskStyle::styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget,
                         QStyleHintReturn* data) const
{
    switch (hint) {
        case SH_EtchDisabledText:
        case SH_ComboBox_Popup:
            return 0;
        case SH_Table_GridLineColor:
            return static_cast<int>(currentTheme().grid.rgba());
        default:
            return QProxyStyle::styleHint(hint, option, widget, data);
    }
}

QSize DeskStyle::sizeFromContents(ContentsType type, const QStyleOption* option, const QSize& contents,
                                  const QWidget* widget) const
{
    QSize size = QProxyStyle::sizeFromContents(type, option, contents, widget);
    const auto atLeast = [&size](int height) { size.setHeight(std::max(size.height(), height)); };
    switch (type) {
        case CT_TabBarTab:
        case CT_MenuItem: {
            const auto* const item = qstyleoption_cast<const QStyleOptionMenuItem*>(option);
            if (item == nullptr || item->menuItemType != QStyleOptionMenuItem::Separator) {
                atLeast(kRowHeight);
            }
            break;
        }
        case CT_ItemViewItem:
            atLeast(kRowHeight);
            break;
        case CT_LineEdit:
        case CT_ComboBox:
            atLeast(kFieldHeight);
            break;
        case CT_SpinBox:
            if (const auto* const box = qstyleoption_cast<const QStyleOptionSpinBox*>(option);
                box != nullptr && box->buttonSymbols != QAbstractSpinBox::NoButtons) {
                size.rwidth() = contents.width() + 2 * kSpinButton + 2 * kGrid;
            }
            atLeast(kFieldHeight);
            break;
        default:
            break;
    }
    return size;
}

QRect DeskStyle::subControlRect(ComplexControl control, const QStyleOptionComplex* option, SubControl part,
                                const QWidget* widget) const
{
    if (control == CC_SpinBox) {
        if (const auto* const box = qstyleoption_cast<const QStyleOptionSpinBox*>(option)) {
            return partOfSpinBox(*box, part);
        }
    }
    if (control == CC_ScrollBar) {
        if (const auto* const bar = qstyleoption_cast<const QStyleOptionSlider*>(option)) {
            return partOfScrollBar(*bar, part);
        }
    }
    if (control == CC_ComboBox && (part == SC_ComboBoxArrow || part == SC_ComboBoxEditField)) {
        const QRect& box = option->rect;
        return part == SC_ComboBoxArrow ? QRect(box.right() - kComboArrow + 1, box.top(), kComboArrow, box.height())
                                        : box.adjusted(6, 2, -kComboArrow, -2);
    }
    return QProxyStyle::subControlRect(control, option, part, widget);
}

QRect DeskStyle::subElementRect(SubElement element, const QStyleOption* option, const QWidget* widget) const
{
    const QRect usual = QProxyStyle::subElementRect(element, option, widget);
    switch (element) {
        case SE_PushButtonFocusRect:
            return option->rect;
        case SE_LineEditContents:
            return isWithinAField(widget) ? usual : usual.adjusted(kFieldMargin, 0, -kFieldMargin, 0);
        default:
            return usual;
    }
}

void DeskStyle::drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                              const QWidget* widget) const
{
    switch (element) {
        case PE_PanelButtonCommand:
            paintButton(*painter, *option, emphasisOf(widget));
            return;
        case PE_PanelButtonTool:
            paintButton(*painter, *option,
                        option->state.testFlag(State_AutoRaise) ? Emphasis::Quiet : emphasisOf(widget));
            return;
        case PE_PanelLineEdit:
            if (isWithinAField(widget)) {
                return;
            }
            if (const auto* const frame = qstyleoption_cast<const QStyleOptionFrame*>(option);
                frame != nullptr && frame->lineWidth > 0) {
                paintField(*painter, *option);
                return;
            }
            break;
        case PE_FrameLineEdit:
            return;  // drawn with the background
        case PE_FrameFocusRect:
            paintFocus(*painter, option->rect);
            return;
        case PE_IndicatorCheckBox:
            paintBox(*painter, *option, false);
            return;
        case PE_IndicatorRadioButton:
            paintBox(*painter, *option, true);
            return;
        case PE_FrameTabWidget:
            paintCard(*painter, option->rect);
            return;
        case PE_FrameTabBarBase:
            return;
        case PE_Frame:
            painter->setPen(currentTheme().hairline);
            painter->drawRect(option->rect.adjusted(0, 0, -1, -1));
            return;
        case PE_PanelMenu:
            painter->fillRect(option->rect, currentTheme().card);
            painter->setPen(currentTheme().hairline);
            painter->drawRect(option->rect.adjusted(0, 0, -1, -1));
            return;
        default:
            break;
    }
    QProxyStyle::drawPrimitive(element, option, painter, widget);
}

void DeskStyle::drawControl(ControlElement element, const QStyleOption* option, QPainter* painter,
                            const QWidget* widget) const
{
    switch (element) {
        case CE_PushButtonLabel:
            if (const auto* const button = qstyleoption_cast<const QStyleOptionButton*>(option)) {
                QStyleOptionButton label = *button;
                const Emphasis emphasis = emphasisOf(widget);
                const bool isHeld = (option->state & (State_Sunken | State_On)).toInt() != 0;
                if (option->state.testFlag(State_Enabled) && emphasis != Emphasis::Normal) {
                    label.palette.setColor(QPalette::ButtonText, emphasis == Emphasis::Primary && !isHeld
                                                                     ? currentTheme().onAccent
                                                                     : currentTheme().accent);
                }
                QProxyStyle::drawControl(element, &label, painter, widget);
                return;
            }
            break;
        case CE_TabBarTabShape:
            paintTab(*painter, *option);
            return;
        case CE_TabBarTabLabel:
            if (const auto* const tab = qstyleoption_cast<const QStyleOptionTab*>(option)) {
                QStyleOptionTab label = *tab;
                label.state.setFlag(State_HasFocus, false);  // the shape shows the focus
                if (!tab->state.testFlag(State_Selected) &&
                    tab->palette.color(QPalette::WindowText) == currentTheme().text) {
                    label.palette.setColor(QPalette::WindowText, currentTheme().secondary);
                }
                QProxyStyle::drawControl(element, &label, painter, widget);
                return;
            }
            break;
        case CE_ShapedFrame:
            if (const auto* const frame = qstyleoption_cast<const QStyleOptionFrame*>(option);
                frame != nullptr && frame->frameShape == QFrame::Box) {
                paintCard(*painter, option->rect);
                return;
            }
            break;
        case CE_HeaderSection:
        case CE_HeaderEmptyArea:
            drawHeader(*painter, option->rect);
            return;
        case CE_HeaderLabel:
            if (const auto* const header = qstyleoption_cast<const QStyleOptionHeader*>(option)) {
                QStyleOptionHeader label = *header;
                label.palette.setColor(QPalette::ButtonText, currentTheme().secondary);
                QProxyStyle::drawControl(element, &label, painter, widget);
                return;
            }
            break;
        default:
            break;
    }
    QProxyStyle::drawControl(element, option, painter, widget);
}

void DeskStyle::drawComplexControl(ComplexControl control, const QStyleOptionComplex* option, QPainter* painter,
                                   const QWidget* widget) const
{
    if (control == CC_SpinBox) {
        if (const auto* const box = qstyleoption_cast<const QStyleOptionSpinBox*>(option)) {
            drawSpinBox(*painter, *box);
            return;
        }
    }
    if (control == CC_ComboBox) {
        if (const auto* const box = qstyleoption_cast<const QStyleOptionComboBox*>(option)) {
            drawComboBox(*painter, *box);
            return;
        }
    }
    if (control == CC_ScrollBar) {
        if (const auto* const bar = qstyleoption_cast<const QStyleOptionSlider*>(option)) {
            drawScrollBar(*painter, *bar);
            return;
        }
    }
    QProxyStyle::drawComplexControl(control, option, painter, widget);
}

}  // namespace boresight::ui

#include "moc_desk_style.cpp"
