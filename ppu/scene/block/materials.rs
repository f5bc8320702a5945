//! Materials and lights in the SPUs' format.
//!
//! Invariant: if a material's shares can have an effect, its flags are set.

use glam::DVec3;
use scenes::{Fog, LightKind, Material, Scene, Shader, Sky, unit};
use zerocopy::big_endian::F32;
use zerocopy::{FromZeros as _, IntoBytes as _};

use super::chains::largest_channel;
use super::error::BlockError;
use super::objects::taxicab;
use super::source_location::SourceLocation;
use crate::scene::colour::Colour;
use crate::scene::render_options::RenderOptions;
use crate::scene::single::{single, singles};
use protocol::layout::{
    self, MATERIAL_FLAT, MATERIAL_LIT, MATERIAL_MIRRORS, MATERIAL_SHADED, MATERIAL_SHINES,
    MATERIAL_TEXTURED, MATERIAL_TRANSMITS, MAX_LIGHTS,
};

/// Blinn's exponent for a highlight, as a multiple of Phong's.
const BLINN: f64 = 4.0;

/// Twice the slack that `cull_nodes` allows for its own rounding, relative to the apex's
/// coordinates.
const SLACK: f64 = 2.0 / (1 << 18) as f64;

/// The share of a ray that is sent only to be counted: 2^-64. For the SPUs it is above 0, even
/// times a cosine, and it has no effect on the picture.
const COUNTED: f64 = 1.0 / (1_u128 << 64) as f64;

/// Names of the built-in shaders.
const CHECKER: &str = "checker";
const DEPTH: &str = "depth";
const PORTAL: &str = "portal";
const SKY: &str = "sky";

/// The largest tangent of half an angle that a portal's record has. A larger one turns a direction
/// by the same angle, to the precision of singles.
const MOST_TANGENT: f64 = (1_u64 << 30) as f64;

/// The parts of a material's record that depend on its shader.
#[derive(Default)]
struct Shading<'a> {
    /// The name and the parameters of the shader that the SPUs call, if any.
    shader: Option<(&'a str, [f64; 4])>,
    emission: DVec3,
    /// Whether the shares for lights, reflection and transmission apply.
    shares: bool,
    /// Whether there is a highlight.
    shines: bool,
    /// Whether all light passes as if there were no surface.
    passes: bool,
}

impl<'a> Shading<'a> {
    fn of(material: &'a Material, colour: Colour) -> Self {
        let emission = colour.light(material.emission);
        let phong = Self { emission, shares: true, shines: true, ..Self::default() };
        match &material.shader {
            Shader::Phong => phong,
            Shader::Lambert => Self { shines: false, ..phong },
            Shader::Flat => {
                Self { emission: emission + colour.light(material.colour), ..Self::default() }
            }
            Shader::Checker { other, size } => {
                let other = colour.light(*other);
                Self { shader: Some((CHECKER, [other.x, other.y, other.z, size.recip()])), ..phong }
            }
            Shader::Depth { far, near } => Self {
                shader: Some((DEPTH, [*far, (far - near).recip(), 0.0, 0.0])),
                ..Self::default()
            },
            Shader::Portal { by, turn } => {
                let half = libm::tan((0.5 * turn).to_radians());
                let half = half.clamp(-MOST_TANGENT, MOST_TANGENT);
                let shader = Some((PORTAL, [by.x, by.y, by.z, half]));
                Self { shader, passes: true, ..Self::default() }
            }
            Shader::Own { name, parameters } => Self { shader: Some((name, *parameters)), ..phong },
        }
    }
}

/// The material of a scene's background. It sends the colour at the horizon, and the shader of
/// skies mixes that with the material's colour.
pub(super) fn background(
    file: &str,
    background: DVec3,
    sky: Option<Sky>,
    colour: Colour,
    entry: &dyn Fn(&str) -> Option<u32>,
) -> Result<layout::Material, BlockError> {
    let place = SourceLocation { file, line: None };
    place.vector("background", background)?;
    let plain = layout::Material {
        emission: singles(colour.light(background)),
        ..layout::Material::new_zeroed()
    };
    let Some(Sky { zenith, up }) = sky else {
        return Ok(plain);
    };
    place.vector("sky", zenith)?;
    place.vector("direction to the zenith", up)?;
    let shader = entry(SKY).ok_or_else(|| BlockError::NoSky { file: file.to_owned() })?;
    // A direction of 0 has no zenith; files with one are refused.
    let [x, y, z] = unit(up).unwrap_or_default().to_array();
    Ok(layout::Material {
        colour: singles(colour.light(zenith)),
        flags: MATERIAL_SHADED.into(),
        parameters: [x, y, z, 0.0].map(single),
        shader: shader.into(),
        ..plain
    })
}

