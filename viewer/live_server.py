"""Serves a live page on 127.0.0.1: hands on what a session sends, and commands to it.

An address has a random token; requests of other hosts and origins are refused, so that no page of
the web can reach the session.
"""

from __future__ import annotations

import contextlib
import json
import math
import queue
import secrets
import threading
import time
from collections.abc import Callable, Iterator
from http import HTTPStatus
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from typing import TYPE_CHECKING, Any
from urllib.parse import parse_qs, urlsplit

from viewer.live import RATE

if TYPE_CHECKING:
    from viewer.live import Session

POLL = 0.05
"""Time in s after which the thread that answers notices the end."""
BEAT = 1.0
"""Time in s after which a page that hears nothing is written to: a closed one is noticed so."""
LARGEST = 65536
"""Bytes of a command."""


class Server(ThreadingHTTPServer):
    """Serves one session on 127.0.0.1.

    GET / is the page, GET /events what it is sent, POST /do a command; each with ``?k=TOKEN``.
    """

    daemon_threads = True

    def __init__(self, session: Session, page: str, port: int = 0, beat: float = BEAT) -> None:
        self.session, self.page, self.beat = session, page.encode(), beat
        self.token = secrets.token_urlsafe(16)
        super().__init__(("127.0.0.1", port), _Handler)

    @property
    def address(self) -> str:
        """What a browser opens."""
        return f"http://127.0.0.1:{self.server_port}/?k={self.token}"

    def allows(self, host: str, origin: str | None, token: str) -> bool:
        """Whether a request is one of our own page."""
        hosts = [f"{name}:{self.server_port}" for name in ("127.0.0.1", "localhost")]
        own = origin is None or origin in [f"http://{name}" for name in hosts]
        known = secrets.compare_digest(token.encode(), self.token.encode())
        return own and host in hosts and known

    def show(self, session: Session, page: str) -> None:
        """Put another session in the place of this one, also on the pages that are open."""
        before, self.session, self.page = self.session, session, page.encode()
        before.close(anew=True)

    def __enter__(self) -> Server:
        """Begin to answer."""
        threading.Thread(target=self.serve_forever, args=(POLL,), daemon=True).start()
        return self

    def __exit__(self, *args: object) -> None:
        """Tell all pages that it is over, and free the port."""
        self.session.close()
        self.shutdown()
        self.server_close()

    def run(
        self, seconds: float | None = None,
        hold: Callable[[], contextlib.AbstractContextManager[object]] = contextlib.nullcontext,
    ) -> None:  # fmt: skip
        """Move the session for so long, else until its last page is closed, each turn in `hold`."""
        end = math.inf if seconds is None else time.perf_counter() + seconds
        while time.perf_counter() < end and not (seconds is None and self.session.ended):
            begun = time.perf_counter()
            with hold():
                self.session.turn()
            time.sleep(max(0.001, 1.0 / RATE - (time.perf_counter() - begun)))


class _Handler(BaseHTTPRequestHandler):
    protocol_version = "HTTP/1.1"

    @property
    def _live(self) -> Server:
        assert isinstance(self.server, Server)
        return self.server

    def log_message(self, format: str, *args: object) -> None:
        """Say nothing: the terminal belongs to the command."""

    def do_GET(self) -> None:
        if not self._is_allowed():
            return
        path = urlsplit(self.path).path
        if path == "/":
            self._answer(HTTPStatus.OK, self._live.page, "text/html; charset=utf-8")
        elif path == "/events":
            self._begin(HTTPStatus.OK, "text/event-stream")
            self._hand_on()
        else:
            self._answer(HTTPStatus.NOT_FOUND)

    def do_POST(self) -> None:
        if not self._is_allowed():
            return
        size = self.headers.get("Content-Length", "")
        fits = size.isdecimal() and len(size) <= len(str(LARGEST)) and int(size) <= LARGEST
        if urlsplit(self.path).path != "/do" or not fits:
            self.close_connection = True
            self._answer(HTTPStatus.BAD_REQUEST, b"not a command")
            return
        try:
            command: Any = json.loads(self.rfile.read(int(size)))
        except (ValueError, RecursionError):
            command = None
        if wrong := self._live.session.mistake(command):
            self._answer(HTTPStatus.BAD_REQUEST, wrong.encode())
            return
        self._live.session.do(command)
        self._answer(HTTPStatus.NO_CONTENT)

    def _is_allowed(self) -> bool:
        try:
            token = parse_qs(urlsplit(self.path).query).get("k", [""])[0]
        except ValueError:  # such as http://[
            token = ""
        host, origin = self.headers.get("Host", ""), self.headers.get("Origin")
        if self._live.allows(host, origin, token):
            return True
        self.close_connection = True
        self._answer(HTTPStatus.FORBIDDEN, b"open the address that holonom view printed")
        return False

    def _begin(self, status: HTTPStatus, kind: str, size: int | None = None) -> None:
        self.send_response(status)
        self.send_header("Content-Type", kind)
        self.send_header("Cache-Control", "no-store")
        self.send_header("Referrer-Policy", "no-referrer")
        self.send_header("X-Frame-Options", "DENY")
        self.send_header("X-Content-Type-Options", "nosniff")
        if size is not None:
            self.send_header("Content-Length", str(size))
        self.end_headers()

    def _answer(self, status: HTTPStatus, body: bytes = b"", kind: str = "text/plain") -> None:
        self._begin(status, kind, len(body))
        self.wfile.write(body)

    def _hand_on(self) -> None:
        """Write what the session sends until the page is closed, or the session ends."""
        self.close_connection = True
        session = self._live.session
        page = session.join()
        try:
            for text in self._said(page):
                self.wfile.write(text)
        except OSError:
            pass  # closed
        finally:
            session.leave(page)

    def _said(self, page: queue.Queue[bytes | None]) -> Iterator[bytes]:
        while True:
            try:
                text = page.get(timeout=self._live.beat)
            except queue.Empty:
                text = b":\n\n"  # a comment, which finds out whether anybody listens
            if text is None:
                return
            yield text
