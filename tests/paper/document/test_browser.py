"""The pages in a real browser: both languages, wide and narrow, printed, without a script."""

import re
import shutil
from base64 import b64decode
from collections.abc import Callable, Iterator
from dataclasses import replace
from pathlib import Path

import pytest
from selenium import webdriver
from selenium.webdriver.chrome.options import Options
from selenium.webdriver.chrome.service import Service
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys

from kugelpendel import paper
from kugelpendel.paper.typeset.tex import read

SIZES = {"wide": (1440, 900), "narrow": (360, 800)}
MIDDLING = {"middle": (1200, 900), "small": (400, 800)}
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
    chrome.set_script_timeout(120)
    try:
        yield chrome
    finally:
        chrome.quit()


@pytest.fixture(scope="module", params=["de", "en"])
def page(
    request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory, proofs: paper.Proofs
) -> Path:
    path = tmp_path_factory.mktemp("page") / f"derivation.{request.param}.html"
    path.write_text(paper.write(request.param, "html", proofs=proofs), encoding="utf-8")
    return path


@pytest.fixture(scope="module")
def proofs(examined: Callable[[str], paper.Row]) -> paper.Proofs:
    """All of them, with counts that are as long as they get."""
    found: dict[str, paper.Evidence] = {}
    rows: dict[str, paper.Row] = {}
    for one in paper.FORMULAS:
        row = examined(one.label)
        assert row.evidence is not None
        found[one.label] = row.evidence
        rows[one.label] = replace(row, killed=1000, equal=100, sabotages=(("sign", 100, 100),))
    return paper.Proofs(found, rows, "2026-11-26, kugelpendel 0.1.0")


@pytest.fixture(scope="module", params=["de", "en"])
def handout(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("handout") / f"handout.{request.param}.html"
    path.write_text(paper.handout(request.param), encoding="utf-8")
    return path


@pytest.fixture(scope="module")
def axe(repository: Path) -> str:
    script = repository / ".venv/axe/node_modules/axe-core/axe.min.js"
    if not script.is_file():
        pytest.skip("axe-core is not installed; make test installs it")
    return script.read_text(encoding="utf-8")


def serious(browser: webdriver.Chrome, axe: str, rules: str = "") -> list[str]:
    """What axe-core finds serious or critical, with the first element of each kind."""
    browser.execute_script(axe)
    found = browser.execute_async_script(
        "const done = arguments[arguments.length - 1];"
        # the inside of formulas is tens of thousands of elements about which axe has no rule
        f"axe.run({{exclude: [['math']]}}, {{{rules}resultTypes: ['violations']}})"
        ".then(result => done(result.violations))"
    )
    return [
        f"{one['id']}: {one['help']}: {one['nodes'][0]['html'][:200]}"
        for one in found
        if one["impact"] in ("serious", "critical")
    ]


def sheets(browser: webdriver.Chrome, size: str) -> int:
    """How many sheets the page is in print."""
    width, height = {"A4": (8.27, 11.69), "Letter": (8.5, 11)}[size]
    options = {"paperWidth": width, "paperHeight": height, "preferCSSPageSize": size == "A4"}
    printed = browser.execute_cdp_cmd("Page.printToPDF", options)
    # Chromium writes its page objects uncompressed
    return len(re.findall(rb"/Type /Page\b", b64decode(printed["data"])))


@pytest.fixture(params=SIZES)
def opened(
    request: pytest.FixtureRequest, browser: webdriver.Chrome, page: Path
) -> webdriver.Chrome:
    width, height = (SIZES | MIDDLING)[request.param]
    metrics = {"width": width, "height": height, "deviceScaleFactor": 1, "mobile": False}
    browser.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", metrics)
    browser.get(page.as_uri())
    return browser


@pytest.mark.parametrize("opened", [*SIZES, "middle"], indirect=True)
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
        # where there is a margin, the notes on misprints stand in it
        "const right = innerWidth < 1376"
        "  ? document.querySelector('main').getBoundingClientRect().right + 1 : innerWidth;"
        "return [...document.querySelectorAll('main *')].filter(element =>"
        "  element.getBoundingClientRect().right > right &&"
        "  !element.closest('.formula, .picture, .table')"
        ").map(element => element.outerHTML.slice(0, 120))"
    )
    assert leaking == []
    count = "return document.querySelectorAll('main details[open]').length"
    assert opened.execute_script(count) > 120
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


