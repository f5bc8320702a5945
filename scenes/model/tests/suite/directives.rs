//! What `#cellray` adds to NFF: how it is read, written and refused.

use crate::common::{parsed, scene_text, try_parse};
use glam::DVec3;
use scenes::daylight::{AMBIENT, HORIZON, SUN};
use scenes::{Fog, LightKind, Shader, Sky};

fn refusal(rest: &str) -> String {
    try_parse(scene_text(rest).as_bytes()).expect_err("refused").to_string()
}

#[test]
fn scene_without_directives_is_unchanged() {
    let scene = parsed(&scene_text("l 1 2 3\ns 0 0 0 1\n"));
    assert_eq!(scene.ambient, DVec3::ZERO);
    assert_eq!(scene.materials[0].shader, Shader::Phong);
    assert!(!scene.to_string().contains('#'));
}

#[test]
fn lights_in_the_order_of_the_file() {
    let scene = parsed(&scene_text(
        "l 1 2 3\n#cellray sun 0 0 4\n\t #cellray sun 1 0 0 0.5 0.25 1 # noon\nl 4 5 6\n\
         #cellray ambient 0.1 0.2 0.3\n",
    ));
    assert_eq!(scene.ambient, DVec3::new(0.1, 0.2, 0.3));
    let lights: Vec<_> = scene.lights.iter().map(|it| (it.line, it.kind)).collect();
    let point = |x, y, z| LightKind::Point { position: DVec3::new(x, y, z), range: f64::INFINITY };
    let sun = |to_light| LightKind::Directional { to_light };
    assert_eq!(
        lights,
        [
            (9, point(1.0, 2.0, 3.0)),
            (10, sun(4.0 * DVec3::Z)),
            (11, sun(DVec3::X)),
            (12, point(4.0, 5.0, 6.0)),
        ]
    );
    assert_eq!(scene.lights[1].colour, None);
    assert_eq!(scene.lights[2].colour, Some(DVec3::new(0.5, 0.25, 1.0)));
    let lamp = &parsed(&scene_text("#cellray lamp 1 2 3 8 0.5 0.25 1")).lights[0];
    let position = DVec3::new(1.0, 2.0, 3.0);
    assert_eq!(lamp.kind, LightKind::Point { position, range: 8.0 });
    assert_eq!(lamp.colour, Some(DVec3::new(0.5, 0.25, 1.0)));
    // Suns count among the lights that share the brightness.
    assert_eq!(scene.brightness(&scene.lights[0]), DVec3::splat(0.25));
}

#[test]
fn sky_direction_is_view_up_or_given() {
    let sky = |text: &str| parsed(&scene_text(text)).sky;
    assert_eq!(sky("s 0 0 0 1"), None);
    let zenith = DVec3::new(0.1, 0.2, 0.3);
    let up = parsed(&scene_text("")).view.up;
    assert_eq!(sky("#cellray sky 0.1 0.2 0.3"), Some(Sky { zenith, up }));
    let up = DVec3::new(0.0, 2.0, 1.0);
    let text = "#cellray sky 0.1 0.2 0.3 0 2 1 # a hillside";
    assert_eq!(sky(text), Some(Sky { zenith, up }));
}

#[test]
fn daylight_keeps_settings_of_scene() {
    let day = parsed(&scene_text("l 1 2 3\n#cellray daylight\n"));
    let up = day.view.up;
    assert_eq!(day.sky, Some(Sky::of_day(up)));
    assert_eq!([day.background, day.ambient], [HORIZON, AMBIENT]);
    let [_, sun] = &day.lights[..] else {
        panic!("{:?}", day.lights);
    };
    assert_eq!((sun.line, sun.colour), (10, Some(SUN)));
    let LightKind::Directional { to_light } = sun.kind else {
        panic!("{sun:?}");
    };
    // From the back, from the right and from above.
    let sight = day.view.at - day.view.from;
    assert!(to_light.dot(sight) < 0.0 && to_light.dot(up) > 0.0);
    assert!(to_light.dot(sight.cross(up)) > 0.0);

    let own = "b 0 0.5 1\n#cellray ambient 0 0 0.1\n#cellray sky 0 0 0.5 0 0 1\n";
    let own = parsed(&scene_text(&format!("{own}#cellray daylight\n")));
    assert_eq!(own.background, DVec3::new(0.0, 0.5, 1.0));
    assert_eq!(own.ambient, DVec3::new(0.0, 0.0, 0.1));
    assert_eq!(own.sky.map(|sky| sky.zenith), Some(DVec3::new(0.0, 0.0, 0.5)));
    assert_eq!(own.lights.len(), 1);
}

#[test]
fn shader_applies_to_preceding_material() {
    let own = |name: &str, parameters| Shader::Own { name: name.to_owned(), parameters };
    for (text, shader) in [
        ("flat", Shader::Flat),
        ("lambert", Shader::Lambert),
        ("phong", Shader::Phong),
        ("checker 0.5 0 1 2", Shader::Checker { other: DVec3::new(0.5, 0.0, 1.0), size: 2.0 }),
        ("depth 9 2.5", Shader::Depth { far: 9.0, near: 2.5 }),
        ("portal 1 -2 3", Shader::Portal { by: DVec3::new(1.0, -2.0, 3.0), turn: 0.0 }),
        ("portal 0 0 9 -90", Shader::Portal { by: DVec3::new(0.0, 0.0, 9.0), turn: -90.0 }),
        ("marble_2", own("marble_2", [0.0; 4])),
        ("rings 1 -2", own("rings", [1.0, -2.0, 0.0, 0.0])),
        ("rings 1 2 3 4", own("rings", [1.0, 2.0, 3.0, 4.0])),
    ] {
        let rest = format!(
            "f 1 1 1 1 0 0 0 1\ns 0 0 0 1\n#cellray shader {text} # why\nf 0 0 0 0 0 0 0 1\n"
        );
        let scene = parsed(&scene_text(&rest));
        let shaders: Vec<_> = scene.materials.iter().map(|it| &it.shader).collect();
        assert_eq!(shaders, [&Shader::Phong, &shader, &Shader::Phong], "{text}");
        assert_eq!(parsed(&scene.to_string()), scene);
    }
}

