#!/usr/bin/env python3
"""figures_test.py BUILD LECTURE [FOLDER]: drives headless Chromium over the live figures of BUILD.
LECTURE is the lecture's scene as the stage program makes it, a PPM. Screenshots go to FOLDER."""
import hashlib
import pathlib
import re
import subprocess
import sys

from browser import in_browser, until

BUILD, LECTURE = (pathlib.Path(argument) for argument in sys.argv[1:3])
FOLDER = sys.argv[3] if len(sys.argv) > 3 else None
LEFT, UP, RIGHT, DOWN, PAGE_UP, END, HOME, SHIFT = (
    "\ue012", "\ue013", "\ue014", "\ue015", "\ue00e", "\ue010", "\ue011", "\ue008")
compared = set()  # the frames, by module and numbers

# What the screen shows, and what it was made of.
SHOWN = """
    return Promise.all(Object.entries(figure.frames).map(async ([i, frame]) => {
      const canvas = document.querySelectorAll("canvas")[i];
      const { data } = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
      const hash = new Uint8Array(await crypto.subtle.digest("SHA-256", data));
      return { ...frame, hash: [...hash].map((byte) => byte.toString(16).padStart(2, "0")).join("") };
    }))"""


def native(module, numbers):
    """The pixels as a program makes them that has never seen a browser, RGBA."""
    line = " ".join(repr(number) for number in numbers) + "\n"
    return subprocess.run([BUILD / "bin" / f"figure_{module}"], input=line.encode(),
                          stdout=subprocess.PIPE, check=True).stdout


def opened(browser, name, query="lang=en"):
    page = BUILD / "figures" / f"{name}.html"
    browser.ask("POST", "/url", {"url": f"{page.resolve().as_uri()}?{query}"})
    settle(browser)


def settle(browser):
    until(lambda: browser.run("return window.figure && !figure.busy"), "the frame")
    assert not browser.run("return document.querySelector('[role=alert]')")


def check_frames(browser):
    """Each canvas shows what its numbers give."""
    settle(browser)
    frames = browser.run(SHOWN)
    assert frames
    for frame in frames:
        pixels = native(frame["module"], frame["numbers"])
        width, height = frame["numbers"][2:4]
        assert len(pixels) == 4 * width * height, len(pixels)
        assert hashlib.sha256(pixels).hexdigest() == frame["hash"], frame
        compared.add((frame["module"], *frame["numbers"]))
    return [frame["numbers"] for frame in frames]


def text(browser, selector):
    return browser.run(f"return document.querySelector(`{selector}`).textContent")


def focus(browser, selector, number=0):
    browser.run(f"document.querySelectorAll('{selector}')[{number}].focus()")


def drag(browser, selector, start, end):
    """From one place to another in the units of a picture, 600 to each side; the button is down
    unless both are the same, which is a mere visit."""
    places = browser.run(f"""
        const target = document.querySelector(`{selector}`);
        target.scrollIntoView({{ block: "nearest" }});
        const box = target.getBoundingClientRect();
        return [{list(start)}, {list(end)}].map(([x, y]) =>
          [box.left + x * box.width / 600, box.top + y * box.height / 600].map(Math.round));""")
    move = [{"type": "pointerMove", "duration": 0, "x": x, "y": y} for x, y in places]
    steps = move[:1] if start == end else [
        move[0], {"type": "pointerDown", "button": 0}, move[1], {"type": "pointerUp", "button": 0}]
    browser.ask("POST", "/actions", {"actions": [{"type": "pointer", "id": "m", "actions": steps}]})


def choose(browser, number, value):
    browser.run(f"""
        const select = document.querySelectorAll("select")[{number}];
        select.value = "{value}";
        select.dispatchEvent(new Event("change"));""")


