#!/usr/bin/python3
"""sheet.py FOLDER/SHEET.png TITLE COLUMNS PICTURE LABEL [PICTURE LABEL]...

A contact sheet with a label below each picture. Each PICTURE.ppm is written by itself as
FOLDER/pictures/PICTURE.png too. No picture is scaled.
"""
import pathlib
import sys

from PIL import Image, ImageDraw, ImageFont

FONT = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf"
PAPER, INK = "#f6f5f2", "#222222"
GAP, TITLE, LABEL = 16, 22, 14

sheet_name, title, columns, *rest = sys.argv[1:]
sheet_path, columns = pathlib.Path(sheet_name), int(columns)
pictures = [Image.open(name) for name in rest[0::2]]
labels = rest[1::2]
for name, picture in zip(map(pathlib.Path, rest[0::2]), pictures):
    if name.suffix == ".ppm":
        picture.save(sheet_path.parent / "pictures" / (name.stem + ".png"))

width = max(picture.width for picture in pictures) + GAP
height = max(picture.height for picture in pictures) + LABEL + 2 * GAP
rows = -(-len(pictures) // columns)
top = TITLE + 2 * GAP
sheet = Image.new("RGB", (columns * width + GAP, top + rows * height), PAPER)
draw = ImageDraw.Draw(sheet)
draw.text((GAP, GAP), title, INK, ImageFont.truetype(FONT, TITLE))
for number, (picture, label) in enumerate(zip(pictures, labels)):
    x = GAP + number % columns * width
    y = top + number // columns * height
    sheet.paste(picture, (x, y))
    draw.text((x, y + picture.height + GAP // 3), label, INK, ImageFont.truetype(FONT, LABEL))
sheet.save(sheet_path)
