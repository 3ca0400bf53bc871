"""Report pages in a headless Chromium, for report_browser_test.py."""
import base64
import json
import os
import shutil
import struct
import subprocess
import tempfile
import unittest
import zlib
from pathlib import Path

from selenium import webdriver
from selenium.webdriver import ActionChains
from selenium.webdriver.chrome.service import Service
from selenium.webdriver.common.actions.wheel_input import ScrollOrigin
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys
from selenium.webdriver.support.ui import Select, WebDriverWait


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


class ReportBrowser(unittest.TestCase):
    """Opens the page anew for every test and checks after it that the page kept silent."""
    report_page = ""  # the program that writes the example pages
    built = "#viewer.live"  # an element of the page once its scripts are done
    screenshots = ""  # folder for screenshots, empty for none

    @classmethod
    def make_page(cls, page):
        subprocess.run([cls.report_page, str(page)], check=True)

    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.folder.cleanup)
        page = Path(cls.folder.name, "report page.html")
        cls.make_page(page)
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
        self.assertLessEqual(set(asked), {"file", "data"})

    def open(self, width, height, dark=False, ratio=1):
        command = self.browser.execute_cdp_cmd
        command("Emulation.setDeviceMetricsOverride",
                {"width": width, "height": height, "deviceScaleFactor": ratio, "mobile": False})
        command("Emulation.setEmulatedMedia", {"features": [
            {"name": "prefers-color-scheme", "value": "dark" if dark else "light"}]})
        self.loads += 1
        self.browser.get(self.url)
        WebDriverWait(self.browser, 20).until(
            lambda browser: browser.find_elements(By.CSS_SELECTOR, self.built))

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
        if self.screenshots:
            path = Path(self.screenshots, name + ".png")
            path.write_bytes(self.capture(captureBeyondViewport=whole))
