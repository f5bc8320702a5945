//! Vertices as a file has them, and where morph targets, joints or a node take them.

use std::collections::HashMap;

use glam::{DAffine3, DMat3, DMat4, DVec3};

use super::accessor::{Data, Use};
use super::json;
use super::nodes::Nodes;
use super::wrong;
use crate::Fault;

/// The most positions of all morph targets.
const MAX_MORPHED: usize = 1 << 23;
/// The most joints of a skin: vertices have their numbers in 16 bits.
const MAX_JOINTS: usize = 1 << 16;

/// A transform of positions, and that of normals.
struct Transform {
    place: DAffine3,
    upright: DMat3,
}

impl Transform {
    fn of(place: DAffine3) -> Self {
        // Normals are perpendicular to surfaces also where the scale differs between axes: their
        // transform is the inverse transpose, but for a positive factor.
        let DMat3 { x_axis, y_axis, z_axis } = place.matrix3;
        let x = y_axis.cross(z_axis);
        let cofactors = DMat3::from_cols(x, z_axis.cross(x_axis), x_axis.cross(y_axis));
        let upright = if x_axis.dot(x) < 0.0 { -cofactors } else { cofactors };
        Self { place, upright }
    }

    fn normal(&self, normal: DVec3) -> DVec3 {
        let normal = self.upright * normal;
        // NaN has no direction, and would become a normal of 0.
        scenes::unit(normal).unwrap_or(if normal.is_nan() { normal } else { DVec3::ZERO })
    }
}

/// The joints that move vertices.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Skin {
    /// The node of each joint.
    joints: Vec<usize>,
    /// From the vertices' coordinates to those of each joint, in which vertices stand still.
    inverse_bind: Vec<DMat4>,
    /// From the vertices' coordinates to the scene's, where the joints are now.
    matrices: Vec<DAffine3>,
}

impl Skin {
    pub fn read(data: &Data<'_>, index: usize, nodes: &Nodes) -> Result<Self, Fault> {
        let wrong = |what: String| wrong(format!("skin {index} {what}"));
        let skin = &data.root.skins[index];
        let joints = skin.joints.clone();
        if let Some(joint) = joints.iter().find(|&&joint| joint >= nodes.places.len()) {
            return Err(wrong(format!("has node {joint} as a joint, which doesn't exist")));
        }
        let inverse_bind = match skin.inverse_bind_matrices {
            None => vec![DMat4::IDENTITY; joints.len()],
            Some(accessor) => {
                let found = data.count(accessor);
                if found < joints.len() || found > MAX_JOINTS {
                    let count = joints.len();
                    return Err(wrong(format!("has {found} matrices for {count} joints")));
                }
                let matrices = data.read::<16>(accessor, Use::Positions, &["MAT4"])?;
                matrices.iter().map(DMat4::from_cols_array).collect()
            }
        };
        if let Some(joint) = inverse_bind.iter().position(|matrix| !matrix.is_finite()) {
            return Err(wrong(format!("has an inverse bind matrix {joint} that is not finite")));
        }
        let mut skin = Self { matrices: Vec::with_capacity(joints.len()), joints, inverse_bind };
        skin.place(nodes);
        Ok(skin)
    }

    /// Brings the joints to their nodes' places.
    pub fn place(&mut self, nodes: &Nodes) {
        let joints = self.joints.iter().zip(&self.inverse_bind);
        self.matrices.clear();
        self.matrices.extend(
            joints.map(|(&node, inverse)| DAffine3::from_mat4(nodes.places[node] * inverse)),
        );
    }

    /// The sum of the transforms of a vertex's joints.
    fn blended(&self, joints: &Joints) -> DAffine3 {
        let mut sum = DAffine3 { matrix3: DMat3::ZERO, translation: DVec3::ZERO };
        for &(joint, share) in joints.iter().filter(|(_, share)| *share > 0.0) {
            let DAffine3 { matrix3, translation } = &self.matrices[usize::from(joint)];
            sum.matrix3.x_axis += share * matrix3.x_axis;
            sum.matrix3.y_axis += share * matrix3.y_axis;
            sum.matrix3.z_axis += share * matrix3.z_axis;
            sum.translation += share * *translation;
        }
        sum
    }

