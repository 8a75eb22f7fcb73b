"""Live pages: what a session does with commands and its clock, and whom its server answers."""

from __future__ import annotations

import base64
import contextlib
import http.client
import json
import os
import signal
import socket
import subprocess
import sys

import numpy as np
import pytest

from build_fmu.run_page import Carried
from build_fmu.stepping import SteppedFmu
from tests.support.fmus.commands import run
from tests.support.hanging import HANGS
from tests.viewer.conftest import ROOT, scene
from viewer.live import BUSY, GRACE, LAG, RATE, SPEEDS, Session, StoppedError, live_page
from viewer.live_server import Server


class Clock:
    """A clock that goes on when it is told, and by `each` whenever it is read."""

    def __init__(self, each=0.0):
        self.now, self.each = 0.0, each

    def __call__(self):
        self.now += self.each
        return self.now


class Falling:
    """A source: height of a thing that falls with a gravity that can be set, and stops at 0."""

    columns, start_time, stop_time, step_size = ("g", "height"), 0.0, 1.0, 0.01

    def begin(self, values):
        if values.get("height", 1.0) <= 0.0:
            text = "height: must be > 0 m"
            raise StoppedError(text)
        self.g, self.height = values.get("g", 1.0), values.get("height", 1.0)
        return self._row(0.0)

    def set(self, name, value):
        setattr(self, name, value)

    def step(self, time, step):
        if self._row(time + step)[1] < 0.0:
            text = "it has come to the ground"
            raise StoppedError(text)
        return self._row(time + step)

    def _row(self, time):
        return np.array([self.g, self.height - self.g * time**2 / 2.0])

    def drawing(self, values):
        return {"height": values.get("height", 1.0)}


CONTROLS = [
    {"name": "g", "live": True, "start": 1.0},
    {"name": "height", "live": False, "start": 1.0},
]


def begun(clock=None):
    """Session with one page, and the function that makes a turn after some time and its events."""
    clock = clock or Clock()
    session = Session(Falling(), CONTROLS, clock)
    page = session.join()

    def turn(after=0.0, **command):
        clock.now += after
        if command:
            session.do(command)
        session.turn()
        return events(page)

    return session, page, turn


def events(page):
    found = []
    while not page.empty():
        kind, data = page.get().decode().split("\n")[:2]
        found.append((kind.removeprefix("event: "), json.loads(data.removeprefix("data: "))))
    return found


def numbers(data):
    return np.frombuffer(base64.b64decode(data["values"]), "<f4")


def test_a_page_is_greeted_with_the_drawing_values_and_a_row():
    _, _, turn = begun()
    ((kind, data),) = turn()
    assert kind == "start"
    assert data["set"] == {"g": 1.0, "height": 1.0}
    assert (data["time"], data["playing"]) == (0.0, False)
    assert list(numbers(data)) == [1.0, 1.0]


def test_time_goes_as_fast_as_the_clock_times_the_speed():
    session, _, turn = begun()
    turn()
    turn(play=True)
    turn(0.5)
    assert session.time == pytest.approx(0.5, abs=0.011)
    turn(speed=0.1)
    turn(1.0)
    assert session.time == pytest.approx(0.6, abs=0.012)
    turn(play=False)
    turn(3.0)
    assert session.time == pytest.approx(0.6, abs=0.012)


def test_a_session_that_cannot_keep_up_goes_on_from_where_it_is():
    clock = Clock()
    session, _, turn = begun(clock)
    turn()
    turn(play=True)
    clock.each = BUSY / 3.5  # a step takes that long
    for _ in range(3):
        (row,) = turn(0.5)
        assert row[0] == "row"
        assert row[1]["late"]
    assert session.time < 0.15
    clock.each = 0.0
    before = session.time
    (row,) = turn(0.1)
    assert not row[1]["late"]
    assert session.time - before <= LAG + BUSY + 0.111


def test_a_pause_of_a_busy_machine_is_made_up_for():
    clock = Clock()
    session, _, turn = begun(clock)
    turn()
    turn(play=True)
    clock.each = BUSY / 3.5
    (row,) = turn(0.9 * LAG)  # more steps than one turn has time for
    assert not row[1]["late"]
    clock.each = 0.0
    for _ in range(6):
        turn(1.0 / RATE)
    assert session.time == pytest.approx(clock.now, abs=0.011)


