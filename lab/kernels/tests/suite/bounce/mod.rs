//! `refract_r16` and `reflect_r16`: their limits, and their results compared with `f64`.

use kernels::cases::whitted::bounce::{Hits, Sites, hit, off, reflected, refracted};
use kernels::prelude::*;
use kernels::source::Source;
use twins::bounce::{Bounce, CHAIN_STEP, Limits, Queued};

/// Runs both kernels on a packet of hits, each separately, and compares with the twins. Returns the
/// refracted and the reflected rays.
fn check(bench: &mut Bench, random: &mut impl Rng, packet: [Bounce; 16]) -> [Vec<Queued>; 2] {
    check_within(Limits::NONE, bench, random, packet)
}

/// The same with limits.
fn check_within(
    limits: Limits,
    bench: &mut Bench,
    random: &mut impl Rng,
    packet: [Bounce; 16],
) -> [Vec<Queued>; 2] {
    let (packets, junk) = (vec![packet], random.random());
    let (through, _) = Hits::<true> { packets: packets.clone(), limits, junk }.check(bench);
    let (thrown_back, _) = Hits::<false> { packets, limits, junk }.check(bench);
    [through, thrown_back]
}

#[test]
fn rays_below_min_weight_are_not_sent_on() {
    let mut random = random();
    let mut bench = Bench::new();
    let (mut all, mut sent) = ([0; 2], [0; 2]);
    for _ in 0..200 {
        let packet: [Bounce; 16] = std::array::from_fn(|_| hit(&mut random));
        let minimum = random.random_range(0.0..1.0);
        let limits = Limits { min_weight: from_f64(minimum), ..Limits::NONE };
        let found = check_within(limits, &mut bench, &mut random, packet);
        let light = |ray: &Queued| to_f64(ray.weight) < to_f64(from_f64(minimum));
        assert!(!found.iter().flatten().any(light), "{minimum}: {found:x?}");
        let open = check(&mut bench, &mut random, packet);
        for kernel in 0..2 {
            let heavy = open[kernel].iter().filter(|ray| !light(ray));
            assert!(heavy.eq(&found[kernel]), "{minimum}: {packet:x?}");
            all[kernel] += open[kernel].len();
            sent[kernel] += found[kernel].len();
        }
    }
    let distinguished = (0..2).all(|kernel| sent[kernel] > 100 && all[kernel] > sent[kernel] + 100);
    assert!(distinguished, "{sent:?} of {all:?} rays");
}

#[test]
fn the_last_ray_of_a_chain_sends_none() {
    let mut random = random();
    let mut bench = Bench::new();
    let mut sent = [0; 2];
    for _ in 0..200 {
        let packet: [Bounce; 16] = std::array::from_fn(|_| hit(&mut random));
        let limits = Limits { deepest: random.random_range(0..16) * CHAIN_STEP, ..Limits::NONE };
        let found = check_within(limits, &mut bench, &mut random, packet);
        let open = check(&mut bench, &mut random, packet);
        for kernel in 0..2 {
            let short = |ray: &&Queued| ray.pixel < limits.deepest + CHAIN_STEP;
            let expected = open[kernel].iter().filter(short);
            assert!(expected.eq(&found[kernel]), "{limits:?}: {packet:x?}");
            sent[kernel] += found[kernel].len();
        }
    }
    assert!(sent.iter().all(|sent| *sent > 100), "{sent:?} rays");
}

