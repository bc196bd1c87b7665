// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/kit/leavable.h"
#include "ui/link/profile_draft.h"
#include "ui/sky/region_edit.h"
#include "ui/sky/sky_limits.h"
#include "ui/sky/sky_projection.h"

#include <QWidget>

#include <optional>

// The layer of the polar plot for limits that are being changed. Until they are applied it draws the differences from
// the limits in effect, dashed. While editing is on it takes mouse and keys and changes the draft: drag an edge, a
// corner, a point or a whole keep-out. Double click or + adds a point of the horizon. Del removes. While editing is off
// every click passes through. Nothing here moves the mount or changes the limits in effect. Pixels of the widget.
namespace boresight::ui {

class PlotEditor : public QWidget, public Leavable
{
    Q_OBJECT

public:
    explicit PlotEditor(ProfileDraft& draft, QWidget* parent = nullptr);

    void setEditing(bool on);
    void setSky(const SkyProjection& sky);
    void setTravel(const Travel& travel);
    void addPoint(const SkyPointing& at);       // of the horizon
    void addSector(const SkyPointing& centre);  // a keep-out
    bool cancelDrag();                          // true if a drag was cancelled and undone

    bool leave() override;  // ends the editing

    [[nodiscard]] bool isEditing() const { return m_editing; }
    [[nodiscard]] bool isDragging() const { return m_drag.has_value(); }
    [[nodiscard]] const std::optional<Grip>& selected() const { return m_selected; }
    void paint(QPainter& painter) const;

Q_SIGNALS:
    void leaveWanted();                 // the operator wants to end the editing
    void readout(const QString& text);  // the numbers under the cursor, empty when the cursor has left

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;
    void leaveEvent(QEvent* event) override;

private:
    [[nodiscard]] const pointing::Region& edited() const { return m_draft.edited().limits; }
    [[nodiscard]] std::optional<Grip> under(QPointF pixel) const;
    void followDraft();
    void change(const std::function<void(pointing::Region&)>& change);
    void select(const std::optional<Grip>& grip);
    void removeSelected();
    void showReadout();

    ProfileDraft& m_draft;
    SkyProjection m_sky;
    Travel m_travel;
    bool m_editing = false;
    QPointF m_cursor;
    std::optional<RegionDrag> m_drag;
    std::optional<Grip> m_selected;
};

}  // namespace boresight::ui