def lights(browser):
    opened(browser, "lights")
    [numbers] = check_frames(browser)
    ppm = LECTURE.read_bytes()
    assert ppm.startswith(b"P6\n600 600\n255\n"), ppm[:20]
    rgba = native("combined", numbers)
    assert bytes(ppm[15:]) == bytes(byte for i, byte in enumerate(rgba) if i % 4 != 3)

    at = -8  # of the point light's intensity and position; then those of the directional light
    assert numbers[at:] == [0.6, 2, 1, 0, 0.2, 1, 4, 4], numbers[at:]
    focus(browser, ".picture")
    for key in (RIGHT, UP, UP, PAGE_UP):
        browser.press(key)
    [numbers] = check_frames(browser)
    assert numbers[at:at + 4] == [0.6, 2.1, 1.2, 0.1], numbers[at:]
    drag(browser, ".picture", (450, 225), (150, 100))
    [numbers] = check_frames(browser)
    assert abs(numbers[at + 1] + 2) < 0.03 and abs(numbers[at + 2] - 2.67) < 0.03, numbers[at:]
    assert "position  = (-2" in text(browser, "pre") or "(-1.9" in text(browser, "pre")
    drag(browser, ".map .sun", (300, 300), (300, -2000))
    [numbers] = check_frames(browser)
    assert numbers[at + 3] > 3, numbers[at:]
    drag(browser, ".map .arrow", (300, 300), (-2500, 300))
    [numbers] = check_frames(browser)
    assert numbers[at + 5] < 0, numbers[at:]  # it shines from the left
    for slider in range(8):
        for key in (HOME, END):
            focus(browser, "input", slider)
            browser.press(key)
            check_frames(browser)
    browser.run("document.querySelector('button').click()")
    [numbers] = check_frames(browser)
    assert numbers[at:] == [0.6, 2, 1, 0, 0.2, 1, 4, 4], numbers[at:]


def cosine(browser):
    opened(browser, "cosine")
    [before] = check_frames(browser)

    def table():
        rows = browser.run("return [...document.querySelectorAll('td')].map((e) => e.textContent)")
        return [[float(x) for x in re.findall(r"-?\d+\.\d+", row)] for row in rows]

    for place in ((310, 280), (355, 195), (420, 250), (180, 400)):
        drag(browser, ".picture", place, place)
        P, N, L, [NL], [length_N], [length_L], [angle] = table()
        told = float(text(browser, ".verdict").split()[-1])
        near = lambda a, b: abs(a - b) < 0.004  # of numbers that are told to three decimals
        assert near(length_N, 1) and near(NL, sum(n * l for n, l in zip(N, L))), table()
        assert near(length_L, sum(l * l for l in L) ** 0.5), table()
        assert near(told, NL / length_L), (told, table())
        assert all(near(light, p + l) for light, p, l in zip(before[-3:], P, L)), table()
        assert (angle > 90) == (NL < 0) == ("behind" in text(browser, "[role=status]")), table()
    drag(browser, ".picture", (20, 580), (20, 580))
    assert "no P" in text(browser, "[role=status]")
    focus(browser, ".picture")
    drag(browser, ".picture", (300, 299), (300, 299))
    P = table()[0]
    for _ in range(3):
        browser.press(RIGHT)
    assert table()[0][0] > P[0]
    browser.press(SHIFT, LEFT)
    [numbers] = check_frames(browser)
    assert abs(numbers[-3] - before[-3] + 0.05) < 1e-9, numbers
    drag(browser, ".sun", (300, 300), (-1500, 2000))
    [numbers] = check_frames(browser)
    assert numbers[-3] < before[-3] - 0.1 and numbers[-2] < before[-2] - 0.1, numbers


def mistakes(browser):
    opened(browser, "mistakes", "lang=en&mistake=negative_kept")
    assert "pixels differ" in text(browser, ".verdict"), text(browser, ".verdict")
    options = browser.run("return [...document.querySelectorAll('option')].map((e) => e.value)")
    assert len(options) > 100 and len(set(options)) == len(options), len(options)
    for value in options[::6]:
        choose(browser, 0, value)
        right, wrong = check_frames(browser)
        assert right[0] == 0 and wrong[0] == int(value) + 1 and right[1:] == wrong[1:]
    focus(browser, ".picture")
    browser.press(UP)
    check_frames(browser)
    drag(browser, ".picture", (450, 225), (300, 50))
    check_frames(browser)