    pub fn is_moved(&self, are_moved: &[bool]) -> bool {
        self.joints.iter().any(|&node| are_moved[node])
    }
}

/// Up to four joints of a vertex, and their shares, which add up to 1.
type Joints = [(u16, f64); 4];

/// The joints of all vertices of a part.
#[derive(Clone, Debug, PartialEq)]
struct Binding {
    skin: usize,
    joints: Vec<Joints>,
}

/// What a morph target adds to positions and normals. Either may be empty.
#[derive(Clone, Debug, PartialEq)]
struct Target {
    positions: Vec<DVec3>,
    normals: Vec<DVec3>,
}

/// The vertices of a primitive at a node.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Part {
    node: usize,
    /// The number of its first vertex in the mesh.
    pub first: usize,
    positions: Vec<DVec3>,
    /// As many, or none.
    normals: Vec<DVec3>,
    targets: Vec<Target>,
    binding: Option<Binding>,
}

fn vectors(data: &Data<'_>, accessor: usize, purpose: Use) -> Result<Vec<DVec3>, Fault> {
    let items = data.read::<3>(accessor, purpose, &["VEC3"])?;
    Ok(items.into_iter().map(DVec3::from).collect())
}

/// Checks that an accessor has an item for each vertex, before it is read.
pub(super) fn check_count(
    data: &Data<'_>,
    accessor: usize,
    what: &str,
    count: usize,
) -> Result<(), Fault> {
    match data.count(accessor) {
        found if found == count || accessor >= data.root.accessors.len() => Ok(()),
        found => Err(wrong(format!("{found} {what} for {count} vertices"))),
    }
}

impl Part {
    /// Reads a primitive with these positions. `morphed` counts the positions of morph targets.
    pub fn read(
        data: &Data<'_>,
        primitive: &json::Primitive,
        positions: usize,
        (node, nodes): (usize, &Nodes),
        morphed: &mut usize,
    ) -> Result<Self, Fault> {
        let positions = vectors(data, positions, Use::Positions)?;
        let count = positions.len();
        let read = |from: &HashMap<String, usize>, name: &str, purpose: Use, what: &str| {
            let Some(&accessor) = from.get(name) else {
                return Ok(Vec::new());
            };
            check_count(data, accessor, what, count)?;
            vectors(data, accessor, purpose)
        };
        let normals = read(&primitive.attributes, "NORMAL", Use::Shares, "normals")?;
        let weights = nodes.weights[node].len();
        if primitive.targets.len() != weights {
            let found = primitive.targets.len();
            return Err(wrong(format!(
                "it has {found} morph targets, and the mesh's first primitive has {weights}"
            )));
        }
        let mut targets = Vec::with_capacity(weights);
        for target in &primitive.targets {
            let parts = usize::from(target.contains_key("POSITION"))
                + usize::from(target.contains_key("NORMAL") && !normals.is_empty());
            *morphed = morphed.saturating_add(parts * count);
            if *morphed > MAX_MORPHED {
                return Err(wrong(format!(
                    "the file's morph targets have more than {MAX_MORPHED} positions and normals"
                )));
            }
            targets.push(Target {
                positions: read(target, "POSITION", Use::Positions, "positions of a morph target")?,
                normals: match normals.is_empty() {
                    true => Vec::new(),
                    false => read(target, "NORMAL", Use::Shares, "normals of a morph target")?,
                },
            });
        }
        Ok(Self { node, first: 0, positions, normals, targets, binding: None })
    }

