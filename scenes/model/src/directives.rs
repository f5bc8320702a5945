//! Directives: extensions of NFF in comments, so that other programs can still read the file.
//!
//! Invariant: a directive that was read follows the scene's rules: a direction is not 0, a size is
//! above 0, a range has a width.

use std::io::BufRead;

use glam::DVec3;

use crate::error::Excerpt;
use crate::lines::LineError;
use crate::words::Words;
use crate::{Fault, Fog, HeightMap, LightKind, Shader};

pub(crate) enum Directive {
    /// The ambient light.
    Ambient(DVec3),
    /// The colour of the zenith, and the direction to it, if it is not the view's upwards.
    Sky { zenith: DVec3, up: Option<DVec3> },
    /// The fog.
    Fog(Fog),
    /// The light and the background of a day.
    Daylight,
    /// A light with a range, or infinitely far away.
    Light { kind: LightKind, colour: Option<DVec3> },
    /// The ground, but for its material.
    HeightMap(HeightMap),
    /// The shader of the material before it.
    Shader(Shader),
}

/// Reads the directive of a line whose first word was already read.
pub(crate) fn read(words: &mut Words<impl BufRead>) -> Result<Directive, LineError> {
    match words.word("directive")? {
        "ambient" => {
            let colour = words.colour(["ambient red", "ambient green", "ambient blue"])?;
            words.end("ambient light")?;
            Ok(Directive::Ambient(colour))
        }
        "sky" => {
            let zenith = words.colour(["sky red", "sky green", "sky blue"])?;
            let up = match words.more()? {
                true => Some(words.point(["sky x", "sky y", "sky z"])?),
                false => None,
            };
            words.end("sky")?;
            if up == Some(DVec3::ZERO) {
                return Err(Fault::NoDirection("the direction to the zenith").into());
            }
            Ok(Directive::Sky { zenith, up })
        }
        "fog" => {
            let colour = words.colour(["fog red", "fog green", "fog blue"])?;
            let density = words.not_negative("fog density")?;
            words.end("fog")?;
            Ok(Directive::Fog(Fog { colour, density }))
        }
        "daylight" => {
            words.end("daylight")?;
            Ok(Directive::Daylight)
        }
        "lamp" => {
            let position = words.point(["lamp x", "lamp y", "lamp z"])?;
            let (field, range) = ("lamp range", words.real("lamp range")?);
            if range <= 0.0 {
                return Err(Fault::NotPositive { field, value: range }.into());
            }
            let colour = words.light_colour()?;
            words.end("lamp")?;
            Ok(Directive::Light { kind: LightKind::Point { position, range }, colour })
        }
        "sun" => {
            let to_light = words.point(["sun x", "sun y", "sun z"])?;
            let colour = words.light_colour()?;
            words.end("sun")?;
            if to_light == DVec3::ZERO {
                return Err(Fault::NoDirection("the direction to the sun").into());
            }
            Ok(Directive::Light { kind: LightKind::Directional { to_light }, colour })
        }
        "heights" => {
            let file = words.word("height map file")?.to_owned();
            let mut positive = |field| match words.real(field)? {
                value if value > 0.0 => Ok(value),
                value => Err(LineError::from(Fault::NotPositive { field, value })),
            };
            let scale = (positive("height map step")?, positive("height map unit")?);
            let colours = match words.more()? {
                true => Some(words.word("height map colours")?.to_owned()),
                false => None,
            };
            words.end("height map")?;
            Ok(Directive::HeightMap(HeightMap { line: 0, file, scale, colours, material: 0 }))
        }
        "shader" => {
            let shader = shader(words)?;
            words.end("shader")?;
            Ok(Directive::Shader(shader))
        }
        other => Err(Fault::UnknownDirective(Excerpt::of(other)).into()),
    }
}

fn shader(words: &mut Words<impl BufRead>) -> Result<Shader, LineError> {
    match words.word("name of the shader")? {
        "flat" => Ok(Shader::Flat),
        "lambert" => Ok(Shader::Lambert),
        "phong" => Ok(Shader::Phong),
        "checker" => {
            let other = words.colour(["checker red", "checker green", "checker blue"])?;
            let (field, size) = ("checker size", words.real("checker size")?);
            if size <= 0.0 {
                return Err(Fault::NotPositive { field, value: size }.into());
            }
            Ok(Shader::Checker { other, size })
        }
        "depth" => {
            let far = words.not_negative("depth far")?;
            let near = words.not_negative("depth near")?;
            if far <= near {
                return Err(Fault::DepthRange { far, near }.into());
            }
            Ok(Shader::Depth { far, near })
        }
        "portal" => {
            let by = words.point(["portal x", "portal y", "portal z"])?;
            let turn = if words.more()? { words.real("portal turn")? } else { 0.0 };
            Ok(Shader::Portal { by, turn })
        }
        name => {
            let mut rest = name.chars();
            let begins = rest.next().is_some_and(|c| c.is_ascii_alphabetic());
            if !begins || !rest.all(|c| c.is_ascii_alphanumeric() || c == '_') {
                return Err(Fault::ShaderName(Excerpt::of(name)).into());
            }
            let name = name.to_owned();
            let mut parameters = [0.0; 4];
            for parameter in &mut parameters {
                if words.more()? {
                    *parameter = words.real("parameter of the shader")?;
                }
            }
            Ok(Shader::Own { name, parameters })
        }
    }
}
