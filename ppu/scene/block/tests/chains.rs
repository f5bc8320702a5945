//! The bounds of chains in scenes, and in scenes that change.

use scenes::{Material as NffMaterial, Shader};

use super::*;
use crate::scene::block::ShaderEntries;

const MATT: &str = "l 0 9 0\nf 1 1 1 1 0 0 0 1\n";

/// Its number is 1, because the view comes with a material of its own.
const MATERIAL: usize = 1;

/// A block with spare capacity, and the material of its triangles.
fn changing(triangles: usize) -> (SceneBlock, NffMaterial, ShaderEntries) {
    let triangle = "p 3\n0 0 -5\n1 0 -5\n0 1 -5\n";
    let scene = scene(&(MATT.to_owned() + &triangle.repeat(triangles)));
    let shaders = ShaderEntries::new(vec!["rings".to_owned()]);
    let block =
        SceneBlock::with_spare_capacity(&scene, RenderOptions::default(), &shaders).unwrap();
    (block, scene.materials[MATERIAL].clone(), shaders)
}

#[test]
fn scene_without_reflection_has_primary_rays_alone() {
    let (block, ..) = changing(1);
    assert_eq!(block.ray_depth(), 1);
    assert_eq!(block.batch(), MAX_BATCH);
}

#[test]
fn new_mirror_lengthens_chains() {
    let (mut block, matt, shaders) = changing(1);
    let mirror = NffMaterial { specular: 1.0, ..matt.clone() };
    for (material, ray_depth) in [(&mirror, 5), (&matt, 1)] {
        assert!(block.set_material(MATERIAL, material, &shaders).unwrap());
        assert!(block.bound_chains());
        assert_eq!(block.ray_depth(), ray_depth);
    }
    let own = NffMaterial {
        shader: Shader::Own { name: "rings".to_owned(), parameters: [0.0; 4] },
        ..matt
    };
    assert!(block.set_material(MATERIAL, &own, &shaders).unwrap());
    assert!(block.bound_chains());
    assert_eq!((block.ray_depth(), block.least_weight()), (5, 0.0));
}

#[test]
fn scene_without_memory_for_longer_chains_is_refused() {
    // More than fit with the queue for chains of five rays, and fewer than fit without.
    let (mut block, matt, shaders) = changing(675);
    let mirror = NffMaterial { specular: 1.0, ..matt };
    assert!(block.set_material(MATERIAL, &mirror, &shaders).unwrap());
    assert!(!block.bound_chains());
}