@pytest.mark.parametrize("opened", [*SIZES, *MIDDLING], indirect=True)
def test_no_formula_needs_to_be_scrolled(opened: webdriver.Chrome) -> None:
    opened.find_element(By.CSS_SELECTOR, 'button[data-open="yes"]').click()
    over = opened.execute_script(
        "return [...document.querySelectorAll('main .formula')]"
        ".filter(formula => formula.scrollWidth > formula.clientWidth)"
        ".map(formula => formula.closest('.display').id)"
    )
    assert over == []


def test_a_page_is_one_small_file(page: Path) -> None:
    assert page.stat().st_size <= 720_000


def test_nothing_serious_for_those_who_see_or_hear_otherwise(
    browser: webdriver.Chrome, page: Path, axe: str
) -> None:
    browser.get(page.as_uri())
    assert serious(browser, axe) == []
    dark = [{"name": "prefers-color-scheme", "value": "dark"}]
    browser.execute_cdp_cmd("Emulation.setEmulatedMedia", {"features": dark})
    try:
        assert serious(browser, axe, "runOnly: ['color-contrast', 'link-in-text-block'], ") == []
    finally:
        browser.execute_cdp_cmd("Emulation.setEmulatedMedia", {"features": []})


def test_a_handout_is_six_sheets_at_most_and_says_no_misprint(
    browser: webdriver.Chrome, handout: Path, axe: str
) -> None:
    browser.get(handout.as_uri())
    assert 3 <= sheets(browser, "A4") <= 6
    assert sheets(browser, "Letter") <= 7
    assert serious(browser, axe) == []
    assert len(browser.find_elements(By.CSS_SELECTOR, "svg.drawing")) == 4
    for style in (".misprint", ".differs", ".printed", "s", "details"):
        assert browser.find_elements(By.CSS_SELECTOR, style) == []
    shown = {one.get_attribute("id") for one in browser.find_elements(By.CSS_SELECTOR, ".display")}
    numbered = {one.display for one in paper.FORMULAS if one.number and one.section <= 4}
    assert shown == {f"eq-{label}" for label in numbered}


def test_no_sheet_begins_with_what_closes_an_equation(
    browser: webdriver.Chrome, page: Path
) -> None:
    """Columns of a sheet's size are filled by the same rules, and tell what stands where."""
    browser.get(page.as_uri())
    browser.execute_cdp_cmd("Emulation.setEmulatedMedia", {"media": "print"})
    try:
        counts = browser.execute_script(
            "const main = document.querySelector('main');"
            "main.style.cssText = 'columns: 178mm; column-fill: auto; width: 178mm; height: 261mm';"
            "const last = [...main.querySelectorAll('details.proof, .step > :last-child')]"
            "  .filter(one => one.previousElementSibling && one.getClientRects().length);"
            "const apart = last.filter(one => {"
            "  const before = [...one.previousElementSibling.getClientRects()].at(-1);"
            "  return one.getClientRects()[0].left > before.left + 300;"
            "});"
            "return [main.scrollWidth / main.clientWidth, last.length, apart.length]"
        )
    finally:
        browser.execute_cdp_cmd("Emulation.setEmulatedMedia", {"media": ""})
    sheets, closing, apart = counts
    assert sheets > 40
    assert closing > 2 * sheets
    assert apart == 0


def test_the_short_version_prints_on_fewer_sheets(browser: webdriver.Chrome, page: Path) -> None:
    browser.get(page.as_uri())
    whole = sheets(browser, "A4")
    browser.execute_script("document.getElementById('length-short').click()")
    short = sheets(browser, "A4")
    browser.execute_script("document.getElementById('show-misprints').click()")
    bare = sheets(browser, "A4")
    assert bare < short < whole / 1.5


