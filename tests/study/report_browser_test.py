"""Opens the example report from disk in a headless Chromium and uses it.

report_browser_test.py REPORT_PAGE [--screenshots FOLDER]
REPORT_PAGE is the program that writes the page. Ends with 77 where Chromium, its driver or Selenium
is missing. Debian: chromium chromium-driver python3-selenium.
"""
import argparse
import base64
import json
import os
import shutil
import struct
import subprocess
import sys
import tempfile
import unittest
import zlib
from pathlib import Path

try:
    from selenium import webdriver
    from selenium.webdriver import ActionChains
    from selenium.webdriver.chrome.service import Service
    from selenium.webdriver.common.actions.wheel_input import ScrollOrigin
    from selenium.webdriver.common.by import By
    from selenium.webdriver.common.keys import Keys
    from selenium.webdriver.support.ui import Select, WebDriverWait
except ImportError:
    webdriver = None

RED, GREEN, BLUE = (255, 0, 0), (0, 255, 0), (0, 0, 255)
YELLOW, MAGENTA, BLACK = (255, 255, 0), (255, 0, 255), (0, 0, 0)
LABELS = ["point", "line <i>&'exact'</i>", "reference"]


def decode_png(data):
    """Rows of pixels of an 8-bit PNG without interlacing: each a list of (r, g, b)."""
    position, compressed = 8, b""
    while position < len(data):
        length, kind = struct.unpack(">I4s", data[position:position + 8])
        body = data[position + 8:position + 8 + length]
        if kind == b"IHDR":
            width, height, _, colour = struct.unpack(">IIBB", body[:10])
        if kind == b"IDAT":
            compressed += body
        position += length + 12
    size = {2: 3, 6: 4}[colour]
    raw = zlib.decompress(compressed)
    rows, previous = [], bytearray(width * size)
    for y in range(height):
        start = y * (width * size + 1)
        row = bytearray(raw[start + 1:start + 1 + width * size])
        unfilter(raw[start], row, previous, size)
        rows.append([tuple(row[i:i + 3]) for i in range(0, len(row), size)])
        previous = row
    return rows


