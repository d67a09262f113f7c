# SPDX-License-Identifier: BSD-3-Clause
# browser_test.py SAMPLE_PAGE [METHOD]: the report's page in headless Chromium. Ends with 77 where Chromium cannot be driven.
import io
import json
import re
import shutil
import socket
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

try:
    from PIL import Image
    from selenium import webdriver
    from selenium.webdriver.common.action_chains import ActionChains
    from selenium.webdriver.common.by import By
    from selenium.webdriver.common.keys import Keys
    from selenium.webdriver.chrome.service import Service
except ImportError:
    print("python3-selenium or python3-pil is not installed")
    sys.exit(77)
if not (shutil.which("chromium") and shutil.which("chromedriver")):
    print("chromium or chromium-driver is not installed")
    sys.exit(77)
try:
    socket.gethostbyname("localhost")
except OSError:
    print("localhost is not known here, by which Chromium and its driver talk")
    sys.exit(77)

SAMPLE_PAGE = sys.argv.pop(1)
DESKTOP = (1400, 1000)
PHONE = (390, 844)
MAP = (20.0, 10.0)  # of the sample [m]


class Report(unittest.TestCase):
    def setUp(self):
        self.folder = Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.folder)
        options = webdriver.ChromeOptions()
        for argument in ["--headless=new", "--no-sandbox", "--disable-dev-shm-usage", f"--user-data-dir={self.folder}/profile"]:
            options.add_argument(argument)
        options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
        self.browser = webdriver.Chrome(service=Service(shutil.which("chromedriver")), options=options)
        self.addCleanup(self.browser.quit)

    def open(self, kind="plain", size=DESKTOP, theme="light"):
        page = self.folder / f"{kind}.html"
        made = subprocess.run([SAMPLE_PAGE, kind, page], check=True, stdout=subprocess.PIPE)
        mobile = {"width": size[0], "height": size[1], "deviceScaleFactor": 1, "mobile": size == PHONE}
        self.browser.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", mobile)
        scheme = {"features": [{"name": "prefers-color-scheme", "value": theme}]}
        self.browser.execute_cdp_cmd("Emulation.setEmulatedMedia", scheme)
        self.browser.get(page.as_uri())
        return json.loads(made.stdout)

    def tearDown(self):
        complaints = [entry["message"] for entry in self.browser.get_log("browser")]
        self.assertEqual(complaints, [], "the console says nothing")

    def element(self, css):
        return self.browser.find_element(By.CSS_SELECTOR, css)

    def text(self, css):
        return self.element(css).text

    def script(self, text, *arguments):
        return self.browser.execute_script(text, *arguments)

    def move(self, css, value):
        self.script("const e = document.querySelector(arguments[0]); e.value = arguments[1]; e.dispatchEvent(new Event('input'))", css, value)

    def choose(self, css, value):
        self.script("const e = document.querySelector(arguments[0]); e.value = arguments[1]; e.dispatchEvent(new Event('change'))", css, value)

    # Where a place of the map is on the canvas, which shows all of it [px from its middle].
    def offset(self, x, y):
        size = self.element("#map").size
        scale = min(size["width"] / MAP[0], size["height"] / MAP[1])
        return round((x - MAP[0] / 2) * scale), round((MAP[1] / 2 - y) * scale)

    def hover(self, x, y):
        ActionChains(self.browser).move_to_element_with_offset(self.element("#map"), *self.offset(x, y)).perform()

    def pixel(self, x, y):
        dx, dy = self.offset(x, y)
        picture = Image.open(io.BytesIO(self.element("#map").screenshot_as_png)).convert("RGB")
        return list(picture.getpixel((picture.width // 2 + dx, picture.height // 2 + dy)))

    def cell(self, row, column):
        for line in self.browser.find_elements(By.CSS_SELECTOR, "#figures tbody tr"):
            cells = line.find_elements(By.CSS_SELECTOR, "th, td")
            if cells[0].text.startswith(row):
                return cells[column].text
        self.fail(f"no row {row}")

    def test_draws_walls_and_alignability(self):
        self.open()
        self.assertEqual(self.text("h1"), "Two corridors & <a block>")
        wall, blind, safe = self.pixel(10, 5), self.pixel(10, 9.4), self.pixel(10, 0.6)
        self.assertEqual(wall, [43, 43, 43])
        self.assertLess(sum(blind), sum(safe) - 100, "even lightness: what is blind is darker")
        self.assertNotEqual(self.pixel(18.5, 0.5), safe, "not evaluated")

    def test_asks_no_network(self):
        self.open()
        self.assertEqual(self.script("return performance.getEntriesByType('resource').map(e => e.name)"), [])

    def test_tells_alignability_under_the_pointer(self):
        known = self.open()
        for place in known["alphas"]:
            self.hover(place["x"], place["y"])
            told = re.search(r"α (\d\.\d+), |α (\d\.\d+) · risk", self.text("#readout") + " ")
            self.assertIsNotNone(told, self.text("#readout"))
            # The pointer stands on a pixel, some 2 cm wide.
            self.assertAlmostEqual(float(told.group(1) or told.group(2)), place["alpha"][0], delta=0.02)
            self.assertTrue(self.element("#tip").is_displayed())

    def test_tells_the_arc_length_near_a_path(self):
        self.open()
        self.hover(10, 8.5)
        self.assertRegex(self.text("#readout"), r"shortest at (7\.9|8\.0|8\.1) m")

    def test_switches_paths_off_and_on(self):
        self.open()
        drawn = lambda: len(self.browser.find_elements(By.CSS_SELECTOR, "#alpha-profile path[data-path='shortest']"))
        on_path = self.pixel(10, 8.5)
        self.assertEqual(drawn(), 1)
        box = self.element("#figures thead th:nth-child(2) input")
        box.click()
        self.assertEqual(drawn(), 0)
        self.assertNotEqual(self.pixel(10, 8.5), on_path)
        self.element("#figures thead th:nth-child(2) input").click()
        self.assertEqual(drawn(), 1)
        self.assertEqual(self.pixel(10, 8.5), on_path)

    def test_works_out_figures_at_other_thresholds_as_the_library_does(self):
        for kind in ["plain", "headings"]:
            known = self.open(kind)["figures"]
            before = self.cell("blind", 1)
            self.move("#critical", known["critical"])
            self.move("#safe", known["safe"])
            for column, path in [(1, "shortest"), (2, "risk-aware")]:
                for row, figure in [("blind", "blind"), ("longest blind", "longest_blind"), ("risk integral", "risk")]:
                    told = self.cell(row, column)
                    self.assertTrue(told.startswith("≈ "), told)
                    exact = known[path][figure]
                    self.assertAlmostEqual(float(told[2:]), exact, delta=0.05 + 0.01 * exact, msg=f"{kind}: {figure} of {path}")
            self.element("#reset").click()
            self.assertEqual(self.cell("blind", 1), before)
            self.assertFalse(self.element("#reset").is_enabled())

    def test_keeps_thresholds_in_order(self):
        self.open()
        self.move("#critical", 0.7)
        self.assertEqual((self.text("#critical-value"), self.text("#safe-value")), ("0.70", "0.71"))
        self.move("#safe", 0.2)
        self.assertEqual((self.text("#critical-value"), self.text("#safe-value")), ("0.19", "0.20"))

    def test_shows_risk_and_other_colours(self):
        self.open()
        seen = {tuple(self.pixel(10, 9.4))}
        for css, value in [("#scale", "1"), ("#scale", "2"), ("#view", "risk")]:
            self.choose(css, value)
            seen.add(tuple(self.pixel(10, 9.4)))
        self.assertEqual(len(seen), 4)
        self.choose("#scale", "1")
        red, _, blue = self.pixel(10, 9.4)
        self.assertGreater(red, blue + 60, "the paper's: poor is red")

    def test_shows_alignability_by_heading(self):
        known = self.open("headings")
        place = known["alphas"][2]
        for heading in [0, 2]:
            self.choose("#heading", str(heading))
            self.hover(place["x"], place["y"] + 0.001 * heading)
            told = float(re.search(r"α (\d\.\d+)", self.text("#readout")).group(1))
            self.assertAlmostEqual(told, place["alpha"][heading], delta=0.02)
        self.open("plain")
        self.assertFalse(self.element("#heading-choice").is_displayed())

    def test_shows_errors_of_the_chosen_localizer(self):
        self.open()
        self.assertTrue(self.element("#error-profile").is_displayed())
        first = self.element("#error-profile path").get_attribute("d")
        self.choose("#localizer", "1")
        self.assertNotEqual(self.element("#error-profile path").get_attribute("d"), first)
        self.move("#along", 8)
        self.assertIn("shortest at 8.0 m", self.text("#along-readout"))
        self.assertIn("error 0.12 m", self.text("#along-readout"))

    def test_is_reached_by_keyboard(self):
        self.open()
        reached = set()
        for _ in range(25):
            ActionChains(self.browser).send_keys(Keys.TAB).perform()
            reached.add(self.script("const e = document.activeElement; return e.id || e.type || e.tagName"))
        wanted = {"theme", "view", "scale", "zoom-in", "zoom-out", "zoom-all", "map", "critical", "safe", "checkbox", "localizer", "along", "SUMMARY"}
        self.assertEqual(wanted - reached, set())
        self.script("document.getElementById('map').focus()")
        ActionChains(self.browser).send_keys(Keys.ARROW_RIGHT).perform()
        self.assertIn("x 11.00 m, y 5.00 m", self.text("#readout"))
        ActionChains(self.browser).key_down(Keys.SHIFT).send_keys(Keys.ARROW_DOWN).key_up(Keys.SHIFT).perform()
        self.assertIn("y 0.00 m", self.text("#readout"))
        self.script("document.getElementById('critical').focus()")
        ActionChains(self.browser).send_keys(Keys.ARROW_RIGHT).perform()
        self.assertEqual(self.text("#critical-value"), "0.11")

    def test_zooms_in_and_out(self):
        self.open()
        whole = self.pixel(0.05, 5)
        self.element("#zoom-in").click()
        self.assertNotEqual(self.pixel(0.05, 5), whole)
        self.element("#zoom-all").click()
        self.assertEqual(self.pixel(0.05, 5), whole)

    def test_fits_phones_and_desktops(self):
        for size in [PHONE, DESKTOP]:
            for kind in ["plain", "headings"]:
                self.open(kind, size)
                wide = self.script("return [document.documentElement.scrollWidth, document.documentElement.clientWidth]")
                self.assertLessEqual(wide[0], wide[1], f"{kind} at {size[0]} px scrolls to the side")

    def test_is_dark_where_the_reader_is(self):
        background = "return getComputedStyle(document.body).backgroundColor"
        self.open(theme="dark")
        dark = self.script(background)
        self.assertEqual(self.pixel(10, 5), [240, 240, 238], "walls are light")
        self.element("#theme").click()
        light = self.script(background)
        self.assertEqual((dark, light), ("rgb(20, 23, 26)", "rgb(246, 246, 244)"))


if __name__ == "__main__":
    method = [f"Report.{name}" for name in sys.argv[1:]]
    unittest.main(argv=[sys.argv[0], *method])