def test_switches_work_without_a_script(browser: webdriver.Chrome, page: Path) -> None:
    browser.execute_cdp_cmd("Emulation.setScriptExecutionDisabled", {"value": True})
    try:
        browser.get(page.as_uri())

        def is_shown(style: str) -> bool:
            return browser.find_element(By.CSS_SELECTOR, style).is_displayed()

        assert is_shown("#eq-10\\.1")
        assert is_shown("#eq-12 .misprint")
        assert not is_shown("nav form")
        assert not is_shown(".tools button")
        browser.find_element(By.ID, "length-short").click()
        assert is_shown("#eq-12")
        assert not is_shown("#eq-10\\.1")
        browser.find_element(By.CSS_SELECTOR, '.skipped a[href="#eq-10.1"]').click()
        assert is_shown("#eq-10\\.1")
        assert is_shown("#eq-10\\.2")
        browser.find_element(By.ID, "show-misprints").click()
        assert not is_shown("#eq-12 .misprint")
        assert not is_shown("#misprints")
    finally:
        browser.execute_cdp_cmd("Emulation.setScriptExecutionDisabled", {"value": False})


def test_an_equation_is_found_by_number_and_by_word(opened: webdriver.Chrome) -> None:
    field = opened.find_element(By.ID, "find")

    def hits(sought: str) -> list[str]:
        field.clear()
        field.send_keys(sought)
        return opened.execute_script(
            "return [...document.querySelectorAll('#found b')].map(one => one.textContent.trim())"
        )

    assert hits("13a")[0] == "(13a)"
    assert hits("(10.7)")[0] == "(10.7)"
    assert "(25)" in hits(r"\Omega = \frac{3}{8}")
    assert hits("Newton")[0] == "(1)"
    assert hits("xyzzy") == []
    assert opened.find_element(By.ID, "found").get_attribute("textContent") != ""
    hits("25")
    field.send_keys(Keys.ENTER)
    assert opened.execute_script("return location.hash") == "#eq-25"


def test_each_equation_leads_to_its_neighbours_and_to_itself(opened: webdriver.Chrome) -> None:
    links = opened.execute_script(
        "return [...document.querySelectorAll('#eq-10\\\\.3 :is(.tag, .around a)')]"
        ".map(one => one.getAttribute('href'))"
    )
    assert links == ["#eq-10.3", "#eq-10", "#eq-12"]


def test_latex_is_copied(opened: webdriver.Chrome) -> None:
    copied = opened.execute_async_script(
        "const done = arguments[0];"
        "Object.defineProperty(navigator, 'clipboard', {configurable: true, value:"
        "  {writeText: async text => done(text)}});"
        "document.querySelector('#eq-25 button.copy').click()"
    )
    assert read(copied) == read(paper.formula("25").right)
    names = opened.execute_script(
        "return [...document.querySelectorAll('button.copy')].map(q => q.ariaLabel)"
    )
    assert len(set(names)) == len(names) == len(paper.FORMULAS)


def test_links_read_as_numbers_on_paper(opened: webdriver.Chrome) -> None:
    """A link that is printed says by itself where it leads."""
    texts = opened.execute_script(
        "return [...document.querySelectorAll('main a[href^=\"#eq-\"]')]"
        ".filter(one => !one.closest('.around, svg')).map(one => one.textContent)"
    )
    assert all(re.match(r"\([A-D]?\d", text) for text in texts)
    assert len(texts) > 300


def test_pictures_are_images_and_graphs_are_links(opened: webdriver.Chrome) -> None:
    roles = opened.execute_script(
        "return [...document.querySelectorAll('svg')].map(one =>"
        "  [one.getAttribute('role'), one.querySelectorAll('a').length > 0])"
    )
    assert roles.count(["img", False]) == 4
    assert roles.count(["group", True]) == 2
    assert len(roles) == 6


def test_words_in_pictures_are_whole_and_apart(opened: webdriver.Chrome) -> None:
    found = opened.execute_script(
        "const meet = (a, b) => a.left < b.right && b.left < a.right"
        "  && a.top < b.bottom && b.top < a.bottom;"
        "return [...document.querySelectorAll('svg.drawing')].map(drawing => {"
        "  const room = drawing.getBoundingClientRect();"
        "  const words = [...drawing.querySelectorAll('text')];"
        "  const boxes = words.map(one => one.getBoundingClientRect());"
        "  return [boxes.length, words.filter((_, n) =>"
        "    boxes[n].left < room.left || boxes[n].right > room.right ||"
        "    boxes.some((box, k) => k !== n && meet(box, boxes[n]))"
        "  ).map(one => one.textContent)]"
        "})"
    )
    assert [words for _, words in found] == [[], [], [], []]
    assert sum(count for count, _ in found) > 25
