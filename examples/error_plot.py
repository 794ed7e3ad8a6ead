#!/usr/bin/env python3
"""Draws what an engine's strip of a look errs by, over all hues: error_plot.py LOOK ENGINE OUT.png

Needs Debian's python3-matplotlib. The look is evaluated exactly; the strip as lutlib reads it back.
"""

# %% What is compared
import sys
import tempfile

import lutlib
import matplotlib
import numpy as np

matplotlib.use("Agg")
from matplotlib import pyplot

path, engine, output = sys.argv[1:4]
look = lutlib.read(path)
with tempfile.TemporaryDirectory() as folder:
    lutlib.bake(look, engine, f"{folder}/strip.png", convert=False)
    baked = lutlib.read(f"{folder}/strip.png", engine=engine)

# %% Hues from left to right, from black through the pure hue to white
hue, light = np.meshgrid(np.linspace(0, 1, 720), np.linspace(1, 0, 240))
pure = np.clip(np.abs((hue[..., None] * 6 + np.array([0, 4, 2])) % 6 - 3) - 1, 0, 1)
level = light[..., None]
colours = np.where(level < 0.5, 2 * level * pure, 1 - 2 * (1 - level) * (1 - pure))
error = np.abs(baked(colours) - np.clip(look(colours), 0, 1)).max(axis=-1) * 255

# %% The picture
figure, (top, bottom) = pyplot.subplots(2, 1, figsize=(9, 7), constrained_layout=True)
top.imshow(np.clip(look(colours), 0, 1), extent=(0, 360, 0, 1), aspect="auto")
top.set_title(f"{path}: what it makes of every hue, black to white")
shown = bottom.imshow(error, extent=(0, 360, 0, 1), aspect="auto", cmap="magma")
bottom.set_title(f"error of the {engine} strip, largest channel, in codes of 8 bits")
bottom.set_xlabel("hue in degrees")
figure.colorbar(shown, ax=bottom)
figure.savefig(output)
figures = lutlib.compare(look, baked)["delta_e_2000"]
print(f"{output}: dE2000 p99 {figures['p99']:.3g}, max {figures['max']:.3g}")
