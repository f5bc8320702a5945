//! The kernels that bound the rays of packets.

use twins::bound::{Bound, bound, bound_fan};
use twins::primary_rays::Ray;

use super::call::{ANYTHING, bounds, put_bounds, put_packets};
use super::fans::{self, FANS, SCALES};
use crate::prelude::*;

/// A point where rays start or end.
#[derive(Clone, Copy, Debug)]
pub struct Point {
    /// The position.
    pub place: [Single; 3],
    /// The largest distance of the rays' ends from it.
    pub near: Single,
    /// 1 if rays start there, -1 if they end there.
    pub along: Single,
}

impl Point {
    /// The eye.
    pub const EYE: Self = Self { place: [ZERO; 3], near: ZERO, along: ONE };

    /// A point of random bits from which or to which rays go.
    pub fn any(random: &mut ChaCha8Rng) -> Self {
        let along = from_f64(if random.random() { 1.0 } else { -1.0 });
        Self { place: random.random(), near: random.random(), along }
    }
}

/// A packet of any relation in a scene of any scale.
pub fn any_fan(random: &mut ChaCha8Rng) -> [Ray; 16] {
    let scale = magnitude(SCALES, random);
    fans::packet(FANS[random.random_range(0..FANS.len())], scale, random)
}

fn any_fans(count: usize, random: &mut ChaCha8Rng) -> Vec<[Ray; 16]> {
    (0..count).map(|_| any_fan(random)).collect()
}

/// Packets of rays from or to a point.
#[derive(Clone, Debug)]
pub struct Fans {
    /// The packets.
    pub packets: Vec<[Ray; 16]>,
    /// The point.
    pub point: Point,
}

impl Description for Fans {
    const KERNEL: &'static str = "bound_fan_r16";
    const ROUNDS: [usize; 2] = [40, 1000];
    const LENGTHS: &'static [usize] = &[1, 2, 3, 7, 8, 40];
    type Placed = Place;
    type Found = Vec<Bound>;

    fn sensible(count: usize, random: &mut ChaCha8Rng) -> Self {
        Self { packets: any_fans(count, random), point: Point::any(random) }
    }

    fn any(_: usize, random: &mut ChaCha8Rng) -> Self {
        Self { packets: vec![any_bits(random)], point: Point::any(random) }
    }

    fn place(&self, bench: &mut Bench) -> (Place, Vec<u32>) {
        let Self { packets, point } = self;
        let records = put_packets(bench, packets);
        let bounds = put(bench, &vec![layout::Bound::new_zeroed(); packets.len()]);
        let light = layout::Light {
            position: point.place.map(single),
            falloff: ANYTHING.into(),
            brightness: [ANYTHING; 3].map(single),
            near: single(point.near),
        };
        let light = put(bench, &[light]).address;
        let count = packets.len() as u32;
        (bounds, vec![records.address, count, bounds.address, light, point.along])
    }

    fn found(&self, bench: &Bench, placed: &Place, _: u32) -> Vec<Bound> {
        bounds(bench, *placed)
    }

    fn twin(&self, _: &Place) -> Vec<Bound> {
        let Point { place, near, along } = self.point;
        self.packets.iter().map(|packet| bound_fan(packet, place, near, along)).collect()
    }
}

/// Packets of rays from anywhere, with the bounds that `bound_fan_r16` makes of them.
#[derive(Clone, Debug)]
pub struct Origins {
    /// The packets.
    pub packets: Vec<[Ray; 16]>,
}

impl Description for Origins {
    const KERNEL: &'static str = "bound_origins_r16";
    const ROUNDS: [usize; 2] = Fans::ROUNDS;
    const LENGTHS: &'static [usize] = Fans::LENGTHS;
    type Placed = Place;
    type Found = Vec<Bound>;

    fn sensible(count: usize, random: &mut ChaCha8Rng) -> Self {
        Self { packets: any_fans(count, random) }
    }

    fn any(_: usize, random: &mut ChaCha8Rng) -> Self {
        Self { packets: vec![any_bits(random)] }
    }

    fn place(&self, bench: &mut Bench) -> (Place, Vec<u32>) {
        let records = put_packets(bench, &self.packets);
        let fan = |packet| bound_fan(packet, [ANYTHING; 3], ANYTHING, ONE);
        let fans: Vec<Bound> = self.packets.iter().map(fan).collect();
        let bounds = put_bounds(bench, &fans);
        (bounds, vec![records.address, fans.len() as u32, bounds.address])
    }

    fn found(&self, bench: &Bench, placed: &Place, _: u32) -> Vec<Bound> {
        bounds(bench, *placed)
    }

    fn twin(&self, _: &Place) -> Vec<Bound> {
        self.packets.iter().map(bound).collect()
    }
}
