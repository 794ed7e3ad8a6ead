"""The Python module, held against twins in numpy that know the definitions alone."""

import ast
import pathlib
import tempfile
import threading
import unittest

import lutlib
import numpy as np

ROOT = pathlib.Path(__file__).resolve().parents[2]
LOOKS = ROOT / "luts"


def trilinear(cube, colours):
    """cube[b, g, r] over 0..1, read trilinearly in float64."""
    n = cube.shape[0]
    place = np.clip(np.asarray(colours, np.float64), 0, 1) * (n - 1)
    low = np.minimum(place.astype(int), n - 2)
    t = place - low
    out = np.zeros(place.shape)
    for corner in np.ndindex(2, 2, 2):
        weight = np.prod(np.where(np.array(corner) == 1, t, 1 - t), axis=-1)
        r, g, b = (low[..., c] + corner[c] for c in range(3))
        out += weight[..., None] * cube[b, g, r]
    return out


def tetrahedral(cube, colours):
    """The same along the edges of the cell's tetrahedra, largest fraction first."""
    n = cube.shape[0]
    place = np.clip(np.asarray(colours, np.float64), 0, 1) * (n - 1)
    low = np.minimum(place.astype(int), n - 2)
    t = place - low
    at = low.copy()
    out = cube[at[..., 2], at[..., 1], at[..., 0]].astype(np.float64)
    for step in np.moveaxis(np.argsort(-t, axis=-1, kind="stable"), -1, 0):
        before = cube[at[..., 2], at[..., 1], at[..., 0]].astype(np.float64)
        np.put_along_axis(at, step[..., None], np.take_along_axis(at, step[..., None], -1) + 1, -1)
        after = cube[at[..., 2], at[..., 1], at[..., 0]]
        out += np.take_along_axis(t, step[..., None], -1) * (after - before)
    return out


def noise(shape, seed=1):
    return np.random.default_rng(seed).random(shape, np.float32)


def rough_cube(n=9):
    grid = np.stack(np.meshgrid(*3 * [np.linspace(0, 1, n)], indexing="ij")[::-1], -1)
    return (0.8 * grid + 0.2 * noise((n, n, n, 3), 7)).astype(np.float32)


class Apply(unittest.TestCase):
    look = lutlib.Look.from_arrays(cube=rough_cube())

    def expect(self, got, wanted, tolerance):
        self.assertLessEqual(np.abs(got.astype(np.float64) - wanted).max(), tolerance)

    def test_is_the_tetrahedral_and_the_trilinear_twin_on_float32(self):
        picture = noise((37, 53, 3)) * 1.4 - 0.2
        self.expect(lutlib.apply(self.look, picture), tetrahedral(rough_cube(), picture), 3e-7)
        self.expect(
            lutlib.apply(self.look, picture, interpolation="trilinear"),
            trilinear(rough_cube(), picture),
            3e-7,
        )

    def test_rounds_codes_and_halves_to_nearest(self):
        for dtype, top in ((np.uint8, 255), (np.uint16, 65535)):
            codes = (noise((40, 50, 3)) * top).astype(dtype)
            wanted = tetrahedral(rough_cube(), codes / top) * top
            got = lutlib.apply(self.look, codes)
            self.assertEqual(got.dtype, dtype)
            self.expect(got, wanted, 0.51)
        half = noise((40, 50, 3)).astype(np.float16)
        self.expect(lutlib.apply(self.look, half), tetrahedral(rough_cube(), half), 6e-4)
        ten = (noise((9, 9, 3)) * 1023).astype(np.uint16)
        self.expect(
            lutlib.apply(self.look, ten, bits=10), tetrahedral(rough_cube(), ten / 1023) * 1023, 0.51
        )

    def test_takes_any_strides_without_a_copy(self):
        wide = noise((24, 40, 6))
        for view in (
            wide[:, :, :3],
            wide[::-1, ::2, 5:2:-1],
            np.moveaxis(noise((3, 24, 40)), 0, -1),
            wide[..., :3].transpose(1, 0, 2),
            wide[0, :, :3],
            wide[0, 0, :3],
            noise((2, 3, 8, 8, 4))[..., :3],
        ):
            with self.subTest(strides=view.strides):
                wanted = tetrahedral(rough_cube(), view)
                self.expect(lutlib.apply(self.look, view), wanted, 3e-7)
                self.assertIs(lutlib.apply(self.look, view, out=view), view)
                self.expect(view, wanted, 3e-7)

    def test_in_place_leaves_every_other_byte_alone(self):
        wide = noise((6, 7, 5))
        before = wide.copy()
        lutlib.apply(self.look, wide[1:4, ::2, 1:4], out=wide[1:4, ::2, 1:4])
        changed = wide != before
        changed[1:4, ::2, 1:4] = False
        self.assertFalse(changed.any())

    def test_hands_alpha_on_and_converts_between_types(self):
        picture = noise((8, 9, 4))
        out = np.zeros((8, 9, 4), np.uint16)
        lutlib.apply(self.look, picture, out=out)
        self.expect(out[..., :3], tetrahedral(rough_cube(), picture[..., :3]) * 65535, 0.6)
        self.expect(out[..., 3], picture[..., 3] * 65535, 0.51)
        self.assertTrue((lutlib.apply(self.look, picture)[..., 3] == picture[..., 3]).all())

    def test_refuses_what_it_would_get_wrong(self):
        picture = noise((8, 8, 3))
        for wrong, error in (
            (lambda: lutlib.apply(self.look, picture.astype(np.float64)), TypeError),
            (lambda: lutlib.apply(self.look, picture.astype(">f4")), TypeError),
            (lambda: lutlib.apply(self.look, noise((3, 8, 8))), ValueError),
            (lambda: lutlib.apply(self.look, picture, out=noise((8, 9, 3))), ValueError),
            (lambda: lutlib.apply(self.look, picture[1:], out=picture[:-1]), ValueError),
            (lambda: lutlib.apply(self.look, picture, out=np.broadcast_to(picture[0], (8, 8, 3))), ValueError),
            (lambda: lutlib.apply(self.look, picture, bits=10), TypeError),
            (lambda: lutlib.apply(self.look, picture, threads=-1), ValueError),
            (lambda: lutlib.apply(self.look, picture, interpolation="cubic"), lutlib.UsageError),
        ):
            with self.assertRaises(error):
                wrong()
        self.assertEqual(lutlib.apply(self.look, noise((0, 8, 3))).shape, (0, 8, 3))

    def test_lets_other_threads_run(self):
        picture = noise((1500, 1500, 3))
        worker = threading.Thread(target=lutlib.apply, args=(self.look, picture), kwargs={"threads": 1})
        worker.start()
        turns = 0
        while worker.is_alive():
            turns += 1
        self.assertGreater(turns, 100)