@pytest.mark.parametrize("speed", [0.01, 0.3, 1.0, 7.0])
@pytest.mark.parametrize("step_size", [1e-4, 0.01, 0.05, 1.0])
def test_a_session_is_less_than_a_sixtieth_second_behind_its_clock(monkeypatch, speed, step_size):
    monkeypatch.setattr(Falling, "step_size", step_size)
    monkeypatch.setattr(Falling, "_row", lambda *_: np.zeros(2))
    clock = Clock()
    session, _, turn = begun(clock)
    turn()
    turn(play=True, speed=speed)
    begin = clock.now
    for _ in range(300):  # turns are not of the same length
        turn(0.013)
        turn(0.021)
        assert 0.0 <= (clock.now - begin) - session.time / speed <= 1.0 / RATE + 1e-9


def test_a_single_step_is_one_of_the_scene_and_pauses():
    session, _, turn = begun()
    turn()
    turn(play=True)
    turn(0.1)
    before = session.time
    turn(step=True)
    assert session.time == before + 0.01
    assert not session.playing


def test_what_acts_at_once_changes_the_next_row_and_nothing_else():
    session, _, turn = begun()
    turn()
    for _ in range(5):
        turn(step=True)
    (*_, (kind, data)) = turn(step=True, set={"g": 4.0})
    assert kind == "row"
    assert numbers(data)[0] == 4.0
    assert session.time == pytest.approx(0.06)


def test_a_fixed_parameter_restarts_with_all_values():
    session, _, turn = begun()
    turn(step=True, set={"g": 4.0})
    (*_, (kind, data)) = turn(set={"height": 2.0})
    assert (kind, session.time) == ("start", 0.0)
    assert list(numbers(data)) == [4.0, 2.0]
    assert data["drawing"] == {"height": 2.0}
    (*_, (kind, data)) = turn(original=True)
    assert (kind, list(numbers(data))) == ("start", [1.0, 1.0])


def test_a_reset_begins_again_and_goes_on_playing():
    session, _, turn = begun()
    turn()
    turn(play=True)
    turn(0.5)
    ((kind, data),) = turn(reset=True)
    assert (kind, data["time"], session.playing) == ("start", 0.0, True)
    turn(0.2)
    assert session.time == pytest.approx(0.2, abs=0.011)


def test_a_failed_step_is_told_with_its_sentence_and_a_reset_helps():
    session, _, turn = begun()
    turn(set={"g": 200.0})
    turn(play=True)
    told = dict(turn(0.5))
    assert told["failed"] == {"time": session.time, "reason": "it has come to the ground"}
    assert told["row"]["time"] == session.time == pytest.approx(0.1)
    assert not session.playing
    turn(original=True)
    assert (session.reason, session.time) == ("", 0.0)


def test_a_value_with_which_it_cannot_begin_is_told_and_another_one_begins():
    session, _, turn = begun()
    turn()
    ((kind, data),) = turn(set={"height": -1.0})
    assert (kind, data["reason"]) == ("failed", "height: must be > 0 m")
    assert not any(kind == "row" for kind, _ in turn(play=True))
    (*_, (kind, _)) = turn(set={"height": 3.0})
    assert (kind, session.reason) == ("start", "")


def test_a_session_ends_when_its_last_page_has_been_closed_for_a_while():
    clock = Clock()
    session = Session(Falling(), CONTROLS, clock)
    session.turn()
    clock.now += 100.0
    assert not session.ended  # nobody has come yet
    pages = [session.join(), session.join()]
    session.turn()
    session.leave(pages[0])
    session.turn()
    clock.now += 10.0 * GRACE
    assert not session.ended
    session.leave(pages[1])
    session.turn()
    assert not session.ended
    clock.now += 1.01 * GRACE
    assert session.ended


def test_a_page_that_is_loaded_again_keeps_the_session():
    clock = Clock()
    session = Session(Falling(), CONTROLS, clock)
    page = session.join()
    session.turn()
    session.leave(page)
    session.turn()
    session.join()
    session.turn()
    clock.now += 10.0 * GRACE
    assert not session.ended


@pytest.mark.parametrize(
    "command",
    [None, [], 3, {"set": 1}, {"set": {"f": 1.0}}, {"set": {"g": "1"}}, {"set": {"g": True}},
     {"set": {"g": float("nan")}}, {"speed": 0.0}, {"speed": -1.0}, {"speed": "fast"},
     {"speed": 1e-320}, {"speed": 1e300}, {"speed": float("inf")}, {"speed": float("nan")},
     {"speed": True}, {"speed": 10**400}, {"set": {"g": -(10**400)}}, {"set": {"g": 10**400}}],
)  # fmt: skip
def test_a_wrong_command_is_refused_with_a_sentence(command):
    assert Session(Falling(), CONTROLS, Clock()).mistake(command)


