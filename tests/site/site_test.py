"""site_test.py SITE [PAGE…]: every page of the site (or these, such as en/start.html) from the file system
in a browser, as a reader would have it: on a desk, on a phone, in the dark, on paper, by keyboard."""
import os
import sys
import urllib.parse

from browser import in_browser

SIZES = {"desk": (1280, 900), "phone": (390, 844)}
TWIN = {"en": "el", "el": "en"}

# What a page has: its language, what does not fit, what is not there, what is not set as a formula.
LOOK = """
const main = document.querySelector('.md-content');
const rendered = (formula) => formula.querySelector('.katex') && !formula.querySelector('.katex-error');
const arrows = [...main.querySelectorAll('.katex svg')].map((svg) => svg.getBoundingClientRect());
const plain = main.cloneNode(true);
for (const other of plain.querySelectorAll('code, pre, .katex, script, style')) other.remove();
return {
  language: document.documentElement.lang,
  titles: document.querySelectorAll('h1').length,
  wide: document.scrollingElement.scrollWidth - document.documentElement.clientWidth,
  formulas: main.querySelectorAll('.arithmatex').length,
  unset: [...main.querySelectorAll('.arithmatex')].filter((f) => !rendered(f)).map((f) => f.textContent),
  left_over: plain.textContent.match(/\\\\\\(|\\\\\\[|\\$\\$|\\\\vec|\\\\frac|<details|<!--/g) || [],
  arrows: arrows.filter((box) => box.width < 1 || box.height < 1).length,
  broken: [...document.images].filter((i) => !i.complete || !i.naturalWidth).map((i) => i.src),
  unnamed: [...document.images].filter((i) => !i.alt).map((i) => i.src),
  ids: [...document.querySelectorAll('[id]')].map((e) => e.id),
  links: [...document.querySelectorAll('a[href]')].map((a) => a.href),
  switch: [...document.querySelectorAll('a.language')].map((a) => a.href),
};
"""

# The least contrast of text on its ground, of what a page is mostly made of.
CONTRAST = """
const light = (color) => {
  const [r, g, b] = color.map((c) => c / 255).map((c) => c <= .03928 ? c / 12.92 : ((c + .055) / 1.055) ** 2.4);
  return .2126 * r + .7152 * g + .0722 * b;
};
const numbers = (text) => text.match(/[\\d.]+/g).map(Number);
const over = (top, under) => under.map((c, i) => c + (top[i] - c) * (top[3] ?? 1));
const ground = (e) => {
  if (!e) return [255, 255, 255];
  const own = numbers(getComputedStyle(e).backgroundColor);
  return own[3] === 0 ? ground(e.parentElement) : over(own, ground(e.parentElement));
};
return Math.min(...[...document.querySelectorAll('.md-content :is(h1, h2, p, li, td, a:not(.headerlink), code)')]
  .filter((e) => e.textContent.trim() && e.getClientRects().length).map((e) => {
    const under = ground(e), text = over(numbers(getComputedStyle(e).color), under);
    const [a, b] = [light(text), light(under)].sort((x, y) => y - x);
    return (a + .05) / (b + .05);
  }));
"""


def check_page(browser, site, page, seen):
    language = page.split("/")[0]
    for size, (width, height) in SIZES.items():
        browser.devtools("Emulation.setDeviceMetricsOverride", width=width, height=height,
                         deviceScaleFactor=1, mobile=size == "phone")
        browser.ask("POST", "/url", {"url": address(site, page)})
        look = browser.run(LOOK)
        assert look["language"] == language, (page, look["language"])
        assert look["titles"] == 1, (page, "headings of the first level", look["titles"])
        assert look["wide"] <= 0, (page, size, "wider than the window by", look["wide"])
        for fault in ("unset", "left_over", "broken", "unnamed"):
            assert not look[fault], (page, size, fault, look[fault])
        assert look["arrows"] == 0, (page, size, "arrows that cannot be seen", look["arrows"])
        browser.check_quiet()
    twin = address(site, TWIN[language] + page[len(language):])
    assert twin in look["switch"] and exists(twin), (page, "no way to its twin", look["switch"])
    seen[address(site, page)] = look


