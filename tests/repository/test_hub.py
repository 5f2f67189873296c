"""The files for a class on a Hub: they agree with each other and with the page, and the collection follows no link."""

import importlib.util
import json
import os
import re
import sys
from pathlib import Path
from urllib.parse import parse_qs, urlsplit

import pytest
import yaml

ROOT = Path(__file__).parents[2]
DEPLOY = ROOT / "deploy"
PAGE = (ROOT / "site" / "pages" / "hub.md").read_text("utf-8")
VALUES = yaml.safe_load((DEPLOY / "values.yaml").read_text("utf-8"))
VOLUME, COLLECTOR = yaml.safe_load_all((DEPLOY / "homes.yaml").read_text("utf-8"))
SHEET = Path("sheets/exercises/03_poe_space/03_poe_space.ipynb")


class Recorder(dict):
    """What a configuration file sets, by name; `c.Spawner.args` is `c["Spawner"]["args"]`."""

    def __getattr__(self, name):
        return self.setdefault(name, Recorder())

    def __setattr__(self, name, value):
        self[name] = value


@pytest.fixture
def config(monkeypatch):
    monkeypatch.setenv("COURSE_SHEETS", "https://example.org/sheets.git")
    recorder = Recorder()
    exec((DEPLOY / "jupyterhub_config.py").read_text("utf-8"), {"get_config": lambda: recorder})
    return recorder


@pytest.fixture
def collect():
    spec = importlib.util.spec_from_file_location("collect", DEPLOY / "collect.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module.collect


def test_both_hubs_fetch_the_sheets_into_the_folder_from_which_they_are_collected(config):
    addresses = [urlsplit(url) for url in (config.Spawner.default_url, VALUES["singleuser"]["defaultUrl"])]
    one, cluster = (parse_qs(address.query) for address in addresses)
    assert {address.path for address in addresses} == {"/git-pull"}
    assert one.pop("repo") == ["https://example.org/sheets.git"]
    assert cluster.pop("repo") == ["SHEETS"]
    assert one == cluster
    assert one["targetPath"] == [SHEET.parts[0]]
    assert PAGE.count(str(SHEET)) == 2


def test_a_kernel_may_hold_as_much_on_one_machine_as_in_the_cluster(config):
    (data,) = [word for word in config.Spawner.cmd if word.startswith("--data=")]
    assert VALUES["singleuser"]["memory"]["limit"] == f"{int(data.removeprefix('--data=')) // 1024**3}G"


def test_the_memory_that_the_cluster_guarantees_is_what_a_student_was_measured_to_need():
    rows = json.loads((ROOT / "evidence" / "benchmarks" / "results.json").read_text("utf-8"))["rows"]
    (needed,) = [row["megabytes"] for row in rows if row["section"] == "student"]
    guaranteed = int(VALUES["singleuser"]["memory"]["guarantee"].removesuffix("M"))
    assert needed < guaranteed < 3 * needed
    assert f"takes about {round(needed, -1):.0f} MB" in PAGE


def test_the_volume_and_the_image_have_one_name_each():
    storage, container = VALUES["singleuser"]["storage"], COLLECTOR["spec"]["containers"][0]
    (volume,) = COLLECTOR["spec"]["volumes"]
    assert storage["static"]["pvcName"] == VOLUME["metadata"]["name"] == volume["persistentVolumeClaim"]["claimName"]
    image = VALUES["singleuser"]["image"]
    assert container["image"] == f"{image['name']}:{image['tag']}"
    assert f"podman push {image['name']}\n" in PAGE
    assert COLLECTOR["metadata"]["name"] in re.findall(r"kubectl exec --namespace course (\w+)", PAGE)
    assert VALUES["singleuser"]["extraEnv"]["HOME"] == storage["homeMountPath"]


@pytest.mark.skipif(sys.platform == "win32", reason="a Hub needs Linux")
def test_sheets_are_collected_with_their_dates_and_the_others_are_named(collect, tmp_path):
    for name in ("ada", "bob"):
        path = tmp_path / "homes" / name / SHEET
        path.parent.mkdir(parents=True)
        path.write_text(name)
        os.utime(path, (1e9, 1e9))
    (tmp_path / "homes" / "eve").mkdir()
    missing = collect(tmp_path / "homes", SHEET, tmp_path / "out")
    assert set(missing) == {"eve"}
    copies = [tmp_path / "out" / name / SHEET.name for name in ("ada", "bob")]
    assert [path.read_text() for path in copies] == ["ada", "bob"]
    assert copies[0].stat().st_mtime == 1e9
    assert sorted(path.name for path in (tmp_path / "out").iterdir()) == ["ada", "bob"]


@pytest.mark.skipif(sys.platform == "win32", reason="a Hub needs Linux")
@pytest.mark.parametrize("kind", ["the file", "a folder above it", "the whole folder", "a pipe", "a folder instead"])
def test_what_is_no_file_of_the_student_is_not_collected(collect, tmp_path, kind):
    homes = tmp_path / "homes"
    path = homes / "ada" / SHEET
    path.parent.mkdir(parents=True)
    path.write_text("ada's own work")
    eve = homes / "eve" / SHEET
    if kind == "the whole folder":
        eve = homes / "eve"
        eve.symlink_to(homes / "ada")
    elif kind == "a folder above it":
        eve.parents[1].mkdir(parents=True)
        eve.parent.symlink_to(path.parent)
    else:
        eve.parent.mkdir(parents=True)
        {"the file": lambda: eve.symlink_to(path), "a pipe": lambda: os.mkfifo(eve)}.get(kind, eve.mkdir)()
    missing = collect(homes, SHEET, tmp_path / "out")
    assert [path.name for path in (tmp_path / "out").iterdir()] == ["ada"]
    assert set(missing) == (set() if kind == "the whole folder" else {"eve"})
