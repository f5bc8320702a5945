//! `colour_vertices_r16`.

use kernels::cases::whitted::colour::{Coloured, surfaces};
use kernels::prelude::*;
use twins::colour::Hit;

/// A vertex's colour is that of the point there, and white leaves a colour as it is.
#[test]
fn colours_at_vertices() {
    let mut bench = Bench::new();
    let vertices = [[-1.0, -1.0, -5.0], [1.0, -1.0, -5.0], [0.0, 1.0, -5.0]];
    let colour = [0.25, 0.5, 1.0];
    let white = 1023 << 22 | 1023 << 12 | 1023 << 2;
    for (corner, point) in vertices.into_iter().enumerate() {
        for colours in [[white, 0, 1023 << 12], [white; 3]] {
            let hit = Hit {
                vertices: vertices.map(|vertex| vertex.map(from_f64)),
                colours,
                point: point.map(from_f64),
                plane: [0.0, 0.0, 1.0].map(from_f64),
                colour: colour.map(from_f64),
            };
            let hits = [Some(hit); 16];
            for are_roots in [false, true] {
                let call = Coloured { hits, known: [None; 16], are_roots, anything: 0 };
                let (Bits(found), ..) = call.check(&mut bench);
                if colours == [white; 3] {
                    assert_eq!(found.as_bytes(), surfaces(&hits, 0).as_bytes());
                    continue;
                }
                let rows = [found.red, found.green, found.blue];
                for (channel, row) in rows.iter().enumerate() {
                    let is_lit = colours[corner] >> (22 - 10 * channel) & 1023 != 0;
                    let exact = if is_lit { colour[channel] } else { 0.0 };
                    let off = row.map(|it| (f64::from(it.get()) - exact).abs());
                    assert!(off.iter().all(|&off| off < 1e-6), "{corner} {off:?}");
                }
            }
        }
    }
}
