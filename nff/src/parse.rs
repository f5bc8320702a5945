//! The grammar: from lines to a scene.
//!
//! Invariant: what is allocated grows with what was read, never with what the file announces.

use std::fs::File;
use std::io::{BufRead, BufReader};
use std::path::Path;

use glam::DVec3;

use crate::directives::{self, Directive};
use crate::error::Excerpt;
use crate::lines::{DIRECTIVE, LineError, Lines};
use crate::view;
use crate::words::Words;
use crate::{Error, Fault, Light, LightKind, Limits, Material, Object, Scene, Shader, Shape, View};

/// Reads a scene file within the default [`Limits`].
///
/// # Errors
/// A file that can't be read, and all that [`parse`] refuses.
pub fn read(path: &Path) -> Result<Scene, Error> {
    let name = path.display().to_string();
    match File::open(path) {
        Ok(file) => parse(BufReader::new(file), &name, &Limits::default()),
        Err(source) => Err(Error::Io { file: name, source }),
    }
}

/// Parses a scene; `name` is what messages call it.
///
/// Lights and the background may stand anywhere: that they come before the objects helps only
/// programs that draw while they read.
///
/// # Errors
/// A reader that fails, text that is not NFF, and scenes beyond `limits`; each with its line.
pub fn parse(reader: impl BufRead, name: &str, limits: &Limits) -> Result<Scene, Error> {
    let mut parser = Parser::new(reader, limits);
    parser
        .run()
        .and_then(|()| parser.take(name))
        .map_err(|error| match error {
            LineError::Io(source) => Error::Io {
                file: name.to_owned(),
                source,
            },
            // An empty file has no line, but a message needs one.
            LineError::Fault(fault) => Error::Text {
                file: name.to_owned(),
                line: parser.lines.number().max(1),
                fault,
            },
        })
}

impl<T: Into<Fault>> From<T> for LineError {
    fn from(fault: T) -> Self {
        Self::Fault(fault.into())
    }
}

/// An entity that takes more than its first line.
#[derive(Clone, Copy)]
struct Entity {
    name: &'static str,
    start: u32,
}

struct Parser<'a, R> {
    lines: Lines<R>,
    limits: &'a Limits,
    view: Option<(u32, View)>,
    background: Option<(u32, DVec3)>,
    ambient: Option<(u32, DVec3)>,
    /// Line of the last material's shader.
    shader: Option<u32>,
    lights: Vec<Light>,
    materials: Vec<Material>,
    objects: Vec<Object>,
    vertices: usize,
}

impl<'a, R: BufRead> Parser<'a, R> {
    fn new(reader: R, limits: &'a Limits) -> Self {
        Self {
            lines: Lines::new(reader, limits),
            limits,
            view: None,
            background: None,
            ambient: None,
            shader: None,
            lights: Vec::new(),
            materials: Vec::new(),
            objects: Vec::new(),
            vertices: 0,
        }
    }

    fn run(&mut self) -> Result<(), LineError> {
        while let Some(text) = self.lines.advance()? {
            let mut words = Words::of(text);
            match words.keyword() {
                "v" => {
                    words.end("view")?;
                    self.view()?;
                }
                "b" => {
                    let colour =
                        words.colour(["background red", "background green", "background blue"])?;
                    words.end("background")?;
                    self.background(colour)?;
                }
                "l" => {
                    let light = words.light()?;
                    self.light(light)?;
                }
                "f" => {
                    let material = words.material()?;
                    self.material(material)?;
                }
                "s" => {
                    let sphere = words.sphere()?;
                    self.object("sphere", self.lines.number(), |_| Ok(sphere))?;
                }
                "c" => {
                    words.end("cone")?;
                    self.object("cone", self.lines.number(), Self::cone)?;
                }
                "p" => {
                    let count = words.count("polygon")?;
                    self.object("polygon", self.lines.number(), |parser| {
                        parser.polygon(count)
                    })?;
                }
                "pp" => {
                    let count = words.count("patch")?;
                    self.object("patch", self.lines.number(), |parser| parser.patch(count))?;
                }
                DIRECTIVE => {
                    let directive = directives::read(&mut words)?;
                    self.directive(directive)?;
                }
                other => return Err(Fault::UnknownEntity(Excerpt::of(other)).into()),
            }
        }
        Ok(())
    }