/// The header's first number holds for every component, and lengths are within 2 ulp of 1.
#[test]
fn keep_their_error_bounds() {
    let mut random = random();
    let mut bench = Bench::new();
    let mut worst = [0.0_f64; 2];
    let (mut length, mut share, mut compared) = (0.0_f64, 0.0_f64, [0; 2]);
    for _ in 0..2000 {
        let packet: [Bounce; 16] =
            std::array::from_fn(|lane| Bounce { pixel: lane as u32, ..hit(&mut random) });
        let found = check(&mut bench, &mut random, packet);
        for (kernel, queued) in found.iter().enumerate() {
            for ray in queued {
                let hit = &packet[(ray.pixel - CHAIN_STEP) as usize];
                let [x, y, z] = ray.direction.map(to_f64);
                let ulps = ((x * x + y * y + z * z).sqrt() - 1.0).abs() * 2_f64.powi(23);
                length = length.max(ulps);
                let exact = [refracted(hit), reflected(hit)][kernel];
                if let Some((exact, part)) = exact {
                    compared[kernel] += 1;
                    worst[kernel] = worst[kernel].max(off(ray, exact));
                    let found = to_f64(ray.weight) / to_f64(hit.weight);
                    share = share.max((found - part).abs());
                }
            }
        }
    }
    println!("worst {worst:?} ulp, length {length}, share {share:e} of {compared:?}");
    for (kernel, worst) in ["refract_r16", "reflect_r16"].iter().zip(worst) {
        let header = Source::find(kernel).and_then(Source::header);
        let stated = header.and_then(|header| header.stated_error());
        assert!(stated.is_some_and(|stated| worst <= stated), "{kernel}: {worst}");
    }
    assert!(length <= 2.0, "a length is {length} ulp off 1");
    assert!(share <= 1e-5, "a share is {share} off");
    assert!(compared.iter().all(|count| *count > 5000), "{compared:?}");
}

/// Near total reflection, the square of the cosine has an error of some ulps of 1, so the cosine
/// has an error of many ulps.
#[test]
fn keeps_its_error_near_the_critical_angle() {
    const STATED: f64 = 2.0;
    const UNDECIDED: f64 = 16.0;
    let ulp = 2_f64.powi(-23);
    let mut random = random();
    let mut bench = Bench::new();
    let (mut worst, mut compared, mut undecided) = (0.0_f64, 0, 0);
    for _ in 0..1000 {
        let packet: [Bounce; 16] = std::array::from_fn(|lane| {
            let ratio: f64 = random.random_range(1.05..4.0);
            let beyond = random.random_range(1e-4..0.1_f64);
            let sine = (1.0 + beyond * beyond * if random.random() { 1.0 } else { -1.0 }).sqrt();
            Bounce { pixel: lane as u32, ..on_plane((1.0 - (sine / ratio).powi(2)).sqrt(), ratio) }
        });
        let [through, _] = check(&mut bench, &mut random, packet);
        for (pixel, hit) in (0..).zip(&packet) {
            let [x, y, z] = hit.direction.map(to_f64);
            let ratio = to_f64(hit.ratio);
            let sine = ratio * (x * x / (x * x + y * y + z * z)).sqrt();
            let squared = 1.0 - sine * sine;
            let found = through.iter().find(|ray| ray.pixel == pixel + CHAIN_STEP);
            if squared.abs() < UNDECIDED * ulp {
                undecided += 1;
                continue;
            }
            assert_eq!(found.is_some(), squared > 0.0, "{hit:x?}");
            if let Some(ray) = found {
                compared += 1;
                let cosine = squared.sqrt();
                worst = worst.max(off(ray, [sine, 0.0, -cosine]) * cosine);
            }
        }
    }
    println!("worst {worst} ulp over the cosine of {compared}, {undecided} undecided");
    assert!(worst <= STATED, "{worst} ulp over the cosine");
    assert!(compared > 5000, "only {compared} compared");
}

/// A hit on a plane that faces +z, by a ray with this cosine in the plane of x and z.
fn on_plane(cosine: f64, ratio: f64) -> Bounce {
    let sine = (1.0 - cosine * cosine).sqrt();
    let up = [0.0, 0.0, 1.0].map(from_f64);
    Bounce {
        direction: [sine, 0.0, -cosine].map(from_f64),
        weight: from_f64(0.5),
        pixel: 0x1230,
        point: [4.0, 5.0, 6.0].map(from_f64),
        normal: up,
        plane: up,
        leave: from_f64(0.125),
        mirror: 0,
        transmittance: from_f64(0.75),
        ratio: from_f64(ratio),
        schlick: 0,
        grazing: 0,
    }
}

