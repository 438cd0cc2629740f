# Copyright 2026 The sTetro Authors
#
# Licensed under the Apache License, Version 2.0 (the "License");
# you may not use this file except in compliance with the License.
# You may obtain a copy of the License at
#
#     http://www.apache.org/licenses/LICENSE-2.0
#
# Unless required by applicable law or agreed to in writing, software
# distributed under the License is distributed on an "AS IS" BASIS,
# WITHOUT WARRANTIES OR CONDITIONS OF ANY KIND, either express or implied.
# See the License for the specific language governing permissions and
# limitations under the License.
"""Writes IDL as ROS 2 mangles it, for another vendor's IDL compiler.

A ROS 2 type pkg/msg/Name is pkg::msg::dds_::Name_ on the wire. fastddsgen adds the extra module and
the underscore by itself (-typeros2); any other compiler must find them in the IDL.

    mangle_idl.py OUTPUT_FOLDER IDL...
"""
import pathlib
import re
import sys

CONSTANTS = re.compile(r'module \w+_Constants\s*\{.*?\n\};\n', re.DOTALL)
DEFAULT = re.compile(r'@default\s*\([^)]*\)\s*')
REFERENCE = re.compile(r'\b((?:\w+::)+)(\w+)\b')
STRUCT = re.compile(r'\bstruct (\w+)\s*(\{.*?\n\};)', re.DOTALL)


def mangle(idl):
    """Return the text with structs in a module dds_ and an underscore behind each of their names."""
    idl = DEFAULT.sub('', CONSTANTS.sub('', idl))
    idl = REFERENCE.sub(r'\1dds_::\2_', idl)
    return STRUCT.sub(r'module dds_\n{\n@final @topic struct \1_\n\2\n};', idl)


def main():
    """Mangle each file of the command line into the folder."""
    folder = pathlib.Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    for name in sys.argv[2:]:
        source = pathlib.Path(name)
        (folder / source.name).write_text(mangle(source.read_text()))


if __name__ == '__main__':
    main()
