//! Queued rays that don't fit in local store: they go to main memory and come back.

use protocol::layout::{
    MAX_BATCH, QueuedRay, RayPacket, SCENE_CAPACITY, SMALL_BATCH, WAITING_SIZE,
};

use crate::frames::fixture::Fixture;
use crate::prelude::*;

/// Rays of a packet.
const PACKET: u32 = 16;

/// The most bytes of a scene without triangles that leave space for the rays of such batches.
fn most_scene_bytes(batch: u32) -> u32 {
    let rays = 3 * PACKET * size_of::<QueuedRay>() as u32;
    let buffers = 2 * size_of::<RayPacket>() as u32;
    match batch {
        ..=SMALL_BATCH => SCENE_CAPACITY - batch * rays,
        _ => SCENE_CAPACITY - batch * (rays + buffers),
    }
}

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
fn rays_over_local_store_capacity_wait_in_main_memory() {
    for (spus, batch) in [(1, 8), (2, 8), (1, 16), (2, 11)] {
        let mut fixture = Fixture::of(&nff_scene("nested-glass.nff"), spus);
        let mut frame = fixture.frame;
        assert_eq!(frame.batch.get(), MAX_BATCH);
        frame.batch = 8.into();
        frame.ray_depth = 11.into();
        fixture.submit(&frame).unwrap();
        let expected = picture(&fixture);
        assert!(used(&fixture, spus).iter().all(|used| *used == 0));

        // Zeros after the scene take the space of all but three batches.
        frame.batch = batch.into();
        frame.scene_bytes = most_scene_bytes(batch).into();
        fixture.submit(&frame).unwrap();
        assert!(picture(&fixture) == expected);
        let bytes = used(&fixture, spus);
        println!("{bytes:?} bytes");
        assert!(bytes.iter().all(|used| *used > 0), "{bytes:?}");

        frame.scene_bytes = (frame.scene_bytes.get() + 128).into();
        assert_eq!(fixture.refused(&frame).field, "scene_bytes, ray_depth, batch");
    }
}

#[test]
fn unmapped_waiting_memory_is_a_dma_error() {
    let mut fixture = Fixture::of(&nff_scene("nested-glass.nff"), 1);
    let mut frame = fixture.frame;
    frame.batch = 8.into();
    frame.ray_depth = 11.into();
    frame.waiting = 0x1000.into();
    fixture.submit(&frame).unwrap();
    frame.scene_bytes = most_scene_bytes(frame.batch.get()).into();
    let error = fixture.submit(&frame).unwrap_err();
    assert!(matches!(error, EngineError::Ended { .. }), "{error}");
    let text = error.to_string();
    assert!(text.contains("unmapped memory"), "{text}");
}
