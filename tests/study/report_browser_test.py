"""Opens reports from disk in a headless Chromium and uses them.

report_browser_test.py REPORT_PAGE RAYTRACING [--screenshots FOLDER]
REPORT_PAGE is the program that writes the example pages; RAYTRACING makes a small chart. Ends with
77 where Chromium, its driver or Selenium is missing. Debian: chromium chromium-driver
python3-selenium.
"""
import argparse
import importlib.util
import shutil
import subprocess
import sys
import unittest
from pathlib import Path

missing = [name for name in ("chromium", "chromedriver") if not shutil.which(name)]
if importlib.util.find_spec("selenium") is None:
    missing.append("selenium for " + sys.executable)
if missing:
    print("skipped, missing: " + ", ".join(missing))
    sys.exit(77)

from report_browser import By, Keys, ReportBrowser, Select, WebDriverWait

RED, GREEN, BLUE = (255, 0, 0), (0, 255, 0), (0, 0, 255)
YELLOW, MAGENTA, BLACK = (255, 255, 0), (255, 0, 255), (0, 0, 0)
LABELS = ["point", "line <i>&'exact'</i>", "reference"]


class ReportPage(ReportBrowser):
    def test_shows_the_first_two_pictures_and_all_text(self):
        self.assertEqual(self.chosen(), LABELS[:2])
        self.assertEqual(self.colours(), (RED, GREEN))
        text = self.browser.find_element(By.TAG_NAME, "main").text
        for part in ("Cornell <Box> & \"friends\"", "a < b", "{{title}}", LABELS[1],
                     "relMSE 0.0007", "Error against time", "4.4 x", "--out <dir>"):
            self.assertIn(part, text)
        self.assertTrue(self.element("help").is_displayed())
        self.screenshot("light", whole=True)

    def test_every_text_is_an_element_of_its_own(self):
        texts = self.browser.execute_script(
            "return [...document.querySelectorAll('main *')].map((e) => e.textContent)")
        for text in ("First note: a < b.", "Second note: {{title}} stays as it is.", *LABELS,
                     "16 spp, 0.42 s, relMSE 0.0031", "4096 spp, 90 s", "Error against time",
                     "At equal time", "method", "relMSE", "speed", "3.1e-3", "-", "4.4 x",
                     "command", "Raytracing chart --scene 'a b.toml' --out <dir>",
                     "Release, AVX2"):
            self.assertIn(text, texts)
        self.assertEqual(self.browser.title, "Cornell <Box> & \"friends\"")
        self.assertEqual(texts.count(self.browser.title), 1)
        meaning = self.browser.find_element(By.CSS_SELECTOR, "dt").get_attribute("title")
        self.assertEqual(meaning, "command line")

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


class TablesReport(ReportBrowser):
    """A page that has nothing but tables."""
    built = "table"

    @classmethod
    def make_page(cls, page):
        subprocess.run([cls.report_page, str(page), "tables"], check=True)

    def count(self, css):
        return len(self.browser.find_elements(By.CSS_SELECTOR, css))

    def test_empty_parts_are_left_out(self):
        self.assertEqual([self.count(css) for css in ("section", "img", "dl", "#viewer")],
                         [1, 0, 0, 0])

    def test_columns_of_numbers_are_flush_right(self):
        table = self.browser.find_element(By.CSS_SELECTOR, "table")
        numbers = [cell.text for cell in table.find_elements(By.CSS_SELECTOR, "th.number")]
        self.assertEqual(numbers, ["number", "with unit", "signed"])
        self.assertEqual(len(table.find_elements(By.CSS_SELECTOR, ".number")), 9)

    def test_rows_have_any_length(self):
        rows = self.browser.find_elements(By.CSS_SELECTOR, "table")[1] \
            .find_elements(By.CSS_SELECTOR, "tbody tr")
        self.assertEqual([len(row.find_elements(By.CSS_SELECTOR, "td")) for row in rows],
                         [1, 3, 0])


class ChartReport(ReportBrowser):
    """The page of a real chart."""
    raytracing = ""  # the program
    scene = Path(__file__).parents[2] / "scenes" / "cornell.toml"

    @classmethod
    def make_page(cls, page):
        chart = page.parent / "chart"
        subprocess.run([cls.raytracing, "chart", "--scene", cls.scene, "--width", "16", "--height",
                        "16", "--max-depth", "1", "--methods", "point,line", "--spp", "1,4,16",
                        "--seeds", "2", "--reference-time", "0.2", "--quiet", "--out", chart],
                       check=True)
        shutil.copyfile(chart / "report.html", page)

    def test_shows_methods_charts_and_tables(self):
        self.assertEqual(self.chosen(), ["point", "line"])
        text = self.browser.find_element(By.TAG_NAME, "main").text
        for part in ("cornell, 16x16, direct light only", "relMSE", "chart --scene"):
            self.assertIn(part, text)
        sizes = self.browser.execute_script(
            "return [...document.querySelectorAll('.picture img')].map(i => i.naturalWidth)")
        self.assertEqual(set(sizes), {16})
        self.assertGreater(len(self.browser.find_elements(By.CSS_SELECTOR, "table tr")), 6)

    def test_slider_and_keys_work(self):
        self.press(Keys.ARROW_RIGHT)
        self.assertEqual(self.split(), 52)
        self.press("3")
        self.assertEqual(self.chosen()[0], "reference")


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("report_page")
    parser.add_argument("raytracing")
    parser.add_argument("--screenshots", help="existing folder that screenshots are written to")
    options, rest = parser.parse_known_args()
    ReportBrowser.report_page = options.report_page
    ChartReport.raytracing = options.raytracing
    ReportBrowser.screenshots = options.screenshots
    unittest.main(argv=sys.argv[:1] + rest, verbosity=2)
