//! Damaged files are refused or read, but nothing panics and nothing hangs.

use proptest::prelude::*;

use super::animated::faults::rig;
use super::files::{MTL, OBJ, PLY, binary_ply, glb};
use super::{heights, scans, textures};

/// A change of a file.
#[derive(Clone, Debug)]
enum Damage {
    /// A byte becomes another one.
    Byte(usize, u8),
    /// The file ends here.
    End(usize),
    /// A part is repeated.
    Repeat(usize, usize),
    /// A part is missing.
    Cut(usize, usize),
}

fn damage() -> impl Strategy<Value = Damage> {
    let digits = prop_oneof![any::<u8>(), b'0'..=b'9', Just(b'-'), Just(b' '), Just(b'\n')];
    prop_oneof![
        6 => (any::<usize>(), digits).prop_map(|(at, byte)| Damage::Byte(at, byte)),
        1 => any::<usize>().prop_map(Damage::End),
        1 => (any::<usize>(), 1..40_usize).prop_map(|(at, length)| Damage::Repeat(at, length)),
        1 => (any::<usize>(), 1..40_usize).prop_map(|(at, length)| Damage::Cut(at, length)),
    ]
}

fn damaged(file: &[u8], damages: &[Damage]) -> Vec<u8> {
    let mut file = file.to_vec();
    for damage in damages {
        let place = |at: usize| at % file.len().max(1);
        match *damage {
            Damage::Byte(at, byte) => {
                let at = place(at);
                if let Some(found) = file.get_mut(at) {
                    *found = byte;
                }
            }
            Damage::End(at) => file.truncate(place(at)),
            Damage::Repeat(at, length) => {
                let at = place(at);
                let part = file[at..(at + length).min(file.len())].to_vec();
                file.splice(at..at, part);
            }
            Damage::Cut(at, length) => {
                let at = place(at);
                file.drain(at..(at + length).min(file.len()));
            }
        }
    }
    file
}

proptest! {
    #[test]
    fn damaged_files_do_not_panic(damages in prop::collection::vec(damage(), 1..6)) {
        let folder = tempfile::tempdir().unwrap();
        let picture = textures::png();
        let files: [(&str, &[u8]); 14] = [
            ("m.mtl", MTL.as_bytes()),
            ("t.obj", OBJ.as_bytes()),
            ("a.ply", PLY.as_bytes()),
            ("l.ply", &binary_ply(false)),
            ("b.ply", &binary_ply(true)),
            ("t.glb", &glb()),
            ("animated.glb", &rig().file()),
            ("t.stl", scans::STL.as_bytes()),
            ("b.stl", &scans::binary_stl(b"by a printer")),
            ("t.png", &picture),
            ("h.png", &heights::grey(3, &[7; 9])),
            ("h.npy", &heights::npy("<f4", "False", "(2, 3)", &[0; 24])),
            ("textured.obj", textures::OBJ.as_bytes()),
            ("textured.glb", &textures::glb(&picture, "{", "{")),
        ];
        for (name, bytes) in files {
            let path = folder.path().join(name);
            std::fs::write(&path, damaged(bytes, &damages)).unwrap();
            if name == "m.mtl" || name == "t.png" {
                continue;
            }
            if let Ok(mut loaded) = meshes::load(&path) {
                prop_assert!(loaded.scene.view.camera(8, 8).is_ok());
                let Some(mesh) = loaded.scene.mesh.take() else {
                    prop_assert!(loaded.scene.heights.is_some());
                    continue;
                };
                prop_assert!(mesh.triangles.iter().flatten().all(|&it| (it as usize) < mesh.positions.len()));
                prop_assert!(mesh.materials.iter().all(|&it| (it as usize) < loaded.scene.materials.len()));
                prop_assert!(mesh.positions.as_flattened().iter().all(|it| it.is_finite()));
                for time in [0.0, 0.4, 1e9] {
                    let Some(animation) = &mut loaded.animation else { break };
                    let (positions, normals) = animation.at(time);
                    prop_assert_eq!(positions.len(), mesh.positions.len());
                    prop_assert_eq!(normals.len(), mesh.normals.len());
                }
                let places = &mesh.texture_coordinates;
                let textured = loaded.scene.materials.iter().any(|it| it.texture.is_some());
                prop_assert_eq!(places.len(), if textured { mesh.positions.len() } else { 0 });
                prop_assert!(places.as_flattened().iter().all(|it| it.is_finite()));
            }
        }
    }
}