class Looks(unittest.TestCase):
    def test_show_their_tables_without_a_copy(self):
        look = lutlib.Look.from_arrays(cube=rough_cube(), title="rough", input="logc3")
        self.assertTrue((look.cube == rough_cube()).all())
        self.assertFalse(look.cube.flags.writeable)
        self.assertEqual(look.cube.ctypes.data, look.cube.ctypes.data)
        self.assertEqual((look.title, look.input, look.shaper), ("rough", "logc3", None))
        cube = look.cube
        del look
        self.assertTrue((cube == rough_cube()).all())

    def test_of_curves_and_of_a_shaper_before_a_cube(self):
        gamma = np.linspace(0, 1, 1024)[:, None] ** np.array([0.5, 1, 2])
        curve = lutlib.Look.from_arrays(shaper=gamma)
        colours = noise((100, 3))
        twin = np.stack(
            [np.interp(colours[:, c], np.linspace(0, 1, 1024), gamma[:, c]) for c in range(3)], -1
        )
        self.assertLess(np.abs(curve(colours) - twin).max(), 1e-6)
        both = lutlib.Look.from_arrays(shaper=gamma, cube=rough_cube())
        self.assertLess(np.abs(both(colours) - tetrahedral(rough_cube(), twin)).max(), 3e-6)

    def test_survive_files(self):
        look = lutlib.Look.from_arrays(cube=rough_cube())
        with tempfile.TemporaryDirectory() as folder:
            for name, tolerance in (("a.cube", 0), ("a.spi3d", 1e-6), ("a.3dl", 1 / 4000)):
                path = f"{folder}/{name}"
                lutlib.write(look, path)
                self.assertLessEqual(np.abs(lutlib.read(path).cube - rough_cube()).max(), tolerance)
            self.assertTrue(lutlib.write(look, f"{folder}/b.3dl"), "12 bits lose something")

    def test_errors_have_file_and_line(self):
        with tempfile.TemporaryDirectory() as folder:
            path = f"{folder}/bad.cube"
            pathlib.Path(path).write_text("LUT_3D_SIZE 2\n0 0 0\n0 0 zero\n" + 6 * "1 1 1\n")
            with self.assertRaises(lutlib.Error) as caught:
                lutlib.read(path)
        self.assertEqual((caught.exception.file, caught.exception.line), (path, 3))
        self.assertIn(caught.exception.message, str(caught.exception))
        self.assertNotIsInstance(caught.exception, lutlib.UsageError)
        self.assertIsInstance(caught.exception, ValueError)