/// The refracted and the reflected ray of one hit, with the kernels called in the driver's order.
fn follow(hit: Bounce) -> [Option<Queued>; 2] {
    let mut bench = Bench::new();
    let mut random = random();
    let nothing = Bounce { mirror: 0, transmittance: 0, ..hit };
    // Only lane 6.
    let mut packet = [nothing; 16];
    packet[6] = hit;
    bench.reset();
    let sites = Sites::put(&mut bench, &[packet], &mut random);
    ["refract_r16", "reflect_r16"].map(|kernel| {
        let end = bench.call(kernel, &sites.arguments(Limits::NONE)).value;
        let queued = sites.queued(&bench, end);
        assert!(queued.len() <= 1, "{queued:?}");
        queued.first().copied()
    })
}

#[test]
fn critical_grazing_and_head_on() {
    // From glass with index 1.5, the critical sine is 2/3, and the cosine is sqrt(5)/3.
    let critical = 5_f64.sqrt() / 3.0;
    for (cosine, total) in [(critical + 1e-5, false), (critical - 1e-5, true)] {
        let [through, back] = follow(on_plane(cosine, 1.5));
        assert_eq!(through.is_none(), total, "{cosine}");
        assert_eq!(back.is_some(), total, "{cosine}");
        if let Some(back) = back {
            assert_eq!(to_f64(back.weight), 0.5 * 0.75);
            assert!((to_f64(back.direction[2]) - cosine).abs() < 1e-6);
            assert!((6.125..6.13).contains(&to_f64(back.origin[2])));
        }
    }
    // Perpendicular incidence goes straight on, at any ratio.
    for ratio in [0.5, 1.0, 2.0] {
        let [through, back] = follow(on_plane(1.0, ratio));
        let through = through.expect("a ray");
        assert!(off(&through, [0.0, 0.0, -1.0]) <= 1.0, "{through:x?}");
        assert!((5.87..=5.875).contains(&to_f64(through.origin[2])));
        assert_eq!(through.pixel, 0x1230 + CHAIN_STEP);
        assert_eq!(back, None);
    }
    // Almost parallel to the surface, Schlick's formula reflects almost everything.
    let grazing =
        Bounce { schlick: from_f64(0.04), grazing: from_f64(0.96), ..on_plane(1e-3, 1.0 / 1.5) };
    let [through, back] = follow(grazing).map(|ray| ray.expect("a ray"));
    let (through, back) = (to_f64(through.weight), to_f64(back.weight));
    assert!((through + back - 0.375).abs() < 1e-6, "{through}, {back}");
    assert!(through < 0.002, "{through}");
}

/// On a patch, a normal that leans too far would send rays to the wrong side. The plane's normal
/// is used there.
#[test]
fn leaning_normals_give_way_to_the_plane() {
    let leaning = [0.8, 0.0, 0.6].map(from_f64);
    let mirror =
        Bounce { normal: leaning, mirror: from_f64(1.0), transmittance: 0, ..on_plane(0.3, 1.0) };
    // With the leaning normal, the ray would be reflected into the surface.
    let away = Bounce { normal: [-0.8, 0.0, 0.6].map(from_f64), ..mirror };
    let [_, back] = follow(away);
    let back = back.expect("a ray").direction.map(to_f64);
    assert!(back[2] > 0.0, "{back:?}");
    let refracting = Bounce {
        mirror: 0,
        transmittance: from_f64(1.0),
        ratio: from_f64(0.4),
        direction: [-0.9, 0.0, -(0.19_f64.sqrt())].map(from_f64),
        normal: [0.99, 0.0, (1.0_f64 - 0.99 * 0.99).sqrt()].map(from_f64),
        ..mirror
    };
    let [through, _] = follow(refracting);
    let through = through.expect("a ray").direction.map(to_f64);
    assert!(through[2] < 0.0, "{through:?}");
}
