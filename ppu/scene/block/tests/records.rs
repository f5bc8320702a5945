//! Compares each record with the scene that it was made of.

use super::*;
use protocol::layout::{
    Cone, MATERIAL_FLAT, MATERIAL_LIT, MATERIAL_MIRRORS, MATERIAL_SHADED, MATERIAL_SHINES,
    MATERIAL_TRANSMITS, Material, Object as Head, Patch, Rectangle, SIDES_BOTH, SIDES_EXIT,
    SIDES_SMOOTH, Triangle,
};

/// The only object of a kind.
fn only(block: &SceneBlock, kind: PrimitiveKind) -> U32 {
    let leaves = block.leaves(kind);
    assert_eq!(leaves.len(), 1, "{kind:?}");
    leaves[0]
}

/// Gain, slope, offset and sides.
fn surface(head: &Head) -> ([f32; 3], u32) {
    let numbers = [head.gain, head.slope, head.offset].map(F32::get);
    (numbers, head.sides.get())
}

fn point(vector: [F32; 4]) -> DVec3 {
    assert_eq!(vector[3], F32::ZERO);
    wide([vector[0], vector[1], vector[2]])
}

/// The height over the surface of a point relative to the eye, by the formula of all shapes.
fn height(head: &Head, point: DVec3) -> f64 {
    let [gain, slope, offset] = surface(head).0.map(f64::from);
    let from_centre = point - wide(head.centre);
    let along = from_centre.dot(wide(head.axis));
    let across = from_centre - along * wide(head.axis);
    gain * across.length() + slope * along - offset
}

#[test]
fn background_comes_first() {
    let block = block("b 0.25 0.5 0.75\n");
    let head: &Head = block.at(U32::new(SCENE_ADDRESS));
    assert_eq!(wide(head.centre), DVec3::ZERO);
    assert_eq!(wide(head.axis), DVec3::Z);
    assert_eq!(surface(head), ([0.0, 1.0, 0.0], SIDES_BOTH));
    assert_eq!(head.leave.get(), 0.0);
    let material: &Material = block.at(head.material);
    assert_eq!(wide(material.emission), DVec3::new(0.25, 0.5, 0.75));
    assert_eq!(material.flags.get(), 0);
    assert_eq!(wide(material.colour), DVec3::ZERO);
    assert_eq!(block.bytes().len() % 128, 0);
    assert!(block.bytes()[144..].iter().all(|byte| *byte == 0));
}

#[test]
fn sky_is_background_shader() {
    let block = block("b 0.25 0.5 0.75\n#cellray sky 0.125 0 1 0 3 -4\n");
    let head: &Head = block.at(U32::new(SCENE_ADDRESS));
    let material: &Material = block.at(head.material);
    assert_eq!(wide(material.emission), DVec3::new(0.25, 0.5, 0.75));
    assert_eq!(wide(material.colour), DVec3::new(0.125, 0.0, 1.0));
    assert_eq!(material.flags.get(), MATERIAL_SHADED);
    assert_eq!(material.shader.get(), entry("sky").expect("a shader"));
    let up = material.parameters.map(F32::get);
    assert_eq!(up, [0.0, 0.6, -0.8, 0.0]);

    let scene = scene("#cellray sky 0 0 0\n");
    let without = SceneBlock::new(&scene, RenderOptions::default(), &|_| None);
    let message = without.expect_err("no shader").to_string();
    assert!(message.contains("no shader `sky`"), "{message}");
}

