//! The kernels for light: the shadow rays to it, and what it adds to surfaces.

use twins::light::{ambient, light};
use twins::shadow_rays::{NOT_THERE, Place, shadow_ray};
use twins::surfaces::{Ray, Surface};

use super::error::{any_light, any_shining_site, any_site};
use super::records;
use super::{EXPONENT, LENGTHS};
use crate::bench;
use crate::prelude::*;
use protocol::layout::SITE_SHINES;
use twins::primary_rays::Ray as WholeRay;

/// Fills the fields that have no meaning here.
pub const ANYTHING: u32 = 0x5555_5555;

/// A ray with nothing but such fields.
pub const NO_RAY: Ray = Ray { origin: [ANYTHING; 3], direction: [ANYTHING; 3], t: ANYTHING };

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

impl Site {
    fn any_bits(random: &mut ChaCha8Rng) -> Self {
        Self {
            surfaces: any_bits(random),
            normals: random.random(),
            directions: random.random(),
            weights: random.random(),
            shines: random.random(),
            shadow: [(); 16].map(|()| (any_bits(random), random.random())),
        }
    }

    /// The record of the surfaces with the light that `lit` gives for each lane.
    fn record(&self, lit: impl Fn(usize) -> [Single; 3]) -> Surfaces {
        let surface = |lane: usize| Surface { lit: lit(lane), ..self.surfaces[lane] };
        records::surfaces(&std::array::from_fn(surface), &self.normals, [ANYTHING; 16])
    }

    fn unlit(&self) -> Surfaces {
        self.record(|lane| self.surfaces[lane].lit)
    }
}

/// A ray of a packet that has hit this object.
pub(super) fn whole(Ray { origin, direction, t }: Ray, object: u32) -> WholeRay {
    WholeRay { origin, direction, t, object, weight: ANYTHING, pixel: ANYTHING }
}

/// Puts sites into local store, each record between guards, with these packets of shadow rays if
/// there are any. Returns the places of their list and of the surfaces.
fn put_sites(
    bench: &mut Bench,
    sites: &[Site],
    shadow: Option<bench::Place>,
) -> (bench::Place, Vec<bench::Place>) {
    let (list, surfaces): (Vec<layout::Site>, _) = sites
        .iter()
        .enumerate()
        .map(|(number, site)| {
            let surfaces = put(bench, &[site.unlit()]);
            let seen = |lane: usize| WholeRay {
                weight: site.weights[lane],
                ..whole(Ray { direction: site.directions[lane], ..NO_RAY }, ANYTHING)
            };
            let rays = put(bench, &[rows::<_, RayPacket, 16>(&std::array::from_fn(seen))]);
            let record = layout::Site {
                surfaces: surfaces.address.into(),
                rays: rays.address.into(),
                shines: if site.shines { SITE_SHINES } else { 0 }.into(),
                shadow: shadow
                    .map_or(ANYTHING, |packets| address::<RayPacket>(packets, number))
                    .into(),
            };
            (record, surfaces)
        })
        .unzip();
    (put(bench, &list), surfaces)
}

fn put_light(bench: &mut Bench, place: &Place, brightness: [Single; 3]) -> bench::Place {
    let light = layout::Light {
        position: place.position.map(single),
        falloff: place.falloff.into(),
        brightness: brightness.map(single),
        near: single(ANYTHING),
    };
    put(bench, &[light])
}

/// Sites, and a light to which they send shadow rays.
#[derive(Clone, Debug)]
pub struct Shadows {
    /// The sites.
    pub sites: Vec<Site>,
    /// Where the light is.
    pub light: Place,
    /// The smallest share of it that is worth a ray.
    pub min_share: Single,
}

/// Packets of shadow rays.
#[derive(Debug, PartialEq)]
pub struct ShadowRays {
    /// The numbers of the sites that have any.
    pub sites: Vec<usize>,
    /// The rays.
    pub packets: Vec<[Ray; 16]>,
    /// The number of rays.
    pub count: usize,
    /// The number of sites that shine.
    pub shining: usize,
}

