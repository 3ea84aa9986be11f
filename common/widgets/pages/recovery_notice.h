// RecoveryNotice: what autosave kept of work that was never saved, for StartPage::setNotice(): one row each
// with Open and Discard. Nothing is asked; the rows wait until the user has decided.
#pragma once

#include "document/recovery/recovery_list.h"

#include <QFrame>

namespace ductus {

class RecoveryNotice : public QFrame
{
    Q_OBJECT
public:
    explicit RecoveryNotice(const QList<RecoveredFile> &files, QWidget *parent = nullptr);

signals:
    void openRequested(const ductus::RecoveredFile &file);
    /// The row is gone then; the app calls discardRecovered().
    void discardRequested(const ductus::RecoveredFile &file);
};

} // namespace ductus