#[test]
fn colours_in_srgb_become_light() {
    let text = "b 0.5 0.5 0.5\n#cellray sky 0 0.5 1\nf 1 0.5 0 0.5 0.5 9 0.5 1\n\
                #cellray shader checker 0 0.5 1 2\ns 0 0 9 1\n";
    let of = |colour| {
        let options = RenderOptions { colour, ..RenderOptions::default() };
        let block = of(&scene(text), options);
        let background: &Head = block.at(U32::new(SCENE_ADDRESS));
        let sphere: &Head = block.at(only(&block, PrimitiveKind::Sphere));
        [background, sphere].map(|head| *block.at::<Material>(head.material))
    };
    let half = |channel: F32| (channel.get() - 0.214_041_14).abs() < 1e-7;
    let [background, sphere] = of(Colour::Srgb);
    assert!(background.emission.into_iter().all(half));
    for colour in [background.colour, sphere.colour] {
        assert!(half(colour[1]), "{colour:?}");
        assert_eq!(colour.map(F32::get).iter().sum::<f32>(), 1.0 + colour[1].get());
    }
    let [red, green, blue, per_size] = sphere.parameters;
    assert!(half(green));
    assert_eq!([red, blue, per_size].map(F32::get), [0.0, 1.0, 0.5]);
    // What a surface shows of other colours, and what it does with light.
    assert!([sphere.mirror, sphere.transmittance].into_iter().all(half));
    let shares = [sphere.diffuse, sphere.highlight];
    assert_eq!(shares.map(F32::get), [0.5, 0.5]);

    let [background, sphere] = of(Colour::Linear);
    assert_eq!(wide(background.emission), DVec3::splat(0.5));
    assert_eq!(sphere.mirror.get(), 0.5);
}

#[test]
fn spheres() {
    let rest = "s 1 2 3 4\n";
    let head = |rest: &str| *block(rest).at::<Head>(only(&block(rest), PrimitiveKind::Sphere));
    let outside = head(rest);
    assert_eq!(wide(outside.centre), DVec3::new(1.0, 2.0, 3.0));
    assert_eq!(wide(outside.axis), DVec3::ZERO);
    assert_eq!(surface(&outside), ([1.0, 0.0, 4.0], 0));
    assert_eq!(outside.leave.get(), 10.0 / (1 << 22) as f32);
    let inside = head("s 1 2 3 -4\n");
    assert_eq!(surface(&inside), ([-1.0, 0.0, -4.0], SIDES_EXIT));
    let glass = "f 1 1 1 0 0 0 1 1.5\n";
    assert_eq!(head(&format!("{glass}{rest}")).sides.get(), SIDES_BOTH);
    assert_eq!(head(&format!("{glass}s 0 0 0 -1\n")).sides.get(), SIDES_BOTH);
}

#[test]
fn parallelograms() {
    let block = block("p 4\n1 0 -5\n3 0 -5\n4 3 -5\n2 3 -5\n");
    let record: &Rectangle = block.at(only(&block, PrimitiveKind::Rectangle));
    let head: &Head = block.at(only(&block, PrimitiveKind::Rectangle));
    assert_eq!(wide(head.centre), DVec3::new(1.0, 0.0, -5.0));
    assert_eq!(wide(head.axis), DVec3::Z);
    assert_eq!(surface(head), ([0.0, 1.0, 0.0], 0));
    let (u, v) = (point(record.dual_u), point(record.dual_v));
    for (vertex, expected) in [
        (DVec3::new(1.0, 0.0, -5.0), (0.0, 0.0)),
        (DVec3::new(3.0, 0.0, -5.0), (1.0, 0.0)),
        (DVec3::new(4.0, 3.0, -5.0), (1.0, 1.0)),
        (DVec3::new(2.0, 3.0, -5.0), (0.0, 1.0)),
    ] {
        let from_corner = vertex - wide(head.centre);
        let found = (u.dot(from_corner), v.dot(from_corner));
        let off = (found.0 - expected.0).abs() + (found.1 - expected.1).abs();
        assert!(off < 1e-6, "{found:?}");
    }
    // The corner's sum of magnitudes is 6; the edges extend up to 3 + 3 from it.
    assert_eq!(head.leave.get(), 12.0 / (1 << 22) as f32);
}

