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
Write one C++ header per IDL file: the type, its DDS support and the list of its members.

usage: headers_from_idl.py OUT_DIR IDL...

The subset of IDL is the one these messages use: modules, constants, one struct per file.
"""

import pathlib
import re
import sys

HEADER = """\
// Generated from {stem}.idl by headers_from_idl.py. Do not edit.

#ifndef STETRO_MSGS__{guard}_HPP_
#define STETRO_MSGS__{guard}_HPP_

#include <cstddef>
#include <type_traits>

{includes}

namespace {namespace}
{{

/// Calls each(name, value, bound) for every member in the order of the wire; bound 0: none.
template <class Message, class Each>
std::enable_if_t<std::is_same_v<std::remove_const_t<Message>, {name}>> for_each_member(
  Message & message, Each && each)
{{
{calls}
}}

}}  // namespace {namespace}

namespace stetro_msgs
{{

{renamed}template <>
struct Support<{namespace}::{name}>
{{
  using type = {support};
}};

}}  // namespace stetro_msgs

#endif  // STETRO_MSGS__{guard}_HPP_
"""

# The ids of rmw_dds_common have two lengths, kept apart by an innermost module that has to vanish
# from the name on the wire.
RENAMED = """\
class {stem}Support : public {generated}
{{
public:
  {stem}Support() {{ setName("{outer}::dds_::{name}_"); }}
}};

"""

MEMBER = re.compile(
    r'^(?:@default\(.*?\)\s*)?(?P<type>[\w:]+(?:<[^>]*>)?)\s+(?P<name>\w+)(?:\[\d+\])?$', re.S)


def parse(text):
    """Return the modules around the struct, its name and its members as (name, bound)."""
    text = re.sub(r'//.*|^#.*$', '', text, flags=re.M)
    text = re.sub(r'module\s+\w+_Constants\s*\{.*?\};', '', text, flags=re.S)
    modules = re.findall(r'module\s+(\w+)', text)
    struct = re.search(r'struct\s+(\w+)\s*\{(.*?)\};', text, re.S)
    members = []
    for declaration in struct[2].split(';')[:-1]:
        member = MEMBER.match(declaration.strip())
        if not member:
            raise ValueError(f'not understood: {declaration.strip()!r}')
        bound = re.search(r'(?:string<|,)\s*(\d+)\s*>$', member['type'])
        members.append((member['name'], bound[1] if bound else '0'))
    return modules, struct[1], members


def header_text(stem, text):
    """Return the C++ header that belongs to the IDL file of this stem and text."""
    modules, name, members = parse(text)
    namespace = '::'.join(modules)
    support = generated = f'{namespace}::{name}PubSubType'
    renamed = ''
    if len(modules) > 2:
        renamed = RENAMED.format(
            stem=stem, generated=generated, outer='::'.join(modules[:2]), name=name)
        support = f'{stem}Support'
    included = re.findall(r'^#include "(\w+)\.idl"', text, re.M)
    includes = [f'#include "stetro_msgs/{other}.hpp"' for other in included]
    includes += [f'#include "stetro_msgs/{stem}PubSubTypes.h"', '#include "stetro_msgs/support.hpp"']
    return HEADER.format(
        stem=stem, guard=stem.upper(), includes='\n'.join(includes), namespace=namespace,
        name=name, renamed=renamed, support=support,
        calls='\n'.join(f'  each("{n}", message.{n}(), std::size_t{{{b}}});' for n, b in members))


def main():
    """Write the headers named on the command line."""
    out = pathlib.Path(sys.argv[1])
    out.mkdir(parents=True, exist_ok=True)
    for idl in map(pathlib.Path, sys.argv[2:]):
        (out / f'{idl.stem}.hpp').write_text(header_text(idl.stem, idl.read_text()))


if __name__ == '__main__':
    main()
