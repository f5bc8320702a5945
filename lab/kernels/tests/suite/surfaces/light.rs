//! `shadow_rays_r16`, `lambert_r16`, `light_r16`, `ambient_r16`.

use kernels::bench::{Bench, random};
use kernels::cases::whitted::shade::call::{self, Site};
use kernels::cases::whitted::shade::error::{any_light, any_shining_site, any_site, light_up_to};
use kernels::cases::whitted::shade::records;
use kernels::description::any_bits;
use protocol::layout::Surfaces;
use rand::Rng as _;
use rand_chacha::ChaCha8Rng;
use spu_emulator::float::single::{from_f64, to_f64};
use twins::light::{ambient, highlight, light};
use twins::shadow_rays::{NOT_THERE, Place, shadow_ray};
use twins::surfaces::{Ray, Surface};
use twins::{FARTHEST, ONE, Single};

use super::{COUNTS, assert_same};

/// The material addresses that the calls pass.
const MATERIALS: [u32; 16] = [0x5555_5555; 16];

/// Compares the packets of sites in which some lane has a ray; the others have none. Returns the
/// number of rays, and of packets.
fn check_shadow_rays(
    bench: &mut Bench,
    sites: &[Site],
    place: &Place,
    min_share: Single,
) -> [usize; 2] {
    let found = call::shadow_rays(bench, sites, place, min_share);
    let expected: Vec<[Ray; 16]> = sites
        .iter()
        .map(|site| {
            std::array::from_fn(|lane| {
                let (surface, normal) = (&site.surfaces[lane], site.normals[lane]);
                shadow_ray(surface, normal, site.weights[lane], place, min_share)
            })
        })
        .collect();
    let with_rays: Vec<usize> = (0..sites.len())
        .filter(|site| expected[*site].iter().any(|ray| ray.t != NOT_THERE))
        .collect();
    assert_eq!(found.sites, with_rays, "sites with rays");
    for (number, packet) in with_rays.iter().zip(&found.packets) {
        for (lane, found) in packet.iter().enumerate() {
            let expected = &expected[*number][lane];
            assert_eq!(
                (found.origin, found.direction, found.t),
                (expected.origin, expected.direction, expected.t),
                "{:x?}, {place:x?}",
                sites[*number].surfaces[lane]
            );
        }
    }
    let lanes = expected.iter().flatten();
    let count = lanes.filter(|ray| ray.t != NOT_THERE).count();
    assert_eq!(found.count as usize, count, "shadow rays");
    let shining = with_rays.iter().filter(|site| sites[**site].shines).count();
    assert_eq!(found.shining as usize, shining, "sites that shine");
    [count, with_rays.len()]
}

/// Compares whole records: only the light that is sent back may change.
fn check_lit(found: &[Surfaces], sites: &[Site], expected: impl Fn(&Site, usize) -> [Single; 3]) {
    for (site, found) in sites.iter().zip(found) {
        let lanes = std::array::from_fn(|lane| Surface {
            lit: expected(site, lane),
            ..site.surfaces[lane]
        });
        let record = records::surfaces(&lanes, &site.normals, MATERIALS);
        assert_same(found, &record, &format!("{site:x?}"));
    }
}

fn check_light(bench: &mut Bench, sites: &[Site], brightness: [Single; 3]) {
    for kernel in ["light_r16", "lambert_r16"] {
        let found = call::light(bench, kernel, sites, brightness);
        check_lit(&found, sites, |site, lane| {
            let (ray, blocked) = &site.shadow[lane];
            let shines = kernel == "light_r16";
            light(
                &site.surfaces[lane],
                site.normals[lane],
                shines.then_some(site.directions[lane]),
                ray.direction,
                *blocked || ray.t >> 31 != 0,
                brightness,
            )
        });
    }
    let found = call::ambient(bench, sites, brightness);
    check_lit(&found, sites, |site, lane| ambient(&site.surfaces[lane], brightness));
}

