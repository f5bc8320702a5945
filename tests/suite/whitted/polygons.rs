//! Polygons that break the rules of NFF: their edges cross, or their vertices are not in a plane.

use crate::whitted::frame::{WHITTED, compared};

/// The maximum share of wrong pixels, including those on silhouettes.
const WRONG: f64 = 0.0015;

const PENTAGRAM: [[f64; 2]; 5] =
    [[0.0, 1.0], [-0.5878, -0.809], [0.9511, 0.309], [-0.9511, 0.309], [0.5878, -0.809]];

/// The polygon or patch with these corners. All of its normals lean outwards.
fn shape(keyword: &str, corners: &[[f64; 3]]) -> String {
    let mut text = format!("{keyword} {}\n", corners.len());
    for [x, y, z] in corners {
        text += &format!("{x} {y} {z}");
        text += &if keyword == "pp" { format!(" {x} {y} 2\n") } else { "\n".to_owned() };
    }
    text
}

/// Shapes above a mirror on which they cast shadows, lit from nearby. The `f` line of `material`
/// defines their material.
fn is_as_the_reference_has_it(what: &str, material: &str, shapes: &str) {
    let text = format!(
        "v\nfrom 1 -3 3.5\nat 0 0 0\nup 0 1 0\nangle 40\nhither 0\nresolution 200 150\nb 0.2 0.3 0.5\n\
         l 1 1 2\nl -3 1 4\nf 0.5 0.5 0.5 0.7 0.3 20 0 1\np 4\n-9 -9 -1\n9 -9 -1\n9 9 -1\n-9 9 -1\n\
         {material}\n{shapes}"
    );
    let scene = scenes::parse(text.as_bytes(), what, &scenes::Limits::default()).unwrap();
    let result = compared(&scene, WHITTED, (200, 150));
    println!("{what}, {material}: {result:?}");
    assert!(result.max_error_off_silhouette <= 2, "{what}: {result:?}");
    assert!(result.wrong_fraction <= WRONG, "{what}: {result:?}");
}

const MATERIALS: [&str; 3] = [
    "f 0.9 0.3 0.2 0.8 0.2 30 0 1",
    "f 0.9 0.3 0.2 0.8 0 1 0 1\n#cellray shader checker 0.1 0.2 0.9 0.3",
    "f 0.9 0.9 0.7 0.3 0.1 30 0.7 1.1",
];

#[test]
fn polygons_whose_edges_cross_are_filled_by_the_even_odd_rule() {
    let flat = |corners: &[[f64; 2]]| -> Vec<[f64; 3]> {
        corners.iter().map(|&[x, y]| [x, y, 0.0]).collect()
    };
    // Its second part is the smaller one and has the opposite orientation.
    let bow_tie = [[-1.0, -1.0], [1.0, 0.6], [1.0, -0.6], [-1.0, 1.0]];
    let twice = [PENTAGRAM, PENTAGRAM].concat();
    for material in MATERIALS {
        for keyword in ["p", "pp"] {
            for (what, corners) in [
                ("pentagram", &PENTAGRAM[..]),
                ("bow tie", &bow_tie),
                ("pentagram that is gone round twice", &twice),
            ] {
                let what = format!("{keyword}, a {what}");
                is_as_the_reference_has_it(&what, material, &shape(keyword, &flat(corners)));
            }
        }
    }
}

#[test]
fn non_planar_polygons_are_projected_into_a_plane() {
    let quad = [[-1.0, -1.0, 0.4], [1.0, -1.0, -0.2], [1.1, 1.0, 0.3], [-1.0, 0.9, -0.3]];
    let hexagon = [
        [1.0, 0.0, 0.2],
        [0.5, 0.9, -0.1],
        [-0.5, 0.9, 0.25],
        [-1.0, 0.0, 0.0],
        [-0.5, -0.9, 0.3],
        [0.5, -0.9, -0.2],
    ];
    let pentagram: Vec<[f64; 3]> =
        PENTAGRAM.iter().zip([0.2, -0.1, 0.0, 0.3, -0.3]).map(|(&[x, y], z)| [x, y, z]).collect();
    for material in MATERIALS {
        for keyword in ["p", "pp"] {
            for (what, corners) in
                [("quadrangle", &quad[..]), ("hexagon", &hexagon), ("pentagram", &pentagram)]
            {
                let what = format!("{keyword}, a bent {what}");
                is_as_the_reference_has_it(&what, material, &shape(keyword, corners));
            }
        }
    }
}
