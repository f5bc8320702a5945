//! Rays that wait and have no room in local store: they go to main memory and come back.

use cellray::EngineError;
use cellray::framebuffer::Framebuffer as _;
use protocol::layout::{QueuedRay, SCENE_ROOM, WAITING_SIZE};

use crate::frames::fixture::Fixture;
use crate::recorder::nff_scene;

/// Rays of a packet.
const PACKET: u32 = 16;

fn picture(fixture: &Fixture) -> Vec<u8> {
    fixture.framebuffer.picture().unwrap().into_raw()
}

/// The bytes of the SPUs' places that are not 0, of each SPU.
fn used(fixture: &Fixture, spus: u32) -> Vec<usize> {
    let mut bytes = vec![0; (spus * WAITING_SIZE) as usize];
    fixture.waiting.read(0, &mut bytes);
    let places = bytes.chunks_exact(WAITING_SIZE as usize);
    let used = places.map(|place| place.iter().filter(|byte| **byte != 0).count());
    used.collect()
}

#[test]
fn rays_without_room_in_local_store_wait_in_main_memory() {
    for spus in [1, 2] {
        let mut fixture = Fixture::of(&nff_scene("nested-glass.nff"), spus);
        let mut frame = fixture.frame;
        assert_eq!(frame.batch.get(), 8);
        frame.ray_depth = 11.into();
        fixture.submit(&frame).unwrap();
        let expected = picture(&fixture);
        assert!(used(&fixture, spus).iter().all(|used| *used == 0));

        // Zeros after the scene take the room of all but three batches.
        let batch = frame.batch.get() * PACKET * size_of::<QueuedRay>() as u32;
        frame.scene_bytes = (SCENE_ROOM - 3 * batch).into();
        fixture.submit(&frame).unwrap();
        assert!(picture(&fixture) == expected);
        let bytes = used(&fixture, spus);
        println!("{bytes:?} bytes");
        assert!(bytes.iter().all(|used| *used > 0), "{bytes:?}");

        frame.scene_bytes = (frame.scene_bytes.get() + 128).into();
        assert_eq!(
            fixture.refused(&frame).field,
            "scene_bytes, ray_depth, batch"
        );
    }
}

#[test]
fn main_memory_that_is_not_there_is_a_dma_error() {
    let mut fixture = Fixture::of(&nff_scene("nested-glass.nff"), 1);
    let mut frame = fixture.frame;
    frame.ray_depth = 11.into();
    frame.waiting = 0x1000.into();
    fixture.submit(&frame).unwrap();
    let batch = frame.batch.get() * PACKET * size_of::<QueuedRay>() as u32;
    frame.scene_bytes = (SCENE_ROOM - 3 * batch).into();
    let error = fixture.submit(&frame).unwrap_err();
    assert!(matches!(error, EngineError::Ended { .. }), "{error}");
    let text = error.to_string();
    assert!(text.contains("unmapped memory"), "{text}");
}
