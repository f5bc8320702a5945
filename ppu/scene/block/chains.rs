//! Bounds of the chains of rays: how long they can get, and the minimum weight of a ray that is
//! sent.
//!
//! The weight of a ray is its share of its pixel's colour: the product of the shares that the
//! surfaces on its way reflect or let through. The ray adds to its pixel at most its weight times
//! the maximum brightness that any ray can see. If that is less than [`MIN_CHANGE`] of a byte's
//! step, the ray is not sent. The materials' largest share also bounds the depth at which a ray
//! can still have enough weight. `docs/whitted.md` derives the bound.
//!
//! Nothing is bounded if an object has a game's own shader, because the light that
//! the shader adds is unknown. Nothing is bounded either if rays are counted as in the Standard
//! Procedural Databases, which have no weights.

use scenes::{Material, Shader};
use zerocopy::big_endian::F32;

use crate::scene::colour::Colour;
use crate::scene::render_options::RenderOptions;
use protocol::layout::{self, MAX_DEPTH};

/// The part of a byte's step that a ray must be able to add to its pixel, or it is not sent.
const MIN_CHANGE: f64 = 1.0 / 16.0;
/// The number of a byte's steps from black to white.
const STEPS: f64 = 255.0;
/// A bound of the relative error of the SPU's weights, which are products of singles.
const ROUNDING: f64 = 1e-5;

/// The bounds of a scene's chains.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Chains {
    /// The longest chain of rays, including the primary ray.
    pub ray_depth: u32,
    /// The minimum weight of a secondary ray; lighter rays are not sent.
    pub least_weight: f32,
    /// Whether a ray may send more than one ray on.
    pub branch: bool,
}

/// What a material adds to a chain.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sends {
    /// The share of a ray's weight that its secondary rays have together.
    share: f64,
    emission: f64,
    diffuse: f64,
    highlight: f64,
    is_own: bool,
    /// Whether a ray that meets it may send more than one ray on.
    branches: bool,
}

impl Sends {
    /// Reads a material and its record.
    pub fn of(record: &layout::Material, material: &Material, colour: Colour) -> Self {
        let single = |share: F32| f64::from(share.get());
        let own = colour.light(material.colour);
        let most = match material.shader {
            Shader::Checker { other, .. } => own.max(colour.light(other)),
            _ => own,
        };
        let emission = match material.shader {
            // Brightest at the near distance.
            Shader::Depth { .. } => own.max_element(),
            _ => largest_channel(&record.emission),
        };
        Self {
            share: single(record.mirror) + single(record.transmittance),
            emission,
            diffuse: single(record.diffuse) * most.max_element(),
            highlight: single(record.highlight),
            is_own: matches!(material.shader, Shader::Own { .. }),
            branches: record.transmittance.get() > 0.0
                || matches!(material.shader, Shader::Own { .. }),
        }
    }
}

pub(super) fn largest_channel(colour: &[F32]) -> f64 {
    let channels = colour.iter().map(|channel| f64::from(channel.get()));
    channels.fold(0.0, f64::max)
}

impl Chains {
    /// The bounds without any knowledge of a scene.
    pub const UNBOUNDED: Self = Self { ray_depth: MAX_DEPTH, least_weight: 0.0, branch: true };

    /// The bounds of a scene with these materials. The array has the largest channels of the
    /// background, of the ambient light, and of the sum of all lights.
    pub(super) fn of(
        options: RenderOptions,
        materials: impl Iterator<Item = Sends> + Clone,
        [background, ambient, lights]: [f64; 3],
    ) -> Self {
        let (mut share, mut is_bounded, mut branch) = (0.0_f64, true, false);
        for sends in materials.clone() {
            share = share.max(sends.share);
            is_bounded &= !sends.is_own;
            branch |= sends.branches;
        }
        if options.spd_rays || !is_bounded {
            return Self { ray_depth: options.ray_depth, branch, ..Self::UNBOUNDED };
        }
        // The maximum brightness that a ray can see: a surface's own light, and a share of the
        // brightness that the next ray of the chain sees.
        let mut seen = 0.0;
        for _ in 0..options.ray_depth {
            let surfaces = materials.clone().map(|sends| {
                let lit = sends.diffuse * (ambient + lights) + sends.highlight * lights;
                sends.emission + lit + sends.share * seen
            });
            seen = surfaces.fold(background, f64::max);
        }
        let least_weight = MIN_CHANGE / (STEPS * seen.max(f64::from(f32::MIN_POSITIVE)));
        let (mut ray_depth, mut weight) = (1, share * (1.0 + ROUNDING));
        while ray_depth < options.ray_depth && weight > 0.0 && weight >= least_weight {
            ray_depth += 1;
            weight *= share * (1.0 + ROUNDING);
        }
        Self { ray_depth, least_weight: least_weight as f32, branch }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sends(share: f64, diffuse: f64) -> Sends {
        Sends { share, emission: 0.0, diffuse, highlight: 0.0, is_own: false, branches: false }
    }

    fn to(ray_depth: u32) -> RenderOptions {
        RenderOptions { ray_depth, ..RenderOptions::default() }
    }

    #[test]
    fn scene_without_reflection_has_chains_of_one_ray() {
        let chains = Chains::of(to(16), [sends(0.0, 1.0)].into_iter(), [0.5, 0.0, 1.0]);
        assert_eq!(chains.ray_depth, 1);
    }

    #[test]
    fn weak_mirrors_end_chains_early() {
        let chains = |share| Chains::of(to(16), [sends(share, 1.0)].into_iter(), [0.0, 0.0, 1.0]);
        let weak = chains(0.1);
        // 0.1^3 is above 1 / (16 * 255 * 1.11...), and 0.1^4 is below.
        assert_eq!(weak.ray_depth, 4);
        assert!((weak.least_weight - 2.2e-4).abs() < 1e-5, "{weak:?}");
        assert_eq!(chains(1.0).ray_depth, 16);
    }

    #[test]
    fn transparent_material_makes_chains_branch() {
        let glass = Sends { branches: true, ..sends(0.9, 0.0) };
        let branch = |materials: &[Sends]| {
            Chains::of(to(5), materials.iter().copied(), [0.0, 0.0, 1.0]).branch
        };
        assert!(branch(&[sends(0.5, 1.0), glass]) && !branch(&[sends(0.5, 1.0)]));
    }

    #[test]
    fn counting_as_in_spd_keeps_all_chains() {
        let options = RenderOptions { spd_rays: true, ..to(6) };
        let chains = Chains::of(options, [sends(0.1, 1.0)].into_iter(), [0.0, 0.0, 1.0]);
        assert_eq!((chains.ray_depth, chains.least_weight), (6, 0.0));
    }

    #[test]
    fn custom_shader_keeps_all_chains() {
        let own = Sends { is_own: true, ..sends(0.0, 1.0) };
        let chains = Chains::of(to(7), [sends(0.0, 1.0), own].into_iter(), [0.0, 0.0, 1.0]);
        assert_eq!((chains.ray_depth, chains.least_weight), (7, 0.0));
    }

    #[test]
    fn brighter_scene_lowers_minimum_weight() {
        let least_weight = |lights| {
            Chains::of(to(5), [sends(0.5, 1.0)].into_iter(), [0.0, 0.0, lights]).least_weight
        };
        assert!(least_weight(2.0) < least_weight(1.0));
        assert!(least_weight(0.0) > 1e30);
    }
}