#[test]
fn polygons_are_triangles() {
    // With a corner off, there are two triangles; in a concave polygon both have the reflex
    // corner.
    let off = block("p 4\n0 0 -5\n2 0 -5\n2 2.001 -5\n0 2 -5\n");
    assert_eq!(off.leaves(PrimitiveKind::Rectangle).len(), 0);
    assert_eq!(off.leaves(PrimitiveKind::Triangle).len(), 2);
    let arrow = block("p 4\n0 0 -5\n4 0 -5\n1 1 -5\n0 4 -5\n");
    for leaf in arrow.leaves(PrimitiveKind::Triangle) {
        let record: &Triangle = arrow.at(leaf);
        let head: &Head = arrow.at(leaf);
        let [a, b, c] = [record.a, record.b, record.c].map(point);
        assert_eq!(wide(head.axis), DVec3::Z);
        assert_eq!(wide(head.centre), a);
        assert!((b - a).cross(c - a).z > 0.0);
        assert!([a, b, c].contains(&DVec3::new(1.0, 1.0, -5.0)));
    }
    // Parts without area are left out, alone or in a larger polygon.
    let flat = block("p 3\n0 0 0\n1 1 1\n2 2 2\np 4\n0 0 -5\n2 0 -5\n0 2 -5\n0 2 -5\n");
    assert_eq!(flat.leaves(PrimitiveKind::Triangle).len(), 1);
}

#[test]
fn self_crossing_polygon_is_cut_by_even_odd_rule() {
    let star = "0 9 -5 9 9 1\n-5 -7 -5 9 9 1\n9 2 -5 9 9 1\n-9 2 -5 9 9 1\n5 -7 -5 9 9 1\n";
    let corners = star.replace(" 9 9 1\n", "\n");
    for shape in [format!("p 5\n{corners}"), format!("pp 5\n{star}")] {
        let block = block(&shape);
        let leaves = block.leaves(PrimitiveKind::Triangle);
        assert_eq!(leaves.len(), 5, "its tips");
        for leaf in leaves {
            let record: &Triangle = block.at(leaf);
            let [a, b, c] = [record.a, record.b, record.c].map(point);
            assert!((b - a).cross(c - a).z > 0.0);
            // A patch has the polygon's own normal there too.
            assert_eq!(surface(block.at(leaf)).1, 0);
        }
    }
}

#[test]
fn nonplanar_polygon_is_projected_onto_its_mean_plane() {
    let bent = block("p 4\n0 0 -5\n2 0 -6\n2 2 -5\n0 2 -6\n");
    for leaf in bent.leaves(PrimitiveKind::Triangle) {
        let record: &Triangle = bent.at(leaf);
        for vertex in [record.a, record.b, record.c].map(point) {
            assert_eq!(vertex.z, -5.5);
        }
    }
    // Vertices that are only off by rounding stay in place, as in adjacent polygons.
    let rounded = block("p 4\n0 0 -5\n2 0 -5.000001\n2 2 -5\n0 3 -5.000001\n");
    for leaf in rounded.leaves(PrimitiveKind::Triangle) {
        let record: &Triangle = rounded.at(leaf);
        for vertex in [record.a, record.b, record.c].map(point) {
            let z = if vertex.x == vertex.y { -5.0f32 } else { -5.000_001 };
            assert_eq!(vertex.z, f64::from(z));
        }
    }
}

#[test]
fn patches_keep_their_vertices_normals() {
    let corners = "0 0 -5 0 0 2\n2 0 -5 3 0 4\n2 2 -5 0 0 0\n0 2 -5 0 1 0\n";
    let block = block(&format!("pp 4\n{corners}"));
    let leaves = block.leaves(PrimitiveKind::Triangle);
    assert_eq!(leaves.len(), 2, "also if it is a parallelogram");
    let expected = [
        (DVec3::new(0.0, 0.0, -5.0), DVec3::Z),
        (DVec3::new(2.0, 0.0, -5.0), DVec3::new(0.6, 0.0, 0.8)),
        (DVec3::new(2.0, 2.0, -5.0), DVec3::ZERO),
        (DVec3::new(0.0, 2.0, -5.0), DVec3::Y),
    ];
    for leaf in leaves {
        let record: &Patch = block.at(leaf);
        let triangle: &Triangle = block.at(leaf);
        assert_eq!(surface(block.at(leaf)).1, SIDES_SMOOTH);
        let corners = [
            (triangle.a, record.normal_a),
            (triangle.b, record.normal_b),
            (triangle.c, record.normal_c),
        ];
        for (vertex, normal) in corners {
            let at = |(place, _): &&(DVec3, DVec3)| *place == point(vertex);
            let (_, wanted) = expected.iter().find(at).expect("a vertex of the patch");
            assert!(wanted.distance(point(normal)) < 1e-7);
        }
    }
}

