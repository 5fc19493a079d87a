"""Long calls: Ctrl-C, progress, journals, threads and processes."""

from __future__ import annotations

import subprocess
import sys
from concurrent.futures import ProcessPoolExecutor, ThreadPoolExecutor
from multiprocessing import get_context

import joblib
import numpy as np
import pandas as pd
import pytest

import touchdown as td
from touchdown import _engine

from conftest import SHORT

# What a shell starts in the background ignores Ctrl-C, and so does what that starts, unless it says otherwise.
HEED_CTRL_C = """
import signal
signal.signal(signal.SIGINT, signal.default_int_handler)
"""

# Begins a call that takes minutes, interrupts it, and says how long the call went on, in milliseconds.
INTERRUPTED = HEED_CTRL_C + """
import os, threading, time
import numpy as np
import touchdown as td
lander = td.vehicles.surveyor()
scene = td.Scene(vertical_velocity_fps=14, horizontal_velocity_fps=11, cross_slope_deg=180, slope_deg=15, friction=1)
at = []
def interrupt(done, wanted, landings):
    if landings and not at:
        at.append(time.perf_counter())
        os.kill(os.getpid(), signal.SIGINT)
try:
    {call}
except KeyboardInterrupt:
    print(1000 * (time.perf_counter() - at[0]))
"""
LONG_CALLS = [
    "td.land_many(lander, {'roll_deg': np.linspace(0, 20, 100_000)}, scene=scene, progress=interrupt)",
    "td.sweep(lander, scene, {'roll_deg': np.linspace(0, 20, 1000)}, progress=interrupt)",
    "td.boundary(lander, scene, search={'scan_step_fps': 0.001}, progress=interrupt)",
    "td.run('sweeps/surface-4-20.toml', '{folder}', progress=interrupt)",
]


@pytest.mark.parametrize("call", LONG_CALLS)
def test_ctrl_c_stops_any_long_call(call, root, tmp_path):
    script = INTERRUPTED.replace("{call}", call.replace("{folder}", str(tmp_path)))
    done = subprocess.run([sys.executable, "-c", script], cwd=root, capture_output=True, text=True, timeout=60, check=False)
    # That it ended in time says that it was interrupted; no test asserts how fast.
    assert done.returncode == 0 and float(done.stdout) > 0, done.stderr


# Begins a landing that takes seconds, interrupts it, and says for how long cores went on, in seconds.
INTERRUPTED_LANDING = HEED_CTRL_C + """
import os, threading, time
import touchdown as td
lander = td.vehicles.surveyor()
scene = td.Scene(vertical_velocity_fps=14, horizontal_velocity_fps=11, cross_slope_deg=180, slope_deg=15, friction=1)
at = []
def interrupt():
    at.append(time.process_time())
    os.kill(os.getpid(), signal.SIGINT)
threading.Timer(0.2, interrupt).start()
try:
    td.land(lander, scene, {solver})
except KeyboardInterrupt:
    print(time.process_time() - at[0])
"""


@pytest.mark.parametrize("solver", [{"tolerance": 1e-12, "time_limit_s": 1000, "stop": "time"}, {"method": "rk4", "interval_s": 1e-6}])
def test_ctrl_c_stops_a_single_landing(solver):
    script = INTERRUPTED_LANDING.replace("{solver}", repr(solver))
    done = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, timeout=60, check=False)
    # A landing that does not look at signals is waited for, a second.
    assert done.returncode == 0 and 0 < float(done.stdout) < 1.5, done.stderr


# Interrupts the check of so many rows with vehicles of their own, and says what landed and for how long a core went on, in seconds.
INTERRUPTED_CHECK = HEED_CTRL_C + """
import os, threading, time
import numpy as np
import touchdown as td
scene = td.Scene(vertical_velocity_fps=14, horizontal_velocity_fps=11, cross_slope_deg=180, slope_deg=15, friction=1)
table = {'vehicle.strut.preload_lb': np.linspace(180, 190, 1_000_000)}
landed = []
threading.Timer(0.5, os.kill, (os.getpid(), signal.SIGINT)).start()
try:
    td.land_many(td.vehicles.surveyor(), table, scene=scene, progress=lambda *counts: landed.append(counts))
except KeyboardInterrupt:
    begun = time.process_time()
    time.sleep(1)
    print(len(landed), time.process_time() - begun)
"""


def test_ctrl_c_stops_the_check_of_rows():
    done = subprocess.run([sys.executable, "-c", INTERRUPTED_CHECK], capture_output=True, text=True, timeout=60, check=False)
    assert done.returncode == 0, done.stderr
    landings, seconds = done.stdout.split()
    assert landings == "0" and float(seconds) < 0.5


