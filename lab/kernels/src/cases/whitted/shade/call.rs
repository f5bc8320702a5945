//! Calls the surface kernels with the inputs of their twins.

use twins::accumulate::Share;
use twins::bounce::CHAIN_STEP;
use twins::surfaces::{Material, Object, Ray, Surface};
use twins::{Single, shadow_rays};
use zerocopy::big_endian::{F32, U32};
use zerocopy::{FromZeros as _, IntoBytes as _};

use super::records::{self, PacketRay};
use crate::bench::{self, Bench};
use crate::cases::eye::call::{address, put};
use crate::eye_records::pixel_shuffle;
use crate::single::{bits, single};
use protocol::layout::{self, RayPacket, SITE_SHINES, Surfaces, TILE_WIDTH};

/// The hit of a lane's ray. The object is a number, of which the first is the background.
#[derive(Clone, Copy, Debug)]
pub struct Hit {
    /// The ray.
    pub ray: Ray,
    /// The object's number.
    pub object: usize,
}

/// Calls `kernel` on packets of hits of these objects. Each object has the material with the given
/// number. Returns the surfaces, the materials' addresses, and the number of rays in each lane
/// that hit something.
pub fn surfaces(
    bench: &mut Bench,
    kernel: &str,
    hits: &[[Hit; 16]],
    objects: &[(Object, usize)],
    materials: &[Material],
) -> (Vec<Surfaces>, Vec<u32>, [u32; 4]) {
    bench.reset();
    let records: Vec<layout::Material> = materials.iter().map(records::material).collect();
    let material_place = put(bench, &records);
    let materials: Vec<u32> = (0..materials.len())
        .map(|number| address::<layout::Material>(material_place, number))
        .collect();
    let records: Vec<layout::Object> = objects
        .iter()
        .map(|(object, material)| records::object(object, materials[*material]))
        .collect();
    let objects = put(bench, &records);
    let packets: Vec<RayPacket> = hits
        .iter()
        .map(|packet| {
            records::rays(&packet.map(|hit| PacketRay {
                ray: hit.ray,
                object: address::<layout::Object>(objects, hit.object),
                // It has no effect.
                weight: u32::MAX,
                pixel: u32::MAX,
            }))
        })
        .collect();
    let rays = put(bench, &packets);
    let found = bench.place(&vec![0x55; size_of::<Surfaces>() * hits.len()]);
    let count = hits.len() as u32;
    let background = objects.address;
    bench.call(kernel, &[rays.address, count, found.address, background]);
    (bench.read_all(found), materials, bench.returned_vector())
}

/// Sixteen hits to be lit.
#[derive(Clone, Debug)]
pub struct Site {
    /// The surfaces.
    pub surfaces: [Surface; 16],
    /// The shading normals.
    pub normals: [[Single; 3]; 16],
    /// The directions of the rays that see them.
    pub directions: [[Single; 3]; 16],
    /// The weights of these rays.
    pub weights: [Single; 16],
    /// Whether some surface may have a highlight.
    pub shines: bool,
    /// The shadow rays, and whether each is blocked.
    pub shadow: [(Ray, bool); 16],
}

/// Sites in local store.
pub struct PlacedSites {
    list: bench::Place,
    surfaces: Vec<bench::Place>,
    background: bench::Place,
}

/// Fills the fields that have no meaning here.
const ANYTHING: u32 = 0x5555_5555;

fn packet_ray(ray: Ray, object: u32) -> PacketRay {
    PacketRay { ray, object, weight: ANYTHING, pixel: ANYTHING }
}

/// Puts sites into local store, each record between guards.
pub fn put_sites(bench: &mut Bench, sites: &[Site]) -> PlacedSites {
    let background = put(bench, &[layout::Object::new_zeroed()]);
    let mut placed = PlacedSites { list: background, surfaces: Vec::new(), background };
    let mut list = Vec::new();
    for site in sites {
        let surfaces = records::surfaces(&site.surfaces, &site.normals, [ANYTHING; 16]);
        let surfaces = put(bench, &[surfaces]);
        let seen: [PacketRay; 16] = std::array::from_fn(|lane| PacketRay {
            ray: Ray { origin: [ANYTHING; 3], direction: site.directions[lane], t: ANYTHING },
            object: ANYTHING,
            weight: site.weights[lane],
            pixel: ANYTHING,
        });
        let rays = put(bench, &[records::rays(&seen)]);
        list.push(layout::Site {
            surfaces: surfaces.address.into(),
            rays: rays.address.into(),
            shines: if site.shines { SITE_SHINES } else { 0 }.into(),
            unused: ANYTHING.into(),
        });
        placed.surfaces.push(surfaces);
    }
    placed.list = put(bench, &list);
    placed
}