/// What a material's colour is multiplied by.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Surfacing {
    /// The address of its texture's record, or 0.
    pub texture: u32,
    /// Whether the streamed mesh has colours at its vertices.
    pub is_coloured: bool,
}

/// The record of a material. `entry` looks up the entry of a shader of the SPU program by its name.
pub(super) fn record(
    file: &str,
    material: &Material,
    surface: Surfacing,
    options: RenderOptions,
    entry: &dyn Fn(&str) -> Option<u32>,
) -> Result<layout::Material, BlockError> {
    let &Material {
        line,
        colour,
        diffuse,
        specular,
        shine,
        transmittance,
        refraction_index,
        emission,
        shader: _,
        texture: _,
    } = material;
    let place = SourceLocation { file, line: Some(line) };
    place.vector("colour", colour)?;
    place.vector("emission", emission)?;
    for (what, value) in [("Kd", diffuse), ("Ks", specular), ("shine", shine), ("T", transmittance)]
    {
        place.number(what, value)?;
    }
    let shading = Shading::of(material, options.colour);
    // The index of an opaque material is not used, whatever the file has.
    let index = if transmittance > 0.0 && !shading.passes {
        if refraction_index == 0.0 {
            let file = file.to_owned();
            return Err(BlockError::RefractionIndex { file, line });
        }
        place.size("index of refraction", refraction_index)?;
        refraction_index
    } else {
        1.0
    };
    let mut shader = 0;
    let mut parameters = [0.0; 4];
    if let Some((name, given)) = shading.shader {
        shader = entry(name).ok_or_else(|| BlockError::UnknownShader {
            file: file.to_owned(),
            line,
            name: name.to_owned(),
        })?;
        for value in given {
            place.number("parameter of the shader", value)?;
        }
        parameters = given;
    }
    let texture = surface.texture;
    let is_flat = material.shader == Shader::Flat;
    let share = |share: f64| if shading.shares { share } else { 0.0 };
    let highlight = if shading.shines { share(specular) } else { 0.0 };
    let diffuse = share(diffuse);
    let [mirror, transmittance] =
        [specular, transmittance].map(|seen| options.colour.seen(share(seen)));
    let transmittance = if shading.passes { 1.0 } else { transmittance };
    let (schlick, grazing) = if options.fresnel && transmittance > 0.0 && !shading.passes {
        let head_on = (1.0 - index) / (1.0 + index);
        let head_on = head_on * head_on;
        (head_on, 1.0 - head_on)
    } else {
        (0.0, 0.0)
    };
    let is_counted = options.spd_rays && shading.shares;
    let counted = |share: f64| {
        if is_counted { share.max(COUNTED) } else { share }
    };
    let mirror = if transmittance > 0.0 { counted(mirror) } else { mirror };
    let diffuse = counted(diffuse);
    let flag = |set: bool, flag: u32| if set { flag } else { 0 };
    let flags = flag(transmittance > 0.0, MATERIAL_TRANSMITS)
        // Transparent materials reflect at least by total reflection.
        | flag(mirror > 0.0 || transmittance > 0.0 && !shading.passes, MATERIAL_MIRRORS)
        | flag(diffuse > 0.0 || highlight > 0.0, MATERIAL_LIT)
        | flag(highlight > 0.0, MATERIAL_SHINES)
        | flag(shading.shader.is_some(), MATERIAL_SHADED)
        | flag(is_flat, MATERIAL_FLAT)
        | flag(texture != 0 || surface.is_coloured, MATERIAL_TEXTURED);

    Ok(layout::Material {
        colour: singles(options.colour.light(colour)),
        diffuse: single(diffuse),
        highlight: single(highlight),
        exponent: single(BLINN * shine),
        mirror: single(mirror),
        transmittance: single(transmittance),
        inverse_index: single(index.recip()),
        index: single(index),
        schlick: single(schlick),
        grazing: single(grazing),
        emission: singles(shading.emission),
        flags: flags.into(),
        parameters: parameters.map(single),
        shader: shader.into(),
        texture: texture.into(),
        ..layout::Material::new_zeroed()
    })
}

/// Checks that a point light's position and range are in range.
fn check_light(kind: LightKind, place: SourceLocation<'_>) -> Result<(), BlockError> {
    if let LightKind::Point { position, range } = kind {
        place.vector("light", position)?;
        if range != f64::INFINITY {
            place.size("range", range)?;
        }
    }
    Ok(())
}

