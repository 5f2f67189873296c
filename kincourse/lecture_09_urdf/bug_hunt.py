"""What the bug hunt of lecture 09 finds. It is here because a cell that repairs the lines would tell which they are."""

from kinlib.urdf.chains import load_urdf

REPAIRS = (("-90 0 0", "-1.5708 0 0"), ('"Rod"', '"rod"'), ('"2" upper="-2"', '"-2" upper="2"'))


def messages(text: str) -> str:
    """Return what `load_urdf` says of a file while its lines are repaired one after the other."""
    said = []
    for wrong, right in REPAIRS:
        try:
            load_urdf(text)
        except ValueError as error:
            said.append(str(error))
        text = text.replace(wrong, right)
    return "\n".join([*said, f"Then it reads the file, with the joints {load_urdf(text).joint_types}."])
