"""The explorer's command: what it serves, to whom, and what it says."""

import base64
import hashlib
import http.client
import math
import re
import socket
import threading
from collections.abc import Iterator
from pathlib import Path
from urllib.parse import unquote

import pytest

from kugelpendel.cli import main
from kugelpendel.cli.explore import command
from kugelpendel.cli.explore.fragment import fragment_of
from kugelpendel.cli.explore.server import PageServer, opened
from kugelpendel.errors import InvalidInput

INLINE = b"<style>p{color:red}</style><script>1</script>"
FILES = {
    "/": b"<!doctype html>",
    "/index.html": b"<!doctype html>",
    "/assets/core.wasm": b"\0asm",
    "/derivation.en.html": INLINE,
}


@pytest.fixture
def server() -> Iterator[PageServer]:
    with PageServer(0, FILES) as server:
        thread = threading.Thread(target=server.serve_forever, kwargs={"poll_interval": 0.01})
        thread.start()
        yield server
        server.shutdown()
        thread.join()


def ask(server: PageServer, path: str, method: str = "GET") -> tuple[int, dict[str, str], bytes]:
    connection = http.client.HTTPConnection("127.0.0.1", server.server_port, timeout=5)
    connection.request(method, path)
    answer = connection.getresponse()
    found = answer.status, {k.lower(): v for k, v in answer.getheaders()}, answer.read()
    connection.close()
    return found


def test_the_page_is_served_with_its_types_and_a_policy(server: PageServer) -> None:
    status, headers, body = ask(server, "/?lang=de")
    assert (status, body) == (200, FILES["/"])
    assert headers["content-type"] == "text/html; charset=utf-8"
    policy = headers["content-security-policy"]
    assert "unsafe-inline" not in policy
    assert "default-src 'none'" in policy
    assert "script-src 'self' 'wasm-unsafe-eval'" in policy
    status, headers, body = ask(server, "/assets/core.wasm")
    assert (status, headers["content-type"], body) == (200, "application/wasm", b"\0asm")
    status, headers, body = ask(server, "/assets/core.wasm", "HEAD")
    assert (status, headers["content-length"], body) == (200, "4", b"")


def test_what_stands_in_a_page_runs_by_its_hash(server: PageServer) -> None:
    policy = ask(server, "/derivation.en.html")[1]["content-security-policy"]
    digest = base64.b64encode(hashlib.sha256(b"1").digest()).decode()
    assert f"script-src 'self' 'wasm-unsafe-eval' 'sha256-{digest}';" in policy
    assert "style-src 'self' 'sha256-" in policy
    assert "unsafe-inline" not in policy
    assert "sha256" not in ask(server, "/")[1]["content-security-policy"]


@pytest.mark.parametrize(
    "path",
    [
        "/../pyproject.toml",
        "/assets/../../server.py",
        "/%2e%2e/server.py",
        "/..%2fserver.py",
        "//etc/passwd",
        "/assets",
        "/assets/",
        "/etc/passwd",
        "/index.html/",
    ],
)
def test_nothing_but_the_page_is_served(server: PageServer, path: str) -> None:
    status, headers, body = ask(server, path)
    assert status == 404
    assert headers["content-type"] == "text/plain"
    assert body == b"The page has no such file.\n"


def test_only_this_machine_is_served(server: PageServer) -> None:
    assert server.server_address[0] == "127.0.0.1"
    assert ask(server, "/", "POST")[0] == 501


def test_a_taken_port_gives_the_next_free_one() -> None:
    with socket.socket() as taken:
        taken.bind(("127.0.0.1", 0))
        taken.listen()
        port = taken.getsockname()[1]
        with opened(port, FILES) as server:
            assert port < server.server_port < port + 20


def test_a_port_without_rights_is_a_sentence(monkeypatch: pytest.MonkeyPatch) -> None:
    def refuse(*_: object) -> None:
        raise PermissionError(13, "Permission denied")

    monkeypatch.setattr(PageServer, "server_bind", refuse)
    with pytest.raises(InvalidInput, match=r"Port 80 .* Permission denied; name another"):
        opened(80, FILES)


@pytest.mark.parametrize("port", ["0", "65536", "http", "-1", "80.5", "²"])
def test_a_port_that_is_none_is_a_sentence(port: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["explore", "--no-browser", f"--port={port}"]) == 2
    assert f"it is {port!r}" in capsys.readouterr().err


def test_a_page_that_is_not_built_is_a_sentence(tmp_path: Path) -> None:
    with pytest.raises(InvalidInput, match="`make explorer` builds it"):
        command.explore(None, "8315", opens=False, page=tmp_path)


def test_the_browser_is_opened_on_the_job(
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
    repository: Path,
) -> None:
    (tmp_path / "index.html").write_bytes(b"<!doctype html>")
    asked: list[str] = []
    monkeypatch.setattr(command.webbrowser, "open", lambda url: asked.append(url) is not None)
    monkeypatch.setattr(PageServer, "serve_forever", interrupted)
    with socket.socket() as taken:
        taken.bind(("127.0.0.1", 0))
        taken.listen()
        port = taken.getsockname()[1]
        job = repository / "examples" / "museum.toml"
        command.explore(job, str(port), opens=True, page=tmp_path)
    said = capsys.readouterr()
    assert re.fullmatch(r"http://127\.0\.0\.1:\d+/#pendulum\.length=20\.0&.*", asked[0])
    assert f"The explorer is at {asked[0]}\n" in said.out
    assert "The explorer is closed." in said.out
    assert f"port {port} is taken;" in said.err
    assert "no browser could be opened" in said.err


def interrupted(*_: object) -> None:
    raise KeyboardInterrupt


def test_a_bad_job_is_the_sentence_of_the_reader(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    job = tmp_path / "job.toml"
    job.write_text('[pendulum]\nlength = "67 s"\n')
    assert main(["explore", str(job)]) == 2
    assert "job.toml" in capsys.readouterr().err


def test_a_job_becomes_a_fragment_of_its_own_keys(tmp_path: Path) -> None:
    job = tmp_path / "job.toml"
    job.write_text(
        """
[pendulum]
length = "67 m"
[launch]
kind = "state"
position = ["1 m", 0, "66.99253689777 m"]
velocity = [0, "2 cm/s", 0]
[site]
latitude = "48.85 N"
[drag]
quality = 800
[bob]
diameter = "20 cm"
density = "8500 kg/m^3"
[output]
duration = "10 min"
step = "1 s"
figure = false
"""
    )
    said = dict(part.split("=") for part in fragment_of(job).split("&"))
    latitude = float(said.pop("site.latitude"))
    assert latitude == pytest.approx(math.radians(48.85), rel=1e-15)
    assert {key: unquote(text) for key, text in said.items()} == {
        "pendulum.length": "67.0",
        "launch.kind": "state",
        "launch.position": "1.0,0.0,66.99253689777",
        "launch.velocity": "0.0,0.02,0.0",
        "drag.quality": "800.0",
        "bob.diameter": "0.2",
        "bob.density": "8500.0",
        "output.duration": "600.0",
    }
