#!/usr/bin/env python3
"""viewer_test.py URL FILE SOLUTION [FOLDER]: drives headless Chromium over the page of a running
watch, whose stage's FILE is wrong at first. Screenshots go to FOLDER, where it is given."""
import sys

from browser import in_browser, until

URL, FILE, SOLUTION = sys.argv[1:4]
FOLDER = sys.argv[4] if len(sys.argv) > 4 else None


def pixel(browser, canvas, column, row):
    return browser.run(f"return [...document.getElementById('{canvas}').getContext('2d')"
                       f".getImageData({column}, {row}, 1, 1).data.slice(0, 3)]")


def click_pixel(browser, column, row):
    x, y = browser.run(f"""
        const canvas = document.getElementById('expected');
        canvas.scrollIntoView({{block: 'center'}});
        const box = canvas.getBoundingClientRect();
        return [box.left + ({column} + 0.5) * box.width / canvas.width,
                box.top + ({row} + 0.5) * box.height / canvas.height];""")
    browser.click(round(x), round(y))


def chosen(browser):
    return [int(word) for word in browser.text("place").replace(",", "").split() if word.isdigit()]


def save(words):
    with open(FILE, "w", encoding="utf-8") as out:
        out.write(words)


def test(browser):
    browser.ask("POST", "/url", {"url": URL})
    until(lambda: browser.text("verdict").startswith("Not yet"), "the verdict")
    until(lambda: browser.text("yours-linear"), "the values of the first wrong pixel")
    assert "of 30 points" in browser.text("verdict")
    assert "✗L parallel to N" in browser.text("list"), browser.text("list")
    assert "expected" in browser.text("first")
    assert "L goes from the light to P" in browser.text("advice"), browser.text("advice")
    advice, panels = (browser.run(f"return document.getElementById('{name}').getBoundingClientRect()")
                      for name in ("advice", "panels"))
    assert 0 < advice["height"] and advice["y"] + advice["height"] <= panels["y"], (advice, panels)
    assert pixel(browser, "expected", 300, 20) == [255, 255, 255]
    assert pixel(browser, "yours", 300, 20) == [255, 255, 255]
    assert pixel(browser, "expected", 300, 349) == EXPECTED, pixel(browser, "expected", 300, 349)
    assert pixel(browser, "yours", 300, 349) != EXPECTED
    assert pixel(browser, "difference", 300, 349) != [255, 255, 255]
    browser.screenshot("desk")

    # A click, exact to the pixel that the browser's own scale allows.
    click_pixel(browser, 300, 349)
    column, row = chosen(browser)
    assert abs(column - 300) <= 1 and abs(row - 349) <= 1, (column, row)
    until(lambda: browser.text("yours-linear"), "the values of a part that was not loaded yet")
    for kind in ("yours", "expected"):
        linear = [float(word) for word in browser.text(kind + "-linear").split(",")]
        told = [int(word) for word in browser.text(kind + "-bytes").split()]
        assert told == pixel(browser, kind, column, row), (kind, told)
        assert [round(min(255, channel)) for channel in linear] == told, (linear, told)
    assert browser.text("judged") == "wrong"
    assert browser.text("explain") == f"./lab explain point {column} {row}"

    # Keys.
    browser.run("document.getElementById('panels').focus()")
    browser.press("\ue014")  # right
    assert chosen(browser) == [column + 1, row]
    browser.press("\ue008", "\ue013")  # Shift, up
    assert chosen(browser) == [column + 1, row - 10]
    browser.press("\ue011")  # Home
    assert chosen(browser) != [column + 1, row - 10]
    for _ in range(2):
        browser.press("\ue013")
    here = chosen(browser)
    browser.run("document.getElementById('copy').click()")
    until(lambda: browser.text("copy") == "copied", "copied")

    # A file that does not compile, with words that are no HTML.
    save('#error "<b id=evil>&amp;</b><img src=x onerror=alert(1)>"\n')
    until(lambda: browser.text("verdict") == "Does not compile", "does not compile")
    assert "<b id=evil>&amp;</b><img src=x" in browser.text("first"), browser.text("first")
    assert not browser.run("return document.querySelector('#evil, img')")
    assert not browser.text("advice"), browser.text("advice")
    assert browser.text("older"), "the pictures are older ones"
    assert pixel(browser, "expected", 300, 349) == EXPECTED

    # A save that is right: the page follows by itself, and one looks where one looked.
    with open(SOLUTION, encoding="utf-8") as solution:
        save(solution.read())
    until(lambda: browser.text("verdict").startswith("All right"), "the right verdict")
    assert "30 of 30 points" in browser.text("verdict")
    assert not browser.text("advice"), browser.text("advice")
    assert chosen(browser) == here, (chosen(browser), here)
    assert browser.text("judged") == "right"
    assert pixel(browser, "yours", 300, 349) == EXPECTED
    assert pixel(browser, "difference", 300, 349) == [255, 255, 255]
    assert browser.run("return document.getElementById('older').hidden")

    # A phone, and the dark.
    browser.devtools("Emulation.setDeviceMetricsOverride", width=360, height=740,
                     deviceScaleFactor=2, mobile=True)
    browser.devtools("Emulation.setEmulatedMedia",
                     features=[{"name": "prefers-color-scheme", "value": "dark"}])
    assert browser.run("return document.documentElement.scrollWidth") <= 360
    color = browser.run("return getComputedStyle(document.body).backgroundColor")
    assert color == "rgb(22, 24, 27)", color
    browser.screenshot("phone")

    browser.check_quiet()


# The slides' formula at column 300, row 400 of the lecture's scene, as tests/check has it.
EXPECTED = [161, 0, 0]

in_browser(test, FOLDER)
print("the page: passed")
