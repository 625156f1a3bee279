"""Stubs and docstrings name all that the module has."""
import ast
import builtins
import inspect
import pathlib

import ecods
import ecods.compat.fcl as fcl


def test_stubs_name_what_there_is():
    tree = ast.parse(pathlib.Path(ecods.__file__).with_name("__init__.pyi").read_text())
    classes = {node.name: node for node in tree.body if isinstance(node, ast.ClassDef)}
    functions = {node.name for node in tree.body if isinstance(node, ast.FunctionDef)}
    imported = {alias.name for node in tree.body if isinstance(node, ast.ImportFrom) for alias in node.names}
    assert {name for name in ecods.__all__ if name != "__version__"} <= set(classes) | functions | imported
    for name, node in classes.items():
        kind = getattr(ecods, name)
        stubbed = {item.name for item in node.body if isinstance(item, ast.FunctionDef)}
        if not issubclass(kind, (Exception, int)):
            assert {member for member in vars(kind) if not member.startswith("_")} <= stubbed, name
    text = ast.unparse(classes["World"])
    assert "def set_pose(self, body: int, pose: ArrayLike) -> None" in text
    assert "def relation(self, a: int | Posed | Mesh | PosedRounded | Rounded | PosedHalfSpace | HalfSpace, b: int | Posed | Mesh | PosedRounded | Rounded | PosedHalfSpace | HalfSpace) -> Relation" in text


def test_stubs_of_the_inner_module_name_all_that_it_has():
    tree = ast.parse(pathlib.Path(ecods.__file__).with_name("_ecods.pyi").read_text())
    named = {alias.asname for node in tree.body if isinstance(node, ast.ImportFrom) for alias in node.names}
    assert named == {name for name in vars(ecods._ecods) if not name.startswith("_")} | {"__version__"}


def test_types_in_stubs_are_defined():
    tree = ast.parse(pathlib.Path(ecods.__file__).with_name("__init__.pyi").read_text())
    known = set(dir(builtins)) | {node.name for node in tree.body if isinstance(node, ast.ClassDef)}
    for node in tree.body:
        if isinstance(node, (ast.Import, ast.ImportFrom)):
            known |= {alias.asname or alias.name for alias in node.names}
    for node in ast.walk(tree):
        if isinstance(node, ast.FunctionDef):
            annotations = [node.returns, *[each.annotation for each in node.args.args + node.args.kwonlyargs]]
            used = {each.id for part in filter(None, annotations) for each in ast.walk(part) if isinstance(each, ast.Name)}
            assert used <= known, (node.name, used - known)


def test_everything_is_documented():
    for name in ecods.__all__:
        thing = getattr(ecods, name)
        assert name == "__version__" or inspect.getdoc(thing), name
    for member, call in vars(ecods.World).items():
        if not member.startswith("_"):
            assert len(call.__doc__.splitlines()) > 1, member
    for name in fcl.__all__:
        thing = getattr(fcl, name)
        members = vars(thing).items() if inspect.isclass(thing) else ()
        documented = [thing, *(call for member, call in members if not member.startswith("_") and callable(call))]
        assert name == "__version__" or all(inspect.getdoc(each) for each in documented), name