#[test]
fn fog_has_colour_and_density() {
    let scene = parsed(&scene_text("#cellray fog 0.5 0.25 1 0.125 # morning"));
    assert_eq!(scene.fog, Some(Fog { colour: DVec3::new(0.5, 0.25, 1.0), density: 0.125 }));
    assert_eq!(parsed(&scene.to_string()), scene);
}

#[test]
fn height_map_has_material_before_it() {
    let rest = "#cellray heights a/b.png 30 0.5 c.jpg # hills\nf 0 0 0 0 0 0 0 1\ns 0 0 0 1\n";
    let scene = parsed(&scene_text(rest));
    let map = scene.height_map.as_ref().expect("a height map");
    assert_eq!((map.file.as_str(), map.scale, map.line), ("a/b.png", (30.0, 0.5), 9));
    assert_eq!((map.colours.as_deref(), map.material), (Some("c.jpg"), 0));
    assert_eq!(parsed(&scene.to_string()).height_map, scene.height_map);
}

#[test]
fn other_comments_stay_comments() {
    let comments = "# cellray sun\n#cellrays\n#cellray_sun 1\n##cellray sun\n#Cellray x\n\
                    s 0 0 0 1 #cellray shader 7\n";
    assert_eq!(parsed(&scene_text(comments)).objects.len(), 1);
}

#[test]
fn faults_name_file_and_line() {
    for (rest, message) in [
        ("#cellray", "9: directive is missing"),
        (
            "\n #cellray mist 1",
            "10: unknown directive `mist` (known: ambient daylight fog heights lamp shader sky sun)",
        ),
        ("#cellray lamp 1 2 3", "9: lamp range is missing"),
        ("#cellray lamp 1 2 3 0", "9: lamp range 0 is not above 0"),
        ("#cellray ambient 1 1", "9: ambient blue is missing"),
        ("#cellray ambient 1 -1 1", "9: ambient green -1 is negative"),
        (
            "#cellray ambient 1 1 1 1",
            "9: ambient light is followed by `1`, which does not belong there",
        ),
        (
            "#cellray ambient 0 0 0\n#cellray ambient 1 1 1",
            "10: a second ambient light; the first is on line 9",
        ),
        ("#cellray sky 1 1", "9: sky blue is missing"),
        ("#cellray sky 1 1 1 0 0", "9: sky z is missing"),
        ("#cellray sky 1 1 1 0 0 0", "9: the direction to the zenith is 0 0 0"),
        ("#cellray sky 1 1 1\n#cellray sky 0 0 1", "10: a second sky; the first is on line 9"),
        ("#cellray daylight 1", "9: daylight is followed by `1`, which does not belong there"),
        ("#cellray daylight\n\n#cellray daylight", "11: a second daylight; the first is on line 9"),
        ("#cellray sun 1 1", "9: sun z is missing"),
        ("#cellray sun 0 -0 0", "9: the direction to the sun is 0 0 0"),
        ("#cellray sun 0 0 1 1", "9: light green is missing"),
        ("#cellray sun 0 0 nan", "9: sun z `nan` is not a finite number"),
        ("#cellray fog 1 1 1", "9: fog density is missing"),
        ("#cellray fog 1 1 1 -1", "9: fog density -1 is negative"),
        ("#cellray fog 1 1 1 1\n#cellray fog 1 1 1 1", "10: a second fog; the first is on line 9"),
        ("#cellray heights", "9: height map file is missing"),
        ("#cellray heights a.png 1 -1", "9: height map unit -1 is not above 0"),
        (
            "#cellray heights a.png 1 1\n#cellray heights b.png 1 1",
            "10: a second height map; the first is on line 9",
        ),
        ("#cellray shader", "9: name of the shader is missing"),
        ("#cellray shader flat 1", "9: shader is followed by `1`, which does not belong there"),
        ("#cellray shader checker 1 1 1", "9: checker size is missing"),
        ("#cellray shader checker 1 1 1 0", "9: checker size 0 is not above 0"),
        ("#cellray shader portal 1 2", "9: portal z is missing"),
        ("#cellray shader depth 2 2", "9: depth far 2 is not more than near 2"),
        (
            "#cellray shader 2rings",
            "9: shader `2rings` is not a name: letters, digits and _, a letter first",
        ),
        (
            "#cellray shader rings 1 2 3 4 5",
            "9: shader is followed by `5`, which does not belong there",
        ),
        ("#cellray shader rings one", "9: parameter of the shader `one` is not a number"),
        (
            "#cellray shader flat\n#cellray shader phong",
            "10: a second shader of this material; the first is on line 9",
        ),
        (
            "p 3\n0 0 0\n#cellray sun 0 0 1",
            "11: vertex x of the polygon that starts on line 9 is missing: found `#cellray` instead",
        ),
    ] {
        assert_eq!(refusal(rest), format!("t.nff:{message}"), "{rest}");
    }
    let bare = scene_text("#cellray shader flat").replace("f 1 1 1 1 0 0 0 1", "");
    assert_eq!(
        try_parse(bare.as_bytes()).expect_err("refused").to_string(),
        "t.nff:9: shader before the first material (f)"
    );
}