@pytest.mark.parametrize("place", ["reading", "in place", "on a thread"])
def test_a_fault_of_the_engine_is_an_exception_of_ours(place):
    with pytest.raises(td.EngineError, match="the engine failed, which is a fault of it: on purpose"):
        _engine.fault(place)


def test_progress_comes_to_an_end(lander, scene):
    told = []
    td.land_many(lander, {"roll_deg": np.zeros(50)}, scene=scene, progress=lambda *counts: told.append(counts))
    assert told[-1] == (50, 50, 50)


def test_what_a_callable_raises_ends_the_call(lander, scene):
    def refuse(done, wanted, landings):
        raise LookupError("enough")

    with pytest.raises(LookupError, match="enough"):
        td.sweep(lander, scene, {"roll_deg": np.linspace(0, 20, 1000)}, progress=refuse)


def test_an_interrupted_sweep_goes_on(lander, scene, tmp_path):
    axes = {"roll_deg": np.arange(0, 40, 1.0)}
    options = {"search": SHORT, "out": tmp_path, "name": "rolls"}

    def interrupt(done, wanted, landings):
        if done >= 5:
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        td.sweep(lander, scene, axes, progress=interrupt, **options)
    assert [file.name for file in tmp_path.iterdir()] == ["rolls.journal"]
    told = []
    resumed = td.sweep(lander, scene, axes, progress=lambda *counts: told.append(counts), **options)
    assert told[-1][0] == 40 and told[-1][2] < resumed.landings.sum()
    assert sorted(file.name for file in tmp_path.iterdir()) == ["rolls.csv", "rolls.json"]
    assert resumed.equals(td.sweep(lander, scene, axes, search=SHORT, progress=False))


def test_interrupted_cases_go_on_and_leave_the_table_of_the_command_line(lander, scene, tmp_path, program):
    table = pd.DataFrame({"case": [f"no-{n}" for n in range(60)], "roll_deg": np.linspace(0, 20, 60)})
    cases = table.assign(**scene.to_dict())
    cases.to_csv(tmp_path / "cases.csv", index=False)
    surveyor = "sweeps/vehicles/surveyor-table-4-1.toml"
    program("land", "--vehicle", surveyor, "--cases", tmp_path / "cases.csv", "--out", tmp_path / "expected.csv", "--quiet")

    def interrupt(done, wanted, landings):
        if done:
            raise KeyboardInterrupt

    out = tmp_path / "landed.csv"
    with pytest.raises(KeyboardInterrupt):
        td.land_many(lander, table, scene=scene, out=out, progress=interrupt)
    assert out.with_name("landed.csv.journal").is_file() and not out.exists()
    told = []
    landed = td.land_many(lander, table, scene=scene, out=out, progress=lambda *counts: told.append(counts))
    assert told[-1][0] == 60 and 0 < told[-1][2] < 60
    assert out.read_bytes() == (tmp_path / "expected.csv").read_bytes()
    pd.testing.assert_frame_equal(landed, td.land_many(lander, table, scene=scene, progress=False))
    (tmp_path / "mine.csv").write_text("mine")
    with pytest.raises(td.InputError, match="exists and is no earlier result"):
        td.land_many(lander, table, scene=scene, out=tmp_path / "mine.csv", progress=False)


def test_a_journal_of_other_input_is_refused(lander, scene, tmp_path):
    def interrupt(done, wanted, landings):
        if done:
            raise KeyboardInterrupt

    axes = {"roll_deg": np.arange(0, 40, 1.0)}
    with pytest.raises(KeyboardInterrupt):
        td.sweep(lander, scene, axes, search=SHORT, out=tmp_path, progress=interrupt)
    with pytest.raises(td.InputError, match="a journal of other input cannot be resumed"):
        td.sweep(lander, scene.replace(friction=0.9), axes, search=SHORT, out=tmp_path, progress=False)


def test_files_that_are_no_results_stay(lander, scene, tmp_path):
    (tmp_path / "sweep.csv").write_text("mine\n")
    with pytest.raises(td.InputError, match="exists and is no earlier result of this command: expected another file, or overwrite=True"):
        td.sweep(lander, scene, {"roll_deg": [0]}, search=SHORT, out=tmp_path, progress=False)
    td.sweep(lander, scene, {"roll_deg": [0]}, search=SHORT, out=tmp_path, overwrite=True, progress=False)


