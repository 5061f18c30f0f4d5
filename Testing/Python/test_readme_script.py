"""The pvpython script of the README, run as printed (in an output folder, at few particles)."""
import os
import re
import sys

import galaxy_testing as gt


def main():
    with open(os.path.join(gt.ROOT, "README.md"), encoding="utf-8") as file:
        scripts = re.findall(r"```python\n(.*?)```", file.read(), re.DOTALL)
    if not scripts:
        sys.exit("README.md has no python script")
    script = scripts[0]
    if len(script.splitlines()) > 12:
        sys.exit("the script of the README is longer than ten lines or so")
    # Not installed here: the plugin is loaded from the build instead of by its name.
    plugin = os.environ["GALAXY_PLUGIN"]
    script = re.sub(r"LoadDistributedPlugin\((.*?), ", f"LoadPlugin({plugin!r}, ", script)
    os.chdir(gt.ROOT)
    picture = os.path.join(gt.output_folder(), "readme.png")
    script = re.sub(r"SaveScreenshot\((['\"]).*?\1", f"SaveScreenshot({picture!r}", script)
    if os.path.exists(picture):
        os.remove(picture)
    exec(compile(script, "README.md", "exec"), {"__name__": "__main__"})
    from PIL import Image

    with Image.open(picture) as image:
        extrema = image.convert("L").getextrema()
    print(picture, extrema)
    if extrema[1] < 100:
        sys.exit("the README's picture is dark")


if __name__ == "__main__":
    main()
