"""The last frame: the text says what is drawn, for a revolute and a prismatic joint."""

from kincourse.lecture_05_dh_standard.drawings import draw_last_frame, draw_last_frames


def test_the_gallery_shows_both_kinds_of_joints_and_a_frame_beside_the_axis():
    captions = [picture.caption for picture in draw_last_frames().pictures]
    assert captions == [
        "revolute, θ_n = q_n; frame n on the axis",
        "prismatic, d_n = q_n; frame n on the axis",
        "revolute, θ_n = q_n; frame n beside the axis",
    ]


def test_the_description_follows_what_is_drawn():
    assert "Frame n is at (0, 0, 0.4)" in draw_last_frame("P", d=0.4).alt
    assert "Frame n is at (0.3, 0, 0.9)" in draw_last_frame("P", d=0.9, a=0.3).alt
    assert draw_last_frame("R", d=0.4).svg != draw_last_frame("P", d=0.4).svg