/// A light's record.
#[must_use]
pub fn light_record(place: &shadow_rays::Place, brightness: [Single; 3]) -> layout::Light {
    layout::Light {
        position: place.position.map(single),
        directional: if place.directional { u32::MAX } else { 0 }.into(),
        brightness: brightness.map(single),
        near: single(ANYTHING),
    }
}

/// The arguments of `shadow_rays_r16`, and the places of the sites, of the packets and of the
/// listed sites.
pub fn shadow_arguments(
    bench: &mut Bench,
    sites: &[Site],
    place: &shadow_rays::Place,
    min_share: Single,
) -> (Vec<u32>, [bench::Place; 3]) {
    let placed = put_sites(bench, sites);
    let light = put(bench, &[light_record(place, [ANYTHING; 3])]);
    let packets = bench.place(&vec![0x55; size_of::<RayPacket>() * sites.len()]);
    let listed = bench.place(&vec![0x55; size_of::<layout::Site>() * sites.len()]);
    let arguments = vec![
        placed.list.address,
        sites.len() as u32,
        light.address,
        placed.background.address,
        min_share,
        packets.address,
        listed.address,
    ];
    (arguments, [placed.list, packets, listed])
}

/// Packets of shadow rays.
#[derive(Debug)]
pub struct ShadowRays {
    /// The numbers of their sites.
    pub sites: Vec<usize>,
    /// The rays.
    pub packets: Vec<[Ray; 16]>,
    /// The number of rays.
    pub count: u32,
    /// The number of sites that shine.
    pub shining: u32,
}

/// `shadow_rays_r16`: returns the rays to a light.
///
/// # Panics
///
/// Panics if a ray's object is not the background, if its weight or pixel has changed, or if a
/// listed site is not one of those given.
pub fn shadow_rays(
    bench: &mut Bench,
    sites: &[Site],
    place: &shadow_rays::Place,
    min_share: Single,
) -> ShadowRays {
    bench.reset();
    let (arguments, [given, packets, listed]) = shadow_arguments(bench, sites, place, min_share);
    bench.call("shadow_rays_r16", &arguments);
    let [end, count, shining, _] = bench.returned_vector();
    let listed_sites = (end - listed.address) as usize / size_of::<layout::Site>();
    let given = bench.read_all::<layout::Site>(given);
    let numbers = bench.read_all::<layout::Site>(listed)[..listed_sites]
        .iter()
        .map(|site| {
            let number = given.iter().position(|given| given.rays == site.rays);
            let number = number.expect("a site of the list");
            assert_eq!(site.as_bytes(), given[number].as_bytes());
            number
        })
        .collect();
    let background = arguments[3];
    let found = bench.read_all::<RayPacket>(packets);
    let rays = found[..listed_sites].iter().map(|packet| {
        records::packet_rays(packet).map(|lane| {
            let others = (lane.object, lane.weight, lane.pixel);
            assert_eq!(others, (background, ANYTHING, ANYTHING));
            lane.ray
        })
    });
    ShadowRays {
        sites: numbers,
        packets: rays.collect(),
        count,
        shining: shining / size_of::<layout::Site>() as u32,
    }
}

/// The arguments of `light_r16` and `lambert_r16`, and the places of the surfaces.
pub fn light_arguments(
    bench: &mut Bench,
    sites: &[Site],
    brightness: [Single; 3],
) -> (Vec<u32>, Vec<bench::Place>) {
    let placed = put_sites(bench, sites);
    let nowhere = shadow_rays::Place { position: [ANYTHING; 3], directional: false };
    let light = put(bench, &[light_record(&nowhere, brightness)]);
    let background = placed.background.address;
    let packets: Vec<RayPacket> = sites
        .iter()
        .map(|site| {
            records::rays(
                &site
                    .shadow
                    .map(|(ray, is_blocked)| packet_ray(ray, background + u32::from(is_blocked))),
            )
        })
        .collect();
    let packets = put(bench, &packets);
    let arguments =
        vec![placed.list.address, sites.len() as u32, light.address, background, packets.address];
    (arguments, placed.surfaces)
}

/// `kernel`, which is `light_r16` or `lambert_r16`: returns the surfaces after a light of this
/// brightness.
pub fn light(
    bench: &mut Bench,
    kernel: &str,
    sites: &[Site],
    brightness: [Single; 3],
) -> Vec<Surfaces> {
    bench.reset();
    let (arguments, surfaces) = light_arguments(bench, sites, brightness);
    bench.call(kernel, &arguments);
    surfaces.iter().map(|place| bench.read(*place)).collect()
}

