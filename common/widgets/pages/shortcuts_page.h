// ShortcutsPage: all actions with their keys; choose one, press the new keys. What the keys did before is
// shown before anything is taken away.
#pragma once

#include <QKeySequence>
#include <QWidget>

class QKeySequenceEdit;
class QLabel;
class QLineEdit;
class QPushButton;
class QTreeWidget;
class QTreeWidgetItem;

namespace ductus {

class ActionCatalogue;

class ShortcutsPage : public QWidget
{
    Q_OBJECT
public:
    explicit ShortcutsPage(ActionCatalogue &actions, QWidget *parent = nullptr);

    void select(const QString &id);
    /// The sentence on a conflict; empty if there is none.
    QString conflictText() const;

private:
    void fill();
    void filter(const QString &typed);
    void showSelected();
    void tryKeys(const QKeySequence &keys);
    void assign(const QKeySequence &keys);
    void updateRow(const QString &id);
    QString selectedId() const;
    QTreeWidgetItem *rowOf(const QString &id) const;

    ActionCatalogue &mActions;
    QLineEdit *mFilter;
    QTreeWidget *mTree;
    QKeySequenceEdit *mKeys;
    QLabel *mConflict;
    QPushButton *mTakeOver;
    QPushButton *mReset;
    QPushButton *mClear;
    QKeySequence mWanted;
};

} // namespace ductus
