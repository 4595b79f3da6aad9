"""Checks an idf_component.yml by the rules of ESP-IDF's component manager.

    manifest.py FILE
"""

import os
import sys

import jsonschema
import yaml

SCHEMA = {
    "type": "object",
    "additionalProperties": False,
    "required": ["version", "description", "license", "url"],  # what its registry asks for
    "properties": {
        "version": {"type": "string", "pattern": r"^\d+\.\d+\.\d+(~\d+)?(-[a-z0-9.]+)?$"},
        "description": {"type": "string"},
        "license": {"type": "string"},
        "url": {"type": "string", "pattern": "^https://"},
        "targets": {"type": "array", "items": {"type": "string"}},
        "dependencies": {"type": "object"},
        "examples": {
            "type": "array",
            "items": {"type": "object", "required": ["path"],
                      "properties": {"path": {"type": "string"}}},
        },
    },
}


def main():
    path = sys.argv[1]
    with open(path, encoding="utf-8") as file:
        manifest = yaml.safe_load(file)
    jsonschema.validate(manifest, SCHEMA)
    for example in manifest.get("examples", []):
        if not os.path.isfile(os.path.join(os.path.dirname(path), example["path"], "CMakeLists.txt")):
            sys.exit(f"idf_component.yml: no example {example['path']}")


main()