/// `ambient_r16`: returns the surfaces after ambient light of this brightness.
pub fn ambient(bench: &mut Bench, sites: &[Site], [x, y, z]: [Single; 3]) -> Vec<Surfaces> {
    bench.reset();
    let records: Vec<Surfaces> = sites
        .iter()
        .map(|site| records::surfaces(&site.surfaces, &site.normals, [ANYTHING; 16]))
        .collect();
    let surfaces = put(bench, &records);
    let brightness = put(bench, &[[x, y, z, ANYTHING].map(single)]);
    let count = sites.len() as u32;
    let arguments = [surfaces.address, count, brightness.address];
    bench.call("ambient_r16", &arguments);
    bench.read_all(surfaces)
}

/// `accumulate_r16` on packets of shares: returns the sums before and after.
pub fn accumulate(
    bench: &mut Bench,
    packets: &[[Share; 16]],
    sums: &[[Single; 3]],
) -> Vec<[Single; 3]> {
    bench.reset();
    let quadwords: Vec<[F32; 4]> =
        sums.iter().map(|&[x, y, z]| [x, y, z, ANYTHING].map(single)).collect();
    let place = put(bench, &quadwords);
    let ray = Ray { origin: [ANYTHING; 3], direction: [ANYTHING; 3], t: ANYTHING };
    let mut rays = Vec::new();
    let mut surfaces = Vec::new();
    for shares in packets {
        // Rays of one pixel may come after any number of others.
        rays.push(records::rays(&std::array::from_fn(|lane| PacketRay {
            ray,
            object: ANYTHING,
            weight: shares[lane].weight,
            pixel: address::<[F32; 4]>(place, shares[lane].pixel) + lane as u32 * CHAIN_STEP,
        })));
        surfaces.push(records::lit_surfaces(&shares.map(|share| share.lit)));
    }
    let rays = put(bench, &rays);
    let surfaces = put(bench, &surfaces);
    let arguments = [rays.address, surfaces.address, packets.len() as u32];
    bench.call("accumulate_r16", &arguments);
    let after: Vec<[F32; 4]> = bench.read_all(place);
    let colours = after.iter().map(|&[x, y, z, _]| [x, y, z].map(bits));
    colours.collect()
}

/// `pack_sums`: returns the words of rows of sums, all of the same length, which is a multiple of
/// four.
///
/// # Panics
///
/// Panics if a row is longer than a tile.
pub fn pack_sums(bench: &mut Bench, rows: &[Vec<[Single; 3]>], shifts: [u32; 3]) -> Vec<u32> {
    bench.reset();
    let mut sums = vec![[single(ANYTHING); 4]; rows.len() * TILE_WIDTH as usize];
    for (row, sums) in rows.iter().zip(sums.chunks_mut(TILE_WIDTH as usize)) {
        assert!(row.len() <= sums.len(), "a row of {} pixels", row.len());
        for (&[x, y, z], sum) in row.iter().zip(sums) {
            *sum = [x, y, z, ANYTHING].map(single);
        }
    }
    let sums = put(bench, &sums);
    let row_bytes = 4 * rows[0].len();
    let pixels = bench.place(&vec![0x55; row_bytes * rows.len()]);
    let shuffle = put(bench, &[pixel_shuffle(shifts)]);
    let arguments =
        [sums.address, pixels.address, rows.len() as u32, row_bytes as u32, shuffle.address];
    bench.call("pack_sums", &arguments);
    let words: Vec<U32> = bench.read_all(pixels);
    words.iter().map(|word| word.get()).collect()
}

/// `same_objects_r16`: returns its bits for packets with these objects.
pub fn same_objects(bench: &mut Bench, packets: &[[u32; 16]]) -> u32 {
    bench.reset();
    let ray = Ray { origin: [ANYTHING; 3], direction: [ANYTHING; 3], t: ANYTHING };
    let records: Vec<RayPacket> = packets
        .iter()
        .map(|objects| records::rays(&objects.map(|object| packet_ray(ray, object))))
        .collect();
    let rays = put(bench, &records);
    let arguments = [rays.address, packets.len() as u32];
    bench.call("same_objects_r16", &arguments).value
}

/// Puts the inputs of `encode_srgb` or `roll_off` into local store. Returns the values' place and
/// the arguments.
pub fn put_values(bench: &mut Bench, values: &[[Single; 4]]) -> (bench::Place, Vec<u32>) {
    let quads: Vec<_> = values.iter().map(|quad| quad.map(single)).collect();
    let place = put(bench, &quads);
    (place, vec![place.address, values.len() as u32])
}

/// Calls one of them.
pub fn convert(bench: &mut Bench, kernel: &str, values: &[[Single; 4]]) -> Vec<[Single; 4]> {
    bench.reset();
    let (place, arguments) = put_values(bench, values);
    bench.call(kernel, &arguments);
    let quads = bench.read_all::<[F32; 4]>(place);
    quads.into_iter().map(|quad| quad.map(bits)).collect()
}
