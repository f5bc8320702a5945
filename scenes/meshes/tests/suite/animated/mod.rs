//! Animations of glTF files, compared with what their formulas give in double precision.

pub mod faults;
mod maker;

use std::f64::consts::TAU;
use std::fs;

use glam::{DAffine3, DMat3, DVec3, Vec3};
use meshes::Animation;
use proptest::prelude::*;
use serde_json::json;

use self::maker::{CORNERS, NORMALS, about_z, triangle};

/// Checks the vertices at a time against transforms of positions and of surfaces for each corner.
#[track_caller]
fn check(animation: &mut Animation, time: f64, truth: impl Fn(usize) -> DAffine3) {
    let (positions, normals) = animation.at(time);
    let (positions, normals) = (positions.to_vec(), normals.to_vec());
    for corner in 0..3 {
        let place = truth(corner);
        let expected = place.transform_point3(CORNERS[corner].into());
        let found = Vec3::from(positions[corner]).as_dvec3();
        let size = expected.length() + place.translation.length() + 1.0;
        assert!(found.distance(expected) < 1e-6 * size, "{time}: {found} {expected}");
        // A normal is perpendicular to two vectors in the surface, wherever these are taken.
        let normal = DVec3::from(NORMALS[corner]);
        let (one, other) = normal.any_orthonormal_pair();
        let [one, other] = [one, other].map(|it| place.transform_vector3(it));
        let expected = one.cross(other).normalize() * place.matrix3.determinant().signum();
        let found = Vec3::from(normals[corner]).as_dvec3();
        assert!(found.distance(expected) < 1e-6, "{time}: {found} {expected}");
    }
}

/// The last key that is not after a time, and the share of the way to the next one.
fn between(times: &[f64], time: f64) -> (usize, usize, f64) {
    let key = times.iter().rposition(|&key| key <= time).unwrap_or(0);
    let next = (key + 1).min(times.len() - 1);
    let span = times[next] - times[key];
    let share = if span > 0.0 { ((time - times[key]) / span).max(0.0) } else { 0.0 };
    (key, next, share)
}

/// Times as singles hold them, in order.
fn times() -> impl Strategy<Value = Vec<f64>> {
    prop::collection::vec(0.0..4.0_f64, 1..6).prop_map(|mut times| {
        times.iter_mut().for_each(|time| *time = f64::from(*time as f32));
        times.sort_by(f64::total_cmp);
        times
    })
}

