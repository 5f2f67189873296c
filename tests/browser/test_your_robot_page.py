"""The page Your robot: a URDF file and a table with a wrong sign, from the form to the corrected table and the first problem."""

from zipfile import ZIP_DEFLATED, ZipFile

import pytest
from browser import watched
from lab_page import PYTHON_TIMEOUT_MS
from mesh_files import crane, stl, visual
from playwright.sync_api import expect

import kinlib as kl
from kincourse.your_robot import KNOWN

TABLE = str(KNOWN["UR5e"][0])


def test_a_table_with_a_wrong_sign_is_explained_and_corrected(
    chromium_without_webgl, site_folder, site_address, tmp_path
):
    if not (site_folder / "lab").exists():
        pytest.skip("NO LAB WAS BUILT: its files could not be downloaded.")
    file = tmp_path / "arm.urdf"
    file.write_text(kl.to_urdf(KNOWN["UR5e"][0].to_chain().changed(name="<b>arm</b>")), encoding="utf-8")
    with watched(chromium_without_webgl) as page:
        page.set_default_timeout(PYTHON_TIMEOUT_MS)
        page.goto(f"{site_address}/lectures/your_robot.html")
        answer, drawing = page.locator(".your-robot-result").all()
        expect(answer).to_be_hidden()
        page.get_by_label("A URDF file, or a zip archive with its meshes").set_input_files(file)
        expect(page.locator("form.your-robot")).to_contain_text("The answer names it.")
        page.get_by_label("A DH table").fill(TABLE.replace("-0.425", "0.425"))
        page.get_by_role("button", name="Check", exact=True).click()
        assert page.locator(".kinlib-live-ask").bounding_box()["y"] < 800  # in view
        expect(answer).to_be_hidden()
        page.get_by_role("button", name="Load Python and run").click()
        expect(answer).to_contain_text("For the same q the tool differs by up to 0.85 m", timeout=PYTHON_TIMEOUT_MS)
        expect(answer).to_contain_text("Row 2: a has the wrong sign.")
        expect(answer.locator("tr", has_text="first wrong row")).to_contain_text("-0.425")
        expect(answer.locator("details[open] pre").first).to_contain_text("-0.425")
        expect(drawing.locator("[data-kinlib-viewer]")).to_have_count(1, timeout=PYTHON_TIMEOUT_MS)
        page.get_by_role("button", name="Start with the robot of the form").click()
        problem = page.locator("div.cell", has_text="sheet = practise(")
        expect(problem.locator(".cell_output")).to_contain_text("points)", timeout=PYTHON_TIMEOUT_MS)
        archive = tmp_path / "robot.zip"
        mesh = "package://crane_description/meshes/arm.stl"
        with ZipFile(archive, "w", ZIP_DEFLATED) as files:
            files.writestr("crane-main/urdf/crane.urdf", crane(visual(mesh), '<drake:name value="not declared"/>'))
            files.writestr("crane-main/meshes/arm.stl", stl())
        page.get_by_label("A URDF file, or a zip archive with its meshes").set_input_files(archive)
        expect(page.locator("form.your-robot")).to_contain_text("1 of 1 meshes were found.")
        page.get_by_label("A DH table").fill("no table")
        page.get_by_role("button", name="Check", exact=True).click()
        expect(answer).to_contain_text("No table was found", timeout=PYTHON_TIMEOUT_MS)
        expect(answer.locator("details", has_text="your check before")).to_contain_text("up to 0.85 m")
        page.get_by_label("A DH table").fill("")
        page.get_by_role("button", name="Check", exact=True).click()
        expect(answer).to_contain_text("crane: 1 joint", timeout=PYTHON_TIMEOUT_MS)
        expect(drawing.locator("[data-kinlib-viewer]")).to_have_count(1, timeout=PYTHON_TIMEOUT_MS)
        expect(drawing).not_to_contain_text("not shown")