impl Description for Shadows {
    const KERNEL: &'static str = "shadow_rays_r16";
    const ROUNDS: [usize; 2] = [20, 500];
    const LENGTHS: &'static [usize] = LENGTHS;
    const SHARES: [Range<f64>; 2] = [0.25..1.0, ANY_SHARE];
    /// The places of the sites, of the background, of the packets and of the listed sites.
    type Placed = [bench::Place; 4];
    type Found = ShadowRays;

    fn sensible(count: usize, random: &mut ChaCha8Rng) -> Self {
        let light = any_light(random);
        let mut site = || {
            let mut site = any_site(random, &light, EXPONENT);
            // In some sites no lane is lit.
            let dark = random.random_ratio(1, 3);
            for surface in &mut site.surfaces {
                if dark || random.random_ratio(1, 4) {
                    (surface.diffuse, surface.highlight) = (0, 0);
                }
            }
            site
        };
        let sites = (0..count).map(|_| site()).collect();
        let min_share = from_f64([0.0, 1e-3, 1e-1][random.random_range(0..3)]);
        Self { sites, light, min_share }
    }

    fn any(count: usize, random: &mut ChaCha8Rng) -> Self {
        let sites = (0..count).map(|_| Site::any_bits(random)).collect();
        let light = Place { position: random.random(), falloff: random.random() };
        Self { sites, light, min_share: if random.random() { random.random() } else { ZERO } }
    }

    fn place(&self, bench: &mut Bench) -> (Self::Placed, Vec<u32>) {
        let Self { sites, light, min_share } = self;
        let background = put(bench, &[layout::Object::new_zeroed()]);
        let (list, _) = put_sites(bench, sites, None);
        let light = put_light(bench, light, [ANYTHING; 3]).address;
        let packets = bench.place(&vec![0x55; size_of::<RayPacket>() * sites.len()]);
        let listed = bench.place(&vec![0x55; size_of::<layout::Site>() * sites.len()]);
        let arguments = [list.address, sites.len() as u32, light, background.address, *min_share];
        let out = [packets, listed].map(|place| place.address);
        ([list, background, packets, listed], [&arguments[..], &out].concat())
    }

    /// A ray must have the background as its object. Its weight and its pixel stay, and so do the
    /// sites that are listed.
    fn found(&self, bench: &Bench, placed: &Self::Placed, _: u32) -> ShadowRays {
        let [given, background, packets, listed] = *placed;
        let [end, count, shining, _] = bench.returned_vector();
        let count_of = |bytes| bytes as usize / size_of::<layout::Site>();
        let listed_sites = count_of(end - listed.address);
        let given = bench.read_all::<layout::Site>(given);
        let number = |site: &layout::Site| {
            let number = given.iter().position(|given| given.as_bytes() == site.as_bytes());
            number.expect("a site of the list")
        };
        let listed = bench.read_all(listed);
        let found = bench.read_all::<RayPacket>(packets);
        let rays = found[..listed_sites].iter().map(|packet| {
            lanes(packet).map(|WholeRay { origin, direction, t, object, weight, pixel }| {
                assert_eq!((object, weight, pixel), (background.address, ANYTHING, ANYTHING));
                Ray { origin, direction, t }
            })
        });
        ShadowRays {
            sites: listed[..listed_sites].iter().map(number).collect(),
            packets: rays.collect(),
            count: count as usize,
            shining: count_of(shining),
        }
    }

    fn twin(&self, _: &Self::Placed) -> ShadowRays {
        let is_there = |ray: &&Ray| ray.t != NOT_THERE;
        let rays = self.sites.iter().map(|site| {
            std::array::from_fn(|lane| {
                let (surface, normal) = (&site.surfaces[lane], site.normals[lane]);
                shadow_ray(surface, normal, site.weights[lane], &self.light, self.min_share)
            })
        });
        let (sites, packets): (Vec<usize>, Vec<[Ray; 16]>) =
            rays.enumerate().filter(|(_, rays)| rays.iter().any(|ray| is_there(&ray))).unzip();
        let count = packets.as_flattened().iter().filter(is_there).count();
        let shining = sites.iter().filter(|site| self.sites[**site].shines).count();
        ShadowRays { sites, packets, count, shining }
    }

