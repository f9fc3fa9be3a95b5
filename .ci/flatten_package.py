# SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Write what a Python package offers as one module without bodies, for Doxygen.

    flatten_package.py FOLDER OUTPUT

Functions that __init__.py defines, or takes from the package's own modules, are the package's: the
modules themselves are no part of its interface. Names that begin with _ are not either.
"""

import ast
import pathlib
import sys


def functions_of(path):
    module = ast.parse(path.read_text(encoding="utf-8"))
    own = {node.name: node for node in module.body if isinstance(node, ast.FunctionDef)}
    for node in module.body:
        if isinstance(node, ast.ImportFrom) and node.level == 1 and node.module:
            source = path.with_name(node.module + ".py")
            if source.exists():
                theirs = functions_of(source)
                own.update((alias.asname or alias.name, theirs[alias.name])
                           for alias in node.names if alias.name in theirs)
    return own


def join_arguments(arguments):
    """Arguments that need their keywords as ordinary ones: Doxygen prints `*, radius=0` as `*radius=0`."""
    if None not in arguments.kw_defaults:
        arguments.args += arguments.kwonlyargs
        arguments.defaults += arguments.kw_defaults
        arguments.kwonlyargs, arguments.kw_defaults = [], []


def flatten(folder):
    path = folder / "__init__.py"
    body = []
    for name, function in functions_of(path).items():
        text = ast.get_docstring(function)
        if not name.startswith("_"):
            function.name = name
            join_arguments(function.args)
            function.body = [ast.Expr(ast.Constant(text))] if text else [ast.Pass()]
            function.decorator_list = []
            body.append(function)
    text = ast.get_docstring(ast.parse(path.read_text(encoding="utf-8"))) or ""
    return ast.unparse(ast.Module([ast.Expr(ast.Constant(text)), *body], []))


output = pathlib.Path(sys.argv[2])
output.parent.mkdir(parents=True, exist_ok=True)
output.write_text(flatten(pathlib.Path(sys.argv[1])) + "\n", encoding="utf-8")
