// ActionCatalogue: every command of an app, once. Menus, tool bars, the action search and the shortcut editor
// all read it; so a command has one text, one icon, one sentence that teaches, and one shortcut.
#pragma once

#include "document/settings/settings.h"

#include <QAction>
#include <QHash>
#include <QKeySequence>
#include <QList>
#include <QObject>
#include <functional>

namespace ductus {

struct ActionSpec
{
    QString id;      // "file.open"; never translated
    QString text;    // tr("&Open..."); with access key, "..." only if it asks for more
    QString teaches; // tr("Opens a project, or a sketch of another program."): one sentence
    QString icon;    // a name the icon set knows; may be empty
    QList<QKeySequence> shortcuts = {}; // default ones
    QString category = {};              // tr("File"): heading in the shortcut editor and the search
    bool isCheckable = false;
    /// Where the shortcut works. Widget context for keys that are letters typed elsewhere.
    Qt::ShortcutContext context = Qt::WindowShortcut;
    /// Shortcuts of different modes may be the same; "" is always there.
    QString mode = {};
};

class ActionCatalogue : public QObject
{
    Q_OBJECT
public:
    /// Shortcuts the user changed are read from and written to \a settings, which must outlive this; null:
    /// nothing is remembered.
    explicit ActionCatalogue(Settings *settings = nullptr, QObject *parent = nullptr);

    /// The action of \a spec, owned by the catalogue, disabled nowhere. \a run is called when it is
    /// triggered; it may be empty. Ids must be new.
    QAction *add(const ActionSpec &spec, std::function<void()> run = {});
    /// The same with the checked state.
    QAction *addToggle(const ActionSpec &spec, std::function<void(bool)> run);

    /// Null for unknown ids.
    QAction *action(const QString &id) const;
    const ActionSpec *spec(const QString &id) const;
    const ActionSpec *spec(const QAction *action) const;
    /// In the order they were added.
    QStringList ids() const { return mOrder; }

    QList<QKeySequence> shortcuts(const QString &id) const;
    bool hasOwnShortcuts(const QString &id) const;
    /// Takes effect at once and is remembered. Conflicts are the caller's to show; see conflicts().
    void setShortcuts(const QString &id, const QList<QKeySequence> &shortcuts);
    void resetShortcuts(const QString &id);
    void resetAllShortcuts();

    /// Ids of other actions that react to \a shortcut in a mode \a id is in as well.
    QStringList conflicts(const QString &id, const QKeySequence &shortcut) const;

    /// Shows why an action is disabled in its tooltip; empty: enables it.
    void setDisabledReason(const QString &id, const QString &reason);

signals:
    void added(const QString &id);
    void shortcutsChanged(const QString &id);

private:
    struct Entry
    {
        ActionSpec spec;
        QAction *action = nullptr;
        QString disabledReason;
    };

    void applyShortcuts(Entry &entry);
    void updateToolTip(Entry &entry);

    Settings *mSettings;
    QHash<QString, Entry> mEntries;
    QStringList mOrder;
};

/// The text of an action without access key and dots, for lists and accessible names: "Open".
QString plainText(const QString &actionText);

} // namespace ductus