#[test]
fn cones() {
    let cone = |radii: [f64; 2]| {
        let [low, high] = radii;
        let block = block(&format!("c\n1 1 -9 {low}\n1 5 -9 {high}\n"));
        let leaf = only(&block, PrimitiveKind::Cone);
        (*block.at::<Head>(leaf), *block.at::<Cone>(leaf))
    };
    let (head, record) = cone([3.0, 1.0]);
    assert_eq!(wide(head.centre), DVec3::new(1.0, 1.0, -9.0));
    assert_eq!(wide(head.axis), DVec3::Y);
    let numbers = [record.radius, record.growth, record.height].map(F32::get);
    assert_eq!(numbers, [3.0, -0.5, 4.0]);
    let (numbers, sides) = surface(&head);
    assert_eq!(sides, SIDES_BOTH, "an open sheet");
    let gain = 1.25f32.sqrt().recip();
    for (found, expected) in numbers.into_iter().zip([gain, 0.5 * gain, 3.0 * gain]) {
        assert!((found - expected).abs() < 1e-6, "{numbers:?}");
    }
    // A point on the surface at half the height, and one at distance 1 from it.
    let on = DVec3::new(1.0, 3.0, -7.0);
    let out = DVec3::new(0.0, 1.0, 2.0) / 5f64.sqrt();
    assert!(height(&head, on).abs() < 1e-6);
    assert!((height(&head, on + out) - 1.0).abs() < 1e-6);

    let (head, record) = cone([-3.0, -1.0]);
    assert_eq!(record.radius.get(), 3.0);
    assert_eq!(head.sides.get(), SIDES_EXIT);
    assert!((height(&head, on + out) + 1.0).abs() < 1e-6);
    let (cylinder, _) = cone([2.0, 2.0]);
    assert_eq!(surface(&cylinder).0, [1.0, 0.0, 2.0]);
    let (point, _) = cone([0.0, -2.0]);
    assert_eq!(point.sides.get(), SIDES_EXIT);
}

#[test]
fn materials() {
    let material = |text: &str, fresnel: bool| {
        let scene = scene(&format!("f {text}\ns 0 0 0 1\n"));
        let block = of(&scene, RenderOptions { fresnel, ..Default::default() });
        let head: &Head = block.at(only(&block, PrimitiveKind::Sphere));
        *block.at::<Material>(head.material)
    };
    let shares = |it: &Material| {
        [it.diffuse, it.highlight, it.exponent, it.mirror, it.transmittance].map(F32::get)
    };
    let optics = |it: &Material| [it.index, it.inverse_index, it.schlick, it.grazing].map(F32::get);

    let dull = material("0.25 0.5 0.75 0.5 0 7 0 0", true);
    assert_eq!(wide(dull.colour), DVec3::new(0.25, 0.5, 0.75));
    assert_eq!(shares(&dull), [0.5, 0.0, 28.0, 0.0, 0.0]);
    assert_eq!(optics(&dull), [1.0, 1.0, 0.0, 0.0]);
    assert_eq!(dull.flags.get(), MATERIAL_LIT);
    let mirror = material("1 1 1 0 0.5 3 0 1", false);
    assert_eq!(shares(&mirror), [0.0, 0.5, 12.0, 0.5, 0.0]);
    assert_eq!(mirror.flags.get(), MATERIAL_LIT | MATERIAL_SHINES | MATERIAL_MIRRORS);
    let glass = material("1 1 1 0 0 0 0.75 1.5", false);
    assert_eq!(shares(&glass), [0.0, 0.0, 0.0, 0.0, 0.75]);
    assert_eq!(optics(&glass), [1.5, 1.0 / 1.5, 0.0, 0.0]);
    assert_eq!(glass.flags.get(), MATERIAL_TRANSMITS | MATERIAL_MIRRORS);
    let fresnel = material("1 1 1 0 0 0 0.75 1.5", true);
    assert_eq!(optics(&fresnel), [1.5, 1.0 / 1.5, 0.04, 0.96]);
    assert_eq!(material("0 0 0 0 0 0 0 1", false).flags.get(), 0);
}