# ---------------------------------------------------------------------------------------- server


@pytest.fixture
def server():
    session = Session(Falling(), CONTROLS, Clock())
    with Server(session, "<p>page</p>", beat=0.01) as server:
        yield server


def asked(server, path, body=None, **headers):
    """Status and text of an answer."""
    connection = http.client.HTTPConnection("127.0.0.1", server.server_port, timeout=HANGS)
    method = "GET" if body is None else "POST"
    headers = {"Host": f"127.0.0.1:{server.server_port}"} | headers
    connection.request(method, path, body, headers)
    answer = connection.getresponse()
    text = answer.read().decode()
    connection.close()
    return answer.status, text


def test_only_the_own_page_is_answered(server):
    good, port = f"/?k={server.token}", server.server_port
    assert asked(server, good) == (200, "<p>page</p>")
    assert (
        asked(server, good, Host=f"localhost:{port}", Origin=f"http://localhost:{port}")[0] == 200
    )
    for path in ("/", "/?k=", "/?k=guess", f"/?x={server.token}", "/events", "/nowhere"):
        assert asked(server, path)[0] == 403
    for host in ("evil.example", f"evil.example:{port}", "127.0.0.1", f"127.0.0.1:{port + 1}"):
        assert asked(server, good, Host=host)[0] == 403
    for origin in ("http://evil.example", "null", f"https://127.0.0.1:{port}", "http://127.0.0.1"):
        assert asked(server, good, Origin=origin)[0] == 403
        assert asked(server, f"/do?k={server.token}", "{}", Origin=origin)[0] == 403


def test_a_posted_value_acts(server):
    path = f"/do?k={server.token}"
    assert asked(server, path, json.dumps({"set": {"g": 7.0}}))[0] == 204
    server.session.turn()
    assert server.session.values == {"g": 7.0}


@pytest.mark.parametrize("speed", SPEEDS)
def test_a_session_turns_at_the_slowest_and_the_fastest_speed(speed):
    clock = Clock(each=1e-3)
    session = Session(Falling(), CONTROLS, clock)
    assert not session.mistake({"speed": speed})
    session.do({"speed": speed, "play": True})
    for _ in range(3):
        clock.now += 0.1
        session.turn()
    assert session.time >= 0.0


def test_a_request_of_odd_numbers_is_answered_and_the_server_goes_on(server, capfd):
    port, token = server.server_port, server.token
    for line in ("GET http://[ HTTP/1.1", f"POST /do?k={token} HTTP/1.1"):
        with socket.create_connection(("127.0.0.1", port), timeout=HANGS) as connection:
            head = f"{line}\r\nHost: 127.0.0.1:{port}\r\nContent-Length: {'9' * 5000}\r\n\r\n"
            connection.sendall(head.encode())
            assert connection.makefile("rb").read().startswith(b"HTTP/1.1 4")
    assert asked(server, f"/?k={token}")[0] == 200
    assert "Traceback" not in capfd.readouterr().err


@pytest.mark.parametrize(
    "body",
    [
        "",
        "{",
        '{"speed": %s}' % ("9" * 400),
        '{"speed": %s}' % ("9" * 5000),
        '{"speed": 1e-320}',
        "[" * 60000,
        "x" * 70000,
        '{"set": {"g": NaN}}',
    ],
)
def test_a_post_that_is_no_command_is_refused(server, body):
    assert asked(server, f"/do?k={server.token}", body)[0] == 400
    server.session.turn()
    assert server.session.values == {}


def test_events_come_until_the_page_is_closed_and_then_the_session_ends(server):
    session, clock = server.session, server.session._clock
    connection = http.client.HTTPConnection("127.0.0.1", server.server_port, timeout=HANGS)
    connection.request("GET", f"/events?k={server.token}")
    stream = connection.getresponse()
    while not session._pages:
        session.turn()
    lines = [stream.readline() for _ in range(2)]
    assert lines[0] == b"event: start\n"
    stream.close()
    connection.close()
    while session._pages:  # a write finds out that nobody is there
        session.turn()
    clock.now += 2.0 * GRACE
    assert session.ended


def test_the_server_runs_until_the_session_ends():
    session = Session(Falling(), CONTROLS, Clock())
    turns = []

    @contextlib.contextmanager
    def hold():
        yield
        turns.append(session.time)
        session._alone_since = -10.0 * GRACE if len(turns) == 3 else session._alone_since

    with Server(session, "") as server:
        server.run(hold=hold)
    assert len(turns) == 3
    with Server(session, "", server.server_port):  # its port is free
        pass