def floor(browser):
    opened(browser, "floor")
    assert text(browser, ".verdict").startswith("16 of "), text(browser, ".verdict")
    for stage in ("flat_color", "combined"):
        choose(browser, 0, stage)
        for key in (None, HOME, END, LEFT):
            focus(browser, "input")
            if key:
                browser.press(key)
            check_frames(browser)


def sun(browser):
    opened(browser, "sun")
    verdicts = {}
    for precision in ("", "_float"):
        choose(browser, 0, precision)
        for key in (HOME, RIGHT, END):
            focus(browser, "input")
            browser.press(key)
            check_frames(browser)
        verdicts[precision] = text(browser, ".verdict")
    assert verdicts[""].startswith("All 360000 pixels are the same"), verdicts
    assert "differ" in verdicts["_float"], verdicts  # |L|² is infinite


def speed(browser, name, module):
    """Frames a second while the light is dragged, as the browser lets the page draw them."""
    opened(browser, name)
    return browser.run("""
        const frame = document.querySelector(".picture");
        const box = frame.getBoundingClientRect();
        const send = (kind, x) => frame.dispatchEvent(new PointerEvent(kind, { pointerId: 1,
          clientX: box.left + x, clientY: box.top + box.height / 3, bubbles: true }));
        frame.setPointerCapture = () => {};
        frame.hasPointerCapture = () => true;
        send("pointerdown", 10);
        return new Promise((resolve) => {
          const [began, count] = [performance.now(), figure.count];
          const step = () => {
            const seconds = (performance.now() - began) / 1000;
            if (seconds > 3) return resolve((figure.count - count) / seconds);
            send("pointermove", box.width * (0.5 + 0.4 * Math.sin(3 * seconds)));
            requestAnimationFrame(step);
          };
          step();
        });""")


def pages(browser, name):
    """As each page looks on a desk and on a phone, by day and by night, in both languages; and where
    no script may run."""
    for language in ("en", "el"):
        for width, height, scheme in ((1200, 900, "light"), (390, 844, "dark")):
            browser.devtools("Emulation.setDeviceMetricsOverride", width=width, height=height,
                             deviceScaleFactor=1, mobile=width < 500)
            browser.devtools("Emulation.setEmulatedMedia",
                             features=[{"name": "prefers-color-scheme", "value": scheme}])
            opened(browser, name, f"lang={language}")
            assert browser.run("return document.documentElement.scrollWidth") <= width, (name, width)
            assert browser.run("return document.documentElement.lang") == language
            is_greek = re.search("[α-ω]{3}", text(browser, "body > p")) is not None
            assert is_greek == (language == "el"), (name, language)
            browser.screenshot(f"{name}-{language}-{width}-{scheme}")
    browser.devtools("Emulation.clearDeviceMetricsOverride")
    browser.devtools("Emulation.setScriptExecutionDisabled", value=True)
    browser.ask("POST", "/refresh")
    until(lambda: browser.run("return document.querySelector('noscript img')?.naturalWidth") == 600,
          "the still picture")
    browser.screenshot(f"{name}-still")
    browser.devtools("Emulation.setScriptExecutionDisabled", value=False)


def must_fail(check, what):
    try:
        check()
    except AssertionError:
        return
    raise AssertionError("not caught: " + what)


def test(browser):
    for figure in (lights, cosine, mistakes, floor, sun):
        before = len(compared)
        figure(browser)
        browser.check_quiet()
        pages(browser, figure.__name__)
        browser.check_quiet()
        print(f"{figure.__name__}: {len(compared) - before} frames are the native ones")
    for name in ("lights", "mistakes"):
        print(f"{name}: {speed(browser, name, None):.0f} frames a second while the light is dragged")

    # One byte of one pixel is found, and a request that would go out.
    opened(browser, "sun")
    browser.run("""
        const context = document.querySelectorAll("canvas")[1].getContext("2d");
        const pixels = context.getImageData(0, 0, 600, 600);
        pixels.data[4 * 599 * 600 + 1] ^= 1;
        context.putImageData(pixels, 0, 0);""")
    must_fail(lambda: check_frames(browser), "a byte of the picture")
    browser.run("return fetch('https://example.org/').catch(() => {})")
    must_fail(browser.check_quiet, "a request")


in_browser(test, FOLDER)
print(f"the figures: passed, {len(compared)} frames")
