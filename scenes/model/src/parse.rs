//! The grammar, which turns words into a scene.
//!
//! Invariant: allocated memory grows with the text that was read, never with a number in the file.

use std::fs::File;
use std::io::{BufRead, BufReader};
use std::path::Path;

use glam::DVec3;

use crate::daylight;
use crate::directives::{self, Directive};
use crate::lines::{DIRECTIVE, LineError};
use crate::view;
use crate::words::Words;
use crate::{
    Error, Fault, Fog, HeightMap, Light, LightKind, Limits, Material, Object, Scene, Shader, Shape,
    Sky, View,
};

/// The names of entities in messages.
const VIEW: &str = "view";
const BACKGROUND: &str = "background";
const LIGHT: &str = "light";
const MATERIAL: &str = "material";
const SPHERE: &str = "sphere";
const CONE: &str = "cone";
const POLYGON: &str = "polygon";
const PATCH: &str = "patch";

/// The name of the entity with this keyword.
fn name(keyword: &str) -> Option<&'static str> {
    Some(match keyword {
        "v" => VIEW,
        "b" => BACKGROUND,
        "l" => LIGHT,
        "f" => MATERIAL,
        "s" => SPHERE,
        "c" => CONE,
        "p" => POLYGON,
        "pp" => PATCH,
        DIRECTIVE => DIRECTIVE,
        _ => return None,
    })
}

/// Reads a scene file within the default [`Limits`].
///
/// # Errors
/// The file can't be read, or any error of [`parse`].
pub fn read(path: &Path) -> Result<Scene, Error> {
    let name = path.display().to_string();
    match File::open(path) {
        Ok(file) => parse(BufReader::new(file), &name, &Limits::default()),
        Err(source) => Err(Error::Io { file: name, source }),
    }
}

/// Parses a scene; error messages begin with `name`.
///
/// Lights and the background may be anywhere in the text. Only programs that draw while they read
/// need them before the objects.
///
/// # Errors
/// - The reader fails.
/// - The text is not NFF, or the scene exceeds `limits`; the error names the line.
pub fn parse(reader: impl BufRead, name: &str, limits: &Limits) -> Result<Scene, Error> {
    let mut parser = Parser::new(reader, limits);
    parser.run().and_then(|()| parser.take(name)).map_err(|error| match error {
        LineError::Io(source) => Error::Io { file: name.to_owned(), source },
        // An empty file has no line, but the message needs one.
        LineError::Fault(fault) => {
            Error::Text { file: name.to_owned(), line: parser.words.line().max(1), fault }
        }
    })
}

impl<T: Into<Fault>> From<T> for LineError {
    fn from(fault: T) -> Self {
        Self::Fault(fault.into())
    }
}

struct Parser<'a, R> {
    words: Words<R>,
    limits: &'a Limits,
    view: Option<(u32, View)>,
    background: Option<(u32, DVec3)>,
    ambient: Option<(u32, DVec3)>,
    /// The line of the sky, its zenith's colour and direction.
    sky: Option<(u32, DVec3, Option<DVec3>)>,
    /// The line of the fog, and the fog.
    fog: Option<(u32, Fog)>,
    /// The line of the daylight.
    daylight: Option<u32>,
    /// The line of the last material's shader.
    shader: Option<u32>,
    height_map: Option<HeightMap>,
    lights: Vec<Light>,
    materials: Vec<Material>,
    objects: Vec<Object>,
    vertices: usize,
}

impl<'a, R: BufRead> Parser<'a, R> {
    fn new(reader: R, limits: &'a Limits) -> Self {
        Self {
            words: Words::new(reader, limits),
            limits,
            view: None,
            background: None,
            ambient: None,
            sky: None,
            fog: None,
            daylight: None,
            shader: None,
            height_map: None,
            lights: Vec::new(),
            materials: Vec::new(),
            objects: Vec::new(),
            vertices: 0,
        }
    }

    fn run(&mut self) -> Result<(), LineError> {
        while let Some(entity) = self.words.entity(name)? {
            match entity {
                VIEW => self.view()?,
                BACKGROUND => self.background()?,
                LIGHT => {
                    self.check_light_count()?;
                    let light = self.words.light()?;
                    self.light(light);
                }
                MATERIAL => self.material()?,
                SPHERE => self.object(entity, |parser| parser.words.sphere())?,
                CONE => self.object(entity, Self::cone)?,
                POLYGON => self.object(entity, Self::polygon)?,
                PATCH => self.object(entity, Self::patch)?,
                _ => self.directive()?,
            }
        }
        Ok(())
    }

