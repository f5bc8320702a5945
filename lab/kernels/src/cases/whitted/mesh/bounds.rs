//! The kernels that bound the rays of packets for boxes.

use twins::mesh::{MeshBound, mesh_bound, mesh_farthest};
use twins::mesh_rows::{mesh_eye_bound, mesh_eye_bound_of_all, mesh_window};
use twins::primary_rays::Ray;
use twins::sphere_ray;

use super::call::{bound, bound_record, window_record};
use super::triangles::aimed;
use crate::cases::whitted::isect;
use crate::cases::whitted::rays::bounds::any_fan;
use crate::cases::whitted::rays::call::put_packets;
use crate::prelude::*;
use protocol::layout::{MeshWindow, Shear};

/// Packets of rays from anywhere, which are bounded.
#[derive(Clone, Debug)]
pub struct Bounds {
    /// The packets.
    pub packets: Vec<[Ray; 16]>,
    /// Where their shears are said to be.
    pub shears: u32,
}

impl Description for Bounds {
    const KERNEL: &'static str = "mesh_bounds_r16";
    const ROUNDS: [usize; 2] = [40, 1000];
    const LENGTHS: &'static [usize] = LENGTHS_FROM_0;
    type Placed = Place;
    /// The bounds, each with the address of its shears.
    type Found = Vec<(MeshBound, u32)>;

    fn sensible(count: usize, random: &mut ChaCha8Rng) -> Self {
        Self { packets: (0..count).map(|_| any_fan(random)).collect(), shears: 0x1_2340 }
    }

    fn any(_: usize, random: &mut ChaCha8Rng) -> Self {
        Self { packets: vec![any_bits(random)], shears: random.random_range(0..1 << 30) }
    }

    fn place(&self, bench: &mut Bench) -> (Place, Vec<u32>) {
        let packets = put_packets(bench, &self.packets);
        let count = self.packets.len();
        let bounds = put(bench, &vec![layout::MeshBound::new_zeroed(); count]);
        (bounds, vec![packets.address, count as u32, bounds.address, self.shears])
    }

    fn found(&self, bench: &Bench, placed: &Place, _: u32) -> Self::Found {
        bench.read_all(*placed).iter().map(bound).collect()
    }

    fn twin(&self, _: &Place) -> Self::Found {
        let shears = (self.shears..).step_by(size_of::<Shear>());
        self.packets.iter().map(mesh_bound).zip(shears).collect()
    }
}

/// Packets that have gone on since they were bounded.
#[derive(Clone, Debug)]
pub struct Farthest {
    /// The packets.
    pub packets: Vec<[Ray; 16]>,
    /// Their bounds, of other distances.
    pub bounds: Vec<MeshBound>,
}

/// Where the shears of these packets are said to be.
const SHEARS: u32 = 0x1_2340;

impl Description for Farthest {
    const KERNEL: &'static str = "mesh_farthest_r16";
    const ROUNDS: [usize; 2] = Bounds::ROUNDS;
    const LENGTHS: &'static [usize] = Bounds::LENGTHS;
    type Placed = Place;
    type Found = Vec<(MeshBound, u32)>;

    fn sensible(count: usize, random: &mut ChaCha8Rng) -> Self {
        let Bounds { packets, .. } = Bounds::sensible(count, random);
        Self { packets, bounds: (0..count).map(|_| mesh_bound(&any_fan(random))).collect() }
    }

    fn any(_: usize, random: &mut ChaCha8Rng) -> Self {
        Self { packets: vec![any_bits(random)], bounds: vec![mesh_bound(&any_bits(random))] }
    }

    fn place(&self, bench: &mut Bench) -> (Place, Vec<u32>) {
        let packets = put_packets(bench, &self.packets).address;
        let before: Vec<_> = self.bounds.iter().map(|it| bound_record(it, SHEARS)).collect();
        let bounds = put(bench, &before);
        (bounds, vec![packets, before.len() as u32, bounds.address])
    }