    /// The scene, of what was read.
    fn take(&mut self, name: &str) -> Result<Scene, LineError> {
        let (_, view) = self.view.take().ok_or(Fault::NoView)?;
        Ok(Scene {
            name: name.to_owned(),
            view,
            background: self.background.map_or(DVec3::ZERO, |(_, colour)| colour),
            ambient: self.ambient.map_or(DVec3::ZERO, |(_, colour)| colour),
            lights: std::mem::take(&mut self.lights),
            materials: std::mem::take(&mut self.materials),
            objects: std::mem::take(&mut self.objects),
        })
    }

    fn view(&mut self) -> Result<(), LineError> {
        let start = self.lines.number();
        once("view (v)", self.view.as_ref().map(|(line, _)| *line))?;
        let entity = Entity {
            name: "view",
            start,
        };
        let from = self.view_line(entity, "from", |words| {
            words.point(["from x", "from y", "from z"])
        })?;
        let (at, sight) = self.view_line(entity, "at", |words| {
            let at = words.point(["at x", "at y", "at z"])?;
            Ok((at, view::sight(from, at)?))
        })?;
        let up = self.view_line(entity, "up", |words| {
            let up = words.point(["up x", "up y", "up z"])?;
            view::right(sight, up)?;
            Ok(up)
        })?;
        let angle = self.view_line(entity, "angle", |words| {
            let angle = words.real("angle")?;
            view::check_angle(angle)?;
            Ok(angle)
        })?;
        let hither = self.view_line(entity, "hither", |words| {
            let hither = words.real("hither")?;
            view::check_hither(hither)?;
            Ok(hither)
        })?;
        let resolution = self.view_line(entity, "resolution", |words| {
            let width = words.side("resolution width")?;
            let height = words.side("resolution height")?;
            view::check_size(width, height)?;
            Ok((width, height))
        })?;
        let view = View {
            from,
            at,
            up,
            angle,
            hither,
            resolution,
        };
        self.view = Some((start, view));
        Ok(())
    }

    /// One of the view's lines.
    fn view_line<T>(
        &mut self,
        view: Entity,
        keyword: &'static str,
        read: impl FnOnce(&mut Words<'_>) -> Result<T, Fault>,
    ) -> Result<T, LineError> {
        let mut words = self.continuation(view)?;
        let found = words.keyword();
        if found != keyword {
            return Err(Fault::ViewLine {
                expected: keyword,
                value: Excerpt::of(found),
            }
            .into());
        }
        let value = read(&mut words)?;
        words.end(keyword)?;
        Ok(value)
    }

    /// The next line of an entity that is not at its end.
    fn continuation(&mut self, entity: Entity) -> Result<Words<'_>, LineError> {
        let fault = Fault::Truncated {
            entity: entity.name,
            start: entity.start,
        };
        Ok(Words::of(self.lines.advance()?.ok_or(fault)?))
    }

    fn background(&mut self, colour: DVec3) -> Result<(), LineError> {
        once("background (b)", self.background.map(|(line, _)| line))?;
        self.background = Some((self.lines.number(), colour));
        Ok(())
    }

    fn directive(&mut self, directive: Directive) -> Result<(), LineError> {
        match directive {
            Directive::Ambient(colour) => {
                once("ambient light", self.ambient.map(|(line, _)| line))?;
                self.ambient = Some((self.lines.number(), colour));
                Ok(())
            }
            Directive::Sun { to_light, colour } => {
                self.light((LightKind::Directional { to_light }, colour))
            }
            Directive::Shader(shader) => self.shader(shader),
        }
    }

    fn shader(&mut self, shader: Shader) -> Result<(), LineError> {
        let material = self.materials.last_mut().ok_or(Fault::TooEarly {
            entity: "shader",
            needed: "first material (f)",
        })?;
        once("shader of this material", self.shader)?;
        self.shader = Some(self.lines.number());
        material.shader = shader;
        Ok(())
    }

    fn light(&mut self, (kind, colour): (LightKind, Option<DVec3>)) -> Result<(), LineError> {
        room(self.lights.len(), "lights", self.limits.objects)?;
        self.lights.push(Light {
            line: self.lines.number(),
            kind,
            colour,
        });
        Ok(())
    }

    fn material(&mut self, material: Material) -> Result<(), LineError> {
        room(
            self.materials.len(),
            "materials",
            self.limits.objects.min(u32::MAX as usize),
        )?;
        self.shader = None;
        self.materials.push(Material {
            line: self.lines.number(),
            ..material
        });
        Ok(())
    }

