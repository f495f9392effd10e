#!/usr/bin/env python3
"""report_test.py REPORTS [FOLDER]: drives headless Chromium over the reports that report_test.sh has
made: classes of 0, 1 and 5, and of 150 in English and in Greek. Screenshots go to FOLDER."""
import sys
import time

from browser import in_browser

REPORTS = sys.argv[1]
FOLDER = sys.argv[2] if len(sys.argv) > 2 else None
COUNT = 150
ENTER, SPACE = "\ue007", " "

# What a page's words have made of it, if they were not escaped: elements that our pages do not have,
# attributes that run something, addresses of anything but a page, a place in it or a picture.
EVIL = """
    const all = [...document.querySelectorAll('*')];
    const evil = all.filter((e) => ['IFRAME', 'OBJECT', 'EMBED', 'FORM', 'BASE', 'B'].includes(e.tagName)
        || [...e.attributes].some((a) => a.name.startsWith('on')));
    evil.push(...[...document.querySelectorAll('a')].filter(
        (a) => !/^(submissions\\/[a-z0-9._-]+\\/index\\.html|#stage-\\d+)$/.test(a.getAttribute('href'))));
    evil.push(...[...document.querySelectorAll('img')].filter((i) => !i.closest('figure')));
    evil.push(...[...document.querySelectorAll('script')].filter((s) => s.src));
    return [evil.map((e) => e.outerHTML.slice(0, 200)), typeof hacked];"""


def visit(browser, page):
    browser.ask("POST", "/url", {"url": f"file://{REPORTS}/{page}"})


def check_harmless(browser, scripts):
    evil, hacked = browser.run(EVIL)
    assert not evil, evil
    assert hacked == "undefined"
    count = browser.run("return document.querySelectorAll('script, style').length")
    assert count == scripts + 1, count
    browser.check_quiet()


def column(browser, index):
    return browser.run(f"""return [...document.querySelectorAll('#class tbody tr')]
        .filter((r) => !r.hidden).map((r) => r.cells[{index}].dataset.sort)""")


def heading(browser, index):
    """Where the middle of the heading's button is, after scrolling there."""
    return browser.run(f"""
        const button = document.querySelectorAll('#class thead button')[{index}];
        button.scrollIntoView({{block: 'center'}});
        const box = button.getBoundingClientRect();
        return [Math.round(box.left + box.width / 2), Math.round(box.top + box.height / 2)]""")


def sorted_as(browser, index):
    return browser.run(f"""return document.querySelectorAll('#class thead th')[{index}]
        .getAttribute('aria-sort')""")


def test_sorting(browser):
    # Marks: the best first, then the worst; who has none is last both times.
    browser.click(*heading(browser, 2))
    marks = column(browser, 2)
    known = [int(mark) for mark in marks if mark]
    assert len(marks) == COUNT and 0 < len(known) < COUNT, len(known)
    assert known == sorted(known, reverse=True) and marks[:len(known)] == [str(m) for m in known]
    assert sorted_as(browser, 2) == "descending"
    browser.click(*heading(browser, 2))
    marks = column(browser, 2)
    assert [int(mark) for mark in marks[:len(known)]] == sorted(known)
    assert marks[len(known):] == [""] * (COUNT - len(known))
    assert sorted_as(browser, 2) == "ascending"

    # Names, by the keyboard; one heading at a time says that it sorts.
    browser.run("document.querySelectorAll('#class thead button')[0].focus()")
    browser.press(ENTER)
    names = column(browser, 0)
    assert sorted_as(browser, 0) == "ascending" and sorted_as(browser, 2) is None
    greek = [name for name in names if name.startswith(("Άννα", "Γιώργος", "Ελένη", "Κώστας", "Μαρία"))]
    assert [name[0] for name in greek] == sorted((name[0] for name in greek), key="ΆΓΕΚΜ".index)
    browser.press(SPACE)
    assert column(browser, 0) == names[::-1] or sorted_as(browser, 0) == "descending"
    assert sorted(column(browser, 0)) == sorted(names)


def type_filter(browser, words):
    browser.run("const box = document.getElementById('filter'); box.focus(); box.select()")
    for letter in words or "\ue003":
        browser.press(letter)


