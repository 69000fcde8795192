// SPDX-License-Identifier: MIT
#pragma once

#include <QDialog>

namespace app {

/// A window of its own for one page; it does not block the main window, and goes with its page when it is closed.
class PageWindow : public QDialog {
    Q_OBJECT

public:
    enum class Place {
        Middle,  ///< with room for results
        AtRight, ///< as small as the page, at the parent's right edge: the views stay in sight
    };
    PageWindow(const QString& title, QWidget* page, QWidget* parent, Place place = Place::Middle);
    /// Brings it to the front.
    void present();
};

/// Shows the window's one page of that kind, made by `make` if there is none yet.
template <class Page, class Make>
Page& showPage(QWidget& window, const QString& title, Make make, PageWindow::Place place = PageWindow::Place::Middle) {
    auto* page = window.findChild<Page*>();
    if (!page) {
        page = make();
        new PageWindow(title, page, &window, place);
    }
    static_cast<PageWindow*>(page->window())->present();
    return *page;
}

} // namespace app