/// A light in the scene's coordinates, with its record except for the position.
#[derive(Clone, Debug)]
pub(crate) struct Light {
    kind: LightKind,
    record: layout::Light,
}

impl Light {
    /// A light of a scene.
    pub(super) fn of(
        kind: LightKind,
        brightness: DVec3,
        place: SourceLocation<'_>,
    ) -> Result<Self, BlockError> {
        check_light(kind, place)?;
        place.vector("brightness", brightness)?;
        let record =
            layout::Light { brightness: singles(brightness), ..layout::Light::new_zeroed() };
        Ok(Self { kind, record })
    }

    /// The same light at another position or direction.
    pub(super) fn moved(
        &self,
        kind: LightKind,
        place: SourceLocation<'_>,
    ) -> Result<Self, BlockError> {
        check_light(kind, place)?;
        Ok(Self { kind, record: self.record })
    }

    /// The largest channel of its brightness.
    pub fn brightness(&self) -> f64 {
        largest_channel(&self.record.brightness)
    }

    /// Whether both lights light every point equally.
    pub fn lights_as(&self, other: &Self) -> bool {
        self.kind == other.kind && self.record.as_bytes() == other.record.as_bytes()
    }

    /// The direction to it as SPUs have it, if it is infinitely far.
    pub fn far_away(&self) -> Option<DVec3> {
        let LightKind::Directional { to_light } = self.kind else {
            return None;
        };
        Some(unit(to_light)?.as_vec3().as_dvec3())
    }

    /// The record relative to `eye`; `leave` is the largest origin offset of all objects.
    ///
    /// A shadow ray's direction is from the point on the surface to the light, but the ray starts
    /// off the surface. So it misses the light by the same offset, at most three times `leave`.
    /// The rounding of its direction and length adds four units in the last place of the distance.
    /// That is at most eight times `leave` more, and a quarter of the slack of 2^-18 that
    /// `cull_nodes` allows relative to the light's coordinates. The rest of the 32 times `leave`
    /// is the slack for the point.
    pub fn record(&self, eye: DVec3, leave: f64) -> layout::Light {
        let (position, falloff) = match self.kind {
            LightKind::Point { position, range } => {
                (position - eye, (range.powi(-2) as f32).to_bits())
            }
            // A direction of 0 lights nothing; files with one are refused.
            LightKind::Directional { to_light } => (unit(to_light).unwrap_or_default(), u32::MAX),
        };
        layout::Light {
            position: singles(position),
            falloff: falloff.into(),
            near: single(SLACK * taxicab(position) + 32.0 * leave),
            ..self.record
        }
    }
}

/// The largest channel of light that a ray can see of the background and of fog.
pub(super) fn brightest(
    background: DVec3,
    sky: Option<Sky>,
    fog: Option<Fog>,
    colour: Colour,
) -> f64 {
    let zenith = sky.map_or(background, |sky| sky.zenith);
    let fog = fog.map_or(background, |fog| fog.colour);
    colour.light(background.max(zenith).max(fog)).max_element()
}

/// The fog as a frame has it.
pub(super) fn fog(file: &str, fog: Option<Fog>, colour: Colour) -> Result<[F32; 4], BlockError> {
    let Some(Fog { colour: own, density }) = fog else {
        return Ok(Default::default());
    };
    let place = SourceLocation { file, line: None };
    place.vector("fog", own)?;
    place.vector("density of the fog", DVec3::splat(density))?;
    let [red, green, blue] = singles(colour.light(own));
    Ok([single(density * std::f64::consts::LOG2_E), red, green, blue])
}

/// The ambient light: red, green, blue, and 0.
pub(super) fn ambient(file: &str, brightness: DVec3) -> Result<[F32; 4], BlockError> {
    let place = SourceLocation { file, line: None };
    place.vector("ambient light", brightness)?;
    let [red, green, blue] = singles(brightness);
    Ok([red, green, blue, F32::ZERO])
}

/// The lights of a scene.
///
/// # Errors
/// There are more than the SPUs support, or a number is out of range.
pub(super) fn lights(scene: &Scene) -> Result<Vec<Light>, BlockError> {
    if let Some(light) = scene.lights.get(MAX_LIGHTS as usize) {
        return Err(BlockError::TooManyLights { file: scene.name.clone(), line: light.line });
    }
    let light = |light: &scenes::Light| {
        let place = SourceLocation { file: &scene.name, line: Some(light.line) };
        Light::of(light.kind, scene.brightness(light), place)
    };
    scene.lights.iter().map(light).collect()
}
