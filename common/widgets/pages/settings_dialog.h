// SettingsDialog: pages at the left, one of them at the right; everything applies at once, so there is only
// Close.
#pragma once

#include <QDialog>

class QListWidget;
class QStackedWidget;

namespace ductus {

class SettingsDialog : public QDialog
{
    Q_OBJECT
public:
    explicit SettingsDialog(QWidget *parent = nullptr);

    /// Takes the page.
    void addPage(const QString &title, const QString &iconName, QWidget *page);
    void showPage(int index);
    int pageCount() const;

private:
    QListWidget *mList;
    QStackedWidget *mPages;
};

} // namespace ductus
