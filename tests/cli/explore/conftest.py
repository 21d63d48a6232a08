"""The built page in a browser, for tests that ask its engine what Python is asked."""

import json
import shutil
import threading
from collections.abc import Callable, Iterator
from typing import Any, TypeAlias

import pytest
from selenium import webdriver
from selenium.webdriver.chrome.options import Options
from selenium.webdriver.chrome.service import Service

from kugelpendel.cli.explore import command
from kugelpendel.cli.explore.server import PageServer
from kugelpendel.errors import InvalidInput

Engine: TypeAlias = Callable[..., Any]
"""Runs the body of a function of `engine`, `core` and `given` in the page."""

FLAGS = ("--headless", "--no-sandbox", "--disable-gpu", "--no-first-run", "--disable-sync")


@pytest.fixture(scope="session")
def page_files() -> dict[str, bytes]:
    """The files of the page as it was built."""
    try:
        return dict(command.page_files())
    except InvalidInput as error:
        pytest.skip(str(error))


@pytest.fixture(scope="session")
def engine(
    page_files: dict[str, bytes], tmp_path_factory: pytest.TempPathFactory
) -> Iterator[Engine]:
    """What the page stands on, in the browser: call it with a script and what it is given."""
    program, driver = shutil.which("chromium"), shutil.which("chromedriver")
    if program is None or driver is None:
        pytest.skip("chromium and chromedriver are not installed (chromium, chromium-driver)")
    options = Options()
    options.binary_location = program
    for flag in (*FLAGS, f"--user-data-dir={tmp_path_factory.mktemp('profile')}"):
        options.add_argument(flag)
    with PageServer(0, page_files) as server:
        thread = threading.Thread(target=server.serve_forever, kwargs={"poll_interval": 0.05})
        thread.start()
        chrome = webdriver.Chrome(options=options, service=Service(driver))
        chrome.set_script_timeout(120)
        try:
            # A path without a file: an empty page with the policy of all others.
            chrome.get(f"http://127.0.0.1:{server.server_port}/none")
            yield lambda body, given=None: asked(chrome, body, given)
        finally:
            chrome.quit()
            server.shutdown()
            thread.join()


def asked(chrome: webdriver.Chrome, body: str, given: object) -> Any:
    """What a function of the engine, the core and what is given returns in the page."""
    script = f"""
const [text, done] = arguments;
const run = async () => {{
  const engine = await import("/engine.js");
  const core = (globalThis.core ??= await engine.loadCore());
  const given = JSON.parse(text);
  {body}
}};
run().then((found) => done({{found: JSON.stringify(found ?? null)}}),
           (error) => done({{error: String(error?.stack ?? error)}}));
"""
    answer = chrome.execute_async_script(script, json.dumps(given))
    assert "error" not in answer, answer["error"]
    return json.loads(answer["found"])