proptest! {
    #[test]
    fn nodes_are_where_their_keys_take_them(
        turns in times(), moves in times(), scales in times(), at in 0.0..9.0_f64, seed in 0..1000_u32,
    ) {
        let number = |index: usize| f64::from((seed * 31 + index as u32 * 17) % 97) / 97.0;
        // Rotations by less than half a turn from one to the next, of either sign and any length.
        let angles: Vec<f64> = (0..turns.len()).map(|key| 3.0 * number(key)).collect();
        let lengths = [1.0, -1.0, 2.5, -0.01];
        let rotations: Vec<_> = (0..turns.len())
            .map(|key| about_z(angles[key], lengths[(seed as usize + key) % 4]))
            .collect();
        let values: Vec<[f64; 3]> = (0..3 * moves.len())
            .map(|it| [0, 7, 40].map(|more| f64::from((4.0 * number(it + more) - 2.0) as f32)))
            .collect();
        let sizes: Vec<[f64; 3]> = (0..scales.len())
            .map(|it| [3, 8, 50].map(|more| f64::from((0.5 + number(it + more)) as f32)))
            .collect();
        let mut maker = triangle();
        maker.channel((0, "rotation"), "LINEAR", &turns, &rotations);
        maker.channel((1, "translation"), "CUBICSPLINE", &moves, &values);
        maker.channel((1, "scale"), "STEP", &scales, &sizes);
        let mut animation = maker.animation();
        let ends = [&turns, &moves, &scales].map(|times| times[times.len() - 1]);
        let duration = ends.into_iter().fold(0.0, f64::max);
        prop_assert_eq!(animation.duration(), duration);
        prop_assert_eq!(animation.name(), "walk");
        let time = if duration > 0.0 { at % duration } else { 0.0 };

        let (key, next, share) = between(&turns, time);
        let angle = angles[key] + share * (angles[next] - angles[key]);
        let outer = DAffine3::from_rotation_z(angle);
        // A cubic spline is a Bézier curve whose inner points are a third of a tangent away.
        let (key, next, share) = between(&moves, time);
        let span = moves[next] - moves[key];
        let value = |index: usize| DVec3::from(values[index]);
        let mut points = vec![
            value(3 * key + 1),
            value(3 * key + 1) + span / 3.0 * value(3 * key + 2),
            value(3 * next + 1) - span / 3.0 * value(3 * next),
            value(3 * next + 1),
        ];
        while points.len() > 1 {
            points = points.windows(2).map(|pair| pair[0].lerp(pair[1], share)).collect();
        }
        let (key, _, _) = between(&scales, time);
        let inner = DAffine3 {
            matrix3: DMat3::from_diagonal(sizes[key].into()),
            translation: points[0],
        };
        check(&mut animation, at, |_| outer * inner);
    }

    #[test]
    fn skins_blend_the_transforms_of_joints(
        angle in -1.5..1.5_f64, weights in prop::array::uniform3(prop::array::uniform4(0.0..1.0_f64)),
        at in 0.0..2.0_f64,
    ) {
        let mut maker = triangle();
        let joints = maker.bytes(&[[0, 1, 1, 2], [1, 0, 2, 1], [2, 2, 0, 1]]);
        // The last joint of a vertex has no weight, and may then be one that doesn't exist.
        let singles = weights.map(|[a, b, c, d]| [a + 0.01, b, c, d].map(|it| f64::from(it as f32)));
        let shares = maker.floats(&singles);
        let binds = [[0.0, 0.0, 0.0], [0.5, -1.0, 0.25], [0.0, 2.0, 0.0]];
        let inverse = binds.map(|it| glam::DMat4::from_translation(-DVec3::from(it)).to_cols_array());
        let inverse = maker.floats(&inverse);
        let attributes = &mut maker.root["meshes"][0]["primitives"][0]["attributes"];
        attributes["JOINTS_0"] = joints.into();
        attributes["WEIGHTS_0"] = shares.into();
        // The mesh's node is moved, which counts for nothing. The joints are in no scene.
        maker.root["nodes"][1] = json!({"mesh": 0, "skin": 0, "translation": [5, 6, 7]});
        maker.add("nodes", json!({"children": [3]}));
        maker.add("nodes", json!({"children": [4], "translation": binds[1]}));
        let last = DVec3::from(binds[2]) - DVec3::from(binds[1]);
        maker.add("nodes", json!({"translation": last.to_array(), "scale": [1, 2, 1]}));
        maker.add("skins", json!({"joints": [2, 3, 4], "inverseBindMatrices": inverse}));
        maker.channel((3, "rotation"), "LINEAR", &[0.0, 2.0], &[about_z(0.0, 1.0), about_z(angle, -3.0)]);
        let mut animation = maker.animation();
        let bent = DAffine3::from_translation(DVec3::from(binds[1]))
            * DAffine3::from_rotation_z(angle * at / 2.0);
        let end = bent * DAffine3::from_translation(last) * DAffine3::from_scale(DVec3::new(1.0, 2.0, 1.0));
        let places = [DAffine3::IDENTITY, bent, end];
        let of_vertices = [[0, 1, 1, 2], [1, 0, 2, 1], [2, 2, 0, 1]];
        check(&mut animation, at, |corner| {
            let sum: f64 = singles[corner].iter().sum();
            let mut blended = DAffine3 { matrix3: DMat3::ZERO, translation: DVec3::ZERO };
            for (joint, weight) in of_vertices[corner].into_iter().zip(singles[corner]) {
                let place = places[joint] * DAffine3::from_translation(-DVec3::from(binds[joint]));
                blended.matrix3 += place.matrix3 * (weight / sum);
                blended.translation += place.translation * (weight / sum);
            }
            blended
        });
    }

    #[test]
    fn morph_targets_are_added_by_their_weights(first in -1.0..2.0_f64, at in 0.0..1.0_f64) {
        let moved = [[0.5, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, -2.0]];
        let tilted = [[0.1, 0.0, 0.0], [0.0, 0.0, 0.0], [0.0, 0.3, 0.0]];
        let mut maker = triangle();
        let [positions, normals] = [moved, tilted].map(|it| maker.floats(&it));
        maker.root["meshes"][0]["primitives"][0]["targets"] =
            json!([{"POSITION": positions, "NORMAL": normals}, {"NORMAL": normals}]);
        maker.root["meshes"][0]["weights"] = json!([9.0, 9.0]);
        let first = f64::from(first as f32);
        let mut still = maker.load(None).unwrap();
        let found = std::sync::Arc::make_mut(still.scene.mesh.as_mut().unwrap()).positions[0];
        prop_assert_eq!(found, [1.0 + 4.5, 0.0, 0.5]);
        maker.channel((1, "weights"), "LINEAR", &[0.0, 1.0], &[[first], [0.25], [0.0], [1.0]]);
        let mut animation = maker.animation();
        let weights = [first * (1.0 - at), 0.25 * (1.0 - at) + at];
        let (found, bent) = animation.at(at);
        for corner in 0..3 {
            let expected = DVec3::from(CORNERS[corner]) + weights[0] * DVec3::from(moved[corner]);
            let off = Vec3::from(found[corner]).as_dvec3().distance(expected);
            prop_assert!(off < 1e-6, "{}", off);
            let expected = DVec3::from(NORMALS[corner])
                + (weights[0] + weights[1]) * DVec3::from(tilted[corner]);
            let off = Vec3::from(bent[corner]).as_dvec3().distance(expected.normalize());
            prop_assert!(off < 1e-6, "{}", off);
        }
    }
}

