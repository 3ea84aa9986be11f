// RegionList: the regions of the result: colour, kind of surface, area, deviation, lock.
#pragma once

#include "sketchsurfacer/ui/presentation/result_view.h"

#include <QWidget>

class QLabel;
class QTreeWidget;
class QTreeWidgetItem;

namespace ductus {

/// "plane", "quadric", ...
QString surfaceKindName(int degree);

class RegionList : public QWidget
{
    Q_OBJECT
public:
    explicit RegionList(QWidget *parent = nullptr);

    /// Null: none yet.
    void setResult(const std::shared_ptr<const ResultView> &view, double metresPerUnit);
    void choose(int region);
    int rowCount() const;

signals:
    void chosen(int region);
    void lockToggled(int region);
    void degreeChosen(int region, int degree);

private:
    void openMenu(const QPoint &position);
    int regionOf(const QTreeWidgetItem *item) const;

    QTreeWidget *mTree;
    QLabel *mEmpty;
};

} // namespace ductus
