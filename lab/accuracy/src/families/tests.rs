//! The families match their descriptions.

use super::*;
use crate::space::{dot, sub};
use crate::truth::sphere::Sphere;

const SPHERES: usize = 6;

fn family(name: &str) -> &'static Family {
    FAMILIES.iter().find(|family| family.name == name).unwrap()
}

/// For every ray: its line, its shot, and the distance from the centre at which it passes, in
/// radii.
fn rays(family: &Family, form: Form) -> Vec<(Line, Shot, f64)> {
    let shots = family.shots(form, 3, SPHERES);
    let each = |shot: &Shot| {
        let sphere = Sphere::of_radius(shot.centre, shot.radius);
        let near = |line: &Line| (1.0 + 2.0 * sphere.passing(line).beyond).sqrt();
        shot.lines().map(|line| (line, shot.clone(), near(&line))).collect::<Vec<_>>()
    };
    shots.iter().flat_map(each).collect()
}

fn distance(line: &Line, shot: &Shot) -> f64 {
    let to = sub(shot.centre(), line.origin);
    dot(to, to).sqrt()
}

#[test]
fn names_are_unique_and_every_form_has_rays() {
    for family in FAMILIES {
        let same = FAMILIES.iter().filter(|other| other.name == family.name);
        assert_eq!(same.count(), 1, "{}", family.name);
        for &form in family.forms {
            let shots = family.shots(form, 1, 2);
            assert!(shots.iter().all(|shot| shot.packets.len() == PACKETS));
            let eye = shots.iter().flat_map(|shot| &shot.packets).flatten();
            if form == Form::Eye {
                assert!(eye.into_iter().all(|ray| ray.origin == [0; 3]));
            }
        }
    }
}

#[test]
fn directions_have_length_1_unless_general() {
    for family in FAMILIES {
        for &form in family.forms {
            let lengths: Vec<f64> = rays(family, form)
                .iter()
                .map(|(line, ..)| dot(line.direction, line.direction).sqrt())
                .collect();
            let off = |length: &f64| (length - 1.0).abs();
            if family.any_length {
                assert!(lengths.iter().any(|length| *length < 0.1));
                assert!(lengths.iter().any(|length| *length > 10.0));
                assert!(lengths.iter().all(|length| (0.062..16.001).contains(length)));
            } else {
                assert!(lengths.iter().all(|length| off(length) < 2_f64.powi(-23)));
            }
        }
    }
}

#[test]
fn ratios_are_distances_over_radii_and_half_the_rays_miss() {
    for family in FAMILIES.iter().filter(|family| family.ratio.is_some()) {
        let ratio = family.ratio.unwrap();
        for &form in family.forms {
            let rays = rays(family, form);
            for (line, shot, near) in &rays {
                let found = distance(line, shot) / shot.radius();
                assert!((found / ratio - 1.0).abs() < 1e-5, "{}: {found}", family.name);
                assert!(*near < 2.0 + ratio * 2_f64.powi(-21), "{}: {near}", family.name);
            }
            let hits = rays.iter().filter(|(.., near)| *near < 1.0).count();
            assert!((rays.len() / 8..rays.len() / 2).contains(&hits), "{hits}");
        }
    }
}

#[test]
fn grazing_rays_pass_near_the_edge_on_both_sides() {
    let near: Vec<f64> =
        rays(family("grazing"), Form::Eye).into_iter().map(|(.., near)| near).collect();
    assert!(near.iter().all(|near| (0.99899..1.00101).contains(near)));
    assert!(near.iter().any(|near| *near < 0.9995));
    assert!(near.iter().any(|near| *near > 1.0005));
}

#[test]
fn origins_match_family_names() {
    for (line, shot, _) in rays(family("inside"), Form::General) {
        assert!(distance(&line, &shot) < 0.5001 * shot.radius());
    }
    for radius in ["1e4", "1e5", "1e6"] {
        for (line, shot, _) in rays(family(&format!("ground {radius}")), Form::General) {
            assert_eq!(shot.radius(), radius.parse::<f64>().unwrap());
            let height = distance(&line, &shot) - shot.radius();
            assert!((0.8..100.2).contains(&height), "{height}");
        }
    }
    for (line, shot, _) in rays(family("tiny"), Form::Eye) {
        assert!((0.0005..0.002).contains(&shot.radius()));
        assert!((distance(&line, &shot) - 1e3).abs() < 0.01);
    }
}

#[test]
fn coherent_packets_have_one_origin_and_incoherent_ones_sixteen() {
    let origins = |name: &str| {
        let shots = family(name).shots(Form::General, 4, 1);
        let mut origins = shots[0].packets[0].map(|ray| ray.origin).to_vec();
        origins.sort_unstable();
        origins.dedup();
        origins.len()
    };
    assert_eq!((origins("coherent"), origins("incoherent")), (1, 16));
}

#[test]
fn families_depend_on_seed_alone() {
    let first = |seed| family("ratio 16").shots(Form::Eye, seed, 1)[0].centre;
    assert_eq!(first(1), first(1));
    assert_ne!(first(1), first(2));
}
