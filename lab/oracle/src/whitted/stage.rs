//! Computes the colour that a ray sees, in a scene prepared for tracing.
//!
//! Invariant: a ray sends at most a reflected and a refracted ray, and none at the maximum depth.
//! A ray with too little weight to matter is neither sent nor counted. If rays are counted as in
//! SPD, it is sent and counted, but changes only the counts.

use std::sync::Arc;

use glam::DVec3;
use scenes::{Camera, LightKind, Material, Scene, Shader, Shape};

use super::finish::Finish;
use super::light;
use super::path::{Counts, Path};
use super::texture::Textures;
use super::{MAX_DEPTH, Options, Rounding, weight};
use crate::Error;
use crate::bvh::Bvh;
use crate::ray::Ray;
use crate::shapes::{MAX_PATCH_VERTICES, Surface};

pub(super) struct Stage<'a> {
    tree: Bvh,
    materials: Vec<&'a Material>,
    textures: Textures,
    eye: DVec3,
    /// The angle between the rays of neighbouring pixels in the middle of the picture.
    pixel: f64,
    /// The position or direction, and the brightness, of each light.
    lights: Vec<(LightKind, DVec3)>,
    ambient: DVec3,
    background: DVec3,
    /// The light at the zenith and the unit direction to it, if the background has a gradient.
    sky: Option<(DVec3, DVec3)>,
    /// The fog's light, and its density.
    fog: Option<(DVec3, f64)>,
    options: Options,
    /// The minimum weight of a ray that is sent.
    min_weight: f64,
}

struct Hit {
    finish: Finish,
    point: DVec3,
    distance: f64,
    /// The surface's normal, on the ray's side.
    normal: DVec3,
    /// The shading normal, on the ray's side.
    smooth: DVec3,
    /// Whether the ray comes from outside of a transparent body.
    outside: bool,
}

/// Refuses materials that the reference can't shade.
fn check_material(scene: &Scene, material: &Material) -> Result<(), Error> {
    if material.transmittance > 0.0 && material.refraction_index == 0.0 {
        return Err(Error::RefractionIndex { scene: scene.name.clone(), line: material.line });
    }
    if let Shader::Own { name, .. } = &material.shader {
        return Err(Error::Shader {
            scene: scene.name.clone(),
            line: material.line,
            name: name.clone(),
        });
    }
    Ok(())
}

impl<'a> Stage<'a> {
    pub(super) fn new(scene: &'a Scene, camera: &Camera, options: &Options) -> Result<Self, Error> {
        if !(1..=MAX_DEPTH).contains(&options.depth) {
            return Err(Error::Depth(options.depth));
        }
        let (mut surfaces, mut materials) = (Vec::new(), Vec::new());
        for object in &scene.objects {
            let Some(material) = scene.materials.get(object.material as usize) else {
                continue;
            };
            let transmits = material.transmittance > 0.0;
            check_material(scene, material)?;
            if let Shape::Patch { vertices, .. } = &object.shape
                && vertices.len() > MAX_PATCH_VERTICES
            {
                return Err(Error::PatchVertices {
                    scene: scene.name.clone(),
                    line: object.line,
                    vertices: vertices.len(),
                });
            }
            if let Some(surface) = Surface::new(&object.shape, transmits) {
                surfaces.push(surface);
                materials.push(material);
            }
        }
        let mut textures = Textures::default();
        let ground = scene.heights.as_ref().map(|heights| Arc::new(heights.mesh()));
        for (mesh, triangle) in scene
            .mesh
            .iter()
            .chain(&ground)
            .flat_map(|mesh| (0..mesh.triangles.len()).map(move |triangle| (mesh, triangle)))
        {
            let index = mesh.materials[triangle] as usize;
            let Some(material) = scene.materials.get(index) else {
                continue;
            };
            check_material(scene, material)?;
            let both = mesh.two_sided || material.transmittance > 0.0;
            if let Some(surface) = Surface::new(&mesh.shape(triangle), both) {
                textures.add(surfaces.len(), scene, mesh, triangle, options.pixels.colour);
                surfaces.push(surface);
                materials.push(material);
            }
        }
        let lights: Vec<(LightKind, DVec3)> =
            scene.lights.iter().map(|light| (light.kind, scene.brightness(light))).collect();
        let min_weight = if options.spd_rays {
            0.0
        } else {
            weight::minimum(scene, &materials, &lights, options)
        };
        Ok(Self {
            tree: Bvh::new(surfaces),
            materials,
            textures,
            eye: camera.eye,
            pixel: camera.down.length(),
            lights,
            ambient: scene.ambient,
            background: options.pixels.colour.light(scene.background),
            sky: scene.sky.and_then(|sky| {
                let up = scenes::unit(sky.up)?;
                Some((options.pixels.colour.light(sky.zenith), up))
            }),
            fog: scene.fog.map(|fog| (options.pixels.colour.light(fog.colour), fog.density)),
            options: *options,
            min_weight,
        })
    }