def test_filter(browser):
    assert browser.text("shown") == f"{COUNT} of {COUNT} shown"
    type_filter(browser, "μαρια παπα")
    names = column(browser, 0)
    assert names and all("Μαρία" in name and "Παπα" in name for name in names), names
    assert browser.text("shown") == f"{len(names)} of {COUNT} shown"
    type_filter(browser, "cs7919")
    assert column(browser, 1) == ["cs7919"]
    type_filter(browser, "nobody is called so")
    assert column(browser, 0) == [] and browser.text("shown") == f"0 of {COUNT} shown"
    type_filter(browser, "")
    assert len(column(browser, 0)) == COUNT
    # A mistake of the list filters for those who made it.
    mistake, count = browser.run("""
        const row = document.querySelector('#mistakes tbody tr');
        row.querySelector('button').click();
        return [row.cells[0].textContent, Number(row.cells[2].textContent)]""")
    assert browser.run("return document.getElementById('filter').value") == mistake
    assert len(column(browser, 0)) >= count > 1
    assert browser.run("return document.activeElement.id") == "filter"


def test_links(browser):
    """Every submission's page is there, is harmless, and shows its pictures."""
    pages = browser.run("return [...document.querySelectorAll('#class a')]"
                        ".map((a) => [a.getAttribute('href'), a.textContent])")
    assert len(pages) == COUNT
    pictures = 0
    for page, name in pages:
        visit(browser, "en/" + page)
        assert browser.run("return document.querySelector('h1').textContent") == name, page
        browser.run("for (const i of document.images) i.loading = 'eager'")
        for _ in range(100):
            if browser.run("return [...document.images].every((i) => i.complete)"):
                break
            time.sleep(0.05)
        broken = browser.run("""return [...document.images].filter(
            (i) => !i.naturalWidth || !i.alt).map((i) => i.outerHTML)""")
        assert not broken, (page, broken)
        dead = browser.run("""return [...document.querySelectorAll('a')].filter(
            (a) => !document.querySelector(a.getAttribute('href'))).length""")
        assert not dead, page
        pictures += browser.run("return document.images.length")
        check_harmless(browser, 0)
    assert pictures > COUNT // 2, pictures


def test_small_classes(browser):
    visit(browser, "0/index.html")
    assert "There are no submissions" in browser.run("return document.body.textContent")
    check_harmless(browser, 0)
    browser.screenshot("none")
    for count in (1, 5):
        visit(browser, f"{count}/index.html")
        assert len(column(browser, 0)) == count
        check_harmless(browser, 1)
        browser.screenshot(str(count))


def test_greek(browser):
    visit(browser, "el/index.html")
    assert browser.run("return document.documentElement.lang") == "el"
    headings = browser.run("return [...document.querySelectorAll('h2')].map((h) => h.textContent)")
    assert headings == ["Κατανομή", "Ανά στάδιο", "Συχνότερα λάθη", "Παραδόσεις"], headings
    assert browser.text("shown") == f"φαίνονται {COUNT} από {COUNT}"
    check_harmless(browser, 1)
    browser.screenshot("greek")


def media(browser, **features):
    browser.devtools("Emulation.setEmulatedMedia", media=features.pop("media", ""),
                     features=[{"name": "prefers-color-scheme", "value": v} for v in features.values()])


def test_screens(browser):
    """A phone, the dark, and paper."""
    for name, page in (("class", "en/index.html"), ("submission", "en/submissions/s0003/index.html"),
                       ("wrong", "en/submissions/s0002/index.html")):
        visit(browser, page)
        browser.screenshot(name + "-desk")
        browser.devtools("Emulation.setDeviceMetricsOverride", width=360, height=740,
                         deviceScaleFactor=2, mobile=True)
        media(browser, scheme="dark")
        width = browser.run("return document.documentElement.scrollWidth")
        assert width <= 360, (page, width)
        color = browser.run("return getComputedStyle(document.body).backgroundColor")
        assert color == "rgb(22, 24, 27)", color
        browser.screenshot(name + "-phone")
        browser.devtools("Emulation.clearDeviceMetricsOverride")
        media(browser, media="print", scheme="dark")
        color = browser.run("return getComputedStyle(document.body).backgroundColor")
        assert color == "rgb(255, 255, 255)", color
        if name == "class":
            assert browser.run("return document.getElementById('filter-box').offsetHeight") == 0
        browser.screenshot(name + "-print")
        media(browser)


def test(browser):
    visit(browser, "en/index.html")
    assert len(column(browser, 0)) == COUNT
    test_sorting(browser)
    test_filter(browser)
    check_harmless(browser, 1)
    visit(browser, "en/index.html")
    test_links(browser)
    test_small_classes(browser)
    test_greek(browser)
    test_screens(browser)


in_browser(test, FOLDER)
print("the reports: passed")
