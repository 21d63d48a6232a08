"""The page in a real browser: both languages, wide and narrow."""

import shutil
from collections.abc import Iterator
from pathlib import Path

import pytest
from selenium import webdriver
from selenium.webdriver.chrome.options import Options
from selenium.webdriver.chrome.service import Service
from selenium.webdriver.common.by import By

from kugelpendel import paper

SIZES = {"wide": (1200, 900), "narrow": (400, 800)}
FLAGS = (
    "--headless",
    "--no-sandbox",
    "--disable-gpu",
    "--disable-quic",
    "--no-first-run",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
)


@pytest.fixture(scope="module")
def browser(tmp_path_factory: pytest.TempPathFactory) -> Iterator[webdriver.Chrome]:
    program, driver = shutil.which("chromium"), shutil.which("chromedriver")
    if program is None or driver is None:
        pytest.skip("chromium and chromedriver are not installed (chromium, chromium-driver)")
    options = Options()
    options.binary_location = program
    for flag in (*FLAGS, f"--user-data-dir={tmp_path_factory.mktemp('profile')}"):
        options.add_argument(flag)
    options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
    chrome = webdriver.Chrome(options=options, service=Service(driver))
    try:
        yield chrome
    finally:
        chrome.quit()


@pytest.fixture(scope="module", params=["de", "en"])
def page(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("page") / f"derivation.{request.param}.html"
    path.write_text(paper.write(request.param, "html"), encoding="utf-8")
    return path


@pytest.fixture(params=SIZES)
def opened(
    request: pytest.FixtureRequest, browser: webdriver.Chrome, page: Path
) -> webdriver.Chrome:
    width, height = SIZES[request.param]
    metrics = {"width": width, "height": height, "deviceScaleFactor": 1, "mobile": False}
    browser.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", metrics)
    browser.get(page.as_uri())
    return browser


def test_page(opened: webdriver.Chrome) -> None:
    """One test for all, so that each page is loaded once in each size."""
    assert opened.get_log("browser") == []  # pyright: ignore[reportUnknownMemberType]
    for state in ("closed", "open"):
        if state == "open":
            opened.find_element(By.CSS_SELECTOR, 'button[data-open="yes"]').click()
        sizes = opened.execute_script(
            "const root = document.documentElement;"
            "return [root.scrollWidth, root.clientWidth, document.body.scrollWidth]"
        )
        assert sizes[0] <= sizes[1], state
        assert sizes[2] <= sizes[1], state
    # With all steps open every formula has a size, and none is cut off.
    flat = opened.execute_script(
        "return [...document.querySelectorAll('main math')].filter(math => {"
        "  const box = math.getBoundingClientRect();"
        "  return !(box.width > 3 && box.height > 3);"
        "}).map(math => math.textContent)"
    )
    assert flat == []
    leaking = opened.execute_script(
        "const right = document.querySelector('main').getBoundingClientRect().right + 1;"
        "return [...document.querySelectorAll('main *')].filter(element =>"
        "  element.getBoundingClientRect().right > right &&"
        "  !element.closest('.formula, .picture, .table')"
        ").map(element => element.outerHTML.slice(0, 120))"
    )
    assert leaking == []
    count = "return document.querySelectorAll('main details[open]').length"
    assert opened.execute_script(count) > 60
    opened.find_element(By.CSS_SELECTOR, 'button[data-open="no"]').click()
    assert opened.execute_script(count) == 0
    first = opened.find_element(By.CSS_SELECTOR, ".display details summary")
    first.click()
    assert opened.execute_script(count) == 1
    first.click()
    assert opened.execute_script(count) == 0


def test_links_open_what_they_lead_into(opened: webdriver.Chrome) -> None:
    opened.execute_script("location.hash = '#eq-10.7-5'")
    assert opened.execute_async_script(
        "const done = arguments[0];"
        "setTimeout(() => {"
        "  const line = document.getElementById('eq-10.7-5');"
        "  const box = line.getBoundingClientRect();"
        "  done(line.closest('details').open && box.top < innerHeight && box.bottom > 0)"
        "}, 100)"
    )
    box = opened.find_element(By.CSS_SELECTOR, 'svg.graph a[href="#eq-25"]')
    assert opened.execute_script("return arguments[0].getBoundingClientRect().width", box) > 20


def test_formulas_are_drawn_as_mathematics(opened: webdriver.Chrome) -> None:
    """A fraction is higher than a letter: the browser lays MathML out and does not only show it."""
    heights = opened.execute_script(
        "const height = selector => Math.max(...[...document.querySelectorAll(selector)]"
        "  .map(element => element.getBoundingClientRect().height));"
        "return [height('#eq-25 mfrac'), height('#eq-3 mi')]"
    )
    assert heights[0] > 1.5 * heights[1] > 0


def test_no_line_begins_with_the_sign_after_a_formula(opened: webdriver.Chrome) -> None:
    opened.find_element(By.CSS_SELECTOR, 'button[data-open="yes"]').click()
    counts = opened.execute_script(
        "const glued = [...document.querySelectorAll('main .glued')];"
        "return [glued.length, glued.filter(one => one.getClientRects().length > 1).length]"
    )
    assert counts[0] > 100
    assert counts[1] == 0


def test_formulas_stay_in_their_column(opened: webdriver.Chrome) -> None:
    """On a wide page; a narrow one shows tables as lists."""
    over = opened.execute_script(
        "return [...document.querySelectorAll('main td')].filter(cell =>"
        "  [...cell.querySelectorAll('math')].some(math =>"
        "    math.getBoundingClientRect().right > cell.getBoundingClientRect().right + 1)"
        ").map(cell => cell.textContent)"
    )
    assert over == []


def test_few_formulas_need_to_be_scrolled(opened: webdriver.Chrome) -> None:
    opened.find_element(By.CSS_SELECTOR, 'button[data-open="yes"]').click()
    over = opened.execute_script(
        "return [...document.querySelectorAll('main .formula')].map(formula =>"
        "  formula.scrollWidth - formula.clientWidth).filter(hidden => hidden > 0)"
    )
    is_narrow = opened.execute_script("return innerWidth < 500")
    assert len(over) <= (5 if is_narrow else 0)
    # the widest is the integral C9, whose root cannot be broken
    assert all(hidden < 70 for hidden in over)
