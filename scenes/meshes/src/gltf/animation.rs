//! Animations: the channels that move nodes and morph targets, and the vertices at a time.

use glam::{DQuat, DVec3, Vec3};
use scenes::Mesh;

use super::accessor::Data;
use super::json;
use super::nodes::Nodes;
use super::part::{Part, Skin};
use super::sampler::{Budget, Sampler};
use super::{within, wrong};
use crate::Fault;
use crate::builder::{Cut, LARGEST};
use crate::notes::Notes;

/// The name of no animation.
pub(crate) const NONE: &str = "none";

/// The times at which an animation is looked at when it is loaded.
const TIMES: u32 = 16;

/// A property of a node.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Property {
    Translation,
    Rotation,
    Scale,
    Weights,
}

#[derive(Clone, Debug, PartialEq)]
struct Channel {
    node: usize,
    property: Property,
    sampler: Sampler,
}

/// The channels of an animation, or of none.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Channels {
    name: Option<String>,
    channels: Vec<Channel>,
}

impl Channels {
    /// Reads the animation that was chosen, by its name or its number: the first one without a
    /// choice.
    pub fn read(data: &Data<'_>, chosen: Option<&str>, notes: &mut Notes) -> Result<Self, Fault> {
        let all = &data.root.animations;
        let index = match chosen {
            Some(NONE) => return Ok(Self::default()),
            None if all.is_empty() => return Ok(Self::default()),
            None => 0,
            Some(name) => {
                let number = || name.parse().ok().filter(|number| *number < all.len());
                let found = all.iter().position(|it| it.name.as_deref() == chosen).or_else(number);
                found.ok_or_else(|| Fault::NoAnimation {
                    name: name.to_owned(),
                    known: all.iter().enumerate().map(display_name).collect(),
                })?
            }
        };
        let animation = &all[index];
        let name = display_name((index, animation));
        let mut read =
            Self { name: Some(animation.name.clone().unwrap_or_default()), channels: vec![] };
        let mut budget = Budget::default();
        for (number, channel) in animation.channels.iter().enumerate() {
            let place = format!("animation {name}, channel {number}");
            let channel = Channel::read(data, animation, channel, &mut budget, notes);
            read.channels.extend(channel.map_err(|fault| within(&place, fault))?);
        }
        Ok(read)
    }

    pub fn are_none(&self) -> bool {
        self.name.is_none()
    }

    /// The time of the last key.
    fn duration(&self) -> f64 {
        self.channels.iter().map(|channel| channel.sampler.end()).fold(0.0, f64::max)
    }

    /// Sets the nodes as they are at a time.
    pub fn set(&self, nodes: &mut Nodes, time: f64) {
        for Channel { node, property, sampler } in &self.channels {
            let mut value = [0.0; 4];
            let local = &mut nodes.locals[*node];
            match property {
                Property::Translation => {
                    sampler.at(time, &mut value[..3]);
                    local.translation = DVec3::from_slice(&value);
                }
                Property::Rotation => {
                    sampler.at(time, &mut value);
                    local.rotation = DQuat::from_array(value);
                }
                Property::Scale => {
                    sampler.at(time, &mut value[..3]);
                    local.scale = DVec3::from_slice(&value);
                }
                Property::Weights => sampler.at(time, &mut nodes.weights[*node]),
            }
        }
        nodes.place();
    }

    /// The nodes that are placed anew, and those whose morph targets are weighted anew.
    pub fn moved(&self, nodes: &Nodes) -> [Vec<bool>; 2] {
        let mut driven = vec![false; nodes.places.len()];
        let mut morphed = driven.clone();
        for channel in &self.channels {
            match channel.property {
                Property::Weights => morphed[channel.node] = true,
                _ => driven[channel.node] = true,
            }
        }
        [nodes.moved_with(driven), morphed]
    }

    /// The corners of a box around what moves, at times between which it moves little.
    pub fn reach(
        &self,
        nodes: &mut Nodes,
        skins: &mut [Option<Skin>],
        parts: &[Part],
    ) -> Option<[DVec3; 2]> {
        let mut reach = None;
        for step in 0..TIMES {
            self.set(nodes, self.duration() * f64::from(step) / f64::from(TIMES));
            skins.iter_mut().flatten().for_each(|skin| skin.place(nodes));
            for part in parts {
                part.vertices(nodes, skins, |place, _| {
                    // The frame that has a vertex anywhere else will be refused.
                    if place.abs().max_element() <= LARGEST {
                        let [low, high] = reach.unwrap_or([place; 2]);
                        reach = Some([low.min(place), high.max(place)]);
                    }
                });
            }
        }
        reach
    }

    /// Whether it mirrors a node at some times and not at others.
    pub fn mirror(&self) -> bool {
        let mut scales = self.channels.iter().filter(|it| it.property == Property::Scale);
        scales.any(|it| it.sampler.changes_sign())
    }
}

/// The name of an animation, or its number if it has none.
fn display_name((index, animation): (usize, &json::Animation)) -> String {
    let name = animation.name.as_deref().filter(|name| !name.is_empty());
    name.map_or(index.to_string(), |name| scenes::Excerpt::of(name).to_string())
}