    fn found(&self, bench: &Bench, placed: &Place, _: u32) -> Self::Found {
        bench.read_all(*placed).iter().map(bound).collect()
    }

    fn twin(&self, _: &Place) -> Self::Found {
        let each = self.packets.iter().zip(&self.bounds);
        each.map(|(rays, bound)| (MeshBound { farthest: mesh_farthest(rays), ..*bound }, SHEARS))
            .collect()
    }
}

type Bound = Bits<layout::MeshBound>;

/// Packets from the eye, which are bounded.
#[derive(Clone, Debug)]
pub struct EyeBounds {
    /// The packets.
    pub packets: Vec<[sphere_ray::Ray; 16]>,
}

impl Description for EyeBounds {
    const KERNEL: &'static str = "mesh_eye_bounds_r16";
    const ROUNDS: [usize; 2] = [33, 100];
    const LENGTHS: &'static [usize] = &[0, 1, 2, 3, 4, 5, 6, 7, 8];
    const SHARES: [Range<f64>; 2] = [0.01..0.9, ANY_SHARE];
    type Placed = [Place; 2];
    /// Those of the packets, and after the last window the bound of them all.
    type Found = (Vec<(Bound, Bits<MeshWindow>)>, Option<Bound>);

    fn sensible(count: usize, random: &mut ChaCha8Rng) -> Self {
        Self { packets: aimed(random).1[..count].to_vec() }
    }

    fn any(count: usize, random: &mut ChaCha8Rng) -> Self {
        Self { packets: (0..count).map(|_| any_bits(random)).collect() }
    }

    fn place(&self, bench: &mut Bench) -> ([Place; 2], Vec<u32>) {
        let packets = put(bench, &isect::call::packets(&self.packets, 0)).address;
        let count = self.packets.len();
        let bounds = put(bench, &vec![layout::MeshBound::new_zeroed(); count]);
        let of_all = if count > 0 { size_of::<layout::MeshBound>() } else { 0 };
        let windows = bench.place(&vec![0; count * size_of::<MeshWindow>() + of_all]);
        let arguments = vec![packets, count as u32, bounds.address, SHEARS, windows.address];
        ([bounds, windows], arguments)
    }

    fn found(&self, bench: &Bench, &[bounds, windows]: &[Place; 2], _: u32) -> Self::Found {
        let bounds = bench.read_all(bounds).into_iter().map(Bits);
        let bytes: Vec<u8> = bench.read_all(windows);
        let length = self.packets.len() * size_of::<MeshWindow>();
        let (windows, of_all) = bytes.split_at(length);
        let windows = windows.chunks(size_of::<MeshWindow>());
        let windows = windows.filter_map(|bytes| MeshWindow::read_from_bytes(bytes).ok()).map(Bits);
        (bounds.zip(windows).collect(), layout::MeshBound::read_from_bytes(of_all).ok().map(Bits))
    }

    fn twin(&self, _: &[Place; 2]) -> Self::Found {
        let each = self.packets.iter().zip((SHEARS..).step_by(size_of::<Shear>()));
        let each = each.map(|(rays, shears)| {
            let window = window_record(&mesh_window(rays));
            (Bits(bound_record(&mesh_eye_bound(rays), shears)), Bits(window))
        });
        let after = SHEARS + (self.packets.len() * size_of::<Shear>()) as u32;
        let of_all = bound_record(&mesh_eye_bound_of_all(&self.packets), after);
        (each.collect(), (!self.packets.is_empty()).then_some(Bits(of_all)))
    }

    /// How many windows have no limits.
    fn part(&self, _: &Self::Found) -> [usize; 2] {
        let wide = |rays: &&[_; 16]| mesh_window(rays).rows[0].low[0] == u32::MAX;
        [self.packets.iter().filter(wide).count(), self.packets.len()]
    }
}