    /// Makes the scene of the entities that were read.
    fn take(&mut self, name: &str) -> Result<Scene, LineError> {
        let (_, view) = self.view.take().ok_or(Fault::NoView)?;
        let mut sky = self.sky.map(|(_, zenith, up)| Sky { zenith, up: up.unwrap_or(view.up) });
        let [mut background, mut ambient] = [DVec3::ZERO; 2];
        if let Some(line) = self.daylight {
            [background, ambient] = [daylight::HORIZON, daylight::AMBIENT];
            sky = sky.or(Some(Sky::of_day(view.up)));
            let sun = daylight::sun(&view)?;
            self.lights.push(Light { line, ..sun });
        }
        Ok(Scene {
            name: name.to_owned(),
            view,
            background: self.background.map_or(background, |(_, colour)| colour),
            sky,
            fog: self.fog.map(|(_, fog)| fog),
            ambient: self.ambient.map_or(ambient, |(_, colour)| colour),
            lights: std::mem::take(&mut self.lights),
            materials: std::mem::take(&mut self.materials),
            objects: std::mem::take(&mut self.objects),
            mesh: None,
            heights: None,
            height_map: self.height_map.take(),
        })
    }

    fn view(&mut self) -> Result<(), LineError> {
        let start = self.words.start();
        once("view (v)", self.view.as_ref().map(|(line, _)| *line))?;
        let words = &mut self.words;
        words.expect("from")?;
        let from = words.point(["from x", "from y", "from z"])?;
        words.expect("at")?;
        let at = words.point(["at x", "at y", "at z"])?;
        let sight = view::sight(from, at)?;
        words.expect("up")?;
        let up = words.point(["up x", "up y", "up z"])?;
        view::right(sight, up)?;
        words.expect("angle")?;
        let angle = words.real("angle")?;
        view::check_angle(angle)?;
        words.expect("hither")?;
        let hither = words.real("hither")?;
        view::check_hither(hither)?;
        words.expect("resolution")?;
        let resolution = (words.side("resolution width")?, words.side("resolution height")?);
        view::check_size(resolution.0, resolution.1)?;
        let view = View { from, at, up, angle, hither, resolution };
        self.view = Some((start, view));
        Ok(())
    }

    fn background(&mut self) -> Result<(), LineError> {
        let start = self.words.start();
        once("background (b)", self.background.map(|(line, _)| line))?;
        let fields = ["background red", "background green", "background blue"];
        self.background = Some((start, self.words.colour(fields)?));
        Ok(())
    }

    fn directive(&mut self) -> Result<(), LineError> {
        match directives::read(&mut self.words)? {
            Directive::Ambient(colour) => {
                once("ambient light", self.ambient.map(|(line, _)| line))?;
                self.ambient = Some((self.words.start(), colour));
                Ok(())
            }
            Directive::Light { kind, colour } => {
                self.check_light_count()?;
                self.light((kind, colour));
                Ok(())
            }
            Directive::Sky { zenith, up } => {
                once("sky", self.sky.map(|(line, ..)| line))?;
                self.sky = Some((self.words.start(), zenith, up));
                Ok(())
            }
            Directive::Fog(fog) => {
                once("fog", self.fog.map(|(line, _)| line))?;
                self.fog = Some((self.words.start(), fog));
                Ok(())
            }
            Directive::Daylight => {
                once("daylight", self.daylight)?;
                self.check_light_count()?;
                self.daylight = Some(self.words.start());
                Ok(())
            }
            Directive::HeightMap(map) => {
                once("height map", self.height_map.as_ref().map(|map| map.line))?;
                let material = self.last_material("height map")?;
                self.height_map = Some(HeightMap { line: self.words.start(), material, ..map });
                Ok(())
            }
            Directive::Shader(shader) => self.shader(shader),
        }
    }

    fn shader(&mut self, shader: Shader) -> Result<(), LineError> {
        let material = self
            .materials
            .last_mut()
            .ok_or(Fault::TooEarly { entity: "shader", needed: "first material (f)" })?;
        once("shader of this material", self.shader)?;
        self.shader = Some(self.words.start());
        material.shader = shader;
        Ok(())
    }