#[test]
fn sites_equal_the_twins_in_lists_of_any_length() {
    let mut random = random();
    let mut bench = Bench::new();
    let (mut rays, mut packets, mut all) = (0, 0, 0);
    for _ in 0..20 {
        for count in COUNTS {
            let place = any_light(&mut random);
            let mut site = || {
                let mut site = any_site(&mut random, &place, 4096.0);
                // In some sites no lane is lit.
                let dark = random.random_ratio(1, 3);
                for surface in &mut site.surfaces {
                    if dark || random.random_ratio(1, 4) {
                        (surface.diffuse, surface.highlight) = (0, 0);
                    }
                }
                site
            };
            let sites: Vec<Site> = (0..count).map(|_| site()).collect();
            let min_share = from_f64([0.0, 1e-3, 1e-1][random.random_range(0..3)]);
            let made = check_shadow_rays(&mut bench, &sites, &place, min_share);
            rays += made[0];
            packets += made[1];
            all += count;
            let shining: Vec<Site> =
                (0..count).map(|_| any_shining_site(&mut random, 4096.0)).collect();
            let brightness = [(); 3].map(|()| from_f64(random.random_range(0.0..2.0)));
            check_light(&mut bench, &shining, brightness);
        }
    }
    assert!(packets > all / 4 && packets < all, "{packets} of {all}");
    assert!(rays > all && rays < 8 * all, "{rays} of {}", 16 * all);
}

fn any_bits_of_a_site(random: &mut ChaCha8Rng) -> Site {
    Site {
        surfaces: any_bits(random),
        normals: random.random(),
        directions: random.random(),
        weights: random.random(),
        shines: random.random(),
        shadow: [(); 16].map(|()| (any_bits(random), random.random())),
    }
}

#[test]
fn any_bits_at_all_equal_the_twins() {
    let mut random = random();
    let mut bench = Bench::new();
    for _ in 0..500 {
        let sites = [(); 2].map(|()| any_bits_of_a_site(&mut random));
        let place = Place { position: random.random(), directional: random.random() };
        let min_share = if random.random() { random.random() } else { 0 };
        check_shadow_rays(&mut bench, &sites, &place, min_share);
        check_light(&mut bench, &sites, random.random());
    }
}

/// A surface in front of the eye that faces it.
fn facing() -> Surface {
    Surface {
        point: [0.0, 0.0, -4.0].map(from_f64),
        plane: [0.0, 0.0, 1.0].map(from_f64),
        leave: from_f64(0.001),
        colour: [from_f64(1.0); 3],
        diffuse: from_f64(0.5),
        highlight: from_f64(0.25),
        exponent: from_f64(20.0),
        mirror: 0,
        transmittance: 0,
        ratio: 0,
        schlick: 0,
        grazing: 0,
        lit: [0; 3],
        flags: 0,
    }
}

#[test]
fn shadow_rays_go_only_to_lights_ahead() {
    let surface = facing();
    let normal = surface.plane;
    let at = |position: [f64; 3]| Place { position: position.map(from_f64), directional: false };
    let there = |surface: &Surface, normal, place: &Place| {
        shadow_ray(surface, normal, ONE, place, 0).t != NOT_THERE
    };
    assert!(there(&surface, normal, &at([0.0; 3])));
    assert!(!there(&surface, normal, &at([1.0, 2.0, -4.0])), "beside");
    assert!(!there(&surface, normal, &at([0.0, 0.0, -5.0])), "behind the surface");
    assert!(!there(&surface, normal, &at([0.0, 0.0, -4.0])), "at the point");
    let turned = [-1.0, 0.0, 0.0].map(from_f64);
    let light = at([1.0, 0.0, 0.0]);
    assert!(!there(&surface, turned, &light), "on the other side of the normal");
    let averted = Surface { plane: turned, ..surface };
    assert!(!there(&averted, normal, &light), "behind the plane");
    let dark = Surface { diffuse: 0, highlight: 0, ..surface };
    assert!(!there(&dark, normal, &at([0.0; 3])), "not lit");
    for share in [Surface { diffuse: 0, ..surface }, Surface { highlight: 0, ..surface }] {
        assert!(there(&share, normal, &at([0.0; 3])));
    }
    let sun = Place { position: [0.0, 0.6, 0.8].map(from_f64), directional: true };
    let ray = shadow_ray(&surface, normal, ONE, &sun, 0);
    assert_eq!(ray.t, FARTHEST);
    for (found, exact) in ray.direction.into_iter().zip(sun.position) {
        assert!((to_f64(found) - to_f64(exact)).abs() <= 2.0 / f64::from(1 << 23));
    }
    assert_eq!(to_f64(ray.origin[2]), to_f64(from_f64(-4.0 + 0.001)));
}