class Work(unittest.TestCase):
    path = str(LOOKS / "warm_teal.cube")

    def test_bakes_the_codes_that_the_definition_gives_and_proves_them(self):
        look = lutlib.read(self.path)
        with tempfile.TemporaryDirectory() as folder:
            strip = f"{folder}/strip.png"
            baked = lutlib.bake(look, "Unity", strip, size=16, measure=True)
            # Unity's strip: blue from slice to slice, green up from the bottom row.
            n = 16
            axis = np.linspace(0, 1, n)
            y, x = np.mgrid[:n, : n * n]
            nodes = np.stack([axis[x % n], axis[n - 1 - y], axis[x // n]], -1)
            codes = np.clip(tetrahedral(look.cube, nodes), 0, 1) * 255
            self.assertEqual(baked["picture"].shape, (n, n * n, 3))
            self.assertLess(np.abs(baked["picture"] - codes).max(), 0.501)
            self.assertGreater(baked["error"]["delta_e_2000"]["max"], 0)
            proof = lutlib.verify(strip, self.path, "unity")
            self.assertTrue(proof["passed"], proof["verdict"])
            self.assertIn("OpenColorIO", proof["oracle"])
            other = lutlib.verify(strip, str(LOOKS / "soft_print.cube"), "unity")
            self.assertFalse(other["passed"])
            with self.assertRaises(lutlib.UsageError):
                lutlib.bake(look, "unrael")

    def test_compares_as_numpy_does(self):
        a = lutlib.Look.from_arrays(cube=rough_cube())
        b = lutlib.Look.from_arrays(cube=rough_cube() + np.float32(0.01))
        figures = lutlib.compare(a, b)
        self.assertAlmostEqual(figures["absolute"]["max"], 0.01, 6)
        self.assertAlmostEqual(figures["psnr"], 40, 2)

    def test_makes_recipes_of_operators(self):
        recipe = lutlib.Recipe("calm").add("exposure", stops=1)
        recipe.add("hue-vs-sat", curve=[(0, 1), (120, 0.5)], enabled=False, opacity=0.25)
        self.assertEqual([row["op"] for row in recipe.operators], ["exposure", "hue-vs-sat"])
        self.assertEqual(recipe.operators[1]["curve"], [(0, 1), (120, 0.5)])
        self.assertEqual(recipe.operators[1]["opacity"], 0.25)
        again = lutlib.Recipe.from_json(recipe.to_json())
        self.assertEqual(again.operators, recipe.operators)
        # A stop is twice the light: sRGB by its standard's formula.
        code = np.array([0.1, 0.3, 0.5])
        light = 2 * np.where(code <= 0.04045, code / 12.92, ((code + 0.055) / 1.055) ** 2.4)
        wanted = np.where(light <= 0.0031308, 12.92 * light, 1.055 * light ** (1 / 2.4) - 0.055)
        self.assertLess(np.abs(recipe.look()(code) - wanted).max(), 1e-6)
        for wrong in ({"stop": 1}, {"stops": 1000}):
            with self.assertRaises(lutlib.Error):
                recipe.add("exposure", **wrong)
        with self.assertRaises(TypeError):
            recipe.add("exposure", stops="much")
        with tempfile.TemporaryDirectory() as folder:
            recipe.save(f"{folder}/calm.json")
            self.assertEqual(
                lutlib.recipe_of(lutlib.read(f"{folder}/calm.json")).operators, recipe.operators
            )

    def test_puts_recipes_on_top_of_a_look(self):
        look = lutlib.read(self.path)
        recipe = lutlib.Recipe(base=look).add("offset", amount=0.1)
        colours = noise((50, 3))
        self.assertLess(np.abs(recipe.look()(colours) - (look(colours) + 0.1)).max(), 1e-6)

    def test_reports_and_checks(self):
        look = lutlib.Look.from_arrays(cube=rough_cube())
        report = lutlib.report(look, sizes=[9])
        self.assertGreater(len(report["rows"]), 3)
        self.assertIn("words", report["recommendation"])
        names = [point["check"] for point in lutlib.check(look)]
        self.assertEqual(len(names), len(set(names)))

    def test_lists_what_there_is(self):
        self.assertIn("unreal", [row["name"] for row in lutlib.engines()])
        self.assertIn("cube", [row["name"] for row in lutlib.formats()])
        self.assertIn("slog3", [row["name"] for row in lutlib.encodings()["curves"]])
        exposure = next(row for row in lutlib.operators() if row["name"] == "exposure")
        self.assertEqual(exposure["parameters"][0]["name"], "stops")


class Stub(unittest.TestCase):
    def test_names_what_the_module_has(self):
        stub = ast.parse((ROOT / "python" / "lutlib.pyi").read_text())

        def names(nodes):
            return {n.name for n in nodes if isinstance(n, (ast.ClassDef, ast.FunctionDef))}

        module = {name for name in dir(lutlib) if not name.startswith("_")}
        self.assertEqual(names(stub.body), module)
        for node in stub.body:
            if isinstance(node, ast.ClassDef) and node.name in ("Look", "Recipe"):
                members = {n for n in dir(getattr(lutlib, node.name)) if not n.startswith("_")}
                listed = {n for n in names(node.body) if not n.startswith("_")}
                fields = {n.target.id for n in node.body if isinstance(n, ast.AnnAssign)}
                self.assertEqual(listed | fields, members, node.name)


if __name__ == "__main__":
    unittest.main()