    fn check_light_count(&self) -> Result<(), Fault> {
        check_count(self.lights.len(), "lights", self.limits.objects)
    }

    fn light(&mut self, (kind, colour): (LightKind, Option<DVec3>)) {
        self.lights.push(Light { line: self.words.start(), kind, colour });
    }

    fn material(&mut self) -> Result<(), LineError> {
        check_count(self.materials.len(), "materials", self.limits.objects.min(u32::MAX as usize))?;
        self.shader = None;
        self.materials.push(Material { line: self.words.start(), ..self.words.material()? });
        Ok(())
    }

    /// Adds an object whose keyword was read; `shape` reads the rest of it.
    fn object(
        &mut self,
        entity: &'static str,
        shape: impl FnOnce(&mut Self) -> Result<Shape, LineError>,
    ) -> Result<(), LineError> {
        if self.view.is_none() {
            return Err(Fault::TooEarly { entity, needed: "view (v)" }.into());
        }
        let material = self.last_material(entity)?;
        check_count(self.objects.len(), "objects", self.limits.objects)?;
        let line = self.words.start();
        let shape = shape(self)?;
        self.objects.push(Object { line, material, shape });
        Ok(())
    }

    /// The index of the last material, which what comes after it has.
    fn last_material(&self, entity: &'static str) -> Result<u32, Fault> {
        let last = self.materials.len().checked_sub(1);
        // `material` keeps the number of materials within a u32.
        let last = last.map(|last| last as u32);
        last.ok_or(Fault::TooEarly { entity, needed: "first material (f)" })
    }

    fn cone(&mut self) -> Result<Shape, LineError> {
        let words = &mut self.words;
        let base = words.point(["base x", "base y", "base z"])?;
        let base_radius = words.real("base radius")?;
        let apex = words.point(["apex x", "apex y", "apex z"])?;
        let apex_radius = words.real("apex radius")?;
        if base_radius == 0.0 && apex_radius == 0.0 {
            return Err(Fault::ZeroRadius("each of base radius and apex radius").into());
        }
        if base_radius.max(apex_radius) > 0.0 && base_radius.min(apex_radius) < 0.0 {
            return Err(Fault::MixedRadii { base: base_radius, apex: apex_radius }.into());
        }
        if base == apex {
            return Err(Fault::FlatCone.into());
        }
        Ok(Shape::Cone { base, base_radius, apex, apex_radius })
    }

    fn polygon(&mut self) -> Result<Shape, LineError> {
        let mut vertices = Vec::new();
        for _ in 0..self.vertices(POLYGON)? {
            vertices.push(self.words.vertex()?);
        }
        vertices.shrink_to_fit();
        Ok(Shape::Polygon { vertices })
    }

    fn patch(&mut self) -> Result<Shape, LineError> {
        let (mut vertices, mut normals) = (Vec::new(), Vec::new());
        for _ in 0..self.vertices(PATCH)? {
            vertices.push(self.words.vertex()?);
            normals.push(self.words.point(["normal x", "normal y", "normal z"])?);
        }
        vertices.shrink_to_fit();
        normals.shrink_to_fit();
        Ok(Shape::Patch { vertices, normals })
    }

    /// Reads the number of vertices. A number beyond the limit is refused before the first vertex
    /// is read, because it may exceed all memory.
    fn vertices(&mut self, entity: &'static str) -> Result<usize, LineError> {
        let limit = self.limits.vertices;
        let count = self.words.count(limit)?;
        if count < 3 {
            return Err(Fault::FewVertices { entity, count }.into());
        }
        if count > limit - self.vertices {
            return Err(Fault::TooMany { what: "vertices", limit }.into());
        }
        self.vertices += count;
        Ok(count)
    }
}

/// Checks that an entity occurs only once; `first` is the line of an earlier one.
fn once(entity: &'static str, first: Option<u32>) -> Result<(), Fault> {
    first.map_or(Ok(()), |first| Err(Fault::Second { entity, first }))
}

/// Checks that the limit allows one more of `what`.
fn check_count(len: usize, what: &'static str, limit: usize) -> Result<(), Fault> {
    if len < limit { Ok(()) } else { Err(Fault::TooMany { what, limit }) }
}
