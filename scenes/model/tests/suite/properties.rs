//! What holds for all scenes and for all bytes.

use crate::common::try_parse;
use glam::DVec3;
use proptest::collection::vec;
use proptest::prelude::*;
use scenes::{Fog, Light, LightKind, Material, Object, Scene, Shader, Shape, Sky, View};

/// Numbers of all sizes that a scene may have, among them those with few digits.
fn number() -> impl Strategy<Value = f64> {
    prop_oneof![
        -1e150..1e150,
        -10.0..10.0,
        (-1000i32..1000).prop_map(|n| f64::from(n) / 8.0),
        (-1074..490i32, -1.0..1.0).prop_map(|(exponent, m)| m * libm::exp2(f64::from(exponent))),
    ]
}

/// Boxed, as the strategies below: whole strategies of scenes fill a thread's stack by value.
fn point() -> BoxedStrategy<DVec3> {
    (number(), number(), number()).prop_map(|(x, y, z)| DVec3::new(x, y, z)).boxed()
}

fn radius() -> impl Strategy<Value = f64> {
    number().prop_filter("not 0", |&radius| radius != 0.0)
}

fn shape() -> BoxedStrategy<Shape> {
    let sphere = (point(), radius()).prop_map(|(centre, radius)| Shape::Sphere { centre, radius });
    let cone = (point(), radius(), point(), number())
        .prop_filter("a height", |(base, _, apex, _)| base != apex)
        .prop_map(|(base, base_radius, apex, other)| {
            let apex_radius = other.abs().copysign(base_radius);
            Shape::Cone { base, base_radius, apex, apex_radius }
        });
    let polygon = vec(point(), 3..8).prop_map(|vertices| Shape::Polygon { vertices });
    let patch = vec((point(), point()), 3..8).prop_map(|corners| {
        let (vertices, normals) = corners.into_iter().unzip();
        Shape::Patch { vertices, normals }
    });
    prop_oneof![sphere, cone, polygon, patch].boxed()
}

fn shader() -> BoxedStrategy<Shader> {
    let checker = (point(), radius())
        .prop_map(|(other, size)| Shader::Checker { other: other.abs(), size: size.abs() });
    let depth = (number(), number())
        .prop_filter("a range", |(a, b)| a.abs() != b.abs())
        .prop_map(|(a, b)| Shader::Depth { far: a.abs().max(b.abs()), near: a.abs().min(b.abs()) });
    let own = ("[a-z][a-zA-Z0-9_]{0,9}", [number(), number(), number(), number()]);
    let portal = (point(), number()).prop_map(|(by, turn)| Shader::Portal { by, turn });
    let taken = ["flat", "lambert", "phong", "checker", "depth", "portal"];
    let own = own
        .prop_filter("a name of its own", move |(name, _)| !taken.contains(&name.as_str()))
        .prop_map(|(name, parameters)| Shader::Own { name, parameters });
    let simple = prop::sample::select(vec![Shader::Flat, Shader::Lambert, Shader::Phong]);
    prop_oneof![simple, checker, depth, portal, own].boxed()
}

fn light() -> BoxedStrategy<LightKind> {
    let sun = point().prop_filter("a direction", |to_light| *to_light != DVec3::ZERO);
    prop_oneof![
        point().prop_map(|position| LightKind::Point { position, range: f64::INFINITY }),
        (point(), number())
            .prop_filter("a range", |(_, range)| *range != 0.0)
            .prop_map(|(position, range)| LightKind::Point { position, range: range.abs() }),
        sun.prop_map(|to_light| LightKind::Directional { to_light }),
    ]
    .boxed()
}

fn material() -> BoxedStrategy<Material> {
    let parts = (point(), point(), number(), number(), shader());
    let material = parts.prop_map(|(colour, shares, shine, index, shader)| Material {
        line: 0,
        colour: colour.abs(),
        diffuse: shares.x.abs(),
        specular: shares.y.abs(),
        transmittance: shares.z.abs(),
        shine: shine.abs(),
        refraction_index: index.abs(),
        emission: DVec3::ZERO,
        texture: None,
        shader,
    });
    material.boxed()
}

prop_compose! {
    fn view()(
        from in point(), at in point(), up in point(), angle in 0.01..179.99, hither in number(),
        resolution in (1u32..=scenes::MAX_SIDE, 1u32..=scenes::MAX_SIDE),
    ) -> View {
        View { from, at, up, angle, hither: hither.abs(), resolution }
    }
}

