//! primary rays get the very bits of a formulation's eye form from its general form: what is
//! measured of the one holds of the other.

use rand::{Rng as _, SeedableRng as _};
use rand_chacha::ChaCha8Rng;
use spu_emulator::float::single::from_f64;
use twins::FARTHEST;
use twins::pairs::Sides;
use twins::sphere::{
    Estimate, Eye, General, Interpolated, Newton2, Paper, Perpendicular, Refined, Stable,
    Unnormalised,
};
use twins::sphere_pairs::SphereObject;
use twins::sphere_ray::{BareSphere, Ray};

const FRONT: Sides = Sides { both: false, exit: false };

fn forms_agree<F: General + Eye<Sphere = BareSphere>>() {
    let mut random = ChaCha8Rng::seed_from_u64(31);
    let mut hits = 0;
    for _ in 0..20_000 {
        // Of so few digits that its square is a single.
        let radius = f64::from(random.random_range(1..2048_u32)) / 1024.0;
        let distance = radius * f64::from(1_u32 << random.random_range(1..20_u32));
        let mut near = |size: f64| size * random.random_range(-1.0..1.0);
        let centre = [near(distance), near(distance), -distance];
        let target = centre.map(|place| place + near(2.0 * radius));
        let length = target.iter().map(|place| place * place).sum::<f64>().sqrt();
        let direction = target.map(|place| from_f64(place / length));
        let centre = centre.map(from_f64);
        let ray = Ray { origin: [0; 3], direction, t: FARTHEST, object: 0 };
        let sphere = SphereObject { centre, offset: from_f64(radius), sides: FRONT };
        let bare = BareSphere { centre, radius_squared: from_f64(radius * radius) };
        let (general, eye) = (F::crossing(&ray, &sphere), F::entry(direction, &bare));
        assert_eq!(general.outside >> 31, eye.outside >> 31);
        if eye.outside >> 31 == 0 {
            assert_eq!(general.t, eye.t, "{ray:x?} {sphere:x?}");
            hits += 1;
        }
    }
    assert!(hits > 1000, "only {hits} hits");
}

#[test]
fn both_forms_of_a_formulation_give_the_same_bits() {
    forms_agree::<Paper>();
    forms_agree::<Perpendicular>();
    forms_agree::<Estimate>();
    forms_agree::<Interpolated>();
    forms_agree::<Newton2>();
    forms_agree::<Stable>();
    forms_agree::<Refined>();
    forms_agree::<Unnormalised>();
}