#[test]
fn shaders() {
    let material = |shader: &str| {
        let rest =
            format!("f 0.5 0.25 1 0.5 0.25 2 0.75 1.5\n#cellray shader {shader}\ns 0 0 0 1\n");
        let block = block(&rest);
        let head: &Head = block.at(only(&block, PrimitiveKind::Sphere));
        assert_eq!(head.sides.get(), SIDES_BOTH);
        *block.at::<Material>(head.material)
    };
    let shares =
        |it: &Material| [it.diffuse, it.highlight, it.mirror, it.transmittance].map(F32::get);
    let shading = |it: &Material| (it.shader.get(), it.parameters.map(F32::get));
    let glass = MATERIAL_TRANSMITS | MATERIAL_MIRRORS | MATERIAL_LIT;
    let colour = DVec3::new(0.5, 0.25, 1.0);

    let phong = material("phong");
    assert_eq!(shares(&phong), [0.5, 0.25, 0.25, 0.75]);
    assert_eq!(phong.flags.get(), glass | MATERIAL_SHINES);
    assert_eq!(wide(phong.emission), DVec3::ZERO);
    let lambert = material("lambert");
    assert_eq!(shares(&lambert), [0.5, 0.0, 0.25, 0.75]);
    assert_eq!(lambert.flags.get(), glass);
    let flat = material("flat");
    assert_eq!((shares(&flat), flat.flags.get()), ([0.0; 4], MATERIAL_FLAT));
    assert_eq!(wide(flat.emission), colour);

    let checker = material("checker 0 0.5 1 4");
    assert_eq!(shares(&checker), shares(&phong));
    assert_eq!(checker.flags.get(), glass | MATERIAL_SHINES | MATERIAL_SHADED);
    assert_eq!(shading(&checker), (0, [0.0, 0.5, 1.0, 0.25]));
    let depth = material("depth 10 2");
    assert_eq!((shares(&depth), depth.flags.get()), ([0.0; 4], MATERIAL_SHADED));
    assert_eq!(shading(&depth), (1, [10.0, 0.125, 0.0, 0.0]));
    assert_eq!(wide(depth.colour), colour);
    let portal = material("portal 1 2 -3 90");
    assert_eq!(shares(&portal), [0.0, 0.0, 0.0, 1.0]);
    assert_eq!(portal.flags.get(), MATERIAL_TRANSMITS | MATERIAL_SHADED);
    assert_eq!([portal.index, portal.schlick, portal.grazing].map(F32::get), [1.0, 0.0, 0.0]);
    assert_eq!(shading(&portal), (2, [1.0, 2.0, -3.0, 1.0]));
    let (_, half_a_turn) = shading(&material("portal 0 0 0 -180"));
    assert_eq!(half_a_turn[3], -((1_u32 << 30) as f32));
    let own = material("rings 1 -2 3");
    assert_eq!(shares(&own), shares(&phong));
    assert_eq!(own.flags.get(), checker.flags.get());
    assert_eq!(shading(&own), (3, [1.0, -2.0, 3.0, 0.0]));
}

#[test]
fn ambient_light() {
    let found = block("#cellray ambient 0.25 0.5 1\n").ambient();
    assert_eq!(found.map(F32::get), [0.25, 0.5, 1.0, 0.0]);
    assert_eq!(block("").ambient().map(F32::get), [0.0; 4]);
}

#[test]
fn objects_share_their_material() {
    let block = block("f 0 1 0 1 0 0 0 1\ns 0 0 0 1\ns 5 0 0 1\nf 0 0 1 1 0 0 0 1\ns 9 0 0 1\n");
    let colour = |leaf: &U32| {
        let head: &Head = block.at(*leaf);
        (head.material, wide(block.at::<Material>(head.material).colour))
    };
    let found: Vec<_> = block.leaves(PrimitiveKind::Sphere).iter().map(colour).collect();
    assert_eq!(found[0], found[1]);
    assert_eq!(found[0].1, DVec3::Y);
    assert_eq!(found[2].1, DVec3::Z);
    // The unused material is not sent. There are the background, 2 materials, 3 objects, a node.
    let used = 144 + 2 * 96 + 3 * 48 + 80;
    assert_eq!(block.bytes().len(), usize::next_multiple_of(used, 128));
}