def unfilter(kind, row, above, size):
    for i in range(len(row)):
        a = row[i - size] if i >= size else 0
        b = above[i]
        c = above[i - size] if i >= size else 0
        paeth = min((a, b, c), key=lambda value: abs(a + b - c - value))
        row[i] = (row[i] + (0, a, b, (a + b) // 2, paeth)[kind]) & 255


class ReportPage(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.folder.cleanup)
        page = Path(cls.folder.name, "report page.html")
        subprocess.run([OPTIONS.report_page, str(page)], check=True)
        cls.url = page.as_uri()
        options = webdriver.ChromeOptions()
        options.binary_location = shutil.which("chromium")
        for argument in ("--headless=new", "--disable-gpu", "--disable-dev-shm-usage",
                         f"--user-data-dir={cls.folder.name}/profile"):
            options.add_argument(argument)
        if os.geteuid() == 0:
            options.add_argument("--no-sandbox")  # Chromium refuses to run as root with it
        options.set_capability("goog:loggingPrefs", {"browser": "ALL", "performance": "ALL"})
        cls.browser = webdriver.Chrome(
            service=Service(shutil.which("chromedriver")), options=options)
        cls.addClassCleanup(cls.browser.quit)
        cls.browser.get("about:blank")  # its first page asks for its own parts

    def setUp(self):
        self.loads = 0
        for kind in ("browser", "performance"):
            self.browser.get_log(kind)  # forgets what came before
        self.open(1280, 900)

    def tearDown(self):
        """After every test: nothing failed in the page and nothing was asked of the network."""
        messages = [entry["message"] for entry in self.browser.get_log("browser")]
        self.assertEqual(messages, [])
        events = [json.loads(entry["message"])["message"]
                  for entry in self.browser.get_log("performance")]
        asked = [event["params"]["request"]["url"].partition(":")[0] for event in events
                 if event["method"] == "Network.requestWillBeSent"]
        self.assertEqual(asked.count("file"), self.loads)
        self.assertEqual(set(asked), {"file", "data"})

    def open(self, width, height, dark=False, ratio=1):
        command = self.browser.execute_cdp_cmd
        command("Emulation.setDeviceMetricsOverride",
                {"width": width, "height": height, "deviceScaleFactor": ratio, "mobile": False})
        command("Emulation.setEmulatedMedia", {"features": [
            {"name": "prefers-color-scheme", "value": "dark" if dark else "light"}]})
        self.loads += 1
        self.browser.get(self.url)
        WebDriverWait(self.browser, 20).until(
            lambda browser: browser.find_elements(By.CSS_SELECTOR, "#viewer.live"))

    def element(self, name):
        return self.browser.find_element(By.ID, name)

    def press(self, *keys):
        ActionChains(self.browser).send_keys(*keys).perform()

    def press_with_shift(self, key):
        ActionChains(self.browser).key_down(Keys.SHIFT).send_keys(key).key_up(Keys.SHIFT).perform()

    def drag(self, element, x, y=0):
        ActionChains(self.browser).click_and_hold(element).move_by_offset(x, y).release().perform()

    def pan(self, x, y):
        """Drags the picture, off the divider."""
        ActionChains(self.browser).move_to_element_with_offset(self.element("stage"), -100, -100) \
            .click_and_hold().move_by_offset(x, y).release().perform()

    def wheel(self, amount):
        origin = ScrollOrigin.from_element(self.element("stage"))
        ActionChains(self.browser).scroll_from_origin(origin, 0, amount).perform()

    def split(self):
        return int(self.element("divider").get_attribute("aria-valuenow"))

    def zoom(self):
        return float(self.element("zoom-level").text.split()[0])

    def chosen(self):
        return [Select(self.element(side)).first_selected_option.text for side in ("left", "right")]

    def stage(self, x, y, width, height):
        """Pixels of the screen in a part of the stage."""
        box = self.browser.execute_script(
            "scrollTo(0, 0); return stage.getBoundingClientRect().toJSON()")
        return decode_png(self.capture(clip={
            "x": box["x"] + x, "y": box["y"] + y, "width": width, "height": height, "scale": 1}))

    def row(self):
        """The row of pixels at three quarters of the stage's height, below the checkerboard."""
        size = self.element("stage").size
        return self.stage(0, size["height"] * 3 // 4, size["width"], 1)[0]

    def colours(self):
        """Colours near the left and the right end of that row of the picture."""
        row = self.row()
        inside = [x for x, colour in enumerate(row) if min(colour) == 0]
        return row[inside[0] + 5], row[inside[-1] - 5]

    def capture(self, **options):
        answer = self.browser.execute_cdp_cmd("Page.captureScreenshot", options)
        return base64.b64decode(answer["data"])

    def screenshot(self, name, whole=False):
        if OPTIONS.screenshots:
            path = Path(OPTIONS.screenshots, name + ".png")
            path.write_bytes(self.capture(captureBeyondViewport=whole))

    def test_shows_the_first_two_pictures_and_all_text(self):
        self.assertEqual(self.chosen(), LABELS[:2])
        self.assertEqual(self.colours(), (RED, GREEN))
        text = self.browser.find_element(By.TAG_NAME, "main").text
        for part in ("Cornell <Box> & \"friends\"", "a < b", "{{title}}", LABELS[1],
                     "relMSE 0.0007", "Error against time", "4.4 x", "--out <dir>"):
            self.assertIn(part, text)
        self.assertTrue(self.element("help").is_displayed())
        self.screenshot("light", whole=True)

    def test_charts_are_shown_and_run_nothing(self):
        chart = self.browser.find_element(By.CSS_SELECTOR, ".chart img")
        self.assertEqual(chart.get_property("naturalWidth"), 640)
        self.assertIsNone(self.browser.execute_script("return window.chartScriptRan"))

    def test_pictures_are_decoded(self):
        sizes = self.browser.execute_script(
            "return [...document.querySelectorAll('.picture img')].map(i => i.naturalWidth)")
        self.assertEqual(sizes, [480] * 5)

    def test_dragging_the_divider_moves_the_split(self):
        self.assertEqual(self.split(), 50)
        self.drag(self.element("divider"), 192)  # a fifth of the 960 pixels at zoom 2
        self.assertEqual(self.split(), 70)
        row = self.row()
        self.assertAlmostEqual(row.index(GREEN), (len(row) - 960) / 2 + 0.7 * 960, delta=8)
        self.drag(self.element("divider"), 400)
        self.assertEqual(self.split(), 100)

    def test_touch_moves_the_split(self):
        box = self.element("divider").rect
        x, y = box["x"] + box["width"] / 2, box["y"] + box["height"] / 4
        # It begins upwards, where a finger elsewhere would scroll the page.
        for kind, points in (("touchStart", [{"x": x, "y": y}]),
                             ("touchMove", [{"x": x, "y": y - 80}]),
                             ("touchMove", [{"x": x - 100, "y": y - 90}]),
                             ("touchMove", [{"x": x - 288, "y": y - 100}]), ("touchEnd", [])):
            self.browser.execute_cdp_cmd("Input.dispatchTouchEvent",
                                         {"type": kind, "touchPoints": points})
        self.assertEqual(self.split(), 20)
        self.assertEqual(self.browser.execute_script("return scrollY"), 0)

    def test_arrow_keys_move_the_split(self):
        self.press(Keys.ARROW_RIGHT)
        self.assertEqual(self.split(), 52)
        self.press(Keys.ARROW_LEFT, Keys.ARROW_LEFT)
        self.assertEqual(self.split(), 48)
        divider = self.element("divider")
        for key, expected in ((Keys.END, 100), (Keys.HOME, 0), (Keys.PAGE_UP, 10),
                              (Keys.ARROW_UP, 12), (Keys.ARROW_LEFT, 10), (Keys.PAGE_DOWN, 0)):
            divider.send_keys(key)
            self.assertEqual(self.split(), expected, key)
        self.assertEqual(self.colours(), (GREEN, GREEN))
        self.assertIn("100 % line", divider.get_attribute("aria-valuetext"))

    def test_flip_shows_one_whole_picture_then_the_other(self):
        for key, colour in (("f", RED), ("F", GREEN), (" ", RED), ("f", GREEN)):
            self.press(key)
            self.assertEqual(self.colours(), (colour, colour))
        self.assertFalse(self.element("left-caption").is_displayed())
        self.press(Keys.ESCAPE)
        self.assertEqual(self.colours(), (RED, GREEN))
        self.element("flip").click()
        self.assertEqual(self.colours(), (RED, RED))
        self.press("3")
        self.assertEqual(self.colours(), (BLUE, BLUE))
        self.press(Keys.ARROW_RIGHT)
        self.assertEqual(self.colours(), (BLUE, GREEN))

    def test_digits_and_select_boxes_choose(self):
        self.press("3")
        self.assertEqual(self.chosen(), [LABELS[2], LABELS[1]])
        self.assertEqual(self.colours(), (BLUE, GREEN))
        self.press_with_shift("1")
        self.assertEqual(self.colours(), (BLUE, RED))
        self.press("9")  # there are only three
        Select(self.element("left")).select_by_index(1)
        Select(self.element("right")).select_by_index(2)
        self.assertEqual(self.colours(), (GREEN, BLUE))
        self.assertIn("4 spp, 0.43 s", self.element("left-caption").text)
        Select(self.element("right")).select_by_index(1)
        self.assertEqual(self.colours(), (GREEN, GREEN))
        self.assertFalse(self.element("divider").is_displayed())

    def test_error_maps_toggle(self):
        self.press("e")
        self.assertEqual(self.colours(), (YELLOW, MAGENTA))
        self.assertEqual(self.element("errors").get_attribute("aria-pressed"), "true")
        self.press("3")
        self.assertEqual(self.colours(), (BLUE, MAGENTA))
        self.assertIn("(no error map)", self.element("left-caption").text)
        self.assertIn("(error map)", self.element("right-caption").text)
        self.screenshot("errors")
        self.element("errors").click()
        self.assertEqual(self.colours(), (BLUE, GREEN))

    def test_zoom_keeps_pixels_sharp(self):
        self.assertEqual(self.zoom(), 2)
        self.press("+", "+", "+")
        self.assertEqual(self.zoom(), 6)
        self.wheel(-120)
        self.assertEqual(self.zoom(), 8)
        picture = self.browser.find_element(By.CSS_SELECTOR, ".picture img")
        self.assertEqual(picture.value_of_css_property("image-rendering"), "pixelated")
        self.assertEqual(picture.size["width"], 8 * 480)
        for _ in range(4):  # to the corner with the checkerboard, and not beyond
            self.pan(500, 280)
        self.screenshot("zoomed")
        for y, row in enumerate(self.stage(8, 8, 200, 24)):
            self.assertEqual(row, [BLACK if (x // 8 + y // 8) % 2 else RED for x in range(200)])
        self.press("0")
        self.assertEqual(self.zoom(), 2)
        self.element("zoom-out").click()  # all is in view already
        self.assertEqual(self.zoom(), 2)
        self.element("zoom-in").click()
        self.assertEqual(self.zoom(), 3)
        self.element("zoom-out").click()
        self.assertEqual(self.zoom(), 2)

    def test_wheel_zooms_about_the_pointer_and_drag_pans(self):
        left = lambda: self.browser.find_element(By.CSS_SELECTOR, ".picture").rect["x"]
        middle = 1280 / 2 - 7.5  # the scroll bar has 15 pixels
        before = (middle - left()) / self.zoom()
        self.wheel(-120)
        self.wheel(-120)
        self.assertEqual(self.zoom(), 4)
        self.assertAlmostEqual((middle - left()) / self.zoom(), before, delta=4)
        start, split = left(), self.split()
        self.pan(-37, 0)
        self.assertAlmostEqual(left(), start - 37, delta=0.01)
        self.press_with_shift(Keys.ARROW_RIGHT)
        self.assertAlmostEqual(left(), start - 37 - 120, delta=0.01)
        self.assertEqual(self.split(), split)

    def test_wheel_at_the_last_level_scrolls_the_page(self):
        self.press("+")
        self.wheel(120)
        self.assertEqual(self.zoom(), 2)
        self.assertEqual(self.browser.execute_script("return scrollY"), 0)
        self.wheel(120)
        WebDriverWait(self.browser, 5).until(
            lambda browser: browser.execute_script("return scrollY") > 0)
        self.assertEqual(self.zoom(), 2)

    def test_keys_leave_other_controls_alone(self):
        self.element("right").send_keys("r")  # the select box's own search
        self.assertEqual(self.chosen(), [LABELS[0], LABELS[2]])
        self.element("right").send_keys("e2")
        self.assertEqual(self.element("errors").get_attribute("aria-pressed"), "false")
        self.assertEqual(self.chosen(), [LABELS[0], LABELS[2]])
        self.element("zoom-in").send_keys(" ")  # a click, not a flip
        self.assertEqual(self.zoom(), 3)
        self.assertEqual(self.split(), 50)
        self.assertTrue(self.element("right-caption").is_displayed())

    def test_narrow_window(self):
        self.open(400, 800)
        width = self.browser.execute_script("return document.documentElement.scrollWidth")
        self.assertLessEqual(width, 400)
        self.assertLess(self.zoom(), 1)
        self.assertEqual(self.colours(), (RED, GREEN))
        self.drag(self.element("divider"), -60)
        self.assertLess(self.split(), 40)
        self.press("+")
        self.assertEqual(self.zoom(), 1)
        self.screenshot("narrow", whole=True)

    def test_dark_page_keeps_charts_on_white(self):
        self.open(1280, 900, dark=True)
        colour = lambda css: self.browser.find_element(
            By.CSS_SELECTOR, css).value_of_css_property("background-color")
        self.assertEqual(colour("body"), "rgba(21, 23, 26, 1)")
        self.assertEqual(colour(".chart img"), "rgba(255, 255, 255, 1)")
        self.screenshot("dark", whole=True)

    def test_dense_screen_shows_whole_pixels(self):
        self.open(1280, 900, ratio=1.5)
        self.assertEqual(self.zoom(), 3)
        picture = self.browser.find_element(By.CSS_SELECTOR, ".picture")
        self.assertEqual(picture.size["width"], 3 * 480 / 1.5)


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("report_page")
    parser.add_argument("--screenshots", help="existing folder that screenshots are written to")
    OPTIONS, rest = parser.parse_known_args()
    missing = [name for name in ("chromium", "chromedriver") if not shutil.which(name)]
    if webdriver is None:
        missing.append("selenium for " + sys.executable)
    if missing:
        print("skipped, missing: " + ", ".join(missing))
        sys.exit(77)
    unittest.main(argv=sys.argv[:1] + rest, verbosity=2)