def test_results_of_other_input_stay(lander, scene, tmp_path):
    def swept(given, **options):
        return td.sweep(lander, given, {"roll_deg": [0, 10]}, search=SHORT, out=tmp_path, progress=False, **options)

    first = swept(scene)
    files = {file: file.read_bytes() for file in tmp_path.iterdir()}
    icy = scene.replace(friction=0.9)
    other = rf"{tmp_path}/sweep.csv: holds results of other input: expected another folder or name, or overwrite=True"
    for call in [
        lambda: swept(icy),
        lambda: swept(scene, units="SI"),
        lambda: swept(scene, title="Other"),
        lambda: td.map(
            lander, scene, {"roll_deg": [0, 10]}, {"roll_deg": 10}, error_fps=5, search=SHORT, out=tmp_path, progress=False
        ),
    ]:
        with pytest.raises(td.InputError, match=other):
            call()
        assert {file: file.read_bytes() for file in tmp_path.iterdir()} == files
    replaced = swept(icy, overwrite=True)
    assert not replaced.equals(first) and replaced.identical(swept(icy))
    (tmp_path / "sweep.json").unlink()
    with pytest.raises(td.InputError, match=other):
        swept(icy)


def test_results_of_the_same_input_are_given_back(root, lander, scene, tmp_path):
    landings = []

    def swept(**options):
        landings.clear()
        watch = lambda done, wanted, landed: landings.append(landed)  # noqa: E731
        return td.sweep(lander, scene, {"roll_deg": [0, 10]}, search=SHORT, out=tmp_path, progress=watch, **options)

    first = swept()
    assert landings and swept().identical(first) and not landings
    assert swept(parquet=True).identical(first) and (tmp_path / "sweep.parquet").is_file()
    assert swept(overwrite=True).identical(first) and landings
    path = root / "sweeps/figure-4-25.toml"
    ran = td.run(path, tmp_path, progress=False)
    assert td.run(path, tmp_path, progress=lambda *counts: landings.clear()).identical(ran) and landings


def test_a_grown_sample_takes_over_the_points_of_the_smaller_one(lander, scene, tmp_path):
    landings = []

    def drawn(count, out, **options):
        landings.clear()
        watch = lambda done, wanted, landed: landings.append((done, wanted, landed))  # noqa: E731
        axes = {"friction": {"from": 0.8, "to": 1.1}}
        ds = td.sample(lander, scene, axes, count, 7, out=tmp_path / out, progress=watch, **options)
        return ds, landings[-1]

    for options in [{}, {"units": "SI", "parquet": True, "design": "sobol"}]:
        name = options.get("design", "monte-carlo")
        drawn(8, name, **options)
        grown, counts = drawn(12, name, threads=1, **options)
        assert counts == (12, 12, 4)
        whole, counts = drawn(12, "whole", overwrite=True, **options)
        assert counts == (12, 12, 12) and grown.identical(whole)
        for file in (tmp_path / name).iterdir():
            assert file.suffix == ".kept" or file.read_bytes() == (tmp_path / "whole" / file.name).read_bytes()


def test_tables_of_other_rows_stay(lander, scene, tmp_path):
    out = tmp_path / "landed.csv"

    def landed(rolls, **options):
        return td.land_many(lander, {"roll_deg": rolls}, scene=scene, out=out, progress=False, **options)

    first = landed([0, 10])
    written = out.read_bytes()
    pd.testing.assert_frame_equal(landed([0, 10]), first)
    for rolls, options in [([0, 11], {}), ([0, 10, 20], {}), ([0, 10], {"units": "SI"})]:
        with pytest.raises(td.InputError, match=f"{out}: holds other results: expected another file, or overwrite=True"):
            landed(rolls, **options)
        assert [file.name for file in tmp_path.iterdir()] == ["landed.csv"] and out.read_bytes() == written
    landed([0, 11], overwrite=True)
    assert out.read_bytes() != written


def outcome(vehicle: td.Vehicle, scene: td.Scene) -> td.Landing:
    return td.land(vehicle, scene)


def test_threads_and_processes_get_the_same_landing(lander, scene):
    expected = td.land(lander, scene)
    with ThreadPoolExecutor(4) as pool:
        assert set(pool.map(td.land, [lander] * 8, [scene] * 8)) == {expected}
    for method in ("spawn", "fork"):
        with ProcessPoolExecutor(2, get_context(method)) as pool:
            assert set(pool.map(outcome, [lander] * 4, [scene] * 4)) == {expected}


def test_joblib_gets_the_same_landing(lander, scene):
    landings = joblib.Parallel(n_jobs=2)(joblib.delayed(outcome)(lander, scene) for _ in range(4))
    assert set(landings) == {td.land(lander, scene)}


def test_searches_run_side_by_side(lander, scene):
    rolls = [0, 10, 20]
    search = lambda roll: td.boundary(lander, scene.replace(roll_deg=roll), search=SHORT, progress=False)  # noqa: E731
    alone = [search(roll) for roll in rolls]
    with ThreadPoolExecutor(3) as pool:
        assert list(pool.map(search, rolls)) == alone