impl Channel {
    /// Reads a channel; `None` if it drives nothing that is shown.
    fn read(
        data: &Data<'_>,
        animation: &json::Animation,
        channel: &json::Channel,
        budget: &mut Budget,
        notes: &mut Notes,
    ) -> Result<Option<Self>, Fault> {
        let json::ChannelTarget { node, path } = &channel.target;
        let Some(node) = *node else {
            // An extension drives something else.
            notes.add("animations move only nodes and morph targets");
            return Ok(None);
        };
        let found = data.root.nodes.get(node);
        let found = found.ok_or_else(|| wrong(format!("node {node} doesn't exist")))?;
        let (property, kind, width) = match path.as_str() {
            "translation" => (Property::Translation, "VEC3", 3),
            "rotation" => (Property::Rotation, "VEC4", 4),
            "scale" => (Property::Scale, "VEC3", 3),
            "weights" => {
                let mesh = found.mesh.and_then(|mesh| data.root.meshes.get(mesh));
                let first = mesh.and_then(|mesh| mesh.primitives.first());
                (Property::Weights, "SCALAR", first.map_or(0, |first| first.targets.len()))
            }
            other => {
                let other = scenes::Excerpt::of(other);
                return Err(wrong(format!(
                    "{other} is not translation, rotation, scale or weights"
                )));
            }
        };
        if property != Property::Weights && found.matrix.is_some() {
            return Err(wrong(format!("node {node} has a matrix, which no animation can move")));
        }
        if width == 0 {
            return Err(wrong(format!("node {node} has no morph targets")));
        }
        let sampler = animation.samplers.get(channel.sampler);
        let sampler =
            sampler.ok_or_else(|| wrong(format!("sampler {} doesn't exist", channel.sampler)))?;
        let sampler = Sampler::read(data, sampler, (kind, width), budget)?;
        Ok(Some(Self { node, property, sampler }))
    }
}

/// An animation of a mesh: the positions and normals of its vertices at any time.
///
/// ```no_run
/// use meshes::Animation;
///
/// let loaded = meshes::load("fox.glb".as_ref())?;
/// if let Some(mut animation) = loaded.animation {
///     let (positions, normals) = animation.at(0.5);
///     println!("{} vertices and {} normals", positions.len(), normals.len());
/// }
/// # Ok::<(), meshes::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Animation {
    channels: Channels,
    duration: f64,
    nodes: Nodes,
    skins: Vec<Option<Skin>>,
    /// Those that move.
    parts: Vec<Part>,
    cuts: Vec<Cut>,
    origin: DVec3,
    positions: Vec<[f32; 3]>,
    normals: Vec<[f32; 3]>,
}

impl Animation {
    /// An animation of a mesh, of which these parts move. Triangles that are never seen are dropped
    /// from the mesh: rounding gives them an area at times, and the scene a new tree each time.
    pub(super) fn new(
        channels: Channels,
        (nodes, skins, parts): (Nodes, Vec<Option<Skin>>, Vec<Part>),
        cuts: Vec<Cut>,
        mesh: &mut Mesh,
    ) -> Self {
        let mut animation = Self {
            duration: channels.duration(),
            channels,
            nodes,
            skins,
            parts,
            cuts,
            origin: mesh.origin,
            positions: mesh.positions.clone(),
            normals: mesh.normals.clone(),
        };
        let mut are_seen = vec![false; mesh.triangles.len()];
        for step in 0..TIMES {
            let time = animation.duration * f64::from(step) / f64::from(TIMES);
            let (positions, _) = animation.at(time);
            for (is_seen, triangle) in are_seen.iter_mut().zip(&mesh.triangles) {
                *is_seen = *is_seen || has_area(triangle.map(|it| positions[it as usize].into()));
            }
        }
        if are_seen.contains(&true) {
            let mut seen = are_seen.iter();
            mesh.triangles.retain(|_| *seen.next().unwrap_or(&true));
            let mut seen = are_seen.iter();
            mesh.materials.retain(|_| *seen.next().unwrap_or(&true));
        }
        animation
    }

    /// The name that it has in its file. It may be empty.
    #[must_use]
    pub fn name(&self) -> &str {
        self.channels.name.as_deref().unwrap_or_default()
    }

    /// The time of the last key in seconds.
    #[must_use]
    pub fn duration(&self) -> f64 {
        self.duration
    }

    /// The positions of the mesh's vertices, relative to its origin, and their normals, if it has
    /// any. The animation begins at the time 0 in seconds, and is repeated without end. Allocates
    /// no memory.
    pub fn at(&mut self, time: f64) -> (&[[f32; 3]], &[[f32; 3]]) {
        let time = if self.duration > 0.0 { time.rem_euclid(self.duration) } else { 0.0 };
        self.channels.set(&mut self.nodes, time);
        for skin in self.skins.iter_mut().flatten() {
            skin.place(&self.nodes);
        }
        for part in &self.parts {
            let mut vertex = part.first;
            part.vertices(&self.nodes, &self.skins, |position, normal| {
                self.positions[vertex] = (position - self.origin).as_vec3().to_array();
                if let Some(normal) = normal {
                    self.normals[vertex] = normal.as_vec3().to_array();
                }
                vertex += 1;
            });
        }
        for cut in &self.cuts {
            cut.mix(&mut self.positions);
            cut.mix(&mut self.normals);
        }
        (&self.positions, &self.normals)
    }
}

/// Whether a triangle is more than a line, but for the rounding of its corners.
fn has_area(corners: [Vec3; 3]) -> bool {
    let [a, b, c] = corners.map(|corner| corner.as_dvec3());
    let longest = [b - a, c - b, a - c].map(|edge| edge.length()).into_iter().fold(0.0, f64::max);
    let largest = a.abs().max(b.abs()).max(c.abs()).max_element();
    (b - a).cross(c - a).length() > 8.0 * f64::from(f32::EPSILON) * largest * longest
}