#[test]
fn keys_hold_before_the_first_and_after_the_last() {
    let values = [[1.0, 0.0, 0.0], [2.0, 0.0, 0.0], [4.0, 0.0, 0.0], [8.0, 0.0, 0.0]];
    let at = |interpolation: &str, times: &[f64], time: f64| {
        let mut maker = triangle();
        maker.channel((0, "translation"), interpolation, times, &values[..times.len()]);
        // Another channel makes the animation last until 10.
        maker.channel((1, "translation"), "LINEAR", &[10.0], &[[0.0; 3]]);
        f64::from(maker.animation().at(time).0[0][0]) - CORNERS[0][0]
    };
    let times = [1.0, 2.0, 2.0, 3.0];
    for (interpolation, time, expected) in [
        ("LINEAR", 0.5, 1.0),
        ("LINEAR", 1.0, 1.0),
        ("LINEAR", 1.5, 1.5),
        // Where two keys have the same time, the property jumps.
        ("LINEAR", 2.0, 4.0),
        ("LINEAR", 2.25, 5.0),
        ("LINEAR", 3.0, 8.0),
        ("LINEAR", 9.0, 8.0),
        ("LINEAR", 11.5, 1.5),
        ("LINEAR", -8.5, 1.5),
        ("LINEAR", f64::NAN, 1.0),
        ("STEP", 0.5, 1.0),
        ("STEP", 1.99, 1.0),
        ("STEP", 2.0, 4.0),
        ("STEP", 9.0, 8.0),
    ] {
        assert_eq!(at(interpolation, &times, time), expected, "{interpolation} {time}");
    }
    assert_eq!(at("LINEAR", &[5.0], 2.0), 1.0);
    assert_eq!(at("LINEAR", &[5.0], 7.0), 1.0);
}