    /// How many sites have shadow rays.
    fn part(&self, found: &ShadowRays) -> [usize; 2] {
        [found.sites.len(), self.sites.len()]
    }
}

/// Light from everywhere.
pub const AMBIENT: usize = 0;
/// Light from one place, without highlights.
pub const LAMBERT: usize = 1;
/// Light from one place.
pub const HIGHLIGHT: usize = 2;

/// Sites that are lit in one of these ways.
#[derive(Clone, Debug)]
pub struct Lit<const WAY: usize> {
    /// The sites.
    pub sites: Vec<Site>,
    /// The light, which the shadow rays go to.
    pub light: Place,
    /// Its brightness.
    pub brightness: [Single; 3],
}

impl<const WAY: usize> Description for Lit<WAY> {
    const KERNEL: &'static str = ["ambient_r16", "lambert_r16", "light_r16"][WAY];
    const ROUNDS: [usize; 2] = Shadows::ROUNDS;
    const LENGTHS: &'static [usize] = LENGTHS;
    /// The places of the surfaces.
    type Placed = Vec<bench::Place>;
    type Found = Vec<Bits<Surfaces>>;

    fn sensible(count: usize, random: &mut ChaCha8Rng) -> Self {
        let light = any_light(random);
        let sites = (0..count).map(|_| any_shining_site(random, &light, EXPONENT)).collect();
        let brightness = [(); 3].map(|()| from_f64(random.random_range(0.0..2.0)));
        Self { sites, light, brightness }
    }

    fn any(count: usize, random: &mut ChaCha8Rng) -> Self {
        let sites = (0..count).map(|_| Site::any_bits(random)).collect();
        let light = Place { position: random.random(), falloff: random.random() };
        Self { sites, light, brightness: random.random() }
    }

    fn place(&self, bench: &mut Bench) -> (Vec<bench::Place>, Vec<u32>) {
        let Self { sites, light, brightness } = self;
        let count = sites.len() as u32;
        if WAY == AMBIENT {
            let surfaces: Vec<Surfaces> = sites.iter().map(Site::unlit).collect();
            let surfaces = put(bench, &surfaces);
            let [red, green, blue] = *brightness;
            let brightness = put(bench, &[red, green, blue, ANYTHING].map(single)).address;
            return (vec![surfaces], vec![surfaces.address, count, brightness]);
        }
        let light = put_light(bench, light, *brightness).address;
        let background = put(bench, &[layout::Object::new_zeroed()]).address;
        let shadow = |(ray, blocked)| whole(ray, background + u32::from(blocked));
        let packets = sites.iter().map(|site| rows::<_, RayPacket, 16>(&site.shadow.map(shadow)));
        let packets = put(bench, &packets.collect::<Vec<_>>());
        let (list, surfaces) = put_sites(bench, sites, (WAY == HIGHLIGHT).then_some(packets));
        let mut arguments = vec![list.address, count, light, background];
        if WAY == LAMBERT {
            arguments.push(packets.address);
        }
        (surfaces, arguments)
    }

    fn found(&self, bench: &Bench, surfaces: &Vec<bench::Place>, _: u32) -> Vec<Bits<Surfaces>> {
        surfaces.iter().flat_map(|place| bench.read_all(*place)).map(Bits).collect()
    }

    fn twin(&self, _: &Vec<bench::Place>) -> Vec<Bits<Surfaces>> {
        let lit = |site: &Site, lane: usize| {
            let (surface, (ray, blocked)) = (&site.surfaces[lane], &site.shadow[lane]);
            if WAY == AMBIENT {
                return ambient(surface, self.brightness);
            }
            let direction = (WAY == HIGHLIGHT).then_some(site.directions[lane]);
            let blocked = *blocked || ray.t >> 31 != 0;
            let shadow = (ray, blocked);
            light(surface, site.normals[lane], direction, shadow, &self.light, self.brightness)
        };
        self.sites.iter().map(|site| Bits(site.record(|lane| lit(site, lane)))).collect()
    }
}
