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

"""
Hold every IDL file of sTetro's own messages equal to its ROS 2 twin in msg/.

usage: twins.py PACKAGE_DIR

Both are read by rosidl: the .msg is converted to IDL as a ROS 2 machine would do it, and both IDL
texts go through rosidl's parser. Names, order, types, bounds and constants have to be the same.
"""

import pathlib
import re
import sys
import tempfile

from rosidl_adapter.msg import convert_msg_to_idl
from rosidl_parser import definition
from rosidl_parser.parser import parse_idl_string


def type_text(type_):
    """Return a type as one line of text that tells all about it."""
    if isinstance(type_, definition.AbstractNestedType):
        bound = getattr(type_, 'size', getattr(type_, 'maximum_size', None))
        return f'{type(type_).__name__}<{type_text(type_.value_type)}, {bound}>'
    if isinstance(type_, definition.NamespacedType):
        return '::'.join(type_.namespaced_name())
    if isinstance(type_, definition.BasicType):
        return type_.typename
    return f'{type(type_).__name__}<{getattr(type_, "maximum_size", None)}>'


def description(idl_text):
    """Return name, constants and members of the one message in an IDL text, as lines."""
    without_directives = re.sub(r'^#.*$', '', idl_text, flags=re.M)
    content = parse_idl_string(without_directives)
    (message,) = content.get_elements_of_type(definition.Message)
    lines = ['message ' + type_text(message.structure.namespaced_type)]
    lines += [
        f'constant {type_text(c.type)} {c.name} = {c.value!r}' for c in message.constants]
    lines += [f'member {type_text(m.type)} {m.name}' for m in message.structure.members]
    return lines


def idl_of_msg(package_dir, path, out_dir):
    """Return the IDL text that rosidl makes of a .msg file."""
    written = convert_msg_to_idl(
        package_dir, 'stetro_msgs', path.relative_to(package_dir), out_dir)
    return written.read_text()


def differences(package_dir):
    """Return what differs between the twins, as lines; and how many twins there are."""
    idls = {path.stem: path for path in package_dir.glob('idl/stetro_msgs/*.idl')}
    msgs = {path.stem: path for path in package_dir.glob('msg/*.msg')}
    found = [f'{name}: idl or msg is missing' for name in idls.keys() ^ msgs.keys()]
    with tempfile.TemporaryDirectory() as scratch:
        for name in sorted(idls.keys() & msgs.keys()):
            own = description(idls[name].read_text())
            twin = description(idl_of_msg(package_dir, msgs[name], pathlib.Path(scratch)))
            found += [f'{name}: only in the IDL: {line}' for line in own if line not in twin]
            found += [f'{name}: only in the msg: {line}' for line in twin if line not in own]
            if sorted(own) == sorted(twin) and own != twin:
                found.append(f'{name}: the same in another order')
    return found, len(idls)


def main():
    """Print the differences; exit with 1 if there are any, or nothing was compared."""
    found, count = differences(pathlib.Path(sys.argv[1]).absolute())
    print('\n'.join(found) or f'{count} messages are the same as IDL and as msg')
    sys.exit(1 if found or count == 0 else 0)


if __name__ == '__main__':
    main()
