#!/usr/bin/env python3
"""stills.py FIGURES IMAGES: the pictures that stand for the live figures on paper and where scripts
are off. Of each page in FIGURES, how it begins: IMAGES/figure-NAME.png, at most 600 pixels wide."""
import os
import pathlib
import sys

sys.path.insert(0, os.path.join(os.path.dirname(__file__), "..", "watch"))
from browser import in_browser, until  # noqa: E402


def make(browser):
    browser.devtools("Emulation.setDeviceMetricsOverride", width=1200, height=1000,
                     deviceScaleFactor=1, mobile=False)
    for page in sorted(pathlib.Path(sys.argv[1]).glob("*.html")):
        browser.ask("POST", "/url", {"url": page.resolve().as_uri() + "?lang=en"})
        until(lambda: browser.run("return window.figure && !figure.busy"), "the figure")
        browser.run("""document.querySelector('.still').style.maxWidth = '600px';
            for (const words of document.querySelectorAll('.still figcaption')) words.hidden = true""")
        image = pathlib.Path(sys.argv[2], f"figure-{page.stem}.png")
        browser.element_screenshot(".still", f"{image}.new")
        os.replace(f"{image}.new", image)


in_browser(make)
