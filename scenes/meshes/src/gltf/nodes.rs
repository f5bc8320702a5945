//! The places of a file's nodes: those that they have in the file, or at a moment of an animation.

use glam::{DMat4, DQuat, DVec3};

use super::json::{self, Root};
use super::wrong;
use crate::Fault;

/// The transform of a node relative to its parent.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Local {
    /// Replaces all others.
    matrix: Option<DMat4>,
    pub translation: DVec3,
    /// Of any length.
    pub rotation: DQuat,
    pub scale: DVec3,
}

impl Local {
    fn of(node: &json::Node) -> Self {
        Self {
            matrix: node.matrix.as_ref().map(DMat4::from_cols_array),
            translation: node.translation.unwrap_or_default().into(),
            rotation: DQuat::from_array(node.rotation.unwrap_or([0.0, 0.0, 0.0, 1.0])),
            scale: node.scale.unwrap_or([1.0; 3]).into(),
        }
    }

    fn matrix(&self) -> DMat4 {
        let rotation = match self.rotation {
            it if it.length_squared() > 0.0 && it.is_finite() => it.normalize(),
            _ => DQuat::IDENTITY,
        };
        self.matrix.unwrap_or_else(|| {
            DMat4::from_scale_rotation_translation(self.scale, rotation, self.translation)
        })
    }
}

/// The nodes of a file.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Nodes {
    /// All nodes, each after its parent, and those of the scene before all others.
    order: Vec<(usize, Option<usize>)>,
    /// How many of these are in the scene.
    in_scene: usize,
    pub locals: Vec<Local>,
    /// The weights of the morph targets of each node's mesh.
    pub weights: Vec<Vec<f64>>,
    /// The transform of each node to the scene.
    pub places: Vec<DMat4>,
}

impl Nodes {
    /// The nodes of a file, for a scene of these. They have no places yet.
    pub fn new(root: &Root, scene: &[usize]) -> Result<Self, Fault> {
        let count = root.nodes.len();
        let mut seen = vec![false; count];
        let mut order = Vec::with_capacity(count);
        let mut stack: Vec<_> = scene.iter().rev().map(|&node| (node, None)).collect();
        while let Some((node, parent)) = stack.pop() {
            let Some(found) = root.nodes.get(node) else {
                return Err(wrong(format!("node {node} doesn't exist")));
            };
            if std::mem::replace(&mut seen[node], true) {
                return Err(wrong(format!("node {node} is in the scene twice, or in itself")));
            }
            order.push((node, parent));
            stack.extend(found.children.iter().rev().map(|&child| (child, Some(node))));
        }
        let in_scene = order.len();
        // Joints may be elsewhere. Nodes there may be in each other: a ring is opened anywhere.
        for top in tops(root).into_iter().chain(0..count) {
            stack.push((top, None));
            while let Some((node, parent)) = stack.pop() {
                if seen.get(node) == Some(&false) {
                    seen[node] = true;
                    order.push((node, parent));
                    let children = root.nodes[node].children.iter();
                    stack.extend(children.map(|&child| (child, Some(node))));
                }
            }
        }
        let weights = root.nodes.iter().enumerate().map(|(index, node)| weights(root, index, node));
        Ok(Self {
            order,
            in_scene,
            locals: root.nodes.iter().map(Local::of).collect(),
            weights: weights.collect::<Result<_, _>>()?,
            places: vec![DMat4::IDENTITY; count],
        })
    }

    /// The nodes of the scene, each after its parent.
    pub fn of_scene(&self) -> Vec<usize> {
        self.order[..self.in_scene].iter().map(|&(node, _)| node).collect()
    }

    /// Places all nodes by their transforms relative to their parents.
    pub fn place(&mut self) {
        for &(node, parent) in &self.order {
            let outer = parent.map_or(DMat4::IDENTITY, |parent| self.places[parent]);
            self.places[node] = outer * self.locals[node].matrix();
        }
    }

    /// The nodes that are moved if the nodes of `driven` are.
    pub fn moved_with(&self, mut driven: Vec<bool>) -> Vec<bool> {
        for &(node, parent) in &self.order {
            driven[node] |= parent.is_some_and(|parent| driven[parent]);
        }
        driven
    }
}

/// The nodes that are in no other.
pub(super) fn tops(root: &Root) -> Vec<usize> {
    let mut is_top = vec![true; root.nodes.len()];
    for &child in root.nodes.iter().flat_map(|node| &node.children) {
        if let Some(is_top) = is_top.get_mut(child) {
            *is_top = false;
        }
    }
    (0..is_top.len()).filter(|&node| is_top[node]).collect()
}

/// The weights of the morph targets of a node's mesh, as the file has them.
fn weights(root: &Root, index: usize, node: &json::Node) -> Result<Vec<f64>, Fault> {
    let mesh = node.mesh.and_then(|mesh| root.meshes.get(mesh));
    let targets = mesh.and_then(|mesh| mesh.primitives.first()).map_or(0, |it| it.targets.len());
    let own = Some(&node.weights).filter(|own| !own.is_empty());
    let weights = own.or(mesh.map(|mesh| &mesh.weights)).filter(|own| !own.is_empty());
    match weights {
        None => Ok(vec![0.0; targets]),
        Some(weights) if weights.len() == targets => Ok(weights.clone()),
        Some(weights) => Err(wrong(format!(
            "node {index} has {} weights for {targets} morph targets",
            weights.len()
        ))),
    }
}
