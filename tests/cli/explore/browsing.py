"""The built page's engine in a browser, as tests and the benchmark ask it."""

import json
import shutil
import tempfile
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any, TypeAlias

from selenium import webdriver
from selenium.webdriver.chrome.options import Options
from selenium.webdriver.chrome.service import Service

from kugelpendel.cli.explore import command
from kugelpendel.cli.explore.server import PageServer
from kugelpendel.errors import InvalidInput

Engine: TypeAlias = Callable[..., Any]
"""Runs the body of a function of `engine`, `core` and `given` in the page, and gives its answer."""

FLAGS = ("--headless", "--no-sandbox", "--disable-gpu", "--no-first-run", "--disable-sync")


class NotThere(Exception):
    """No page or no browser; the message is a sentence."""


def built() -> dict[str, bytes]:
    """The files of the page as it was built."""
    try:
        return dict(command.page_files())
    except InvalidInput as error:
        raise NotThere(str(error)) from error


@contextmanager
def running() -> Iterator[Engine]:
    """Serve the page, open a browser on it, and take scripts."""
    files = built()
    program, driver = shutil.which("chromium"), shutil.which("chromedriver")
    if program is None or driver is None:
        raise NotThere("chromium and chromedriver are not installed (chromium, chromium-driver)")
    with tempfile.TemporaryDirectory() as profile, PageServer(0, files) as server:
        options = Options()
        options.binary_location = program
        for flag in (*FLAGS, f"--user-data-dir={profile}"):
            options.add_argument(flag)
        thread = threading.Thread(target=server.serve_forever, kwargs={"poll_interval": 0.05})
        thread.start()
        chrome = webdriver.Chrome(options=options, service=Service(driver))
        chrome.set_script_timeout(120)
        try:
            # A path without a file: an empty page with the policy of all others.
            chrome.get(f"http://127.0.0.1:{server.server_port}/none")
            yield lambda body, given=None: _asked(chrome, body, given)
        finally:
            chrome.quit()
            server.shutdown()
            thread.join()


def _asked(chrome: webdriver.Chrome, body: str, given: object) -> Any:
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
