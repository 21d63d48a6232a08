"""``kugelpendel explore``: the explorer's page, served to the browser of this machine."""

from __future__ import annotations

import webbrowser
from pathlib import Path
from typing import TYPE_CHECKING

from kugelpendel import InvalidInput
from kugelpendel.cli.explore.server import PageServer, opened
from kugelpendel.cli.terminal.streams import complain

if TYPE_CHECKING:
    from collections.abc import Mapping

_PAGE = Path(__file__).with_name("page")
"""What ``make explorer`` builds and the wheel carries."""

_LAST_PORT = 65535


def explore(job: Path | None, port: str, *, opens: bool, page: Path = _PAGE) -> None:
    """Serve the page until somebody interrupts.

    Parameters
    ----------
    job
        A job file on which the page opens; None opens it on its own first example.
    port
        As it was typed; where it is taken, the next free one is used, and a sentence says so.
    opens
        Whether the browser is opened.
    page
        The folder of the built page.

    Raises
    ------
    InvalidInput
        Anything wrong with the job or the port, no free port, and a page that has not been built.
    """
    wanted = _port(port)
    fragment = ""
    if job is not None:
        from kugelpendel.cli.explore.fragment import fragment_of  # needs pint

        fragment = f"#{fragment_of(job)}"
    files = page_files(page)
    with opened(wanted, files) as server:
        address = f"http://127.0.0.1:{server.server_port}/"
        if server.server_port != wanted:
            complain(f"port {wanted} is taken; {server.server_port} is used in its place.")
        print(f"The explorer is at {address}{fragment}\nCtrl-C ends it.", flush=True)
        if opens and not webbrowser.open(f"{address}{fragment}"):
            complain("no browser could be opened; open the address above in one.")
        _serve(server)


def _serve(server: PageServer) -> None:
    try:
        server.serve_forever()
    except KeyboardInterrupt:
        print("\nThe explorer is closed.")


def _port(text: str) -> int:
    if not (text.isascii() and text.isdigit() and 1 <= int(text) <= _LAST_PORT):
        raise InvalidInput(
            f"The port must be a whole number from 1 to {_LAST_PORT}, but it is {text!r}; leave "
            f"--port out, and a free one is found."
        )
    return int(text)


def page_files(page: Path = _PAGE) -> Mapping[str, bytes]:
    """Read all files of the page, under the paths by which a browser asks for them.

    Raises
    ------
    InvalidInput
        The page has not been built.
    """
    if not (page / "index.html").is_file():
        raise InvalidInput(
            "The explorer's page has not been built; a wheel carries it, and in a source tree "
            "`make explorer` builds it."
        )
    found = (path for path in sorted(page.rglob("*")) if path.is_file())
    files = {f"/{path.relative_to(page).as_posix()}": path.read_bytes() for path in found}
    return {"/": files["/index.html"], **files}
