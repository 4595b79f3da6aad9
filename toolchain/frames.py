#!/usr/bin/python3
"""frames.py SHEET ANIMATION FRAME...: a contact sheet (PNG) and an animated PNG."""
import sys

from PIL import Image

COLUMNS = 6
MILLISECONDS = 80

sheet_name, animation_name, *names = sys.argv[1:]
frames = [Image.open(name).convert("RGB") for name in names]
width, height = frames[0].size
rows = -(-len(frames) // COLUMNS)
sheet = Image.new("RGB", (width * COLUMNS, height * rows))
for number, frame in enumerate(frames):
    sheet.paste(frame, (number % COLUMNS * width, number // COLUMNS * height))
sheet.save(sheet_name)
frames[0].save(animation_name, format="PNG", save_all=True, append_images=frames[1:],
               duration=MILLISECONDS, loop=0)