    /// Binds the vertices to the joints of a skin.
    pub fn bind(
        &mut self,
        data: &Data<'_>,
        primitive: &json::Primitive,
        (index, skin): (usize, &Skin),
    ) -> Result<(), Fault> {
        let attribute = |name: &str| {
            let accessor = primitive.attributes.get(name).copied();
            let accessor = accessor.ok_or_else(|| wrong(format!("a skin needs {name}")))?;
            check_count(data, accessor, name, self.positions.len())?;
            Ok::<usize, Fault>(accessor)
        };
        let joints = data.read::<4>(attribute("JOINTS_0")?, Use::Indices, &["VEC4"])?;
        let weights = data.read::<4>(attribute("WEIGHTS_0")?, Use::Shares, &["VEC4"])?;
        let count = skin.joints.len();
        let mut bound = Vec::with_capacity(joints.len());
        for (vertex, (joints, weights)) in joints.into_iter().zip(weights).enumerate() {
            let wrong = |what: String| wrong(format!("vertex {vertex} {what}"));
            if let Some(weight) = weights.iter().find(|weight| weight.is_nan() || **weight < 0.0) {
                return Err(wrong(format!("has a joint with the weight {weight}")));
            }
            let sum: f64 = weights.iter().sum();
            if !(sum > 0.0 && sum.is_finite()) {
                return Err(wrong(format!("has weights of joints that add up to {sum}")));
            }
            // The joint of a weight of 0 may be any.
            let shares = joints.into_iter().zip(weights).map(|(joint, weight)| match weight {
                0.0 => Ok((0, 0.0)),
                _ if joint < count as f64 => Ok((joint as u16, weight / sum)),
                _ => Err(wrong(format!("has joint {joint} of {count}"))),
            });
            let mut own = [(0, 0.0); 4];
            for (own, share) in own.iter_mut().zip(shares) {
                *own = share?;
            }
            bound.push(own);
        }
        self.binding = Some(Binding { skin: index, joints: bound });
        Ok(())
    }

    /// Whether one of its vertices moves with nodes, skins or morph targets that do.
    pub fn is_moved(
        &self,
        are_moved: &[bool],
        skins: &[Option<Skin>],
        are_morphed: &[bool],
    ) -> bool {
        let is_placed_anew = match self.bound(skins) {
            Some((_, skin)) => skin.is_moved(are_moved),
            None => are_moved[self.node],
        };
        is_placed_anew || are_morphed[self.node]
    }

    pub fn len(&self) -> usize {
        self.positions.len()
    }

    /// Whether its triangles are mirrored, and so wound the other way.
    pub fn is_mirrored(&self, nodes: &Nodes, skins: &[Option<Skin>]) -> bool {
        let place = match (self.bound(skins), self.len()) {
            (Some((joints, skin)), 1..) => skin.blended(&joints[0]),
            _ => DAffine3::from_mat4(nodes.places[self.node]),
        };
        place.matrix3.determinant() < 0.0
    }

    /// The joints of all vertices, and their skin, if it has one.
    fn bound<'a>(&'a self, skins: &'a [Option<Skin>]) -> Option<(&'a [Joints], &'a Skin)> {
        let binding = self.binding.as_ref()?;
        Some((&binding.joints, skins[binding.skin].as_ref()?))
    }

    /// Calls `put` with the position of each vertex, and its normal if it has one.
    pub fn vertices(
        &self,
        nodes: &Nodes,
        skins: &[Option<Skin>],
        mut put: impl FnMut(DVec3, Option<DVec3>),
    ) {
        let rigid = Transform::of(DAffine3::from_mat4(nodes.places[self.node]));
        let bound = self.bound(skins);
        let morphs = self.targets.iter().zip(&nodes.weights[self.node]);
        let morphs = morphs.filter(|(_, weight)| **weight != 0.0);
        for (vertex, &position) in self.positions.iter().enumerate() {
            let mut position = position;
            let mut normal = self.normals.get(vertex).copied();
            for (target, &weight) in morphs.clone() {
                position += weight * target.positions.get(vertex).copied().unwrap_or_default();
                let by = target.normals.get(vertex).copied().unwrap_or_default();
                normal = normal.map(|normal| normal + weight * by);
            }
            let blended;
            let transform = match bound {
                None => &rigid,
                Some((joints, skin)) => {
                    blended = Transform::of(skin.blended(&joints[vertex]));
                    &blended
                }
            };
            let normal = normal.map(|normal| transform.normal(normal));
            put(transform.place.transform_point3(position), normal);
        }
    }
}