    pub(super) fn set_rounding(&mut self, rounding: Rounding) {
        self.options.rounding = rounding;
    }

    /// The colour that a primary ray sees. The direction need not have length 1.
    pub(super) fn eye(&self, eye: DVec3, direction: DVec3, path: &mut Path) -> DVec3 {
        let direction = direction.normalize();
        let first = self.options.rounding.unit(direction, direction.x.to_bits());
        let colour = self.look(&Ray::new(eye, first), 1, 1.0, path);
        path.counts.eye += 1;
        colour
    }

    /// The colour that a ray sees. `depth` is the ray's number in its chain, and `weight` its
    /// weight.
    fn look(&self, ray: &Ray, depth: u32, weight: f64, path: &mut Path) -> DVec3 {
        let Some(hit) = self.meet(ray, path) else {
            path.counts.background += 1;
            return self.beyond(ray.direction);
        };
        path.counts.hit += 1;
        path.counts.eye_hit += u64::from(depth == 1);
        let lit = self.lit(&hit, ray.direction, weight, path);
        let (fog, share) = match self.fog {
            Some((fog, density)) => (fog, libm::exp(-density * hit.distance)),
            None => (DVec3::ZERO, 1.0),
        };
        let bounced = match depth < self.options.depth {
            true => self.bounced(&hit, ray.direction, depth + 1, share * weight, path),
            false => DVec3::ZERO,
        };
        share * (lit + bounced) + (1.0 - share) * fog
    }

    /// The light from beyond all objects.
    fn beyond(&self, direction: DVec3) -> DVec3 {
        match self.sky {
            Some((zenith, up)) => {
                let elevation = direction.dot(up).max(0.0);
                (1.0 - elevation) * self.background + elevation * zenith
            }
            None => self.background,
        }
    }

    /// The nearest hit of a ray.
    fn meet(&self, ray: &Ray, path: &mut Path) -> Option<Hit> {
        let Some((index, distance)) = self.tree.nearest(ray) else {
            path.note(0);
            return None;
        };
        let place = self.tree.surface(index).place(ray, distance);
        let outside = place.normal.dot(ray.direction) < 0.0;
        path.note(1 + 2 * index as u64 + u64::from(outside));
        let mut finish =
            Finish::of(self.materials[index], place.point, distance, self.options.pixels.colour);
        if finish.other {
            path.note(1);
        } else {
            let width = self.pixel * (ray.origin.distance(self.eye) + distance);
            let cosine = place.normal.dot(ray.direction);
            let texel = self.textures.colour(index, place.point, width, cosine);
            finish = finish.tinted(texel.unwrap_or(DVec3::ONE));
        }
        let (rounding, way) = (self.options.rounding, distance.to_bits());
        let [normal, smooth] = [place.normal, place.smooth]
            .map(|exact| rounding.unit(if outside { exact } else { -exact }, way));
        let seen = smooth.dot(ray.direction) < 0.0;
        Some(Hit {
            finish,
            distance,
            point: rounding.point(place.point, self.eye, !way),
            normal,
            smooth: if seen { smooth } else { normal },
            outside,
        })
    }

    /// The ray that leaves a hit in this direction.
    fn sent(&self, hit: &Hit, direction: DVec3) -> Ray {
        let rounding = self.options.rounding;
        let direction = rounding.unit(direction, hit.point.x.to_bits());
        Ray::new(rounding.origin(hit.point, self.eye, hit.normal, direction), direction)
    }

    /// The light that a hit sends back along a ray of this weight: the lights' and its own.
    fn lit(&self, hit: &Hit, direction: DVec3, weight: f64, path: &mut Path) -> DVec3 {
        let finish = &hit.finish;
        let sum = finish.emission + finish.diffuse * self.ambient * finish.colour;
        if finish.diffuse == 0.0 && finish.highlight == 0.0 {
            if self.options.spd_rays && finish.is_lit {
                path.counts += Counts::unseen(|path| {
                    self.shone_on(sum, hit, direction, weight, path);
                });
            }
            return sum;
        }
        self.shone_on(sum, hit, direction, weight, path)
    }

