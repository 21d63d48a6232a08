"""A server for one page: it holds the page's files and knows no others."""

from __future__ import annotations

import base64
import errno
import hashlib
import os
import re
from http import HTTPStatus
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from pathlib import PurePosixPath
from typing import TYPE_CHECKING, Any, cast
from urllib.parse import unquote, urlsplit

from kugelpendel import InvalidInput

if TYPE_CHECKING:
    from collections.abc import Mapping

HOST = "127.0.0.1"

_TRIED = 20
"""Ports that are tried from the wanted one on."""

_LAST_PORT = 65535

_TYPES = {
    ".html": "text/html; charset=utf-8",
    ".js": "text/javascript; charset=utf-8",
    ".css": "text/css; charset=utf-8",
    ".svg": "image/svg+xml",
    ".json": "application/json",
    ".wasm": "application/wasm",
    ".woff2": "font/woff2",
    ".png": "image/png",
}

_POLICY = {
    "default-src": "'none'",
    "script-src": "'self' 'wasm-unsafe-eval'",
    "style-src": "'self'",
    "font-src": "'self'",
    "img-src": "'self' data: blob:",
    "connect-src": "'self'",
    "base-uri": "'none'",
    "form-action": "'none'",
    "frame-ancestors": "'none'",
}
"""Nothing but the page's own files; WebAssembly may be compiled, text may not be run."""

_INLINE = re.compile(rb"<(script|style)>(.*?)</\1>", re.DOTALL)
"""What stands in a page of the derivation, which is one file; it is let through by its hash."""

_HEADERS = {
    "X-Content-Type-Options": "nosniff",
    "Referrer-Policy": "no-referrer",
    "Cross-Origin-Resource-Policy": "same-origin",
    "Cache-Control": "no-cache",
}


def _is_page(path: str) -> bool:
    return path.endswith((".html", "/"))


def _policy(page: bytes) -> str:
    """The policy of a page, with the hashes of what stands in it."""
    allowed = dict(_POLICY)
    for kind, text in _INLINE.findall(page):
        digest = base64.b64encode(hashlib.sha256(text).digest()).decode()
        allowed[f"{kind.decode()}-src"] += f" 'sha256-{digest}'"
    return "; ".join(f"{name} {sources}" for name, sources in allowed.items())


class PageServer(ThreadingHTTPServer):
    """Serves some files on 127.0.0.1.

    Parameters
    ----------
    port
        Of this machine; 0 takes any free one.
    files
        Contents by path; nothing else is served, so that no path leads out of the page.

    Raises
    ------
    OSError
        The port is taken or not allowed.
    """

    daemon_threads = True
    # It allows a restart at once; on Windows it would share a port that is taken.
    allow_reuse_address = os.name == "posix"

    def __init__(self, port: int, files: Mapping[str, bytes]):
        self.files = files
        self.policies = {path: _policy(body) for path, body in files.items() if _is_page(path)}
        super().__init__((HOST, port), _Handler)


class _Handler(BaseHTTPRequestHandler):
    server_version = "kugelpendel"
    sys_version = ""
    protocol_version = "HTTP/1.1"
    timeout = 30

    def do_GET(self) -> None:
        """Answer with a file of the page, or with 404."""
        self._answer(has_body=True)

    def do_HEAD(self) -> None:
        """Answer likewise, without the file."""
        self._answer(has_body=False)

    def _answer(self, *, has_body: bool) -> None:
        path = unquote(urlsplit(self.path).path)
        content = cast("PageServer", self.server).files.get(path)
        status = HTTPStatus.NOT_FOUND if content is None else HTTPStatus.OK
        body = b"The page has no such file.\n" if content is None else content
        suffix = PurePosixPath("index.html" if path == "/" else path).suffix
        kind = _TYPES.get(suffix, "text/plain") if content is not None else "text/plain"
        policy = cast("PageServer", self.server).policies.get(path) or _policy(b"")
        self.send_response(status)
        for name, value in (*_HEADERS.items(), ("Content-Security-Policy", policy)):
            self.send_header(name, value)
        self.send_header("Content-Type", kind)
        self.send_header("Content-Length", str(len(body)))
        self.end_headers()
        if has_body:
            self.wfile.write(body)

    def log_message(self, format: str, *args: Any) -> None:  # noqa: A002 - it is its base's
        """Say nothing: a page that works needs no log."""


def opened(wanted: int, files: Mapping[str, bytes]) -> PageServer:
    """Open a server on a port or, where that is taken, on the next free one.

    Raises
    ------
    InvalidInput
        None of twenty ports is free, or the port needs rights that the user has not.
    """
    last = min(wanted + _TRIED - 1, _LAST_PORT)
    for port in range(wanted, last + 1):
        try:
            return PageServer(port, files)
        except OSError as error:
            if error.errno != errno.EADDRINUSE:
                raise InvalidInput(
                    f"Port {port} of this machine cannot be used: {error.strerror or error}; name "
                    f"another with --port, such as 8315."
                ) from error
    raise InvalidInput(
        f"All ports from {wanted} to {last} are taken; name another with --port, such as "
        f"{wanted + 1000 if wanted + 1000 <= _LAST_PORT else 8315}."
    )