def check_links(site, seen):
    for page, look in seen.items():
        for link in look["links"]:
            target, _, anchor = link.partition("#")
            if not target.startswith("file:"):
                continue
            assert exists(target), (page, link)
            if anchor and target in seen:
                assert urllib.parse.unquote(anchor) in seen[target]["ids"], (page, "no such place", link)
    stray = {file for file in files(site) if address(site, file) not in
             {link.partition("#")[0] for look in seen.values() for link in look["links"]}}
    assert len(seen) < 3 or not stray, ("no page leads to", stray)


def check_lights(browser, site, page):
    """By day and by night the text can be read, and the night is dark."""
    grounds = {}
    for scheme in ("light", "dark"):
        browser.devtools("Emulation.setEmulatedMedia",
                         features=[{"name": "prefers-color-scheme", "value": scheme}])
        browser.run("localStorage.clear()")  # what the reader chose last
        browser.ask("POST", "/url", {"url": address(site, page)})
        browser.run("for (const change of document.getAnimations()) change.finish()")
        contrast = browser.run(CONTRAST)
        assert contrast >= 4.5, (page, scheme, "contrast", contrast)
        grounds[scheme] = browser.run("return getComputedStyle(document.body).backgroundColor")
        browser.screenshot(f"{page.replace('/', '-')}-{scheme}")
    assert grounds["light"] != grounds["dark"], grounds
    browser.devtools("Emulation.setEmulatedMedia", features=[])


def check_keyboard(browser, site, page):
    browser.ask("POST", "/url", {"url": address(site, page)})
    browser.press("\ue004")  # Tab
    skip = browser.run("return document.activeElement.getAttribute('href') || ''")
    assert skip.startswith("#"), (page, "the first Tab does not lead past the navigation", skip)
    reached = set()
    for _ in range(80):
        browser.press("\ue004")
        reached |= set(browser.run("return document.activeElement.className").split())
    assert "language" in reached, (page, "the language cannot be changed by keyboard")


def check_paper(browser, site, page):
    browser.ask("POST", "/url", {"url": address(site, page)})
    browser.devtools("Emulation.setEmulatedMedia", media="print")
    shown = browser.run("""return ['.md-header', '.md-sidebar', '.md-footer']
      .flatMap((name) => [...document.querySelectorAll(name)]).filter((e) => e.getClientRects().length).length""")
    assert shown == 0, (page, "on paper there is what only a screen can use")
    browser.devtools("Emulation.setEmulatedMedia", media="")


def address(site, page):
    return "file://" + urllib.parse.quote(os.path.join(site, page))


def exists(target):
    return os.path.exists(urllib.parse.unquote(target.removeprefix("file://").partition("?")[0]))


def files(site):
    return [os.path.join(language, name) for language in TWIN
            for name in sorted(os.listdir(os.path.join(site, language))) if name.endswith(".html")]


def test(browser):
    site, pages, seen = os.path.abspath(sys.argv[1]), sys.argv[2:], {}
    browser.ask("POST", "/url", {"url": address(site, "index.html")})
    assert browser.run("return location.href").endswith("/start.html"), "the front door leads nowhere"
    for page in pages or files(site):
        check_page(browser, site, page, seen)
    check_links(site, seen)
    browser.devtools("Emulation.clearDeviceMetricsOverride")
    for page in pages or ("en/stage-point.html", "el/start.html"):
        check_lights(browser, site, page)
        check_paper(browser, site, page)
        check_keyboard(browser, site, page)
    print(f"{len(seen)} pages, {sum(look['formulas'] for look in seen.values())} formulas")


in_browser(test, os.environ.get("FOS_SCREENSHOTS"))