/// Half a turn from one key to the next has two shortest arcs. Any of them is right, and no number
/// is NaN.
#[test]
fn half_a_turn_and_equal_rotations_stay_finite() {
    for (from, to) in [(0.0, TAU / 2.0), (0.3, 0.3), (0.3, 0.3 + TAU), (0.0, 1e-9)] {
        let mut maker = triangle();
        let keys = [about_z(from, 1.0), about_z(to, 1.0)];
        maker.channel((0, "rotation"), "LINEAR", &[0.0, 1.0], &keys);
        maker.channel(
            (1, "rotation"),
            "CUBICSPLINE",
            &[0.0, 1.0],
            &[[0.0; 4], keys[0], [0.0; 4]].repeat(2),
        );
        let mut animation = maker.animation();
        for time in [0.25, 0.5, 0.75] {
            let (positions, _) = animation.at(time);
            let lengths = positions.iter().map(|it| Vec3::from(*it).length());
            for (length, corner) in lengths.zip(CORNERS) {
                assert!((f64::from(length) - DVec3::from(corner).length()).abs() < 1e-5);
            }
        }
    }
}

/// Vertices on the edges of holes stay at the same places of their triangles.
#[test]
fn holes_move_with_their_triangles() {
    let mut maker = triangle();
    let picture = image::RgbaImage::from_fn(2, 1, |x, _| image::Rgba([0, 200, 0, 255 * x as u8]));
    let mut png = std::io::Cursor::new(Vec::new());
    picture.write_to(&mut png, image::ImageFormat::Png).unwrap();
    let start = maker.data.len();
    maker.data.extend(png.into_inner());
    maker.data.resize(maker.data.len().next_multiple_of(4), 0);
    let length = maker.data.len() - start;
    let view = json!({"buffer": 0, "byteOffset": start, "byteLength": length});
    let view = maker.add("bufferViews", view);
    maker.add("images", json!({"bufferView": view, "mimeType": "image/png"}));
    maker.add("textures", json!({"source": 0}));
    let texture = json!({"baseColorTexture": {"index": 0}});
    maker.add("materials", json!({"alphaMode": "MASK", "pbrMetallicRoughness": texture}));
    let places = maker.floats(&[[0.1, 0.0], [0.9, 0.0], [0.1, 1.0]]);
    let primitive = &mut maker.root["meshes"][0]["primitives"][0];
    primitive["attributes"]["TEXCOORD_0"] = places.into();
    primitive["material"] = json!(0);
    let keys = [about_z(0.0, 1.0), about_z(2.0, 1.0)];
    maker.channel((0, "rotation"), "LINEAR", &[0.0, 1.0], &keys);
    let mut animation = maker.animation();
    let (positions, normals) = animation.at(0.0);
    let first = [positions.to_vec(), normals.to_vec()];
    assert!(first[0].len() > 3, "the triangle is cut");
    let (positions, normals) = animation.at(0.3);
    for (before, after) in first.iter().zip([positions, normals]) {
        for (before, after) in before.iter().zip(after) {
            let expected = DMat3::from_rotation_z(0.6) * Vec3::from(*before).as_dvec3();
            assert!(Vec3::from(*after).as_dvec3().distance(expected) < 1e-6);
        }
    }
}

/// Triangles of one place may part later, so their vertices stay their own.
#[test]
fn equal_vertices_of_two_nodes_part() {
    let mut maker = triangle();
    maker.root["scenes"][0]["nodes"] = json!([0, 2]);
    maker.add("nodes", json!({"mesh": 0}));
    maker.channel((1, "translation"), "LINEAR", &[0.0, 1.0], &[[0.0; 3], [0.0, 0.0, 8.0]]);
    let mut animation = maker.animation();
    let first = animation.at(0.0).0.to_vec();
    assert_eq!((first.len(), first[0]), (6, first[3]));
    let later = animation.at(0.5).0;
    assert_eq!((later[0][2], later[3]), (first[0][2] + 4.0, first[3]));
}