    /// Adds the object that starts on `line`; `shape` reads what is left of it.
    fn object(
        &mut self,
        entity: &'static str,
        line: u32,
        shape: impl FnOnce(&mut Self) -> Result<Shape, LineError>,
    ) -> Result<(), LineError> {
        if self.view.is_none() {
            return Err(Fault::TooEarly {
                entity,
                needed: "view (v)",
            }
            .into());
        }
        let Some(material) = self.materials.len().checked_sub(1) else {
            return Err(Fault::TooEarly {
                entity,
                needed: "first material (f)",
            }
            .into());
        };
        room(self.objects.len(), "objects", self.limits.objects)?;
        let shape = shape(self)?;
        // `material` keeps the number of materials within a u32.
        self.objects.push(Object {
            line,
            material: material as u32,
            shape,
        });
        Ok(())
    }

    fn cone(&mut self) -> Result<Shape, LineError> {
        let cone = Entity {
            name: "cone",
            start: self.lines.number(),
        };
        let mut words = self.continuation(cone)?;
        let base = words.point(["base x", "base y", "base z"])?;
        let base_radius = words.real("base radius")?;
        words.end("cone's base")?;
        let mut words = self.continuation(cone)?;
        let apex = words.point(["apex x", "apex y", "apex z"])?;
        let apex_radius = words.real("apex radius")?;
        words.end("cone's apex")?;
        if base_radius == 0.0 && apex_radius == 0.0 {
            return Err(Fault::ZeroRadius("each of base radius and apex radius").into());
        }
        if base_radius.max(apex_radius) > 0.0 && base_radius.min(apex_radius) < 0.0 {
            return Err(Fault::MixedRadii {
                base: base_radius,
                apex: apex_radius,
            }
            .into());
        }
        if base == apex {
            return Err(Fault::FlatCone.into());
        }
        Ok(Shape::Cone {
            base,
            base_radius,
            apex,
            apex_radius,
        })
    }

    fn polygon(&mut self, count: u64) -> Result<Shape, LineError> {
        let mut vertices = Vec::new();
        self.vertices("polygon", count, |words| {
            vertices.push(words.vertex()?);
            Ok(())
        })?;
        vertices.shrink_to_fit();
        Ok(Shape::Polygon { vertices })
    }

    fn patch(&mut self, count: u64) -> Result<Shape, LineError> {
        let (mut vertices, mut normals) = (Vec::new(), Vec::new());
        self.vertices("patch", count, |words| {
            vertices.push(words.vertex()?);
            normals.push(words.point(["normal x", "normal y", "normal z"])?);
            Ok(())
        })?;
        vertices.shrink_to_fit();
        normals.shrink_to_fit();
        Ok(Shape::Patch { vertices, normals })
    }

    /// The `count` lines of a polygon or a patch, each read by `read`.
    fn vertices(
        &mut self,
        name: &'static str,
        count: u64,
        mut read: impl FnMut(&mut Words<'_>) -> Result<(), Fault>,
    ) -> Result<(), LineError> {
        if count < 3 {
            return Err(Fault::FewVertices {
                entity: name,
                count,
            }
            .into());
        }
        let limit = self.limits.vertices;
        let left = limit.saturating_sub(self.vertices);
        // Refused before the first vertex is read; `count` may be far beyond any memory.
        let count = usize::try_from(count).ok().filter(|&count| count <= left);
        let count = count.ok_or(Fault::TooMany {
            what: "vertices",
            limit,
        })?;
        let entity = Entity {
            name,
            start: self.lines.number(),
        };
        for _ in 0..count {
            let mut words = self.continuation(entity)?;
            read(&mut words)?;
            words.end("vertex")?;
        }
        self.vertices += count;
        Ok(())
    }
}

/// Whether what may be given once was not; else its first line is here.
fn once(entity: &'static str, first: Option<u32>) -> Result<(), Fault> {
    first.map_or(Ok(()), |first| Err(Fault::Second { entity, first }))
}

/// Whether one more of `what` may be added to `len`.
fn room(len: usize, what: &'static str, limit: usize) -> Result<(), Fault> {
    if len < limit {
        Ok(())
    } else {
        Err(Fault::TooMany { what, limit })
    }
}
