"""A CMSIS-Pack's description, by the rules of its schema and of packChk that concern one library:
elements, their order-free content, attributes, forms of numbers and names, and that each file that
is named lies in the pack.

    pack.py PACK.pdsc
"""

import os
import re
import sys
import xml.etree.ElementTree

VERSION = r"\d+\.\d+\.\d+(-[0-9A-Za-z.-]+)?"
NAME = r"[-_A-Za-z0-9]+"
ANY = r"(?s).*\S.*"

# Of each element: the pattern of its text, patterns of its attributes (all are required), and how
# often a child stands in it.
ELEMENTS = {
    "package": ("", {"schemaVersion": r"1\.\d+(\.\d+)?", "noNamespaceSchemaLocation": r"PACK\.xsd"},
                {"vendor": "1", "name": "1", "description": "1", "url": "1", "license": "1",
                 "releases": "1", "keywords": "?", "components": "1", "examples": "?"}),
    "vendor": (NAME, {}, {}),
    "name": (NAME, {}, {}),
    "description": (ANY, {}, {}),
    "url": (r"https://\S+", {}, {}),
    "license": (ANY, {}, {}),
    "releases": ("", {}, {"release": "+"}),
    "release": (ANY, {"version": VERSION}, {}),
    "keywords": ("", {}, {"keyword": "+"}),
    "keyword": (ANY, {}, {}),
    "components": ("", {}, {"component": "+"}),
    "component": ("", {"Cclass": ANY, "Cgroup": ANY, "Cversion": VERSION},
                  {"description": "1", "files": "1"}),
    "files": ("", {}, {"file": "+"}),
    "file": ("", {"category": "include|header|source", "name": ANY}, {}),
    "examples": ("", {}, {"example": "+"}),
    "example": ("", {"name": ANY, "folder": ANY, "doc": ANY}, {"description": "1", "project": "1"}),
    "project": ("", {}, {"environment": "+"}),
    "environment": ("", {"name": ANY, "load": ANY}, {}),
}
TIMES = {"1": (1, 1), "?": (0, 1), "+": (1, sys.maxsize)}


def check_element(element):
    text, attributes, children = ELEMENTS.get(element.tag) or sys.exit(f"no element {element.tag}")
    if not re.fullmatch(text, (element.text or "").strip()):
        sys.exit(f"{element.tag}: {element.text!r}")
    given = {name.rpartition("}")[2]: value for name, value in element.attrib.items()}
    if set(given) != set(attributes):
        sys.exit(f"{element.tag}: attributes {sorted(given)}")
    for name, value in given.items():
        if not re.fullmatch(attributes[name], value):
            sys.exit(f"{element.tag}: {name}={value!r}")
    tags = [child.tag for child in element]
    for tag, times in children.items():
        least, most = TIMES[times]
        if not least <= tags.count(tag) <= most:
            sys.exit(f"{element.tag}: {tags.count(tag)} of {tag}")
    if not set(tags) <= set(children):
        sys.exit(f"{element.tag}: {sorted(set(tags) - set(children))} in it")
    for child in element:
        check_element(child)


def check_files(root, folder):
    names = [root.findtext("license")]
    names += [file.get("name") for file in root.iter("file")]
    for example in root.iter("example"):
        names += [os.path.join(example.get("folder"), name) for name in
                  [example.get("doc"), *[tool.get("load") for tool in example.iter("environment")]]]
    for name in names:
        if not os.path.exists(os.path.join(folder, name)) or name.endswith("/") != os.path.isdir(
                os.path.join(folder, name)):
            sys.exit(f"no {name} in the pack")


def read(path):
    root = xml.etree.ElementTree.parse(path).getroot()
    check_element(root)
    if os.path.basename(path) != f"{root.findtext('vendor')}.{root.findtext('name')}.pdsc":
        sys.exit(f"the file's name is not that of the pack: {path}")
    check_files(root, os.path.dirname(path))
    return root


if __name__ == "__main__":
    read(sys.argv[1])