prop_compose! {
    /// Scenes whose objects use their materials in order, as files do.
    fn scene()(
        view in view().prop_filter("shows something", |view| view.camera(1, 1).is_ok()).boxed(),
        background in point(),
        sky in prop::option::of((point(), point())),
        ambient in point(),
        fog in prop::option::of((point(), 0.0..9.0)),
        lights in vec((light(), prop::option::of(point())), 0..4),
        groups in vec((material(), vec(shape(), 0..4)), 0..5),
    ) -> Scene {
        let lights = lights.into_iter().map(|(kind, colour)| {
            Light { line: 0, kind, colour: colour.map(DVec3::abs) }
        });
        let (mut materials, mut objects) = (Vec::new(), Vec::new());
        for (index, (material, shapes)) in (0..).zip(groups) {
            materials.push(material);
            let shapes = shapes.into_iter();
            objects.extend(shapes.map(|shape| Object { line: 0, material: index, shape }));
        }
        Scene {
            name: String::new(),
            view,
            background: background.abs(),
            sky: sky
                .filter(|(_, up)| *up != DVec3::ZERO)
                .map(|(zenith, up)| Sky { zenith: zenith.abs(), up }),
            ambient: ambient.abs(),
            lights: lights.collect(),
            materials,
            objects,
            mesh: None,
            heights: None,
            height_map: None,
            fog: fog.map(|(colour, density)| Fog { colour: colour.abs(), density }),
        }
    }
}

/// Words of the format in any order, which get deeper into the parser than bytes.
fn nearly_a_scene() -> impl Strategy<Value = String> {
    let word = prop::sample::select(vec![
        "v",
        "from",
        "at",
        "up",
        "angle",
        "hither",
        "resolution",
        "b",
        "l",
        "f",
        "s",
        "c",
        "p",
        "pp",
        "0",
        "1",
        "-1",
        "3",
        "0.5",
        "1e3",
        "1e999",
        "nan",
        "4000000000",
        "\n",
        "\n",
        "\n",
        "#",
        "#cellray",
        "ambient",
        "sun",
        "shader",
        "checker",
        "depth",
        "portal",
        "own",
        "\r\n",
        "\r",
    ]);
    vec(word, 0..80).prop_map(|words| words.join(" "))
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(512) })]

    #[test]
    fn written_scene_reads_back_equal(scene in scene()) {
        let text = scene.to_string();
        let back = try_parse(text.as_bytes()).map_err(|error| TestCaseError::fail(error.to_string()))?;
        prop_assert_eq!(&back, &scene);
        prop_assert_eq!(back.to_string(), text);
    }

    #[test]
    fn bytes_never_panic(bytes in vec(any::<u8>(), 0..400)) {
        prop_assert!(try_parse(&bytes).is_err(), "400 random bytes hold no view");
    }

    #[test]
    fn words_in_any_order_never_panic(words in nearly_a_scene()) {
        // A scene or an error: both are right, as long as they are given.
        if let Ok(scene) = try_parse(words.as_bytes()) {
            prop_assert_eq!(try_parse(scene.to_string().as_bytes()).ok(), Some(scene));
        }
    }

    #[test]
    fn damaged_scene_does_not_panic(scene in scene(), at in any::<prop::sample::Index>(), byte in any::<u8>()) {
        let mut bytes = scene.to_string().into_bytes();
        let at = at.index(bytes.len());
        bytes[at] = byte;
        if let Ok(back) = try_parse(&bytes) {
            prop_assert_eq!(try_parse(back.to_string().as_bytes()).ok(), Some(back));
        }
        prop_assert!(try_parse(&bytes[..at]).is_err() || at > 50, "a view has more than 50 bytes");
    }

    #[test]
    fn camera_is_finite_and_square(view in view(), width in 1u32..5000, height in 1u32..5000) {
        if let Ok(camera) = view.camera(width, height) {
            let middle = camera.corner
                + f64::from(width - 1) / 2.0 * camera.right
                + f64::from(height - 1) / 2.0 * camera.down;
            prop_assert!((middle.length() - 1.0).abs() < 1e-9, "{}", middle.length());
            prop_assert!((camera.right.length() / camera.down.length() - 1.0).abs() < 1e-12);
            prop_assert!(camera.right.dot(camera.down).abs() <= 1e-12 * camera.right.length_squared());
        }
    }
}