    /// Adds the lights' light that a hit sends back to a sum. Shadow rays that `cellray` would not
    /// send add their light, too, but do not count.
    fn shone_on(
        &self,
        mut sum: DVec3,
        hit: &Hit,
        direction: DVec3,
        weight: f64,
        path: &mut Path,
    ) -> DVec3 {
        let finish = &hit.finish;
        for &(kind, brightness) in &self.lights {
            let (way, distance, fade) = match kind {
                LightKind::Point { position, range } => {
                    let distance = hit.point.distance(position);
                    (position - hit.point, distance, light::fade(distance, range))
                }
                LightKind::Directional { to_light } => (to_light, f64::INFINITY, 1.0),
            };
            let Some(to_light) = scenes::unit(way) else {
                continue;
            };
            let is_facing = hit.smooth.dot(to_light) > 0.0;
            if !is_facing || hit.normal.dot(to_light) <= 0.0 || fade == 0.0 {
                path.counts.shadow_behind += u64::from(is_facing && fade > 0.0);
                path.note(0);
                continue;
            }
            let share = light::bound(finish, hit.smooth.dot(to_light));
            let shown = weight * share * fade.sqrt() * weight::most(brightness);
            let counts = self.min_weight == 0.0 || shown > weight::MIN_LIGHT;
            path.counts.shadow += u64::from(counts && self.options.shadows);
            let hidden = self.options.shadows && self.tree.any(&self.sent(hit, to_light), distance);
            path.note(1 + u64::from(hidden));
            if !hidden {
                sum += fade * brightness * light::shine(finish, hit.smooth, direction, to_light);
            }
        }
        sum
    }

    /// The light that a hit reflects and lets through, for a ray of this weight. `depth` is the
    /// number of the secondary rays in their chains.
    fn bounced(
        &self,
        hit: &Hit,
        direction: DVec3,
        depth: u32,
        weight: f64,
        path: &mut Path,
    ) -> DVec3 {
        let is_sent = |share: f64| share > 0.0 && weight * share >= self.min_weight;
        let finish = &hit.finish;
        if let Some(portal) = finish.portal {
            if !is_sent(1.0) {
                return DVec3::ZERO;
            }
            path.counts.refracted += 1;
            let beyond = Hit {
                point: portal.transform_point3(hit.point),
                normal: portal.transform_vector3(hit.normal),
                ..*hit
            };
            let ray = self.sent(&beyond, portal.transform_vector3(direction));
            return self.look(&ray, depth, weight, path);
        }
        let (mut mirror, mut through) = (finish.mirror, None);
        if finish.transmittance > 0.0 {
            let index = finish.refraction_index;
            let ratio = if hit.outside { index.recip() } else { index };
            // With a patch's smooth normal the refracted direction may stay on this side of the
            // surface.
            let refracted =
                light::refracted(direction, hit.smooth, ratio).and_then(|(found, beyond)| {
                    if found.dot(hit.normal) < 0.0 {
                        Some((found, beyond))
                    } else {
                        light::refracted(direction, hit.normal, ratio)
                    }
                });
            let share = match refracted {
                None => 1.0,
                Some((_, beyond)) if self.options.fresnel => {
                    light::schlick(ratio, -direction.dot(hit.smooth), beyond)
                }
                Some(_) => 0.0,
            };
            mirror += finish.transmittance * share;
            let rest = finish.transmittance * (1.0 - share);
            through = refracted.map(|(found, _)| (found, rest));
        }

        let mut sum = DVec3::ZERO;
        let is_counted = self.options.spd_rays && finish.transmittance > 0.0;
        if is_sent(mirror) || is_counted {
            let reflected = light::reflected(direction, hit.smooth);
            let reflected = if reflected.dot(hit.normal) > 0.0 {
                reflected
            } else {
                light::reflected(direction, hit.normal)
            };
            let ray = self.sent(hit, reflected);
            path.counts.reflected += 1;
            let is_total = finish.transmittance > 0.0 && through.is_none();
            path.counts.totally_reflected += u64::from(is_total);
            if mirror > 0.0 {
                sum += mirror * self.look(&ray, depth, weight * mirror, path);
            } else {
                path.counts += Counts::unseen(|path| {
                    self.look(&ray, depth, 0.0, path);
                });
            }
        }
        if let Some((refracted, share)) = through.filter(|&(_, share)| is_sent(share)) {
            path.counts.refracted += 1;
            let ray = self.sent(hit, refracted);
            sum += share * self.look(&ray, depth, weight * share, path);
        }
        sum
    }
}