/// A light in front of [`facing`] such that N.L is this cosine.
fn light_at(cosine: f64) -> Place {
    Place {
        position: [(1.0 - cosine * cosine).sqrt(), 0.0, cosine].map(from_f64),
        directional: true,
    }
}

#[test]
fn shadow_ray_below_min_share_is_omitted() {
    let surface = Surface { colour: [0.25, 0.5, 0.125].map(from_f64), ..facing() };
    let matt = Surface { highlight: 0, ..surface };
    // The OR of the channels' bits.
    let most = to_f64(surface.colour.into_iter().fold(0, |all, channel| all | channel));
    assert!((0.5..2.0).contains(&most), "{most}");
    let min_share = 1.0 / 4096.0;
    let there = |surface: &Surface, weight: f64, cosine: f64, min_share: f64| {
        let (weight, min_share) = (from_f64(weight), from_f64(min_share));
        let ray = shadow_ray(surface, surface.plane, weight, &light_at(cosine), min_share);
        ray.t != NOT_THERE
    };
    for cosine in [0.01, 0.1, 0.5, 0.9] {
        let lambert = 0.5 * cosine * most;
        for (surface, share) in [(&matt, lambert), (&surface, lambert + 0.25)] {
            let weight = min_share / share;
            assert!(there(surface, 1.01 * weight, cosine, min_share), "{cosine}");
            assert!(!there(surface, 0.99 * weight, cosine, min_share), "{cosine}");
            assert!(there(surface, 0.99 * weight, cosine, 0.9 * min_share));
        }
    }
    // Without a bound only what is not lit at all is left out, whatever the weight and the colour.
    let black = Surface { colour: [0; 3], ..matt };
    for surface in [&surface, &matt, &black] {
        assert!(there(surface, 0.0, 0.5, 0.0));
    }
    assert!(!there(&black, 1.0, 0.5, min_share));
    let dark = Surface { diffuse: 0, ..matt };
    assert!(!there(&dark, 1.0, 0.5, 0.0));
}

#[test]
fn light_kernels_agree_without_highlight() {
    let mut random = random();
    let mut bench = Bench::new();
    for _ in 0..100 {
        let mut site = any_shining_site(&mut random, 100.0);
        for surface in &mut site.surfaces {
            surface.highlight = 0;
        }
        let brightness = [(); 3].map(|()| from_f64(random.random_range(0.0..2.0)));
        let [a, b] = ["light_r16", "lambert_r16"]
            .map(|kernel| call::light(&mut bench, kernel, std::slice::from_ref(&site), brightness));
        assert_same(&a[0], &b[0], &format!("{site:x?}"));
    }
}

#[test]
fn highlights_are_powers_of_the_cosine() {
    let normal = [0.0, 0.0, 1.0].map(from_f64);
    let eye = [0.0, 0.0, -1.0];
    let power = |cosine: f64, exponent: f64| {
        // H bisects the angle between the light and the eye.
        let (sin, cos) = libm::sincos(2.0 * libm::acos(cosine));
        let to = [sin, 0.0, cos].map(from_f64);
        to_f64(highlight(normal, eye.map(from_f64), to, from_f64(exponent)))
    };
    for exponent in [0.25, 1.0, 2.0, 10.0, 100.0, 1000.0, 4096.0] {
        for step in 0..=1000 {
            let cosine = f64::from(step) / 1000.0 * (1.0 - 0.001) + 0.001;
            let error = (power(cosine, exponent) - libm::pow(cosine, exponent)).abs();
            let bound = if exponent > 1000.0 { 0.0015 } else { 0.0006 };
            assert!(error <= bound, "{cosine}^{exponent}: {error}");
        }
    }
    // 0^0 = 1.
    let across = [1.0, 0.0, 0.0].map(from_f64);
    let of = |exponent: f64| {
        let power = highlight(across, eye.map(from_f64), normal, from_f64(exponent));
        to_f64(power)
    };
    assert!((of(0.0) - 1.0).abs() <= 0.001);
    assert!(of(0.25) <= 0.001 && of(1.0) <= 0.001);
}

#[test]
fn the_highest_exponents_keep_their_bound() {
    let mut bench = Bench::new();
    let worst = light_up_to(&mut bench, &mut random(), "light_r16", 4096.0);
    println!("exponents to 4096: {worst:.5}");
    assert!(worst <= 0.0015, "{worst}");
}
