//! Animations, skins and morph targets that are refused, with the messages.

use serde_json::{Value, json};

use super::maker::{CORNERS, Maker, about_z, triangle};

/// A triangle that a skin and a morph target move, for files that are to be damaged.
pub fn rig() -> Maker {
    let mut maker = triangle();
    let joints = maker.bytes(&[[0, 1, 0, 0]; 3]);
    let weights = maker.floats(&[[0.5, 0.5, 0.0, 0.0], [1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0]]);
    let target = maker.floats(&CORNERS);
    let inverse = maker.floats(&[glam::DMat4::IDENTITY.to_cols_array(); 2]);
    let primitive = &mut maker.root["meshes"][0]["primitives"][0];
    primitive["attributes"]["JOINTS_0"] = joints.into();
    primitive["attributes"]["WEIGHTS_0"] = weights.into();
    primitive["targets"] = json!([{"POSITION": target}]);
    maker.root["nodes"][1]["skin"] = json!(0);
    maker.add("skins", json!({"joints": [0, 1], "inverseBindMatrices": inverse}));
    maker.channel((1, "weights"), "LINEAR", &[0.0, 1.0], &[[0.0], [1.0]]);
    maker.channel((0, "rotation"), "LINEAR", &[0.0, 1.0], &[about_z(0.0, 1.0), about_z(1.0, 1.0)]);
    maker.channel((1, "translation"), "STEP", &[0.0, 1.0], &[[0.0; 3], [1.0; 3]]);
    maker
}

#[test]
fn faulty_animations_are_named() {
    let animation = |change: &dyn Fn(&mut Maker, usize)| {
        let mut maker = rig();
        let rotation = maker.root["accessors"].as_array().unwrap().len() - 4;
        change(&mut maker, rotation);
        maker.load(None).map(|_| "nothing is wrong".to_owned()).unwrap_or_else(|error| error)
    };
    let keys = |times: [f64; 2], values: Vec<[f64; 4]>| {
        animation(&|maker, _| {
            let times = maker.floats(&times.map(|time| [time]));
            let values = maker.floats(&values);
            maker.root["animations"][0]["samplers"][1] = json!({"input": times, "output": values});
        })
    };
    let turns = || vec![about_z(0.0, 1.0); 2];
    let place = "not a valid glTF file: animation `walk`, channel 1: ";
    let json = |pointer: &str, value: Value| {
        animation(&|maker, _| {
            let (above, last) = pointer.rsplit_once('/').unwrap();
            maker.root.pointer_mut(above).unwrap()[last] = value.clone();
        })
    };
    let channel = "/animations/0/channels/1";
    let sampler = "/animations/0/samplers/1";
    let attributes = "/meshes/0/primitives/0/attributes";
    for (found, expected) in [
        (keys([0.0, f64::NAN], turns()), "key 1 has the time NaN, which is not finite"),
        (
            keys([1.0, 0.5], turns()),
            "key 1 has the time 0.5, which is before 1, that of the last key",
        ),
        (keys([0.0, 1.0], vec![[0.0; 4]; 2]), "key 0 has a rotation of length 0"),
        (
            keys([0.0, 1.0], vec![[f64::INFINITY; 4]; 2]),
            "key 0 has the value inf, which is not finite",
        ),
        (
            keys([0.0, 1.0], turns()[..1].to_vec()),
            "the sampler has 1 values for 2 keys, each of which needs 1",
        ),
        (json(&format!("{channel}/target/node"), json!(9)), "node 9 doesn't exist"),
        (
            json(&format!("{channel}/target/path"), json!("colour")),
            "`colour` is not translation, rotation, scale or weights",
        ),
        (json(&format!("{channel}/sampler"), json!(9)), "sampler 9 doesn't exist"),
        (
            json(&format!("{sampler}/interpolation"), json!("QUINTIC")),
            "the interpolation `QUINTIC` is not LINEAR, STEP or CUBICSPLINE",
        ),
        (
            json(&format!("{sampler}/interpolation"), json!("CUBICSPLINE")),
            "the sampler has 2 values for 2 keys, each of which needs 3",
        ),
        (
            json(&format!("{sampler}/input"), json!(99)),
            "the sampler has 2 values for 0 keys, each of which needs 1",
        ),
        (
            json("/nodes/0/matrix", json!(glam::DMat4::IDENTITY.to_cols_array())),
            "node 0 has a matrix, which no animation can move",
        ),
    ] {
        assert_eq!(found, format!("{place}{expected}"));
    }
    let part = "mesh 0, primitive 0: ";
    let bound = |joints: [u8; 4], weights: [f64; 4]| {
        animation(&|maker, _| {
            let joints = maker.bytes(&[joints; 3]);
            let weights = maker.floats(&[weights; 3]);
            let attributes = &mut maker.root["meshes"][0]["primitives"][0]["attributes"];
            attributes["JOINTS_0"] = joints.into();
            attributes["WEIGHTS_0"] = weights.into();
        })
    };
    for (found, expected) in [
        (bound([0, 7, 0, 0], [0.5, 0.5, 0.0, 0.0]), format!("{part}vertex 0 has joint 7 of 2")),
        (bound([0; 4], [0.0; 4]), format!("{part}vertex 0 has weights of joints that add up to 0")),
        (
            bound([0; 4], [-1.0, 2.0, 0.0, 0.0]),
            format!("{part}vertex 0 has a joint with the weight -1"),
        ),
        (
            bound([0; 4], [f64::NAN, 2.0, 0.0, 0.0]),
            format!("{part}vertex 0 has a joint with the weight NaN"),
        ),
        (
            json(&format!("{attributes}/JOINTS_0"), json!(99)),
            format!("{part}accessor 99 doesn't exist"),
        ),
        (json(attributes, json!({"POSITION": 0})), format!("{part}a skin needs JOINTS_0")),
        (json("/nodes/1/skin", json!(4)), format!("{part}skin 4 doesn't exist")),
        (
            json("/skins/0/joints", json!([0, 8])),
            format!("{part}skin 0 has node 8 as a joint, which doesn't exist"),
        ),
        (
            json("/skins/0/joints", json!([0, 1, 1])),
            format!("{part}skin 0 has 2 matrices for 3 joints"),
        ),
        (
            json("/nodes/1/weights", json!([1, 2])),
            "node 1 has 2 weights for 1 morph targets".into(),
        ),
        (
            json("/meshes/0/primitives/0/targets", json!([])),
            "animation `walk`, channel 0: node 1 has no morph targets".into(),
        ),
        (
            json("/meshes/0/primitives/0/targets/0/POSITION", json!(5)),
            format!("{part}2 positions of a morph target for 3 vertices"),
        ),
    ] {
        assert_eq!(found, format!("not a valid glTF file: {expected}"));
    }
    // A joint without a weight may be any.
    assert_eq!(bound([0, 7, 0, 0], [0.5, 0.0, 0.0, 0.0]), "nothing is wrong");
}