#[test]
fn surfaces_mirrored_at_times_have_two_sides() {
    for (scale, expected) in [([-1.0, 1.0, 1.0], true), ([0.5, 2.0, 1.0], false)] {
        let mut maker = triangle();
        maker.channel((0, "scale"), "LINEAR", &[0.0, 1.0], &[[1.0; 3], scale]);
        let mesh = maker.load(None).unwrap().scene.mesh.unwrap();
        assert_eq!(mesh.two_sided, expected);
    }
}

/// A triangle that is a line but for rounding is none, unless it becomes one later.
#[test]
fn invisible_triangles_are_dropped() {
    for (to, expected) in [([0.1, 0.3, 0.1], 1), ([0.0, 0.0, 0.0], 0)] {
        let mut maker = triangle();
        let line = maker.floats(&[[0.0; 3], [1.0, 1.0, 1.0], [1.0, 1.0 + 1e-7, 1.0]]);
        let primitive = json!({"attributes": {"POSITION": line}});
        let target = maker.floats(&[[0.0; 3], [0.0; 3], to]);
        let still = maker.floats(&[[0.0; 3]; 3]);
        let primitives = &mut maker.root["meshes"][0]["primitives"];
        primitives.as_array_mut().unwrap().push(primitive);
        primitives[0]["targets"] = json!([{"POSITION": still}]);
        primitives[1]["targets"] = json!([{"POSITION": target}]);
        maker.channel(
            (0, "rotation"),
            "LINEAR",
            &[0.0, 1.0],
            &[about_z(0.0, 1.0), about_z(1.0, 1.0)],
        );
        maker.channel((1, "weights"), "LINEAR", &[0.0, 1.0], &[[0.0], [1.0]]);
        let mesh = maker.load(None).unwrap().scene.mesh.unwrap();
        let counts = (mesh.triangles.len(), mesh.materials.len(), mesh.positions.len());
        assert_eq!(counts, (1 + expected, 1 + expected, 6));
    }
}

/// The view of a file without a camera has all of the animation in the picture.
#[test]
fn view_shows_all_of_an_animation() {
    let mut maker = triangle();
    maker.channel((0, "translation"), "LINEAR", &[0.0, 1.0, 2.0], &[[0.0; 3], [40.0; 3], [0.0; 3]]);
    let view = maker.load(None).unwrap().scene.view;
    let far = DVec3::from(CORNERS[1]) + 38.0;
    let sight = (view.at - view.from).normalize();
    let angle = libm::acos((far - view.from).normalize().dot(sight));
    assert!(angle < (view.angle / 2.0).to_radians(), "{angle}");
}

#[test]
fn animations_are_chosen_by_name_or_number() {
    let mut maker = triangle();
    maker.channel((0, "translation"), "LINEAR", &[0.0, 1.0], &[[0.0; 3], [1.0; 3]]);
    let mut second = maker.root["animations"][0].clone();
    second["name"] = json!("run");
    second["channels"] = json!([]);
    maker.add("animations", second);
    let name = |chosen| {
        maker
            .load(chosen)
            .map(|loaded| (loaded.animation.map(|it| it.name().to_owned()), loaded.notes.len()))
    };
    assert_eq!(name(None), Ok((Some("walk".to_owned()), 0)));
    assert_eq!(name(Some("walk")), Ok((Some("walk".to_owned()), 0)));
    assert_eq!(name(Some("0")), Ok((Some("walk".to_owned()), 0)));
    assert_eq!(name(Some("none")), Ok((None, 0)));
    assert_eq!(name(Some("run")), Ok((None, 1)), "it moves nothing, and a note states that");
    let found = name(Some("jump")).unwrap_err();
    assert_eq!(found, "the file has no animation `jump`; it has `walk`, `run`");
    let found = name(Some("2")).unwrap_err();
    assert_eq!(found, "the file has no animation `2`; it has `walk`, `run`");
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("x.stl");
    fs::write(&path, super::scans::STL).unwrap();
    let found = meshes::load_animated(&path, Some("walk")).unwrap_err().to_string();
    assert!(found.ends_with("x.stl: the file has no animation `walk`; it has none"), "{found}");
    assert!(meshes::load_animated(&path, Some("none")).is_ok());
}
