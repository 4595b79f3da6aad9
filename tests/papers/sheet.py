#!/usr/bin/python3
"""sheet.py FOLDER SHEET TITLE COLUMNS PICTURE LABEL [PICTURE LABEL]...

Writes FOLDER/SHEET.png: pictures of FOLDER/pictures with a label of some lines below each. What
lies as FOLDER/data/PICTURE.ppm is written there first. No picture is scaled.
"""
import pathlib
import sys

from PIL import Image, ImageDraw, ImageFont

FONT = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf"
PAPER, INK = "#f6f5f2", "#222222"
GAP, TITLE, LABEL = 16, 22, 14


def picture_of(name):
    picture, data = folder / "pictures" / (name + ".png"), folder / "data" / (name + ".ppm")
    if data.exists():
        Image.open(data).save(picture)
    return Image.open(picture)


folder, sheet_name, title, columns, *rest = sys.argv[1:]
folder, columns = pathlib.Path(folder), int(columns)
pictures = [picture_of(name) for name in rest[0::2]]
labels = rest[1::2]

width = max(picture.width for picture in pictures) + GAP
lines = 1 + max(label.count("\n") for label in labels)
height = max(picture.height for picture in pictures) + lines * (LABEL + 4) + 2 * GAP - 4
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
sheet.save(folder / (sheet_name + ".png"))
