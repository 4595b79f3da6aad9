"""What Zephyr makes of a module before CMake runs.

    module.py MODULE PRJ_CONF FOLDER

Checks MODULE/zephyr/module.yml, evaluates its Kconfig with the application's settings, and writes
FOLDER/module.cmake: the folder that CMake enters, and each CONFIG_ that is set.
"""

import os
import sys

import jsonschema
import kconfiglib
import yaml

PATHS = {"type": "array", "items": {"type": "string"}}

# The fields of scripts/schemas/module-schema of Zephyr that a library may have.
SCHEMA = {
    "type": "object",
    "additionalProperties": False,
    "required": ["name", "build"],
    "properties": {
        "name": {"type": "string", "pattern": "^[a-zA-Z0-9_-]+$"},
        "build": {
            "type": "object",
            "additionalProperties": False,
            "required": ["cmake", "kconfig"],
            "properties": {"cmake": {"type": "string"}, "kconfig": {"type": "string"},
                           "depends": PATHS},
        },
        "tests": PATHS, "samples": PATHS, "boards": PATHS,
    },
}

# What an application may set besides: some of Zephyr's own.
ROOT = """
mainmenu "Zephyr"
config MAIN_STACK_SIZE
	int "Size of stack for initialization and main thread"
	default 1024
source "{module}"
"""


def configuration(kconfig, settings, folder):
    root = os.path.join(folder, "Kconfig")
    with open(root, "w", encoding="utf-8") as file:
        file.write(ROOT.format(module=os.path.abspath(kconfig)))
    tree = kconfiglib.Kconfig(root, warn_to_stderr=False)
    tree.load_config(settings)
    if tree.warnings:
        sys.exit("\n".join(tree.warnings))
    return {name: symbol.str_value for name, symbol in tree.syms.items() if symbol.config_string}


def main():
    module, settings, folder = sys.argv[1:]
    with open(os.path.join(module, "zephyr", "module.yml"), encoding="utf-8") as file:
        description = yaml.safe_load(file)
    jsonschema.validate(description, SCHEMA)
    for path in description.get("samples", []) + description.get("tests", []):
        if not os.path.isdir(os.path.join(module, path)):
            sys.exit(f"module.yml: no folder {path}")
    build = description["build"]
    values = configuration(os.path.join(module, build["kconfig"]), settings, folder)
    with open(os.path.join(folder, "module.cmake"), "w", encoding="utf-8") as file:
        file.write(f'set(module "{os.path.abspath(os.path.join(module, build["cmake"]))}")\n')
        for name, value in values.items():
            if value != "n":
                file.write(f'set(CONFIG_{name} "{value}")\n')


main()