#[test]
fn lights() {
    let mut block = block("l 1 2 3\n#cellray sun 0 3 4 1 1 1\nl 4 5 6 0.25 0.5 1\n");
    assert_eq!(block.light_count(), 3);
    block.write_for(DVec3::new(1.0, 1.0, 1.0)).expect("an eye");
    let light = |block: &SceneBlock, number: u32| {
        let address = U32::new(block.light_address() + number * 32);
        *block.at::<layout::Light>(address)
    };
    let first = light(&block, 0);
    assert_eq!(wide(first.position), DVec3::new(0.0, 1.0, 2.0));
    assert_eq!(first.falloff.get(), 0);
    assert_eq!(first.near.get(), 24.0 / (1 << 20) as f32);
    let grey = 3f64.sqrt() / 6.0;
    assert!(wide(first.brightness).distance(DVec3::splat(grey)) < 1e-7);
    let sun = light(&block, 1);
    assert!(wide(sun.position).distance(DVec3::new(0.0, 0.6, 0.8)) < 1e-7);
    assert_eq!(sun.falloff.get(), u32::MAX);
    let second = light(&block, 2);
    assert_eq!(wide(second.position), DVec3::new(3.0, 4.0, 5.0));
    assert_eq!(wide(second.brightness), DVec3::new(0.25, 0.5, 1.0));
}

#[test]
fn shadow_rays_end_at_offset_from_light() {
    let mut block = block("l 1 2 3\ns 1 1 -2 8\n");
    block.write_for(DVec3::new(1.0, 1.0, 1.0)).expect("an eye");
    let light = block.at::<layout::Light>(U32::new(block.light_address()));
    let (own, leave) = (24.0, 3.0 + 8.0);
    assert_eq!(light.near.get(), (own + 8.0 * leave) / (1 << 20) as f32);
}

#[test]
fn objects_near_eye_are_kept_far_from_origin() {
    let far = DVec3::new(1e6, -2e6, 3e6);
    let at = |x: f64, y: f64, z: f64| {
        let place = far + DVec3::new(x, y, z);
        format!("{} {} {}", place.x, place.y, place.z)
    };
    let rest = format!(
        "l {}\ns {} 0.001\np 3\n{}\n{}\n{}\n",
        at(0.125, 0.25, 0.5),
        at(0.001, 0.002, 0.003),
        at(0.0, 0.0, -0.5),
        at(0.001, 0.0, -0.5),
        at(0.0, 0.001, -0.5)
    );
    let mut block = block(&rest);
    block.write_for(far).expect("an eye");
    // The precision of the scene's f64 coordinates there.
    let exact = 1e-9;
    let sphere: &Head = block.at(only(&block, PrimitiveKind::Sphere));
    assert!(wide(sphere.centre).distance(DVec3::new(0.001, 0.002, 0.003)) < exact);
    assert!(sphere.leave.get() < 1e-7);
    let triangle: &Triangle = block.at(only(&block, PrimitiveKind::Triangle));
    assert!(point(triangle.b).distance(DVec3::new(0.001, 0.0, -0.5)) < exact);
    let light: &layout::Light = block.at(U32::new(block.light_address()));
    assert!(wide(light.position).distance(DVec3::new(0.125, 0.25, 0.5)) < exact);
}

#[test]
fn block_is_written_for_last_eye() {
    let scene = scenes::sphereflake::generate(2).expect("a scene");
    let mut block = of(&scene, RenderOptions::default());
    let first = block.bytes().to_vec();
    block.write_for(DVec3::new(-3.0, 4.0, 1.0)).expect("an eye");
    assert_ne!(block.bytes(), first);
    block.write_for(scene.view.from).expect("an eye");
    assert_eq!(block.bytes(), first);
}