def test_another_session_takes_the_place_of_one_and_pages_load_anew(server):
    before, after = server.session, Session(Falling(), CONTROLS, Clock())
    pages = [before.join(), before.join()]
    before.turn()
    before.say("points.A: wrong")
    server.show(after, "<p>other</p>")
    for page in pages:
        assert page.queue.pop() is None
        assert events(page)[1:] == [("said", {"text": "points.A: wrong"}), ("anew", {})]
    assert asked(server, f"/?k={server.token}") == (200, "<p>other</p>")
    assert asked(server, f"/do?k={server.token}", '{"set": {"g": 7}}')[0] == 204
    after.turn()
    assert after.values == {"g": 7.0}


@pytest.mark.skipif(os.name == "nt", reason="Windows has another Ctrl-C")
@pytest.mark.parametrize(
    "command", [["view"], ["watch"], ["watch", "--view"]], ids=lambda command: " ".join(command)
)
def test_ctrl_c_ends_a_command_with_0_and_leaves_nothing(command, tmp_path):
    shows = command != ["watch"]
    more = ["--no-browser"] if shows else []
    process = subprocess.Popen(
        [sys.executable, "-m", "holonom", *command, scene("double_pendulum"), *more],
        stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, cwd=ROOT,
        env=os.environ | {"TMPDIR": str(tmp_path)},
        preexec_fn=lambda: signal.signal(signal.SIGINT, signal.default_int_handler),
    )  # fmt: skip
    with process, contextlib.ExitStack() as pages:
        assert process.stdout
        assert process.stderr
        said = process.stdout.readline().strip()
        if shows:
            assert process.stderr.readline().startswith("it ends with Ctrl-C")
            port = int(said.split(":")[2].split("/")[0])
            page = http.client.HTTPConnection("127.0.0.1", port, timeout=HANGS)
            pages.enter_context(contextlib.closing(page))
            page.request("GET", f"/events?{said.split('?')[1]}")  # a page that stays open
            stream = pages.enter_context(page.getresponse())
            assert stream.readline() == b"event: start\n"
        process.send_signal(signal.SIGINT)
        assert process.wait(HANGS) == 0  # so no thread is left
        assert process.stderr.read() == ""
    assert list(tmp_path.iterdir()) == []
    if shows:
        Server(Session(Falling(), CONTROLS), "", port).server_close()


def test_a_port_that_is_taken_is_a_sentence(server, capsys):
    taken = str(server.server_port)
    for port, reason in ((taken, "already in use"), ("70000", "must be 0-65535")):
        code, out, err = run(
            capsys, "view", scene("double_pendulum"), "--no-browser", "--port", port
        )
        assert (code, out) == (2, "")
        assert err.startswith(f"holonom: port {port}: ")
        assert reason in err


# ------------------------------------------------------------------------------------------ FMUs


@pytest.fixture(scope="module")
def slider_crank(tmp_path_factory):
    from build_fmu.export import build_archive

    return build_archive(scene("slider_crank"), tmp_path_factory.mktemp("fmu") / "m.fmu", None)


def test_an_fmu_is_stepped_as_simulate_does(slider_crank):
    from build_fmu.run import run_fmu

    with_step = SteppedFmu(Carried(slider_crank), {})
    rows, times = [with_step.begin({})], [0.0]
    for _ in range(20):
        rows.append(with_step.step(times[-1], with_step.step_size))
        times.append(times[-1] + with_step.step_size)
    with_step.close()
    whole = run_fmu(slider_crank, with_local=True)
    for k, name in enumerate(with_step.columns):
        assert rows[20][k] == pytest.approx(whole.values[name][20], rel=1e-9, abs=1e-9)


def test_the_page_of_an_fmu_has_its_controls_and_connects_to_its_server_alone(slider_crank):
    carried = Carried(slider_crank)
    fmu = SteppedFmu(carried, {})
    controls = fmu.controls()
    for control in controls:
        assert control["low"] <= control["start"] <= control["high"]
        assert control["low"] < control["high"]
    page = live_page(
        Session(fmu, controls), fmu, controls, name="x", description="",
        variables=carried.model.variables, outputs=[],
    )  # fmt: skip
    fmu.close()
    assert "connect-src 'self'" in page
    assert {c["name"] for c in controls} == {
        v.name for v in carried.model.variables
        if v.causality in ("parameter", "input") and v.kind != "option"
    }  # fmt: skip
